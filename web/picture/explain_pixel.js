// Asks the server about a pixel, and where its blocked shadow rays end. Loaded with the first question.

import { length, subtract } from '../space/vec.js';
import { calledApart } from './called.js';
import { along, reachOf, stepsOf } from './explained.js';
import { fetchExplanation } from './server.js';

const MOST_PROBES = 12; // blocked shadow rays whose ends are looked for
const PATHS = 256; // of which a pixel's light is the mean, where it is by chance
const SINGLE = 16; // of them that are told one by one

/**
 * The pixel of a request as { tree, hits, steps, left }. The steps are stepsOf's; a blocked shadow
 * ray ends where it is blocked and has its lamp as `aim`. `middle`: what the picture is about. Of
 * the integrator path: { mean, groups, over, count, hits, samples, reach }, of many paths, some of them told
 * as `samples`, whose rays without an end are `reach` long.
 */
export async function explainPixel(request, [x, y], middle, signal) {
  const told = await fetchExplanation({ ...request, x, y }, signal);
  if (!told.tree) {
    const all = await fetchExplanation({ ...request, x, y, samples: PATHS, paths: SINGLE }, signal);
    const { hits, over, samples } = calledApart(all);
    const eye = all.ray.origin;
    const far = samples.flatMap(({ vertices }) => vertices).map(({ point }) => (point ? length(subtract(point, eye)) : 0));
    return { ...all, hits, over, samples, reach: 1.25 * Math.max(leastReach(middle, eye), ...far) };
  }
  const { tree, hits } = calledApart(told);
  const { steps, left } = stepsOf(tree, reachOf(tree, leastReach(middle, tree.ray.origin)));
  const blocked = steps.filter((step) => step.blocked).slice(0, MOST_PROBES);
  await Promise.all(blocked.map((step) => endWhereBlocked(step, tree.ray.origin, request, signal)));
  return { tree, hits, steps, left };
}

const leastReach = (middle, eye) => (middle ? 2 * length(subtract(middle, eye)) : 10);

async function endWhereBlocked(step, eye, request, signal) {
  const probe = probeOf(step, eye);
  const ray = { origin: probe.origin, direction: probe.direction };
  const { hits } = await fetchExplanation({ ...request, ray }, signal);
  const end = blockedAt(hits, step, probe);
  if (end) [step.aim, step.to] = [step.to, end];
}

/**
 * The ray that finds where a shadow ray is blocked: { origin, direction, past }; before `past` a
 * surface may meet itself. It goes by the eye's distance, for a scene may stand far from the origin.
 */
function probeOf({ from, node, term }, eye) {
  const past = 1e-5 * Math.max(node.t, length(subtract(from, eye)));
  return { origin: along(from, node.normal, past), direction: term.direction, past };
}

/** Where the first of the hits along a probe lies that is the step's blocker; null: none does. */
function blockedAt(hits, { term }, { past }) {
  const far = term.distance ?? Infinity;
  const blocks = ({ id, t }) => id === term.blocker_id && t > past && t < far;
  return hits.find(blocks)?.point ?? null;
}
