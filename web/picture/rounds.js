// Where rays are chance a picture comes in rounds: whole pictures of ever more samples a pixel, each in
// place of the one before. Here each is a request of its own, the last the picture asked for.

import { ONE_RAY } from '../state/request.js';
import { pixelsOf } from '../state/window.js';

const GROWTH = 4; // from round to round: those before the last take a third of its time
const LEAST_OF_NOISE = 32; // samples that a pixel has in any case where `noise` says when it has enough

/** The samples of the rounds before a picture of `samples` a pixel, in their order. */
export function roundsBefore(samples) {
  const before = [];
  for (let each = samples / GROWTH; each >= 1; each /= GROWTH) before.unshift(Math.floor(each));
  return before;
}

/** The round after `drawn` on the way to a request of `samples` a pixel; null: the next is that itself. */
export function roundAfter(drawn, request, samples, noise) {
  if (request.budget_ms || request.max_rays) return null; // there is no more than that
  const had = pixelsOf(drawn) === pixelsOf(request) ? drawn.samples ?? samples : 0;
  const next = roundsBefore(noise ? Math.min(samples, LEAST_OF_NOISE) : samples).find((each) => each > had);
  return next ? { ...request, ...ONE_RAY, samples: next } : null;
}
