// What an eye sees where: circles around what it looks at.

import { add, cross, dot, normalize, scale } from './vec.js';
import { project, rayThrough, UNSAID } from './view.js';

/** The places of the picture, in pixels, that lie `degrees` from where the eye looks: [[x, y]], those before the eye. */
export function circleAround(view, [x, y], degrees, count = 72) {
  const axis = rayThrough(view, x, y).direction;
  const side = normalize(cross(axis, Math.abs(dot(axis, view.upwards)) < 0.9 ? view.upwards : view.across));
  const other = cross(side, axis);
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return Array.from({ length: count }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    const around = add(scale(side, Math.cos(turn)), scale(other, Math.sin(turn)));
    const to = add(scale(axis, c), scale(around, s));
    return dot(to, view.axis) > 0.05 ? project(view, add(view.origin, to)) : null;
  }).filter(Boolean);
}

/** A camera at the same place that looks `right` and `up`, in degrees, from where it looks now. */
export function turnedEye(view, right, up, fov_degrees) {
  const [a, b] = [right, up].map((angle) => (angle * Math.PI) / 180);
  const level = add(scale(view.axis, Math.cos(a)), scale(view.across, Math.sin(a)));
  const direction = add(scale(level, Math.cos(b)), scale(view.upwards, Math.sin(b)));
  return { ...UNSAID, location: view.origin, direction, up: view.upwards, projection: 'perspective', fov_degrees };
}
