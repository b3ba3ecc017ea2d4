// The editor's text outlives a reload, also where it is broken.

import { recall, remember } from './memory.js';

const NAME = 'scene';
const STORAGE = 'sessionStorage';
let told = false;

/** Keeps { text, caret, home }, written while `scene` was wanted; true where that first fails. */
export function keep(written, scene) {
  const worked = remember(NAME, JSON.stringify({ ...written, mark: markOf(scene) }), STORAGE);
  const first = !worked && !told;
  told ||= !worked;
  if (!worked) remember(NAME, null, STORAGE);
  return first;
}

export function forget() {
  remember(NAME, null, STORAGE);
}

/**
 * What was kept, as a function of the scene wanted now: null where that is another scene than the
 * text was written for, as after a link; null instead of the function where nothing was kept.
 */
export function kept() {
  const text = recall(NAME, STORAGE);
  if (!text) return null;
  const reloaded = performance.getEntriesByType('navigation')[0]?.type === 'reload';
  const { mark, ...written } = readKept(text);
  if (typeof written.text !== 'string') return null;
  return (scene) => (reloaded || mark === markOf(scene) ? written : null);
}

// What another version of the page has kept may be anything.
function readKept(text) {
  try {
    return JSON.parse(text) ?? {};
  } catch {
    return {};
  }
}

// A short word for a scene: enough to tell it from others. Source: FNV-1a, 32 bits.
function markOf(scene = 'thesis') {
  const text = JSON.stringify(scene);
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return `${text.length}-${hash >>> 0}`;
}
