// The lamp on a sphere around what one looks at. In the picture the sphere is unrolled: its side
// towards the eye in the middle, its rim on a ring, what is behind outside of it (the azimuthal
// equidistant projection), so that a hand can reach everywhere.

import { add, dot, length, scale, subtract } from './vec.js';

const RING = 0.36; // of the window's height: where the lamp stands a quarter round
const MOST_AWAY = 1e8; // from what one looks at
const FARTHEST = 170; // degrees: straight behind it has no single place in the picture

/** Where the lamp's mark stands in the picture, [x, y] in pixels, of whose `window` one sees. */
export function markOf(view, window, pivot, light) {
  const way = subtract(light, pivot);
  const [x, y, z] = [dot(way, view.across), dot(way, view.upwards), -dot(way, view.axis)];
  const around = Math.hypot(x, y);
  const ring = ringRadius(window);
  const far = (ring * Math.atan2(around, z)) / (Math.PI / 2);
  const [s, t] = around > 0 ? [x / around, y / around] : [0, 0];
  const [x0, y0] = centreOf(window);
  return [x0 + s * far, y0 - t * far];
}

/** Where the lamp stands whose mark is at `x`, `y`, at `distance` from the pivot. */
export function lampAt(view, window, pivot, distance, [x, y]) {
  const [x0, y0] = centreOf(window);
  const [s, t] = [x - x0, y0 - y];
  const far = Math.hypot(s, t);
  const angle = Math.min((far / ringRadius(window)) * 90, FARTHEST) * (Math.PI / 180);
  const out = far > 0 ? scale(add(scale(view.across, s / far), scale(view.upwards, t / far)), Math.sin(angle)) : [0, 0, 0];
  return add(pivot, scale(add(out, scale(view.axis, -Math.cos(angle))), distance));
}

/** As in a window of the usual shape, which fits into this one. */
export const ringRadius = ({ width, height }) => RING * Math.min(height, 0.75 * width);

/** The middle of a window, [x, y] in pixels. */
export const centreOf = ({ x, y, width, height }) => [x + width / 2, y + height / 2];

/** The light nearer or farther by a factor, within what the server takes. */
export function atDistance(pivot, light, factor) {
  const way = scale(subtract(light, pivot), factor);
  return length(way) < MOST_AWAY ? add(pivot, way) : light;
}

/** The light that a request's `light` moves; undefined where there is none. */
export function movedLight(scene) {
  return scene?.key_light ?? (Array.isArray(scene?.lights) ? scene.lights : []).find((light) => light?.type !== 'sky');
}

/**
 * The place of the light that a request's `light` moves, told by the scene of its picture; a
 * directional one stands where it would shine on `pivot` from; null where there is none.
 */
export function lightOf(world, pivot) {
  const light = movedLight(world);
  if (!light) return null;
  if (light.position) return light.position;
  if (light.direction) return pivot && subtract(pivot, light.direction);
  if (light.type === 'quad') return add(light.corner, scale(add(light.u, light.v), 1 / 2));
  return null;
}

/**
 * The point that the picture is about: the middle of what its centre shows, told by the hits along
 * that ray; where the thing is no body that one could walk around, the first hit; else what the
 * camera looks at.
 */
export function pivotOf(view, camera, hits) {
  const first = hits.find(({ front, t }) => front && t > 0) ?? hits[0];
  if (!first) return camera.look_at ?? add(view.origin, scale(view.axis, 10));
  const back = hits.find(({ object, front, t }) => object === first.object && !front && t > first.t);
  const body = back && back.t - first.t < first.t;
  return body ? scale(add(first.point, back.point), 1 / 2) : first.point;
}

export const distanceOf = (pivot, light) => length(subtract(light, pivot));
