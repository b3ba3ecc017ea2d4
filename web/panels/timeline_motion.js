// What bodies do, below the time axis: contacts as dots, heights and energy as small curves.

import { t, numberWords } from '../words/words.js';
import { element, svg } from './element.js';
import { secondsWords } from './timeline_words.js';

const [WIDE, HIGH] = [1000, 60];
const SAMPLES = 200;
const MOST_DOTS = 300;
const MOST_TOLD = 8;
const MOST_CURVES = 8;
// Of [t, kinetic, potential], above the lowest potential.
const PARTS = {
  kinetic: ([, kinetic]) => kinetic,
  potential: ([, , potential], low) => potential - low,
  total: ([, kinetic, potential], low) => kinetic + potential - low,
};

/** The lanes as { node, draw() }. */
export function motionLanes(timeline, bodies) {
  const node = element('div', { class: 'motion' });
  let drawn = null;

  function draw() {
    const { motion } = bodies;
    node.hidden = !motion;
    if (motion === drawn) return;
    drawn = motion;
    node.replaceChildren(...(motion ? lanes(timeline, bodies, motion) : []));
  }

  return { node, draw };
}

function lanes({ animation: { duration } }, bodies, { contacts, energy }) {
  return [
    lane('contacts', contactsWords(contacts), dots(contacts, duration)),
    lane('heights', heightsWords(bodies), heights(bodies, duration),
      bodies.ways.slice(0, MOST_CURVES).map(({ index }, i) => [`body-${i % 4}`, bodies.roles[index].name])),
    lane('energy', energyWords(energy), energies(energy, duration), Object.keys(PARTS).map((name) => [name, t(`timeline.energy_${name}`)])),
  ];
}

// `kinds` are told by their colours: [[class, words]].
function lane(name, words, drawing, kinds = []) {
  const legend = kinds.map(([kind, told]) => element('span', { class: `kind ${kind}` }, told));
  return element('div', { class: `motion-lane motion-${name}` },
    element('p', { class: 'note' }, t(`timeline.${name}`), legend),
    svg('svg', { viewBox: `0 0 ${WIDE} ${HIGH}`, preserveAspectRatio: 'none', role: 'img', 'aria-label': words }, drawing));
}

// Round in whatever box they stand: lines of no length with round ends.
function dots(contacts, duration) {
  const d = contacts.slice(0, MOST_DOTS).map(({ time }) => `M${((time / duration) * WIDE).toFixed(1)} ${HIGH / 2}h0`).join('');
  return [svg('path', { class: 'dots', d })];
}

/** "ball and floor at 0.45 s, ..." */
function contactsWords(contacts) {
  const told = contacts.slice(0, MOST_TOLD).map(({ time, a, b }) => t('timeline.contact', { a, b, at: secondsWords(time) })).join(', ');
  return t('timeline.contactsTold', { count: contacts.length, told });
}

function curve(values, [low, high], name) {
  const y = (value) => (HIGH - 4 - ((value - low) / (high - low || 1)) * (HIGH - 8)).toFixed(1);
  const d = values.map(([share, value], i) => `${i ? 'L' : 'M'}${(share * WIDE).toFixed(1)} ${y(value)}`).join('');
  return svg('path', { class: `curve ${name}`, d });
}

const rangeOf = (values) => [Math.min(...values), Math.max(...values)];

function heights(bodies, duration) {
  const all = bodies.ways.slice(0, MOST_CURVES).map((way) => Array.from({ length: SAMPLES + 1 }, (_, i) =>
    [i / SAMPLES, bodies.heightOf(way, (i / SAMPLES) * duration)]));
  const range = rangeOf(all.flat().map(([, value]) => value));
  return all.map((values, i) => curve(values, range, `body-${i % 4}`));
}

function heightsWords(bodies) {
  return t('timeline.heightsTold', { names: bodies.ways.slice(0, MOST_TOLD).map(({ index }) => bodies.roles[index].name).join(', ') });
}

function energies(energy, duration) {
  if (!energy.length) return [];
  const step = Math.max(1, Math.floor(energy.length / 1000));
  const some = energy.filter((_, i) => i % step === 0 || i === energy.length - 1);
  const low = Math.min(...some.map(([, , potential]) => potential));
  const range = rangeOf(some.flatMap((one) => Object.values(PARTS).map((of) => of(one, low))));
  return Object.entries(PARTS).map(([name, of]) => curve(some.map((one) => [one[0] / duration, of(one, low)]), range, name));
}

function energyWords(energy) {
  const total = ([, kinetic, potential]) => numberWords(kinetic + potential);
  return energy.length ? t('timeline.energyTold', { from: total(energy[0]), to: total(energy.at(-1)) }) : '';
}
