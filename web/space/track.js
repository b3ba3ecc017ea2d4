// A track's value between its keys or by its formula, to draw its way: the server's arithmetic
// (core/scene/animation_curves), in double.

import { formula } from './formula.js';
import { tidyVector, turn, add, subtract, length } from './vec.js';

/** The value of a track of numbers at `time`; null of what is no number then. */
export function trackValue(track, time) {
  if (track.formula !== undefined) return formulaValue(track, time);
  const { keys, interpolation = 'linear', repeat = 'once' } = track;
  if (!keys?.length || !listOf(keys[0][1]).every(Number.isFinite)) return null;
  const at = among(keys, repeat, time);
  const after = keys.findIndex(([t]) => t > at);
  if (after === 0) return keys[0][1];
  const i = after < 0 ? keys.length - 1 : after - 1;
  if (after < 0 || interpolation === 'step') return keys[i][1];
  const [from, to] = [knotOf(keys[i]), knotOf(keys[after])];
  const share = eased((at - from.t) / (to.t - from.t), keys[i][2]);
  const numbers = interpolation === 'bezier' ? bezier(keys[i], keys[after], share)
    : interpolation === 'smooth' ? smooth(around(keys, repeat, i), share)
    : from.value.map((p, n) => p + (to.value[n] - p) * share);
  return Array.isArray(keys[i][1]) ? numbers : numbers[0];
}

const read = new Map(); // formulas, by their texts

function formulaValue({ formula: texts, parameters = {} }, time) {
  const numbers = listOf(texts).map((text) => {
    if (!read.has(text)) read.set(text, formula(String(text)));
    return read.get(text)?.({ ...parameters, t: time });
  });
  if (!numbers.every(Number.isFinite)) return null;
  return Array.isArray(texts) ? numbers : numbers[0];
}

const listOf = (value) => (Array.isArray(value) ? value : [value]);
const knotOf = ([t, value]) => ({ t, value: listOf(value) });

// The time after the repeat, within the keys' span.
function among(keys, repeat, time) {
  const [first, last] = [keys[0][0], keys.at(-1)[0]];
  const span = last - first;
  if (repeat === 'once' || !(span > 0) || (first <= time && time < last)) return time;
  const period = repeat === 'loop' ? span : 2 * span;
  const into = (((time - first) % period) + period) % period;
  return first + (into <= span ? into : period - into);
}

function eased(share, ease) {
  const left = 1 - share;
  if (ease === 'in') return share ** 3;
  if (ease === 'out') return 1 - left ** 3;
  if (ease === 'in_out') return share < 0.5 ? 4 * share ** 3 : 1 - 4 * left ** 3;
  return share;
}

function hermite(p, m, q, k, t) {
  const [tt, ttt] = [t * t, t * t * t];
  return (2 * ttt - 3 * tt + 1) * p + (ttt - 2 * tt + t) * m + (3 * tt - 2 * ttt) * q + (ttt - tt) * k;
}

function bezier([t0, p, , leaving], [t1, q, arriving], share) {
  const [a, b, m, k] = [p, q, leaving, arriving].map(listOf);
  return a.map((value, n) => hermite(value, (t1 - t0) * m[n], b[n], (t1 - t0) * k[n], share));
}

// The keys i - 1 to i + 2, as the repeat has them.
function around(keys, repeat, i) {
  const knots = keys.map(knotOf);
  const [first, last] = [knots[0], knots.at(-1)];
  const closed = repeat === 'loop' && String(first.value) === String(last.value);
  const at = (t, { value }) => ({ t, value });
  const before = knots[i - 1] ?? (repeat === 'pingpong' ? at(2 * first.t - knots[1].t, knots[1])
    : closed ? at(first.t - (last.t - knots.at(-2).t), knots.at(-2)) : null);
  const after = knots[i + 2] ?? (repeat === 'pingpong' ? at(2 * last.t - knots.at(-2).t, knots.at(-2))
    : closed ? at(last.t + (knots[1].t - first.t), knots[1]) : null);
  return [before, knots[i], knots[i + 1], after];
}

const smooth = (four, share) => (four[1].value.length === 3 ? catmullRom(four, share) : monotone(four, share));

// Source: Yuksel, Schaefer, Keyser, On the parameterization of Catmull-Rom curves, 2009.
function catmullRom([before, from, to, after], share) {
  const step = (a, b) => Math.sqrt(length(subtract(b.value, a.value)));
  const here = step(from, to);
  if (here === 0) return from.value;
  const [back, on] = [before ? step(before, from) : 0, after ? step(to, after) : 0];
  return from.value.map((p, n) => {
    const q = to.value[n];
    const [o, r] = [before?.value[n], after?.value[n]];
    const m = back > 0 ? here * ((p - o) / back - (q - o) / (back + here) + (q - p) / here) : q - p;
    const k = on > 0 ? here * ((q - p) / here - (r - p) / (here + on) + (r - q) / on) : q - p;
    return hermite(p, m, q, k, share);
  });
}

// Source: Fritsch, Carlson, Monotone piecewise cubic interpolation, 1980.
function monotone([before, from, to, after], share) {
  const secant = (a, b, n) => (b.value[n] - a.value[n]) / (b.t - a.t);
  const slope = (a, at, b, n) => {
    const [left, right] = [secant(a, at, n), secant(at, b, n)];
    if (!(left * right > 0)) return 0;
    const [h, k] = [at.t - a.t, b.t - at.t];
    const most = 3 * Math.min(Math.abs(left), Math.abs(right));
    return Math.min(most, Math.max(-most, (k * left + h * right) / (h + k)));
  };
  const span = to.t - from.t;
  return from.value.map((p, n) => hermite(p,
    span * (before ? slope(before, from, to, n) : secant(from, to, n)), to.value[n],
    span * (after ? slope(from, to, after, n) : secant(from, to, n)), share));
}

const UP = [0, 1, 0];
const ON_AXIS = 1e-3; // of the distance: so near to the axis a circle is a point

/** `count` places on the circle around the vertical axis through `pivot`, from `start` on; null: no circle. */
export function circle(pivot, start, count) {
  const way = subtract(start, pivot);
  if (Math.hypot(way[0], way[2]) <= ON_AXIS * length(way)) return null;
  return Array.from({ length: count }, (_, i) =>
    tidyVector(add(pivot, turn(way, UP, (2 * Math.PI * i) / count)), 5));
}
