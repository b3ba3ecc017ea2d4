// Ways for the lamp: a circle around what one looks at, or a curve through places.

import { add, length, scale, subtract, tidyVector, turn } from './vec.js';

const UP = [0, 1, 0];
const DIGITS = 5;
const ON_AXIS = 1e-3; // of the distance: so near to the axis a circle is a point

/** `count` places on the circle around the vertical axis through `pivot`, from `light` on; null: no circle. */
export function circlePath(pivot, light, count) {
  const way = subtract(light, pivot);
  if (Math.hypot(way[0], way[2]) <= ON_AXIS * length(way)) return null;
  return Array.from({ length: count }, (_, i) =>
    tidyVector(add(pivot, turn(way, UP, (2 * Math.PI * i) / count)), DIGITS));
}

/**
 * `count` places on the curve through `places`, two at least; a closed one comes back to the first.
 * Source: Catmull and Rom, A class of local interpolating splines, 1974.
 */
export function curvePath(places, count, closed) {
  const last = places.length - 1;
  const pieces = closed ? places.length : last;
  const steps = closed ? count : count - 1; // an open curve ends on its last place
  const at = (i) => places[closed ? (i + places.length) % places.length : Math.min(last, Math.max(0, i))];
  return Array.from({ length: count }, (_, i) => {
    const along = (i / steps) * pieces;
    const piece = Math.min(pieces - 1, Math.floor(along));
    return tidyVector(spline([-1, 0, 1, 2].map((by) => at(piece + by)), along - piece), DIGITS);
  });
}

// From the second of four places to the third, s from 0 to 1.
function spline([a, b, c, d], s) {
  const weights = [
    -s + 2 * s ** 2 - s ** 3, 2 - 5 * s ** 2 + 3 * s ** 3, s + 4 * s ** 2 - 3 * s ** 3, s ** 3 - s ** 2];
  return scale([a, b, c, d].map((place, i) => scale(place, weights[i])).reduce(add), 1 / 2);
}
