// What is to be seen, in words for who does not see it: read off the feature images that tell the
// object and the share of the light at every pixel, and off the picture's own brightness.

import { ownerAt, ownersOf, readPfm } from '../picture/feature_image.js';
import { fetchPfm } from '../picture/server.js';
import { dot, subtract } from '../space/vec.js';
import { ONE_RAY } from '../state/request.js';
import { pixelsOf, scaled } from '../state/window.js';
import { t, countWords } from '../words/words.js';

const PIXELS = 80 * 60; // 57 KiB an image
const LEAST_SHARE = 0.002; // of the picture: what is smaller is not told
const MOST_TOLD = 4;
const LEAST_LEAN = 0.08; // of the object's radius: how far its light must lean to have a side
let telling = null;

/** Tells in `place` what the picture shown shows; a newer picture takes over from an older one. */
export async function lookAround(studio, place) {
  telling?.abort();
  const { signal } = (telling = new AbortController());
  const { request: whole } = studio.model;
  const small = Math.min(1, Math.sqrt(PIXELS / pixelsOf(whole)));
  const request = { ...scaled(whole, small), ...ONE_RAY };
  try {
    const [object, shadow, light] = await Promise.all([
      feature({ ...request, integrator: 'object' }, signal),
      feature({ ...request, integrator: 'shadow' }, signal),
      feature(request, signal),
    ]);
    const { world } = studio.model;
    const names = (world?.objects ?? []).map(({ name, type }) => name ?? type);
    const lamps = Math.max(1, (world?.lights ?? []).length + (world?.key_light ? 1 : 0));
    const towards = studio.light && studio.pivot ? lampWay(studio) : null;
    const lit = Boolean(studio.light) || (world?.lights ?? []).length > 0;
    if (!signal.aborted) place.textContent = sceneWords(objectsSeen(object, shadow, light, ownersOf(world ?? {}), { lamps, towards }), names, lit);
  } catch (problem) {
    if (!signal.aborted) place.textContent = '';
  }
}

async function feature(request, signal) {
  return readPfm(await fetchPfm(request, signal));
}

// Where the lamp is from what one looks at, [right, up].
function lampWay({ view, pivot, light }) {
  const way = subtract(light, pivot);
  return [dot(way, view.across), dot(way, view.upwards)];
}

/**
 * What each object looks like, the largest first: { index, share (of the picture), shadow (share of
 * its pixels without all light), lean: [right, up] (how far its light's centre is off its own, by
 * its radius), brightness (its mean) }.
 */
export function objectsSeen(object, shadow, light, owners, { lamps, towards }) {
  const sums = new Map();
  for (let y = 0; y < object.height; ++y) {
    for (let x = 0; x < object.width; ++x) {
      const index = ownerAt(object, owners, x, y);
      if (index < 0) continue;
      const sum = sums.get(index) ?? { index, count: 0, x: 0, y: 0, shadow: 0, glow: 0, glowX: 0, glowY: 0 };
      const glow = light.at(x, y).reduce((all, value) => all + value, 0) / 3;
      sum.count += 1;
      sum.x += x;
      sum.y += y;
      sum.shadow += shadow.at(x, y)[0] < 0.5 / lamps ? 1 : 0;
      sum.glow += glow;
      sum.glowX += glow * x;
      sum.glowY += glow * y;
      sums.set(index, sum);
    }
  }
  const all = object.width * object.height;
  return [...sums.values()].sort((a, b) => b.count - a.count).map((sum) => {
    const radius = Math.sqrt(sum.count / Math.PI);
    const lean = sum.glow > 0 ? [sum.glowX / sum.glow - sum.x / sum.count, sum.y / sum.count - sum.glowY / sum.glow] : [0, 0];
    return {
      index: sum.index,
      share: sum.count / all,
      shadow: sum.shadow / sum.count,
      // A floor is bright where its lamp is near, in the picture maybe below: that is not its side.
      lean: lean.map((by, i) => (towards && by * towards[i] < 0 ? 0 : by / radius)),
      brightness: sum.glow / sum.count,
    };
  });
}

/** The sentence about them. */
export function sceneWords(seen, names, lit) {
  if (!lit) return '';
  const told = seen.filter(({ share }) => share >= LEAST_SHARE).slice(0, MOST_TOLD);
  return told.map((one) => objectWords(one, names[one.index])).join('; ').concat(told.length ? '.' : '');
}

function objectWords({ lean: [right, up], shadow, brightness }, name) {
  const share = Math.round(shadow * 100);
  const told = share > 0 ? t('seen.shadow', { share: countWords(share) }) : t('seen.noShadow');
  if (brightness <= 1e-6) return t('seen.dark', { name });
  const strongest = Math.max(Math.abs(right), Math.abs(up));
  const counts = (by) => Math.abs(by) >= LEAST_LEAN && Math.abs(by) >= strongest / 2;
  const sides = [counts(up) && t(up > 0 ? 'seen.above' : 'seen.below'), counts(right) && t(right > 0 ? 'seen.right' : 'seen.left')].filter(Boolean);
  const from = sides.length ? t('seen.lit', { name, sides: sides.join(` ${t('seen.and')} `) }) : t('seen.evenly', { name });
  return `${from}, ${told}`;
}
