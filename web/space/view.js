// The camera as the page needs it: from the scene's words to rays and back to pixels. The same
// arithmetic as the server's core/scene/view, in double; a test holds it to /explain.

import { add, cross, dot, normalize, scale, subtract } from './vec.js';

/** What takes away all that a scene's camera says of what it sees, so that another view says it alone. */
export const UNSAID = { look_at: null, right: null, basis: null, distance: null, pixel_size: null, fov_degrees: null, height: null,
  aperture: 0, focus_distance: null, near: null, far: null, angle_degrees: null, display: null, interlace: null };

/** A scene's camera with the defaults that the canonical text leaves out. */
export function completeCamera(camera = {}) {
  const whole = { location: [0, 0, 0], up: [0, 1, 0], fov_degrees: 25, projection: 'perspective', ...camera };
  if (!whole.look_at && !whole.direction && !whole.basis) whole.direction = [0, 0, -1];
  return whole;
}

/**
 * View: `origin`, `forward` and the half extents `right` and `up` of the picture's plane, which
 * lies at origin + forward, or where `parallel` through the origin; `across` and `upwards` are
 * unit and perpendicular to the unit `axis`. `width`, `height` in pixels.
 */
export function viewOf(camera, width, height) {
  const whole = completeCamera(camera);
  const { forward, right, up } = whole.right ? ofPlane(whole)
    : whole.basis ? ofGrid(whole, width, height) : ofAngle(whole, width, height);
  const axis = normalize(forward);
  const across = normalize(right);
  const upwards = normalize(subtract(up, scale(across, dot(across, up))));
  const parallel = whole.projection === 'orthographic';
  return { origin: whole.location, forward, right, up, axis, across, upwards, parallel, width, height };
}

export const axisOf = ({ location, look_at: target, direction, basis }) =>
  basis ? scale(basis.w, -1) : direction ?? subtract(target, location);

function ofPlane(camera) {
  return { forward: axisOf(camera), right: camera.right, up: camera.up };
}

function ofGrid({ basis, distance = 1, pixel_size: side }, width, height) {
  return {
    forward: scale(basis.w, -distance),
    right: scale(basis.u, (side * width) / 2),
    up: scale(basis.v, (side * height) / 2),
  };
}

function ofAngle(camera, width, height) {
  const w = normalize(axisOf(camera));
  const u = normalize(cross(w, camera.up));
  const v = cross(u, w);
  const half = camera.projection === 'orthographic' ? camera.height / 2
    : Math.tan((camera.fov_degrees * Math.PI) / 360);
  return { forward: w, right: scale(u, (half * width) / height), up: scale(v, half) };
}

/** The ray through the place `x`, `y` of the picture, in pixels from its top left corner. */
export function rayThrough(view, x, y) {
  const [s, t] = [(2 * x) / view.width - 1, 1 - (2 * y) / view.height];
  const aside = add(scale(view.right, s), scale(view.up, t));
  return view.parallel ? { origin: add(view.origin, aside), direction: view.axis }
    : { origin: view.origin, direction: normalize(add(view.forward, aside)) };
}

/** How deep a point lies before the eye, along the axis; 0 or less is behind it. */
export function depthOf(view, point) {
  return dot(subtract(point, view.origin), view.axis);
}

/** Where a point is seen, as [x, y] in pixels; null behind the eye of a perspective view. */
export function project(view, point) {
  const away = subtract(point, view.origin);
  const normal = cross(view.right, view.up); // along the axis, or against it
  const depth = dot(away, normal) / dot(view.forward, normal);
  if (!view.parallel && depth <= 0) return null;
  const inPlane = view.parallel ? away : subtract(scale(away, 1 / depth), view.forward);
  const across = dot(inPlane, cross(view.up, normal)) / dot(view.right, cross(view.up, normal));
  const upwards = dot(inPlane, cross(normal, view.right)) / dot(view.up, cross(normal, view.right));
  return [((1 + across) / 2) * view.width, ((1 - upwards) / 2) * view.height];
}

/** The part of a segment that lies before the eye, or null. */
export function beforeEye(view, from, to) {
  if (view.parallel) return [from, to];
  const near = 1e-4;
  const [a, b] = [depthOf(view, from), depthOf(view, to)];
  if (a < near && b < near) return null;
  const at = (near - a) / (b - a);
  const cut = add(from, scale(subtract(to, from), at));
  return [a < near ? cut : from, b < near ? cut : to];
}
