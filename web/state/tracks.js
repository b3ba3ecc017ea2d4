// The tracks of a scene's animation: what each of them moves, and the scene with some of it put aside.

import { movedLight } from '../space/lamp.js';
import { mergePatch } from './merge_patch.js';
import { token, tokens } from './scene_reader.js';

/** The tracks of a scene, in its order. */
export const tracksOf = (scene) => (Array.isArray(scene?.animation?.tracks) ? scene.animation.tracks : []);

/** What a track's target means, with numbers in the place of the names of a list's objects. */
export function placeOf(scene, target) {
  let at = scene;
  return tokens(String(target)).map((name) => {
    const named = Array.isArray(at) && !/^\d+$/.test(name) ? at.findIndex((one) => one?.name === name) : -1;
    const step = named < 0 ? name : named;
    at = at?.[step];
    return `/${token(step)}`;
  }).join('');
}

/** Which track moves what is at `place`, a JSON Pointer of numbers; -1 where none does. */
export const trackAt = (scene, place) =>
  tracksOf(scene).findIndex(({ target, visible }) => !visible && placeOf(scene, target) === place);

export const isTracked = (scene, place) => trackAt(scene, place) >= 0;

/** Where the scene says where the light stands that the hand moves; null where it stands nowhere. */
export function lampPlace(scene) {
  if (scene?.key_light || !scene?.lights?.length) return '/key_light/position';
  const light = movedLight(scene);
  return light?.position ? `/lights/${scene.lights.indexOf(light)}/position` : null;
}

const FALL = 5; // seconds that bodies are followed where nothing is said

/** How long a scene moves, by tracks or as bodies; 0 where nothing in it does. */
export function durationOf(scene) {
  const { animation, physics } = scene ?? {};
  return Math.max(animation?.duration ?? 0, physics ? physics.duration ?? FALL : 0);
}

/** Whether a scene moves. */
export const moves = (scene) => momentIn(scene, 0) !== null;

/** The time of a scene that has it, or the last one before; null where nothing in it moves. */
export function momentIn(scene, time) {
  const duration = durationOf(scene);
  return time == null || !(duration > 0) ? null : Math.min(time, duration);
}

/** The scene without the tracks of its camera: as it is seen by another one. */
export function unled(scene) {
  const tracks = tracksOf(scene).filter(({ target }) => !String(target).startsWith('/camera'));
  return tracks.length === tracksOf(scene).length ? scene : { ...scene, animation: { ...scene.animation, tracks } };
}

/** A request whose scene has `held`, values by place, in the place of what its tracks say there. */
export function heldRequest(request, source, held) {
  const places = Object.keys(held);
  if (!places.length || !source) return request;
  const lit = places.includes(lampPlace(source));
  const { light, ...others } = (lit && source.keys?.[request.key]) || {}; // what else its key changes stays so
  const camera = places.filter((place) => place.startsWith('/camera/')).map((place) => [place.slice(8), held[place]]);
  return {
    ...request, ...(lit && { light: null, key: null }), scene: aside(mergePatch(source, others), held),
    ...(camera.length && { camera: { ...request.camera, ...Object.fromEntries(camera) } }),
  };
}

function aside(scene, held) {
  const tracks = tracksOf(scene).filter(({ target }) => !(placeOf(scene, target) in held));
  const still = { ...scene, animation: { ...scene.animation, tracks } };
  return Object.entries(held).reduce((now, [place, value]) => withPart(now, tokens(place), value), still);
}

function withPart(whole, [name, ...rest], value) {
  if (name === undefined) return value;
  const copy = Array.isArray(whole) ? [...whole] : { ...whole };
  copy[name] = withPart(copy[name], rest, value);
  return copy;
}
