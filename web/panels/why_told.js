// An explanation as the panel shows it. Loaded with the first question.

import { codesOf, storesPlainly } from '../picture/srgb.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { makeSteps } from './why_steps.js';
import { decimals, swatch } from './why_sum.js';
import { expressionWords, percent, thingWords, waysSentence, whySentence } from './why_words.js';

const MOST_HITS = 50;
const MOST_GROUPS = 8;

/** Makes { nodes, steps, show(explained, { pixel, transfer, many }, again) }; `show` gives its sentence. */
export function makeTold(moved, stopping) {
  const head = element('div', { class: 'colour' });
  const sentence = element('p', { class: 'because' });
  const note = element('p', { class: 'note' });
  const steps = makeSteps(moved);
  const ways = element('ol', { class: 'ways' });
  const hits = element('details', { class: 'hits' });

  function show(explained, { pixel, transfer, many }, again) {
    const { tree, groups } = explained;
    const color = tree?.color ?? explained.mean;
    head.replaceChildren(swatch(color, transfer, 'swatch big'), numbers(color, pixel, transfer));
    sentence.textContent = tree ? whySentence(tree) : waysSentence(explained);
    note.textContent = tree && many ? t('why.oneRay') : '';
    steps.element.hidden = !tree;
    ways.hidden = Boolean(tree);
    if (tree) steps.show({ ...explained, transfer }, again);
    else ways.replaceChildren(...groups.slice(0, MOST_GROUPS).map(groupItem));
    hits.replaceChildren(...hitList(explained.hits));
    return sentence.textContent;
  }

  return { nodes: [head, sentence, note, stopping, steps.element, ways, hits], steps, show };
}

function numbers(color, [x, y], transfer) {
  const named = ([r, g, b]) => ({ r, g, b });
  return element('div', {},
    element('strong', {}, t('why.pixel', { x, y })),
    storesPlainly(transfer)
      && element('span', { class: 'codes' }, t('why.codes', named(codesOf(color, transfer)))),
    element('span', { class: 'note' }, t('why.light', named(color.map((value) => decimals(value))))));
}

function groupItem({ expression, share }) {
  const words = `${t('why.share', { share: percent(share) })}: ${expressionWords(expression)}`;
  const value = Math.min(1, Math.max(0, share));
  return element('li', {}, element('meter', { value, 'aria-label': words }), ` ${words}`);
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
