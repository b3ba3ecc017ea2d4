// The tracks as rows: a lane of keys each, which pointer and arrow keys move, below one time axis.

import { tracksOf } from '../state/tracks.js';
import { numberText } from '../state/request.js';
import { t } from '../words/words.js';
import { element, svg } from './element.js';
import { secondsWords, trackName } from './timeline_words.js';

const MOST_KEYS = 60; // of a track, that a hand can take: those of a simulation are drawn alone
const STEPS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 };
const SLOP_PX = 3;

/** The rows as { node, draw() }; `scrub`, the slider of the time, stands above them, `more` below. */
export function trackRows(timeline, scrub, more) {
  const ticks = element('div', { class: 'ticks', 'aria-hidden': 'true' });
  const head = element('div', { class: 'playhead', 'aria-hidden': 'true' });
  const list = element('ul', { class: 'tracks' });
  const node = element('div', { class: 'lanes' }, scrub, ticks, list, more, head);
  let drawn = '';

  function draw() {
    const { scene, animation, chosen } = timeline;
    node.style.setProperty('--at', timeline.time / animation.duration);
    const now = JSON.stringify([animation, chosen, tracksOf(scene).map(({ target }) => trackName(scene, target))]);
    if (now === drawn || node.querySelector('[data-held]')) return;
    drawn = now;
    const focus = focusIn(node);
    ticks.replaceChildren(...ticksOf(animation.duration));
    list.replaceChildren(...tracksOf(scene).map((track, at) => row(timeline, track, at)));
    focus?.();
  }

  return { node, draw };
}

// What puts the focus back on what has it once its rows are made anew.
function focusIn(node) {
  const { name } = node.contains(document.activeElement) ? document.activeElement.dataset : {};
  return name && (() => node.querySelector(`[data-name="${name}"]`)?.focus({ preventScroll: true }));
}

const leftOf = (share) => ({ left: `calc(var(--inset) + ${share} * (100% - 2 * var(--inset)))` });

function ticksOf(duration) {
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000, 20000].find((one) => duration / one <= 10) ?? duration;
  const count = Math.floor(duration / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, i) =>
    element('span', { style: leftOf((i * step) / duration) }, secondsWords(i * step)));
}

function row(timeline, track, at) {
  const name = trackName(timeline.scene, track.target);
  const chosen = timeline.chosen?.track === at;
  const choose = () => timeline.choose({ track: at, key: null });
  return element('li', { class: chosen ? 'track chosen' : 'track' },
    element('div', { class: 'track-head' },
      element('button', { type: 'button', class: 'track-name', 'aria-pressed': chosen, dataset: { name: `track-${at}` }, onclick: choose }, name),
      track.keys && element('button', { type: 'button', class: 'track-add', 'aria-label': t('timeline.addIn', { name }),
        title: t('timeline.addIn', { name }), dataset: { name: `add-${at}` }, onclick: () => timeline.addIn(at) }, '+')),
    lane(timeline, track, at, name));
}

function lane(timeline, track, at, name) {
  const { duration } = timeline.animation;
  const made = element('div', { class: 'lane', role: 'group', 'aria-label': name });
  const bar = (from, to) => element('span', { class: 'bar-line', 'aria-hidden': 'true',
    style: { ...leftOf(from / duration), width: `calc(${(Math.min(to, duration) - from) / duration} * (100% - 2 * var(--inset)))` } });
  if (track.formula) made.append(element('code', {}, [track.formula].flat().join(', ')));
  if (track.visible) made.append(...track.visible.map(([from, to]) => bar(from, to)));
  if (track.keys) {
    made.append(bar(track.keys[0][0], track.keys.at(-1)[0]));
    if (track.keys.length > MOST_KEYS) made.append(manyKeys(track.keys, duration, name));
    else made.append(...track.keys.map((key, index) => keyMark(timeline, track, at, index, name)));
  }
  bindScrub(made, timeline);
  return made;
}

function manyKeys(keys, duration, name) {
  const d = keys.map(([time]) => `M${((1000 * time) / duration).toFixed(1)} 0v10`).join('');
  return svg('svg', { class: 'many', viewBox: '0 0 1000 10', preserveAspectRatio: 'none', role: 'img',
    'aria-label': t('timeline.manyKeys', { name, count: keys.length }) }, svg('path', { d }));
}

function keyMark(timeline, { keys }, track, index, name) {
  const { duration } = timeline.animation;
  const [time] = keys[index];
  const { chosen } = timeline;
  const mark = element('span', {
    class: chosen?.track === track && chosen.key === index ? 'key chosen' : 'key', role: 'slider', tabindex: 0,
    'aria-label': t('timeline.keyOf', { name, at: index + 1, count: keys.length }),
    'aria-valuemin': 0, 'aria-valuemax': numberText(duration), 'aria-keyshortcuts': 'Delete',
    dataset: { name: `key-${track}-${index}`, track, key: index },
  });
  const choose = () => {
    if (chosen?.track !== track || chosen.key !== index) timeline.choose({ track, key: index });
  };
  const place = (to) => {
    Object.assign(mark.style, leftOf(to / duration));
    mark.setAttribute('aria-valuenow', numberText(Number(to.toFixed(3))));
    mark.setAttribute('aria-valuetext', t('timeline.seconds', { at: secondsWords(to) }));
  };
  place(time);
  mark.addEventListener('keydown', (event) => press(event, timeline, track, index, choose));
  bindDrag(mark, timeline, { time, place, choose, end: (to) => timeline.moveKey(track, index, to) });
  return mark;
}

function press(event, timeline, track, index, choose) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const { fps } = timeline.animation;
  const [time] = tracksOf(timeline.scene)[track].keys[index];
  const by = STEPS[event.key] * (event.shiftKey ? 10 : 1);
  const acts = {
    Enter: () => (choose(), timeline.seek(time)),
    ' ': () => (choose(), timeline.seek(time)),
    Delete: () => remove(timeline, event.target, track, index),
    Backspace: () => remove(timeline, event.target, track, index),
  };
  if (!by && !acts[event.key]) return;
  event.preventDefault();
  if (by) timeline.moveKey(track, index, time + by / fps, true);
  else acts[event.key]();
}

// The focus goes on to a neighbour, or to what adds a key.
function remove(timeline, mark, track, index) {
  const lanes = mark.closest('.lanes');
  timeline.removeKey(track, index);
  requestAnimationFrame(() => { // when the rows are made anew
    const next = [`key-${track}-${index}`, `key-${track}-${index - 1}`, `track-${track}`, `track-${track - 1}`]
      .map((name) => lanes.querySelector(`[data-name="${name}"]`)).find(Boolean);
    (next ?? lanes.querySelector('input')).focus();
  });
}

// Where in the lane a pointer is, in seconds.
function timeUnder(event, lane, timeline) {
  const { left, width } = lane.getBoundingClientRect();
  const inset = parseFloat(getComputedStyle(lane).getPropertyValue('--inset-px')) || 8;
  const { fps, duration } = timeline.animation;
  const share = Math.min(1, Math.max(0, (event.clientX - left - inset) / (width - 2 * inset)));
  return Math.min(duration, Math.round(share * duration * fps) / fps);
}

function bindDrag(mark, timeline, { time, place, choose, end }) {
  let start = null;
  let to = time;
  mark.addEventListener('pointerdown', (event) => {
    if (event.button) return;
    event.preventDefault();
    event.stopPropagation();
    mark.setPointerCapture(event.pointerId);
    mark.focus({ preventScroll: true });
    [start, to] = [event.clientX, time];
    mark.dataset.held = '';
  });
  mark.addEventListener('pointermove', (event) => {
    if (start === null || (to === time && Math.abs(event.clientX - start) < SLOP_PX)) return;
    to = timeUnder(event, mark.parentElement, timeline);
    place(to);
  });
  const drop = (event) => {
    if (start === null) return;
    start = null;
    delete mark.dataset.held;
    if (event.type === 'pointerup' && to !== time) end(to);
    choose();
  };
  for (const event of ['pointerup', 'pointercancel', 'lostpointercapture']) mark.addEventListener(event, drop);
}

// A press on the lane goes there in time.
function bindScrub(made, timeline) {
  let held = false;
  const go = (event) => timeline.seek(timeUnder(event, made, timeline));
  made.addEventListener('pointerdown', (event) => {
    if (event.button) return;
    made.setPointerCapture(event.pointerId);
    held = true;
    go(event);
  });
  made.addEventListener('pointermove', (event) => held && go(event));
  for (const event of ['pointerup', 'pointercancel', 'lostpointercapture']) made.addEventListener(event, () => (held = false));
}
