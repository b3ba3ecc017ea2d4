// What the last picture took, and how fast they come. Nothing is drawn while nobody looks.

import { median, Pace, rateOf, totalMs } from '../picture/timing.js';
import { windowOf } from '../state/window.js';
import { countWords, has, msWords, numberWords, t } from '../words/words.js';
import { element, svg } from './element.js';

const [WIDTH, HEIGHT, STEP] = [360, 96, 3]; // of 120 bars
const FLUENT_MS = 1000 / 30;

/** The chart, and what its colours mean. */
function chartOf(pace) {
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

const REST_MS = 1000;

export default function mountNumbers(studio, panel) {
  const { model } = studio;
  const pace = new Pace();
  const [figures, pictures] = [element('div', { class: 'figures' }), element('div', { class: 'figures' })];
  panel.append(figures, pictures);
  let resting;

  const open = () => studio.tab === 'tab-numbers';
  const drawFigures = () => model.shown && figures.replaceChildren(...figuresOf(model.shown));
  const drawPace = () => pictures.replaceChildren(...paceOf(pace));

  function came(kind) {
    pace.add({ at: performance.now(), ms: kind === 'failed' ? 0 : model.shown.ms, kind });
    if (!open()) return;
    if (kind !== 'failed') drawFigures();
    drawPace();
    clearTimeout(resting);
    resting = setTimeout(() => open() && drawPace(), REST_MS + 1);
  }

  model.on('show', () => came(model.shown.cached ? 'cached' : 'drawn'));
  model.on('fail', () => came('failed'));
  model.on('tab', () => open() && (drawFigures(), drawPace()));
}

function figuresOf(shown) {
  const { timing, rays, blob, ms, request } = shown;
  const { width, height } = windowOf(request);
  const phases = timing.filter(({ name }) => name !== 'total');
  const all = rays.reduce((sum, { count }) => sum + count, 0);
  return [
    element('h2', {}, t('numbers.server')),
    element('p', { class: 'figure' }, phases.length ? msWords(totalMs(timing)) : t('numbers.untold')),
    bar(phases.map(({ name, ms }) => ({ name, value: ms }))),
    list('phases', phases.map(({ name, ms }) => [name, msWords(ms)])),
    element('p', { class: 'note from' }, t(`numbers.${sourceOf(shown)}`)),
    element('h2', {}, t('numbers.rays')),
    element('p', { class: 'figure' }, rays.length ? countWords(all) : t('numbers.untold')),
    bar(rays.map(({ name, count }) => ({ name, value: count }))),
    list('kinds', rays.map(({ name, count }) => [name, countWords(count)])),
    element('h2', {}, t('numbers.picture')),
    list('whole', [
      ['wait', msWords(ms)],
      ['size', `${width} \u00d7 ${height}`],
      ['bytes', countWords(blob.size)],
      ['each', numberWords(all / (width * height))],
    ]),
  ];
}

const sourceOf = ({ cached, copied }) => (copied ? 'fromCopy' : cached ? 'fromCache' : 'drawnNow');

function bar(parts) {
  const shown = parts.filter(({ value }) => value > 0);
  return element('div', { class: 'shares', 'aria-hidden': 'true' },
    shown.map(({ name, value }) => element('span', { class: name, style: { flexGrow: value } })));
}

function list(kind, rows) {
  return element('dl', { class: kind }, rows.map(([name, value]) =>
    element('div', { class: name }, element('dt', {}, wordOf(name)), element('dd', {}, value))));
}

// A phase or kind of ray that this page knows no word for keeps the server's.
const wordOf = (name) => (has(`numbers.is_${name}`) ? t(`numbers.is_${name}`) : name);

function paceOf(pace) {
  const rate = rateOf(pace.last, performance.now());
  return [
    element('h2', {}, t('numbers.pace')),
    element('p', { class: 'figure rate' },
      rate === null ? t('numbers.atRest') : t('numbers.rate', { rate: numberWords(rate) })),
    ...chartOf(pace),
  ];
}
