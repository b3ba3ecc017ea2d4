// Where tracks lead: the ways of lamp, objects and camera, over the picture and in the plans.

import { trackValue } from '../space/track.js';
import { markOf } from '../space/lamp.js';
import { add, tidyVector } from '../space/vec.js';
import { project } from '../space/view.js';
import { middleOf } from '../state/bodies.js';
import { valueAt, tokens } from '../state/scene_text.js';
import { lampPlace, placeOf, tracksOf } from '../state/tracks.js';
import { windowOf } from '../state/window.js';
import { t } from '../words/words.js';
import { svg } from './element.js';

const [STEPS, BODY_STEPS] = [96, 240]; // of a way
const BESIDE = 9;
const POINTS = /^\/(key_light\/position|lights\/\d+\/position|camera\/location|objects\/\d+\/(center|transform\/\d+\/translate))$/;

/** Draws them from now on. */
export function drawWays(studio, timeline, bodies) {
  const layer = document.getElementById('overlay').appendChild(svg('g', { class: 'ways' }));
  let ways = [];
  let of = []; // the scene that they are of, and its bodies' motion

  function follow() {
    if (of[0] === timeline.scene && of[1] === bodies.motion) return;
    of = [timeline.scene, bodies.motion];
    ways = [...waysOf(timeline), ...bodyWays(timeline, bodies)];
    studio.model.tell('ways');
  }

  function over() {
    const { view, pivot, model } = studio;
    if (!pivot) return layer.replaceChildren();
    const window = windowOf(model.request);
    const lamp = document.getElementById('hand').dataset.tool === 'lamp';
    const size = window.height / 90;
    layer.replaceChildren(...ways.filter(({ kind }) => kind === 'object' || kind === 'body' || (kind === 'lamp' && lamp)).map((way) =>
      drawn(way, (point) => (way.kind === 'lamp' ? markOf(view, window, pivot, point) : project(view, point)), size, timeline.time)));
  }

  studio.drawWays = (group, at) => group.replaceChildren(...ways.map((way) => drawn(way, at, 2.5, timeline.time)),
    ...arrowsOf(bodies).map(({ from, to }) => arrow(at(from), at(to))));
  studio.placeArrows = (plan) => placeArrows(bodies, plan);
  studio.model.onFrame('timeline', () => (follow(), over(), studio.model.tell('ways')));
  for (const event of ['source', 'world', 'show', 'motion']) studio.model.onFrame(event, () => (follow(), over()));
}

function waysOf({ scene, animation: { duration } }) {
  return tracksOf(scene).flatMap((track) => {
    const place = placeOf(scene, track.target);
    if (!POINTS.test(place) || trackValue(track, 0)?.length !== 3) return [];
    const base = baseOf(scene, place);
    const at = (time) => add(base, trackValue(track, time) ?? [NaN, NaN, NaN]);
    const points = Array.from({ length: STEPS + 1 }, (_, i) => at((i * duration) / STEPS));
    const kind = place === lampPlace(scene) ? 'lamp' : place.startsWith('/camera') ? 'camera' : 'object';
    const keys = !track.keys || track.keys.length > 60 ? [] : track.keys.map(([time]) => at(time));
    return [{ kind, points, keys, at }];
  });
}

function bodyWays({ animation: { duration } }, bodies) {
  return bodies.ways.map((way) => ({ kind: 'body', keys: bodies.contactsAt(way), at: way.at,
    points: Array.from({ length: BODY_STEPS + 1 }, (_, i) => way.at((i * duration) / BODY_STEPS)) }));
}

// The velocities of what is to fall: from a body's place to where it would be after a second.
function arrowsOf(bodies) {
  const { scene } = bodies;
  return bodies.roles.filter(({ role }) => role === 'falls').map(({ index, name, body: { velocity } }) => {
    const from = middleOf(scene.objects[index]);
    return { index, name, velocity, from, to: add(from, velocity) };
  });
}

// What takes arrows in a plan, beside their tips: the tip of none is where its body is taken.
function placeArrows(bodies, { map, names, at, handle, drop }) {
  const arrows = arrowsOf(bodies);
  for (const name of names)
    if (name.startsWith('arrow') && !arrows.some(({ index }) => name === `arrow-${index}`)) drop(name);
  for (const { index, name, to } of arrows) {
    let taken = null;
    handle(`arrow-${index}`, at(to).map((value) => value + BESIDE), t('timeline.moveVelocity', { name, map }), {
      take: () => (taken = bodies.roles[index].body.velocity),
      move: (way) => bodies.set(index, { velocity: tidyVector(add(taken, way), 4) }),
    });
  }
}

function arrow([x1, y1], [x2, y2]) {
  return svg('g', { class: 'way way-arrow' }, ['edge', 'core'].map((name) => svg('line', { class: name, x1, y1, x2, y2 })));
}

// Where what is shifted stands by itself.
function baseOf(scene, place) {
  const [list, index, part] = tokens(place);
  return (list === 'objects' && part === 'transform' && valueAt(scene, `/objects/${index}/center`)) || [0, 0, 0];
}

// Where a formula is not defined there is no point.
const there = (point, place) => (point.every(Number.isFinite) ? place(point) : null);

// Pieces: what is behind the eye is in none.
function drawn({ kind, points, keys, at }, place, size, time) {
  let d = '';
  let open = false;
  for (const point of points) {
    const to = there(point, place);
    if (to) d += `${open ? 'L' : 'M'}${to.map((value) => value.toFixed(2)).join(' ')}`;
    open = Boolean(to);
  }
  const dot = (point, r, name) => {
    const to = there(point, place);
    return to && svg('circle', { class: name, cx: to[0].toFixed(2), cy: to[1].toFixed(2), r });
  };
  const lit = kind === 'lamp'; // which has a mark of its own
  return svg('g', { class: `way way-${kind}` }, svg('path', { class: 'edge', d }), svg('path', { class: 'core', d }),
    keys.map((point) => dot(point, size * 0.8, 'stop')), !lit && dot(at(time), size * 1.3, 'now'));
}
