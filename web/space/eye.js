// Moving the camera: every spelling of it moves as one stiff body. What comes out is a request's
// `camera`: the fields that have changed.

import { add, cross, dot, length, normalize, scale, subtract, tidyVector, turn } from './vec.js';
import { axisOf, completeCamera, depthOf } from './view.js';

const STEEPEST = (5 * Math.PI) / 180; // from up and down
const MOST_AWAY = 1e8; // from what one looks at

/** The camera turned around `pivot` by angles in radians: `yaw` about its up, `pitch` about right. */
export function orbit(camera, pivot, yaw, pitch) {
  const whole = completeCamera(camera);
  const up = normalize(whole.basis?.v ?? whole.up);
  const right = normalize(cross(axisOf(whole), up));
  const free = Boolean(whole.right || whole.basis); // has no horizon to keep
  // The angle between the view and up shrinks by the pitch; it ends before the view is turned over.
  const angle = Math.acos(Math.min(1, Math.max(-1, dot(normalize(axisOf(whole)), up))));
  const [most, least] = [Math.max(0, angle - STEEPEST), Math.min(0, angle + STEEPEST - Math.PI)];
  const tilt = free ? pitch : Math.min(most, Math.max(least, pitch));
  const turned = (a) => turn(turn(a, right, tilt), up, yaw);
  return moved(whole, (a) => add(pivot, turned(subtract(a, pivot))), turned, free);
}

/** The camera shifted across its view's picture by parts of the height at the depth of `pivot`. */
export function pan(camera, view, pivot, x, y) {
  const whole = completeCamera(camera);
  const axis = normalize(axisOf(whole));
  const right = normalize(cross(axis, whole.basis?.v ?? whole.up));
  const up = cross(right, axis);
  const size = heightAt(view, pivot);
  const by = add(scale(right, x * size), scale(up, y * size));
  return moved(whole, (a) => add(a, by), (a) => a, false);
}

/** The camera nearer to `pivot` by a factor: 0.5 is half as far. Parallel views show a smaller part. */
export function zoom(camera, pivot, factor) {
  const whole = completeCamera(camera);
  if (whole.projection === 'orthographic') return narrowed(whole, factor);
  const away = subtract(whole.location, pivot);
  const by = scale(away, length(away) * factor < MOST_AWAY ? factor - 1 : 0);
  return moved(whole, (a) => add(a, by), (a) => a, false);
}

/** The eye moved by `way`, looking at `pivot` still; a view plane or a basis moves as it is. */
export function eyeMoved({ camera, pivot }, way) {
  const location = tidyVector(add(camera.location, way), 5);
  if (length(subtract(location, pivot)) < 1e-6) return null;
  return camera.right || camera.basis ? { location }
    : { location, look_at: tidyVector(pivot, 6), direction: null };
}

/** What is looked at moved by `way`; null for a view plane or a basis, which look where they look. */
export function aimMoved({ camera, pivot }, way) {
  if (camera.right || camera.basis) return null;
  return { look_at: tidyVector(add(pivot, way), 5), direction: null };
}

function narrowed({ height, right, up, pixel_size: side }, factor) {
  if (right) return { right: scale(right, factor), up: scale(up, factor) };
  return side ? { pixel_size: side * factor } : { height: height * factor };
}

// How high a picture's slice is where the pivot is.
function heightAt(view, pivot) {
  const plane = 2 * length(view.up);
  return view.parallel ? plane : (plane * Math.abs(depthOf(view, pivot))) / length(view.forward);
}

function moved(camera, point, vector, withUp) {
  const { location, look_at: target, direction, up, right, basis } = camera;
  const fields = { location: point(location) };
  if (target) fields.look_at = point(target);
  if (direction) fields.direction = vector(direction);
  if (right) fields.right = vector(right);
  if (withUp && !basis) fields.up = vector(up);
  if (basis) fields.basis = { u: vector(basis.u), v: vector(basis.v), w: vector(basis.w) };
  return fields;
}
