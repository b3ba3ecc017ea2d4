// The methods side by side: how many paths each finds, how many of the others' it misses, and what it took.

import { countWords, msWords, t } from '../words/words.js';
import { problemWords } from '../picture/problem.js';
import { element } from './element.js';

const COUNTS = ['rays', 'images', 'candidates', 'blocked', 'doubles'];

/** The comparison as { node, draw() }; it is asked for while it is open. */
export function methodTable(radio) {
  const place = element('div', { class: 'radio-scroll', tabindex: 0, role: 'group', 'aria-label': t('radio.compared') });
  const details = element('details', { ontoggle: () => radio.compare(details.open) }, element('summary', {}, t('radio.compared')),
    element('p', { class: 'note' }, t('radio.comparedAbout')), place);

  function draw() {
    const { methods } = radio;
    if (!methods) return;
    const heads = ['method', 'ways', 'missed', 'extra', ...COUNTS, 'took'].map((name) => element('th', { scope: 'col' }, t(`radio.n_${name}`)));
    place.replaceChildren(element('table', { class: 'radio-table' }, element('thead', {}, element('tr', {}, heads)), element('tbody', {}, methods.map(row))));
  }

  function row({ method, problem, paths, missed, extra, counts, ms }) {
    const head = element('th', { scope: 'row' }, t(`radio.${method}`));
    if (problem) return element('tr', {}, head, element('td', { class: 'why-not', colspan: COUNTS.length + 4 }, problemWords(problem).lines.join(' ')));
    const cells = [paths.length, missed, extra, ...COUNTS.map((name) => counts[name])].map(countWords);
    return element('tr', {}, head, [...cells, msWords(ms)].map((words) => element('td', {}, words)));
  }

  return { node: details, draw };
}
