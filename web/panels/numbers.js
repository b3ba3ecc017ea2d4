// What the last picture took, and how fast they come. Nothing is drawn while nobody looks.

import { isChance } from '../picture/integrators.js';
import { countOf, median, Pace, rateOf, totalMs } from '../picture/timing.js';
import { ONE_RAY, queryOf } from '../state/request.js';
import { pixelsOf, windowOf } from '../state/window.js';
import { countWords, has, msWords, numberWords, t } from '../words/words.js';
import { element, svg } from './element.js';

const [WIDTH, HEIGHT, STEP] = [360, 96, 3]; // of 120 bars
const FLUENT_MS = 1000 / 30;

/** The chart, and what its colours mean. */
function chartOf(pace) {
  const { last, counts } = pace;
  const times = last.filter(({ kind }) => kind !== 'failed').map(({ ms }) => ms);
  const most = Math.max(2 * FLUENT_MS, Math.min(4 * (median(times) || 0), Math.max(...times))); // at rest there is time
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
  const height = kind === 'failed' ? HEIGHT : Math.min(HEIGHT, Math.max(1, (ms / most) * HEIGHT));
  return svg('rect', { class: kind, x, y: HEIGHT - height, width: STEP - 1, height });
}

const REST_MS = 1000;

export default function mountNumbers(studio, panel) {
  const { model } = studio;
  const pace = new Pace();
  const [figures, errors, pictures] = [1, 2, 3].map(() => element('div', { class: 'figures' }));
  panel.append(figures, errors, pictures);
  let rounds = []; // of the picture wanted: { samples, ms, blob }
  let resting;

  const open = () => studio.tab === 'tab-numbers';
  const drawFigures = () => model.shown && figures.replaceChildren(...figuresOf(model.shown));
  const drawPace = () => pictures.replaceChildren(...paceOf(pace));

  function keepRound({ request, rays, timing, blob }) {
    const pixels = pixelsOf(request);
    const samples = countOf(rays, 'primary') / pixels;
    if (!isChance(request.integrator ?? model.source?.options?.integrator)) errors.replaceChildren();
    // One sample is through the pixel's centre: the mean of many is another picture.
    else if (samples > 1 && pixels === pixelsOf(model.request) && matterOf(request) === matterOf(model.request)) {
      const ms = timing.find(({ name }) => name === 'trace')?.ms ?? 0;
      rounds = [...rounds.filter((one) => one.samples < samples), { samples, ms, blob }];
    }
  }

  async function drawErrors() {
    const mine = rounds;
    if (mine.length < 2) return; // what was told last stays until there is something to tell
    const nodes = await import('./error_chart.js').then(({ errorChart }) => errorChart(mine));
    if (mine === rounds) errors.replaceChildren(...nodes);
  }
  const drawAll = () => (drawFigures(), drawPace(), drawErrors().catch((error) => console.warn(error.message)));

  function came(kind) {
    pace.add({ at: performance.now(), ms: kind === 'failed' ? 0 : model.shown.ms, kind });
    if (kind !== 'failed') keepRound(model.shown);
    if (!open()) return;
    drawAll();
    clearTimeout(resting);
    resting = setTimeout(() => open() && drawPace(), REST_MS + 1);
  }

  model.on('want', () => (rounds = []));
  model.on('show', () => came(model.shown.cached ? 'cached' : 'drawn'));
  model.on('fail', () => came('failed'));
  model.on('tab', () => open() && drawAll());
}

function figuresOf(shown) {
  const { timing, rays, noise, biased, ignored, blob, ms, request } = shown;
  const { width, height } = windowOf(request);
  const phases = timing.filter(({ name }) => name !== 'total');
  const traced = rays.filter(({ name }) => name !== 'cut'); // which counts paths
  const all = traced.reduce((sum, { count }) => sum + count, 0);
  return [
    element('h2', {}, t('numbers.server')),
    element('p', { class: 'figure' }, phases.length ? msWords(totalMs(timing)) : t('numbers.untold')),
    bar(phases.map(({ name, ms }) => ({ name, value: ms }))),
    list('phases', phases.map(({ name, ms }) => [name, msWords(ms)])),
    element('p', { class: 'note from' }, t(`numbers.${sourceOf(shown)}`)),
    element('h2', {}, t('numbers.rays')),
    element('p', { class: 'figure' }, rays.length ? countWords(all) : t('numbers.untold')),
    bar(traced.map(({ name, count }) => ({ name, value: count }))),
    list('kinds', rays.map(({ name, count }) => [name, countWords(count)])),
    element('h2', {}, t('numbers.picture')),
    list('whole', [
      ['shown', msWords(ms)],
      ['size', `${width} \u00d7 ${height}`],
      ['bytes', countWords(blob.size)],
      ['each', numberWords(all / (width * height))],
      ['noise', noise && numberWords(Number(noise))],
      ['biased', biased],
      ['ignored', ignored],
    ].filter(([, value]) => value)),
  ];
}

// What a request asks for but for how many rays.
const matterOf = (request) => queryOf({ ...request, ...ONE_RAY });

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
