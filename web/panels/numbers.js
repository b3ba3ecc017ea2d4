// What the last picture took, and how fast they come. Nothing is drawn while nobody looks.

import { Pace, rateOf } from '../picture/pace.js';
import { totalMs } from '../picture/timing.js';
import { windowOf } from '../state/window.js';
import { countWords, has, msWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { chartOf } from './numbers_chart.js';

const REST_MS = 1000;

export function mountNumbers(studio) {
  const { model } = studio;
  const pace = new Pace();
  const [figures, pictures] = [element('div', { class: 'figures' }), element('div', { class: 'figures' })];
  document.getElementById('panel-numbers').append(figures, pictures);
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
