// What is wrong with a scene's text, each with its place: where it is no JSON by our own reader,
// else by the server's problem document, whose pointers are into the request.

import { parseScene, tokens, valueAt, withValue } from './scene_text.js';

/** The faults of a text's syntax as [{ start, end, line, column, reason, got }]. */
export function syntaxFaults(text) {
  const { faults, value } = parseScene(text);
  const object = value !== null && typeof value === 'object' && !Array.isArray(value);
  if (!faults.length && !object)
    return [{ start: 0, end: text.length, line: 1, column: 1, reason: 'scene', got: text.trim().slice(0, 20) }];
  return faults.map(({ offset, ...fault }) => ({ ...fault, start: offset }));
}

/**
 * The faults that `errors` of a problem document tell of the scene, shaped as those of the syntax,
 * with `error`, the name that is `missing` at the place, or null, and `fix`, the text with the
 * nearest known name in place, or null. Null where the server says nothing of the scene.
 */
export function serverFaults(text, errors) {
  const { places, value } = parseScene(text);
  const ours = errors.filter(({ pointer }) => /^\/scene(?:\/|$)/.test(pointer ?? ''));
  if (!ours.length) return null;
  return ours.map((error) => {
    const pointer = error.pointer.slice('/scene'.length);
    const there = places.get(pointer);
    const last = tokens(pointer).at(-1);
    const names = there?.name && error.got === last && valueAt(value, pointer) !== error.got;
    const place = there ?? nearestPlace(places, pointer);
    const [start, end] = rangeOf(place, !there || names);
    const column = start - place.start + place.column;
    const missing = there ? null : last;
    const fix = there && fixOf(text, error, pointer, names && there);
    return { start, end, ...lineOf(text, start, place.line, column), error, missing, fix };
  }).sort((a, b) => a.start - b.start);
}

function nearestPlace(places, pointer) {
  let up = pointer;
  while (up && !places.has(up)) up = up.slice(0, up.lastIndexOf('/'));
  return places.get(up);
}

// Of a list or an object its name or its bracket is marked: it may be long.
function rangeOf({ start, end, name, items }, named) {
  if (name && (named || items)) return name;
  return items ? [start, start + 1] : [start, end];
}

// A name may stand on another line than its value.
function lineOf(text, start, line, column) {
  if (column >= 1) return { line, column };
  const before = text.slice(0, start).split('\n');
  return { line: before.length, column: before.at(-1).length + 1 };
}

function fixOf(text, { nearest, got }, pointer, place) {
  if (nearest === undefined || nearest === null || typeof got !== 'string') return null;
  if (!place) return withValue(text, pointer, nearest);
  const [start, end] = place.name;
  return text.slice(0, start) + JSON.stringify(nearest) + text.slice(end);
}
