// The last pictures as bars: how long each took, and who had it.

import { median } from '../picture/pace.js';
import { countWords, msWords, t } from '../words/words.js';
import { element, svg } from './element.js';

const [WIDTH, HEIGHT, STEP] = [360, 96, 3]; // of 120 bars
const FLUENT_MS = 1000 / 30;

/** The chart, and what its colours mean. */
export function chartOf(pace) {
  const { last, counts } = pace;
  const times = last.filter(({ kind }) => kind !== 'failed').map(({ ms }) => ms);
  const most = Math.max(2 * FLUENT_MS, ...times);
  const fluent = HEIGHT - (FLUENT_MS / most) * HEIGHT;
  const words = times.length === 0 ? t('numbers.chartNone')
    : t('numbers.chart', { count: last.length, median: msWords(median(times)),
      most: msWords(Math.max(...times)) });
  return [
    svg('svg', { class: 'chart', viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none',
      role: 'img', 'aria-label': words },
      svg('line', { class: 'fluent', x1: 0, x2: WIDTH, y1: fluent, y2: fluent }),
      last.map((one, i) => barOf(one, WIDTH - (last.length - i) * STEP, most))),
    element('p', { class: 'note' }, words, ' ', t('numbers.chartLine')),
    element('ul', { class: 'legend' }, Object.entries(counts).map(([kind, count]) =>
      element('li', { class: kind }, t(`numbers.${kind}`, { count: countWords(count) })))),
  ];
}

// What failed took no time that means anything: its bar is whole.
function barOf({ ms, kind }, x, most) {
  const height = kind === 'failed' ? HEIGHT : Math.max(1, (ms / most) * HEIGHT);
  return svg('rect', { class: kind, x, y: HEIGHT - height, width: STEP - 1, height });
}
