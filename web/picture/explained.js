// A pixel's explanation made ready to be shown.

import { length, subtract } from '../space/vec.js';
import { blockedAt, probeOf, reachOf, stepsOf } from './ray_tree.js';
import { fetchExplanation } from './server.js';

const MOST_PROBES = 12; // blocked shadow rays whose ends are looked for

/**
 * The pixel of a request as { tree, hits, steps, left }. The steps are ray_tree's; a blocked shadow
 * ray ends where it is blocked and has its lamp as `aim`. `middle`: what the picture is about.
 */
export async function explainPixel(request, [x, y], middle, signal) {
  const { tree, hits } = await fetchExplanation({ ...request, x, y }, signal);
  const least = middle ? 2 * length(subtract(middle, tree.ray.origin)) : 10;
  const { steps, left } = stepsOf(tree, reachOf(tree, least));
  const blocked = steps.filter((step) => step.blocked).slice(0, MOST_PROBES);
  await Promise.all(blocked.map((step) => endWhereBlocked(step, request, signal)));
  return { tree, hits, steps, left };
}

async function endWhereBlocked(step, request, signal) {
  const probe = probeOf(step);
  const ray = { origin: probe.origin, direction: probe.direction };
  const { hits } = await fetchExplanation({ ...request, ray }, signal);
  const end = blockedAt(hits, step, probe);
  if (end) [step.aim, step.to] = [step.to, end];
}
