// The error of a picture's rounds against the time that they took, on axes by powers of ten, beside
// the line that chance alone follows. Loaded with the first chart of it.

import { pixelsOf } from '../picture/difference.js';
import { errorsOf, slopeOf } from '../picture/errors.js';
import { countWords, msWords, numberWords, t } from '../words/words.js';
import { element, svg } from './element.js';

const BOX = { left: 46, right: 350, top: 20, bottom: 176 };
const MOST_TICKS = 5;
const ROOM = 1.6; // around the points, as a factor

const percent = (error) => `${numberWords(100 * error, 2)} %`;
const timeWords = (ms) => (ms < 1000 ? msWords(ms) : `${numberWords(ms / 1000)} s`);
const read = async (blob) => (await pixelsOf(blob)).data;

/** The chart and its table of rounds [{ samples, ms, blob }], the finest last; `ms` 0: not known. */
export async function errorChart(rounds) {
  const errors = await errorsOf(rounds, read);
  const points = errors.filter(({ ms, error }) => ms > 0 && error > 0);
  const measured = points.filter(({ expected }) => !expected).map(({ ms, error }) => [ms, error]);
  const slope = measured.length > 1 && t('numbers.errorSlope', { slope: numberWords(slopeOf(measured), 2) });
  return [
    element('h2', {}, t('numbers.error')),
    points.length > 1 && chartOf(points),
    element('p', { class: 'note', id: 'error-about' }, t('numbers.errorAbout'), ' ', slope),
    tableOf(errors),
  ].filter(Boolean);
}

function tableOf(errors) {
  const heads = ['take.samples', 'numbers.is_trace', 'numbers.isError']
    .map((name) => element('th', { scope: 'col' }, t(name)));
  const row = ({ samples, ms, error, expected }) => [countWords(samples), ms > 0 ? msWords(ms) : '\u2013',
    `${expected ? '\u2248 ' : ''}${percent(error)}`].map((words) => element('td', {}, words));
  return element('table', {}, element('tr', {}, heads), errors.map((one) => element('tr', {}, row(one))));
}

function chartOf(points) {
  const x = axisOf(points.map(({ ms }) => ms), BOX.left, BOX.right);
  const y = axisOf(points.map(({ error }) => error), BOX.bottom, BOX.top);
  const place = ({ ms, error }) => [x.at(ms), y.at(error)];
  return svg('svg', { class: 'errors', viewBox: '0 0 360 214', role: 'img', 'aria-label': t('numbers.error'),
    'aria-describedby': 'error-about' },
    x.ticks.flatMap((ms) => [line([x.at(ms), BOX.top], [x.at(ms), BOX.bottom], 'grid'),
      label(x.at(ms), BOX.bottom + 15, 'middle', timeWords(ms))]),
    y.ticks.flatMap((error) => [line([BOX.left, y.at(error)], [BOX.right, y.at(error)], 'grid'),
      label(BOX.left - 5, y.at(error) + 4, 'end', percent(error))]),
    label(0, 11, 'start', t('numbers.isError')),
    label(BOX.right, BOX.bottom + 33, 'end', t('numbers.is_trace')),
    lawBeside(points, x, y),
    svg('polyline', { points: points.map(place).join(' ') }),
    points.map((one) => svg('circle', { class: one.expected ? 'expected' : null,
      cx: place(one)[0], cy: place(one)[1], r: 4 })));
}

// A little above the points, as wide as they are.
function lawBeside(points, x, y) {
  const [first, last] = [points[0], points.at(-1)];
  const sum = points.reduce((before, { ms, error }) => before + Math.log(error * Math.sqrt(ms)), 0);
  const mean = Math.exp(sum / points.length);
  const at = ({ ms }) => [x.at(ms), y.at((1.3 * mean) / Math.sqrt(ms))];
  const [[x1, y1], [x2, y2]] = [at(first), at(last)];
  return [line([x1, y1], [x2, y2], 'law'), label((x1 + x2) / 2 + 4, (y1 + y2) / 2 - 6, 'start', '\u2212\u00bd')];
}

const line = ([x1, y1], [x2, y2], name) => svg('line', { class: name, x1, y1, x2, y2 });
const label = (x, y, anchor, words) => svg('text', { x, y, 'text-anchor': anchor }, words);

/** An axis by powers of ten from place `from` to `to`: { at(value), ticks }. */
function axisOf(values, from, to) {
  const [least, most] = [Math.min(...values) / ROOM, Math.max(...values) * ROOM];
  const at = (value) => from + ((to - from) * Math.log(value / least)) / Math.log(most / least);
  return { at, ticks: ticksOf(least, most) };
}

function ticksOf(least, most) {
  const by = (steps) => {
    const ticks = [];
    for (let ten = Math.floor(Math.log10(least)); ten <= Math.log10(most); ++ten)
      ticks.push(...steps.map((step) => Number(`${step}e${ten}`)).filter((tick) => tick >= least && tick <= most));
    return ticks;
  };
  const all = [[1, 2, 5], [1, 3], [1]].map(by);
  return all.find(({ length }) => length <= MOST_TICKS) ?? all.at(-1);
}
