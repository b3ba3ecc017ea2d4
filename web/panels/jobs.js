// Pictures that are drawn large, as jobs of the server: they go on when one leaves.

import { largeSizes, submitJob } from '../picture/jobs.js';
import { countingOptions, isChance, usualOf } from '../picture/integrators.js';
import { accessKey, keepAccessKey } from '../state/access_key.js';
import { addJob, ownJobs } from '../state/own_jobs.js';
import { fileName } from '../state/request.js';
import { resized, sizeOf } from '../state/window.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { jobCard } from './job_card.js';
import { showProblem } from './problem_view.js';

export const style = 'panels/jobs.css';

const SAMPLES = [1, 4, 16, 64, 256, 1024, 4096];

export default function mountJobs(studio, panel) {
  const { model } = studio;
  const [size, samples] = [element('select'), element('select')];
  const draw = element('button', { type: 'submit' }, t('jobs.draw'));
  const told = element('p', { class: 'told', role: 'status' });
  const cards = element('div', { class: 'job-cards' });
  const field = (name, control) => element('label', {}, element('span', {}, t(`jobs.${name}`)), control);
  const form = element('form', { onsubmit: begin, class: 'take-form', 'aria-label': t('jobs.tab') },
    field('size', size), field('samples', samples), element('div', { class: 'row' }, draw));
  panel.append(element('p', { class: 'note' }, t('jobs.about')), form, told, cards, keyForm());
  for (const job of ownJobs()) cards.append(card(job));

  function card(job) {
    const made = jobCard(job, { gone: () => (made.remove(), told.textContent = t('jobs.dropped')), tell: (words) => (told.textContent = words) });
    return made;
  }

  async function begin(event) {
    event.preventDefault();
    draw.disabled = true;
    told.textContent = t('jobs.sending');
    try {
      const [width, height] = size.value.split('x').map(Number);
      const request = { ...resized(studio.unasked, [width, height]), samples: Number(samples.value) };
      const name = `tia${fileName(request)}-${width}x${height}`;
      const { id } = await submitJob(request, name);
      addJob({ id, name, width, height, crop: request.crop });
      cards.prepend(card(ownJobs()[0]));
      told.textContent = t('jobs.begun');
    } catch (problem) {
      told.textContent = '';
      showProblem(problem);
    } finally {
      draw.disabled = false;
    }
  }

  // What the picture has now is what is chosen, until somebody chooses.
  function follow() {
    if (studio.tab !== 'tab-jobs') return;
    const sizes = largeSizes(sizeOf(model.request));
    if (size.dataset.all !== sizes.join()) {
      size.dataset.all = sizes.join();
      size.replaceChildren(...sizes.map((one, i) => element('option', { value: one.join('x'), selected: i === 1 }, one.join(' \u00d7 '))));
    }
    const integrator = model.request.integrator ?? model.source?.options?.integrator ?? 'whitted';
    const own = countingOptions(model.request, model.source?.options)?.samples ?? usualOf(integrator, 'samples') ?? 1;
    const usual = isChance(integrator) ? Math.max(own, 64) : Math.max(own, 16);
    const all = [...new Set([...SAMPLES, usual])].sort((a, b) => a - b);
    if (samples.dataset.all === all.join()) return;
    samples.dataset.all = all.join();
    samples.replaceChildren(...all.map((one) => element('option', { value: one, selected: one === usual }, String(one))));
  }

  for (const event of ['want', 'source', 'tab']) model.on(event, follow);
  follow();
}

// A server may ask for a key. It is kept for this tab only.
function keyForm() {
  const input = element('input', { type: 'password', autocomplete: 'off', spellcheck: 'false', value: accessKey() ?? '' });
  const said = element('p', { class: 'note', role: 'status' });
  const use = (key) => {
    keepAccessKey(key || null);
    said.textContent = t(key ? 'jobs.keyKept' : 'jobs.keyGone');
  };
  return element('details', { class: 'access-key' }, element('summary', {}, t('jobs.key')),
    element('form', { class: 'row wrap end', onsubmit: (event) => (event.preventDefault(), use(input.value.trim())) },
      element('label', {}, element('span', {}, t('jobs.keyField')), input),
      element('button', { type: 'submit' }, t('jobs.keyUse')),
      element('button', { type: 'button', onclick: () => ((input.value = ''), use('')) }, t('jobs.keyForget'))),
    element('p', { class: 'note' }, t('jobs.keyNote')), said);
}
