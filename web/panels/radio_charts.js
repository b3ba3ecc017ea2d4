// What arrives when, as stems, and what the channel does to frequencies, as a line; numbers beside both.

import { kindOf, ticksOf } from '../space/radio.js';
import { BAND_HZ } from '../studio/radio.js';
import { numberWords, t } from '../words/words.js';
import { element, svg } from './element.js';
import { DASHES } from './radio_waves.js';

const SIZE = [380, 200];
const BOX = { left: 44, right: 362, top: 22, bottom: 160 };
const DEEPEST_DB = 70; // below the highest point
const TOLD = 21; // numbers of the response in its table

/** Both charts as { node, draw() }. */
export function radioCharts(radio) {
  const node = element('div', { class: 'radio-charts' });
  function draw() {
    const { paths, channel } = radio.found;
    node.replaceChildren(...(paths.length ? [...impulseChart(paths), ...responseChart(channel.frequency)] : []));
  }
  return { node, draw };
}

const ns = ({ delay_s: delay }) => delay * 1e9;

// The numbers of these stems are the list of paths.
function impulseChart(paths) {
  const gains = paths.map(({ gain_db: gain }) => gain);
  const [first, last] = [ns(paths[0]), ns(paths.at(-1))];
  const room = Math.max((last - first) / 12, first / 50);
  const axes = axesOf([Math.max(0, first - room), last + room], rangeOf(gains, 6), 'delay', 'gain');
  const stem = (path) => {
    const [x, y] = [axes.x(ns(path)), axes.y(Math.max(axes.low, path.gain_db))];
    return svg('g', { class: `stem wave-${kindOf(path)}` }, svg('line', { x1: x, x2: x, y1: BOX.bottom, y2: y, 'stroke-dasharray': DASHES[kindOf(path)] }),
      svg('circle', { cx: x, cy: y, r: 3 }));
  };
  const words = t('radio.impulseTold', { count: paths.length, first: numberWords(first), last: numberWords(last) });
  return [element('h2', {}, t('radio.impulse')), axes.chart(words, paths.map(stem))];
}

function responseChart(frequency) {
  const values = frequency.map(powerDb);
  const offset = (i) => ((i / (values.length - 1) - 0.5) * BAND_HZ) / 1e6;
  const axes = axesOf([-BAND_HZ / 2e6, BAND_HZ / 2e6], rangeOf(values, 1), 'offset', 'gain');
  const points = values.map((value, i) => `${axes.x(offset(i)).toFixed(2)},${axes.y(Math.max(axes.low, value)).toFixed(2)}`).join(' ');
  const told = { high: numberWords(Math.max(...values)), low: numberWords(Math.min(...values)) };
  const every = (values.length - 1) / (TOLD - 1);
  const rows = Array.from({ length: TOLD }, (_, i) => [numberWords(offset(i * every), 4), numberWords(values[i * every], 4)]);
  return [element('h2', {}, t('radio.response')), axes.chart(t('radio.responseTold', told), [svg('polyline', { class: 'curve', points })]),
    element('details', {}, element('summary', {}, t('radio.responseTable')),
      element('table', { class: 'radio-table' }, element('thead', {}, element('tr', {}, ['offset', 'gain'].map((name) => element('th', { scope: 'col' }, t(`radio.${name}`))))),
        element('tbody', {}, rows.map((row) => element('tr', {}, row.map((words) => element('td', {}, words)))))))];
}

/** A gain [receiver port][transmitter port] of [re, im] in dB, the mean of its ports. */
function powerDb(gain) {
  const all = gain.flat().map(([re, im]) => re * re + im * im);
  return 10 * Math.log10(Math.max(all.reduce((sum, power) => sum + power, 0) / all.length, 1e-30));
}

function rangeOf(values, room) {
  const high = Math.max(...values);
  return [Math.max(Math.min(...values), high - DEEPEST_DB) - room, high + room];
}

/** Axes with ticks and units: { x(value), y(value), low, chart(words, nodes) }. */
function axesOf([left, right], [low, high], across, upwards) {
  const x = (value) => BOX.left + ((value - left) / (right - left)) * (BOX.right - BOX.left);
  const y = (value) => BOX.bottom - ((value - low) / (high - low)) * (BOX.bottom - BOX.top);
  const label = (at, down, anchor, words) => svg('text', { x: at, y: down, 'text-anchor': anchor }, words);
  const grid = (x1, y1, x2, y2) => svg('line', { class: 'grid', x1, y1, x2, y2 });
  const chart = (words, nodes) => svg('svg', { class: 'radio-chart', viewBox: `0 0 ${SIZE.join(' ')}`, role: 'img', 'aria-label': words },
    ticksOf(left, right, 6).flatMap((tick) => [grid(x(tick), BOX.top, x(tick), BOX.bottom), label(x(tick), BOX.bottom + 15, 'middle', numberWords(tick, 4))]),
    ticksOf(low, high, 5).flatMap((tick) => [grid(BOX.left, y(tick), BOX.right, y(tick)), label(BOX.left - 5, y(tick) + 4, 'end', numberWords(tick, 4))]),
    svg('path', { class: 'axes', d: `M${BOX.left} ${BOX.top}V${BOX.bottom}H${BOX.right}` }),
    label(0, 12, 'start', t(`radio.${upwards}`)), label(BOX.right, BOX.bottom + 33, 'end', t(`radio.${across}`)), nodes);
  return { x, y, low, chart };
}
