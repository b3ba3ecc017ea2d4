// A model as the panel shows it: on its way to the server, what is in it, how it is seen, and how to
// take it along. Loaded with the first model.

import { problemWords } from '../picture/problem.js';
import { fetchModel, keepModel } from '../picture/models.js';
import { bundleOf, modelsAmong, partsOf } from '../state/bundle.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { aboutModel } from './model_about.js';
import { modelForm } from './model_form.js';
import { modelLines } from './model_lines.js';
import { modelTurn } from './model_turn.js';

/** Fills `panel` and gives `take(files)`, which shows what they are, and `follow()` what is wanted. */
export function makeModelView(studio, panel) {
  const { model } = studio;
  const way = wayOf(panel);
  const about = element('div', { class: 'model-about' });
  const form = modelForm(studio);
  const lines = modelLines(studio);
  const shown = element('div', { class: 'model-shown', hidden: true }, about, form.node, modelTurn(studio), ...lines.nodes);
  let known = null; // the description of the model that is asked for, null until it comes
  let asked = null; // its id, or its name in the gallery
  let abort = new AbortController();
  panel.append(shown);

  /** Runs a step of a model's way here; a newer one takes its place. */
  async function go(step) {
    abort.abort();
    const { signal } = (abort = new AbortController());
    try {
      await step(signal);
    } catch (problem) {
      if (!signal.aborted) way.fail(problem, () => go(step));
    }
  }

  function take(files) {
    const parts = partsOf(files);
    const mains = modelsAmong(parts);
    if (mains.length === 0) way.say(t('model.noModel'), true);
    else if (mains.length === 1) send(bundleOf(parts, mains[0]));
    else way.choose(mains, (main) => send(bundleOf(parts, main)));
  }

  const send = (bundle) => go(async (signal) => {
    way.say(t('model.reading', { name: bundle.main }));
    const description = await keepModel(bundle, (part) => !signal.aborted && way.going(part), signal);
    if (signal.aborted) return;
    [known, asked] = [description, description.id];
    lines.named(bundle, known.id);
    model.asked = null;
    const { width, height } = model.request.model ? model.request : {};
    await studio.open({ model: description.id, width, height });
  });

  function follow() {
    const id = model.request.model;
    if (id && asked !== id) {
      [known, asked] = [null, id];
      go(async (signal) => {
        known = await fetchModel(id, signal);
        follow();
      });
    }
    shown.hidden = !id || !known;
    if (!shown.hidden) draw();
  }

  let told = null;
  function draw() {
    if (told !== known) {
      told = known;
      about.replaceChildren(...aboutModel(known));
      form.offer(known);
      way.say('');
    }
    form.draw();
    lines.draw();
  }

  model.on('rest', () => known && model.request.model && lines.draw());
  return { take, follow };
}

// What is told while a model comes: words, how much has gone, which file is meant, what went wrong.
function wayOf(panel) {
  const said = element('div', { id: 'model-said', role: 'status' });
  const bar = element('progress', { max: 1, 'aria-label': t('model.sent'), hidden: true });
  const ask = element('div', { class: 'model-ask' });
  panel.append(said, bar, ask);

  function say(words, wrong = false, ...more) {
    bar.hidden = true;
    ask.replaceChildren();
    said.replaceChildren(...(words ? [element('p', wrong ? { class: 'fault' } : {}, words), ...more] : []));
  }

  function going(part) {
    if (bar.hidden) say(t('model.sending'));
    bar.hidden = part >= 1;
    bar.value = part;
    if (part >= 1) say(t('model.parsing'));
  }

  function fail(problem, retry) {
    const { title, lines, retry: may } = problemWords(problem);
    say(title, true, ...lines.map((line) => element('p', { class: 'fault' }, line)));
    if (may) ask.append(element('button', { type: 'button', onclick: retry }, t('trouble.retry')));
  }

  function choose(mains, chosen) {
    say(t('model.which'));
    ask.append(...mains.map((main) => element('button', { type: 'button', onclick: () => chosen(main) }, main)));
    ask.firstChild.focus();
  }

  return { say, going, fail, choose };
}
