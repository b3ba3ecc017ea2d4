// An explanation as the panel shows it. Loaded with the first question.

import { codesOf, storesPlainly } from '../picture/srgb.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { makePaths } from './why_paths.js';
import { makeSteps } from './why_steps.js';
import { decimals, swatch } from './why_sum.js';
import { expressionWords, overWords, percent, thingWords, waysSentence, whySentence } from './why_words.js';

const MOST_HITS = 50;
const MOST_GROUPS = 8;

/** Makes { nodes, rays, show(explained, { pixel, transfer, many, scene }, again) }; `show` gives its sentence. */
export function makeTold(moved, stopping) {
  const head = element('div', { class: 'colour' });
  const sentence = element('p', { class: 'because' });
  const note = element('p', { class: 'note' });
  const steps = makeSteps(moved);
  const paths = makePaths(moved);
  const [ways, over] = ['ways', 'over'].map((name) => element('ol', { class: name }));
  const walking = element('div');
  let walk = steps;
  const hits = element('details', { class: 'hits' });

  function show(explained, { pixel, transfer, many, scene }, again) {
    const { tree, groups } = explained;
    walk = tree ? steps : paths;
    const color = tree?.color ?? explained.mean;
    head.replaceChildren(swatch(color, transfer, 'swatch big'), numbers(color, pixel, transfer));
    sentence.textContent = tree ? whySentence(tree) : waysSentence(explained, scene);
    note.textContent = tree && many ? t('why.oneRay') : '';
    if (walk.element.parentNode !== walking) walking.replaceChildren(walk.element);
    walk.show({ ...explained, transfer }, again);
    const overOf = (part, share) => t('why.overMore', { share, thing: overWords(part, scene) });
    for (const [list, parts, wordsOf] of [[ways, groups, groupWords], [over, explained.over, overOf]]) {
      list.hidden = Boolean(tree) || parts.length === 0;
      if (!tree) list.replaceChildren(...parts.slice(0, MOST_GROUPS).map((part) => partItem(part, wordsOf(part, percent(part.share)))));
    }
    hits.replaceChildren(...hitList(explained.hits));
    return sentence.textContent;
  }

  const nodes = [head, sentence, note, stopping, ways, over, walking, hits];
  return { nodes, show, get rays() { return walk.rays; } };
}

function numbers(color, [x, y], transfer) {
  const named = ([r, g, b]) => ({ r, g, b });
  return element('div', {},
    element('strong', {}, t('why.pixel', { x, y })),
    storesPlainly(transfer)
      && element('span', { class: 'codes' }, t('why.codes', named(codesOf(color, transfer)))),
    element('span', { class: 'note' }, t('why.light', named(color.map((value) => decimals(value))))));
}

const groupWords = (group, share) => `${t('why.share', { share })}: ${expressionWords(group)}`;

function partItem({ share }, words) {
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
