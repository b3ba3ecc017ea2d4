// Places in the air: what an eye sees through is empty, so that antennas may stand there.

import { fetchExplanation } from '../picture/server.js';
import { distanceOf } from '../space/lamp.js';
import { add, scale } from '../space/vec.js';
import { ONE_RAY } from '../state/request.js';
import { windowOf } from '../state/window.js';

const ROWS = [0.62, 0.5, 0.38]; // of the picture, where places are looked for
const [NEAREST, FARTHEST] = [0.2, 0.97]; // of the way to what is seen: neither at the eye nor at a wall
const BETWEEN = 0.6; // where nothing of that height is seen

/** A place `height` high that is seen at a share of the picture's width; where there is none, one between it and the eye. */
export async function airAt(studio, share, height) {
  let other = null;
  for (const row of ROWS) {
    const { origin, direction, far } = await sightOf(studio, share, row);
    const level = (height - origin[1]) / direction[1];
    const at = (t) => add(origin, scale(direction, t));
    if (level > NEAREST * far && level < FARTHEST * far) return at(level).with(1, height);
    other ??= at(BETWEEN * far);
  }
  return other;
}

async function sightOf(studio, share, row) {
  const { inScene: request, pivot, camera } = studio;
  const seen = windowOf(request);
  const [x, y] = [Math.floor(seen.x + share * seen.width), Math.floor(seen.y + row * seen.height)];
  const { hits, ray } = await fetchExplanation({ ...request, ...ONE_RAY, integrator: 'whitted', x, y });
  return { ...ray, far: hits.find(({ t }) => t > 0)?.t ?? distanceOf(pivot, camera.location) };
}
