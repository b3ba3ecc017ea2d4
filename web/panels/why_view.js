// What the panel shows: an invitation, an explanation, or why there is none.

import { codesOf, storesPlainly } from '../picture/srgb.js';
import { problemWords } from '../picture/problem.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { makeSteps } from './why_steps.js';
import { decimals, swatch } from './why_sum.js';
import { thingWords, whySentence } from './why_words.js';

const MOST_HITS = 50;

/** Fills `panel`; `stop()`, `middle()` and `moved()` hear of what a person does there. */
export function makeView(panel, { stop, middle, moved }) {
  const button = (words, onclick) => element('button', { type: 'button', onclick }, t(words));
  const start = button('why.middle', middle);
  const invitation = [element('p', {}, t('why.intro')), element('div', {}, start)];
  const head = element('div', { class: 'colour' });
  const sentence = element('p', { class: 'because' });
  const note = element('p', { class: 'note' });
  const steps = makeSteps(moved);
  const hits = element('details', { class: 'hits' });
  const stopping = element('div', {}, button('why.stop', stop));
  const told = [head, sentence, note, stopping, steps.element, hits];
  const put = (parts) => parts[0].parentNode === panel || panel.replaceChildren(...parts);

  panel.classList.add('why');
  put(invitation);
  return {
    steps,
    invite(focus) {
      put(invitation);
      if (focus) start.focus();
    },
    busy: () => put([element('p', {}, t('why.busy'))]),
    refuse: (words) => put([element('p', { class: 'fault' }, words), stopping]),
    fail(problem) {
      const { title, lines } = problemWords(problem);
      const said = [element('strong', {}, title), ...lines];
      put([...said.map((line) => element('p', { class: 'fault' }, line)), stopping]);
    },
    /** An explanation with its pixel and transfer; `again` where the pixel is the one shown before. */
    show(explained, { pixel, transfer, many }, again) {
      if (told[0].parentNode !== panel) panel.replaceChildren(...told);
      if (stopping.parentNode !== panel) note.after(stopping);
      const { color } = explained.tree;
      head.replaceChildren(swatch(color, transfer, 'swatch big'), numbers(color, pixel, transfer));
      sentence.textContent = whySentence(explained.tree);
      note.textContent = many ? t('why.oneRay') : '';
      steps.show({ ...explained, transfer }, again);
      hits.replaceChildren(...hitList(explained.hits));
      return sentence.textContent;
    },
  };
}

function numbers(color, [x, y], transfer) {
  const named = ([r, g, b]) => ({ r, g, b });
  return element('div', {},
    element('strong', {}, t('why.pixel', { x, y })),
    storesPlainly(transfer)
      && element('span', { class: 'codes' }, t('why.codes', named(codesOf(color, transfer)))),
    element('span', { class: 'note' }, t('why.light', named(color.map((value) => decimals(value))))));
}

function hitList(hits) {
  return [
    element('summary', {}, t('why.hits', { count: countWords(hits.length) })),
    hits.length === 0 && element('p', {}, t('why.noHits')),
    hits.length > 0 && element('ol', {}, ...hits.slice(0, MOST_HITS).map(hitItem)),
  ].filter(Boolean);
}

function hitItem({ t: far, object, front }) {
  const values = { distance: numberWords(far, 4), thing: thingWords(object) };
  return element('li', {}, t(front ? 'why.enters' : 'why.leaves', values));
}
