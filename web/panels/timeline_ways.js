// Where tracks lead: the ways of lamp, objects and camera, over the picture and in the plans.

import { trackValue } from '../space/track.js';
import { markOf } from '../space/lamp.js';
import { add } from '../space/vec.js';
import { project } from '../space/view.js';
import { valueAt, tokens } from '../state/scene_text.js';
import { lampPlace, placeOf, tracksOf } from '../state/tracks.js';
import { windowOf } from '../state/window.js';
import { svg } from './element.js';

const STEPS = 96; // of a way
const POINTS = /^\/(key_light\/position|lights\/\d+\/position|camera\/location|objects\/\d+\/(center|transform\/\d+\/translate))$/;

/** Draws them from now on. */
export function drawWays(studio, timeline) {
  const layer = document.getElementById('overlay').appendChild(svg('g', { class: 'ways' }));
  let ways = [];
  let of = null; // the scene that they are of

  function follow() {
    if (of === timeline.scene) return;
    of = timeline.scene;
    ways = waysOf(timeline);
    studio.model.tell('ways');
  }

  function over() {
    const { view, pivot, model } = studio;
    if (!pivot) return layer.replaceChildren();
    const window = windowOf(model.request);
    const lamp = document.getElementById('hand').dataset.tool === 'lamp';
    const size = window.height / 90;
    layer.replaceChildren(...ways.filter(({ kind }) => kind === 'object' || (kind === 'lamp' && lamp)).map((way) =>
      drawn(way, (point) => (way.kind === 'lamp' ? markOf(view, window, pivot, point) : project(view, point)), size, timeline.time)));
  }

  studio.drawWays = (group, at) => group.replaceChildren(...ways.map((way) => drawn(way, at, 2.5, timeline.time)));
  studio.model.onFrame('timeline', () => (follow(), over(), studio.model.tell('ways')));
  for (const event of ['source', 'world', 'show']) studio.model.onFrame(event, () => (follow(), over()));
}

function waysOf({ scene, animation: { duration } }) {
  return tracksOf(scene).flatMap((track) => {
    const place = placeOf(scene, track.target);
    if (!track.keys || !POINTS.test(place) || trackValue(track, 0) === null) return [];
    const base = baseOf(scene, place);
    const at = (time) => add(base, trackValue(track, time));
    const points = Array.from({ length: STEPS + 1 }, (_, i) => at((i * duration) / STEPS));
    const kind = place === lampPlace(scene) ? 'lamp' : place.startsWith('/camera') ? 'camera' : 'object';
    const keys = track.keys.length > 60 ? [] : track.keys.map(([time]) => at(time));
    return [{ kind, points, keys, at }];
  });
}

// Where what is shifted stands by itself.
function baseOf(scene, place) {
  const [list, index, part] = tokens(place);
  return (list === 'objects' && part === 'transform' && valueAt(scene, `/objects/${index}/center`)) || [0, 0, 0];
}

// Pieces: what is behind the eye is in none.
function drawn({ kind, points, keys, at }, place, size, time) {
  let d = '';
  let open = false;
  for (const point of points) {
    const to = place(point);
    if (to) d += `${open ? 'L' : 'M'}${to.map((value) => value.toFixed(2)).join(' ')}`;
    open = Boolean(to);
  }
  const dot = (point, r, name) => {
    const to = place(point);
    return to && svg('circle', { class: name, cx: to[0].toFixed(2), cy: to[1].toFixed(2), r });
  };
  const lit = kind === 'lamp'; // which has a mark of its own
  return svg('g', { class: `way way-${kind}` }, svg('path', { class: 'edge', d }), svg('path', { class: 'core', d }),
    keys.map((point) => dot(point, size * 0.8, 'stop')), !lit && dot(at(time), size * 1.3, 'now'));
}
