// The timeline's panel.

import { StoredScene } from '../picture/stored_scene.js';
import { momentIn } from '../state/tracks.js';
import { Bodies } from '../studio/bodies.js';
import { Timeline } from '../studio/timeline.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { addForm } from './timeline_add.js';
import { Clock } from './timeline_clock.js';
import { fallForm } from './timeline_fall.js';
import { filmForm } from './timeline_film.js';
import { keyForm } from './timeline_key.js';
import { motionLanes } from './timeline_motion.js';
import { trackRows } from './timeline_rows.js';
import { transport } from './timeline_transport.js';
import { drawWays } from './timeline_ways.js';
import { secondsWords } from './timeline_words.js';

const GONE = 404;

export const style = 'panels/timeline.css';

export default function mountTimeline(studio, panel) {
  const { model } = studio;
  const timeline = (studio.timeline ??= new Timeline(studio)); // or of what was held
  const bodies = new Bodies(studio, timeline);
  const told = element('p', { class: 'told', role: 'status' });
  const tell = (words) => (told.textContent = words);
  const clock = new Clock(timeline, () => (draw(), clock.playing ? tell('') : tell(momentWords(timeline, bodies))));
  const controls = transport(timeline, clock);
  const motion = motionLanes(timeline, bodies);
  const begun = () => {
    timeline.seek(0);
    controls.toggle.focus();
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) clock.play();
  };
  const parts = [controls, trackRows(timeline, controls.scrub, motion.node), keyForm(timeline, () => controls.scrub.focus()),
    addForm(studio, timeline, tell), fallForm(timeline, bodies, { tell, begun }), settings(studio, timeline), filmForm(studio, timeline)];
  const models = element('p', { class: 'note' }, t('timeline.models'));
  const box = element('div', { class: 'timeline' }, ...parts.slice(0, 5).map(({ node }) => node), told, ...parts.slice(5).map(({ node }) => node));
  panel.append(models, box);

  function draw() {
    models.hidden = !model.request.model;
    box.hidden = Boolean(model.request.model);
    if (!box.hidden && studio.tab === 'tab-timeline') for (const part of [...parts, motion]) part.draw();
  }

  for (const event of ['timeline', 'want', 'source', 'held', 'motion', 'tab']) model.onFrame(event, draw);
  for (const event of ['source', 'tab']) model.on(event, () => begin(studio));
  bindUndo(studio, box);
  carryWhilePlaying(studio, clock);
  drawWays(studio, timeline, bodies);
  begin(studio);
  draw();
}

// What moves is seen at a moment of it.
function begin({ tab, model }) {
  const time = momentIn(model.source, model.request.time ?? 0);
  if (tab === 'tab-timeline' && time !== null && !model.request.model && model.request.time !== time) model.change({ time });
}

function momentWords({ time, animation: { duration } }, bodies) {
  const moment = t('timeline.of', { at: secondsWords(time), all: secondsWords(duration) });
  const last = bodies.lastUntil(time);
  return last ? t('timeline.since', { moment, a: last.a, b: last.b, at: secondsWords(last.time) }) : moment;
}

// Undo and redo as in the scene's text, whose steps they are.
function bindUndo({ steps }, box) {
  box.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.matches('input:not([type=range], [type=checkbox])')) return;
    const act = { z: event.shiftKey ? steps.redo : steps.undo, y: steps.redo }[event.key.toLowerCase()];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

// A scene of one's own goes to the server once while it plays, not with each of its moments.
function carryWhilePlaying(studio, clock) {
  const stored = new StoredScene();
  const { model } = studio;
  const plain = studio.carry;
  const carried = (request) => stored.carry(request);
  const follow = () => (studio.carry = clock.playing ? carried : plain);
  model.on('timeline', follow);
  model.on('rest', () => clock.playing || stored.drop());
  model.on('fail', (_, { status }) => {
    clock.wait();
    if (status !== GONE || !clock.playing) return;
    stored.giveUp();
    studio.again();
  });
  model.on('show', () => clock.goOn());
  model.on('held', () => Object.keys(studio.held.values).length && clock.pause());
  addEventListener('pagehide', () => (clock.pause(), stored.drop()));
}

// How long, how often, one step back, and on from here.
function settings(studio, timeline) {
  const { model, steps } = studio;
  const number = (name, least, most, step) => {
    const input = element('input', { type: 'number', min: least, max: most, step, onchange: () => {
      if (input.checkValidity() && input.value) timeline.set(name, input.valueAsNumber);
      draw();
    } });
    return [name, input, element('label', {}, element('span', {}, t(`timeline.${name}`)), input)];
  };
  const numbers = [number('duration', 0.01, 86400, 'any'), number('fps', 1, 240, 'any')];
  const button = (name, press) => element('button', { type: 'button', onclick: press }, t(`timeline.${name}`));
  const [undo, redo, hold] = [button('undo', steps.undo), button('redo', steps.redo), button('hold', () =>
    studio.open({ ...model.request, scene: model.world, time: null, key: null, light: null, camera: null }, model.world))];

  function draw() {
    for (const [name, input] of numbers) if (input !== document.activeElement) input.value = timeline.animation[name];
    [undo.disabled, redo.disabled] = [!steps.canUndo, !steps.canRedo];
    hold.hidden = !timeline.moves;
  }

  model.on('world', () => requestAnimationFrame(draw));
  return { draw, node: element('div', { class: 'settings' },
    element('div', { class: 'row wrap' }, undo, redo, hold),
    element('div', { class: 'take-form' }, ...numbers.map(([, , label]) => label))) };
}
