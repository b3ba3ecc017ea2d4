// Keys of tracks, edited: each edit is what changes in the scene, as [[JSON Pointer, value]].
// A key is [t, value], [t, value, ease], or of a bezier [t, value, in, out].

import { token } from './scene_reader.js';
import { durationOf, tracksOf, trackAt } from './tracks.js';

/** What a scene without one gets. */
export const USUAL = { duration: 5, fps: 24 };

/** An animation with what is left out at its default. */
export const wholeAnimation = (scene) =>
  ({ ...USUAL, tracks: [], ...scene?.animation, duration: durationOf(scene) || USUAL.duration });

const NOT_MOVED = ['animation', 'physics', 'keys', 'title', 'description'];
const MOST_NUMBERS = 16; // of a list that is one value

/** The place of the first number, or list of numbers, that is another one in the scene `after`; null where none is. */
export function changedPlace(before, after, at = '') {
  if (typeof after === 'number' || isNumbers(after)) {
    const same = String(before) === String(after);
    return same || (before !== undefined && typeof before !== typeof after) ? null : at;
  }
  if (typeof after !== 'object' || after === null || typeof before !== 'object' || before === null) return null;
  if (Array.isArray(after) && after.length !== before.length) return null;
  for (const [name, value] of Object.entries(after)) {
    const place = at === '' && NOT_MOVED.includes(name) ? null : changedPlace(before[name], value, `${at}/${token(name)}`);
    if (place !== null) return place;
  }
  return null;
}

const isNumbers = (value) => Array.isArray(value) && value.length > 0 && value.length <= MOST_NUMBERS && value.every(Number.isFinite);

const keysAt = (track) => `/animation/tracks/${track}/keys`;

/** A key more for each of `keys`, { place, target, value }; one at the same frame goes. */
export function keyed(scene, keys, time) {
  const { duration, fps } = wholeAnimation(scene);
  const tracks = [...tracksOf(scene)];
  const edits = [];
  for (const { place, target, value } of keys) {
    const at = trackAt(scene, place);
    if (at >= 0) edits.push([keysAt(at), withKey(tracks[at], time, value, fps)]);
    else {
      edits.push([`/animation/tracks/${tracks.length}`, newTrack(target, time, value)]);
      tracks.push(null);
    }
  }
  if (scene.animation) return edits;
  return [['/animation', { duration, fps, tracks: edits.map(([, track]) => track) }]];
}

const newTrack = (target, time, value) => ({
  target, keys: [[time, value]], interpolation: typeof value === 'number' || value.length === 3 ? 'smooth' : 'linear',
});

function withKey({ keys, interpolation }, time, value, fps) {
  const near = (key) => Math.abs(key[0] - time) < 0.5 / fps;
  const [, , ...rest] = keys.find(near) ?? [];
  const still = Array.isArray(value) ? value.map(() => 0) : 0;
  const more = rest.length || interpolation !== 'bezier' ? rest : [still, still];
  return [...keys.filter((key) => !near(key)), [time, value, ...more]].sort((a, b) => a[0] - b[0]);
}

/** The key `index` of a track at another time, at least a frame from its neighbours, within the animation. */
export function movedKey(scene, track, index, time) {
  const { duration, fps } = wholeAnimation(scene);
  const { keys } = tracksOf(scene)[track];
  const least = index > 0 ? keys[index - 1][0] + 1 / fps : 0;
  const most = index < keys.length - 1 ? keys[index + 1][0] - 1 / fps : Math.max(duration, keys[index][0]);
  if (least > most) return [];
  const to = Number(Math.min(most, Math.max(least, time)).toFixed(6));
  return to === keys[index][0] ? [] : [[`${keysAt(track)}/${index}/0`, to]];
}

/** Another value of a key. */
export const valuedKey = (track, index, value) => [[`${keysAt(track)}/${index}/1`, value]];

/** How a key's value goes to the next one: `ease` is none, in, out or in_out. */
export function easedKey(scene, track, index, ease) {
  const [time, value] = tracksOf(scene)[track].keys[index];
  return [[`${keysAt(track)}/${index}`, ease === 'none' ? [time, value] : [time, value, ease]]];
}

/** A track without that key; without its last one the track goes. */
export function withoutKey(scene, track, index) {
  const { keys } = tracksOf(scene)[track];
  return keys.length > 1 ? [[keysAt(track), keys.filter((_, i) => i !== index)]] : withoutTrack(scene, track);
}

export const withoutTrack = (scene, track) =>
  [['/animation/tracks', tracksOf(scene).filter((_, i) => i !== track)]];

/** A track whose keys are joined otherwise. What has tangents loses them, what gets some stands still at its keys. */
export function joined(scene, track, interpolation) {
  const one = tracksOf(scene)[track];
  const bezier = (value) => (Array.isArray(value) ? value.map(() => 0) : 0);
  const keys = interpolation === 'bezier' ? one.keys.map(([t, value]) => [t, value, bezier(value), bezier(value)])
    : one.interpolation === 'bezier' ? one.keys.map(([t, value]) => [t, value]) : one.keys;
  return [[`/animation/tracks/${track}`, { ...one, keys, interpolation }]];
}

/** A track that repeats its keys otherwise. */
export const repeated = (track, repeat) => [[`/animation/tracks/${track}/repeat`, repeat]];
