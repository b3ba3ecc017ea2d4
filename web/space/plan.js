// Plans: the scene seen along an axis, as a parallel view. Axes are the camera's own, rounded to
// the world's: what is up in the picture is up from the side, what is right is right from above.

import { add, cross, dot, scale, subtract } from './vec.js';
import { axisOf, UNSAID } from './view.js';

const MARGIN = 1.25;

/** The plans of a camera: { name, across, up, into }, unit vectors along the world's axes. */
export function plansOf(camera) {
  const up = mainAxis(camera.basis?.v ?? camera.up);
  const ahead = mainAxis(subtract(axisOf(camera), scale(up, dot(axisOf(camera), up))));
  const across = cross(ahead, up);
  return [
    { name: 'top', across, up: ahead, into: scale(up, -1) },
    { name: 'side', across: ahead, up, into: scale(across, -1) },
  ];
}

// The axis of the world that a vector is nearest to; x where it is none.
function mainAxis(a) {
  const most = Math.max(...a.map(Math.abs));
  const at = most > 0 ? a.findIndex((value) => Math.abs(value) === most) : 0;
  return [0, 1, 2].map((i) => (i === at ? Math.sign(a[i]) || 1 : 0));
}

/** What a plan shows: `center` and half its height, so that all `points` have room in 4:3. */
export function regionOf(plan, points) {
  const range = (axis) => {
    const along = points.map((point) => dot(point, axis));
    return [Math.min(...along), Math.max(...along)];
  };
  const [left, right] = range(plan.across);
  const [low, high] = range(plan.up);
  const half = MARGIN * Math.max((right - left) / 2 / (4 / 3), (high - low) / 2, 1e-6);
  const near = -range(scale(plan.into, -1))[1];
  const center = add(add(scale(plan.across, (left + right) / 2), scale(plan.up, (low + high) / 2)), scale(plan.into, near));
  return { center, half };
}

/** The camera that draws a plan, as what replaces fields of a scene's camera. */
export function planCamera(plan, { center, half }) {
  return { ...UNSAID, location: center, direction: plan.into, up: plan.up, projection: 'orthographic', height: 2 * half };
}

/** Where a point is in a plan `height` high and 4/3 as wide: [x, y] from the top left. */
export function placeIn(plan, { center, half }, height, point) {
  const away = subtract(point, center);
  const unit = height / 2 / half;
  return [(height * 2) / 3 + dot(away, plan.across) * unit, height / 2 - dot(away, plan.up) * unit];
}

/** The same, moved to the plan's edge where it lies beyond. */
export function placeWithin(plan, region, height, point) {
  const edge = height / 24;
  const [x, y] = placeIn(plan, region, height, point);
  const within = (value, size) => Math.min(size - edge, Math.max(edge, value));
  return [within(x, (height * 4) / 3), within(y, height)];
}

/** How far a way of `x`, `y` in the plan is in the world. */
export function wayIn(plan, { half }, height, [x, y]) {
  const unit = half / (height / 2);
  return add(scale(plan.across, x * unit), scale(plan.up, -y * unit));
}
