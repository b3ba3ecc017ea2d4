// A scene as text: laid out to be read, and changed in one place with all else left as it is.

import { parseScene, token, tokens } from './scene_reader.js';

export { parseScene, token, tokens };

const WIDTH = 80;
const FIRST = ['title', 'description', 'name', 'type', 'camera', 'background', 'ambient_light',
  'materials', 'objects', 'lights', 'key_light', 'keys', 'options'];
const LAST = ['material', 'transform', 'children'];

/** A scene's JSON in readable text: what fits is on one line, numbers fill lines. */
export function formatScene(json) {
  return `${layOut(json, '', WIDTH, true)}\n`;
}

// `room` is what is left of the first line.
function layOut(value, indent, room, root = false) {
  const short = root ? null : inline(value, room);
  if (short !== null || typeof value !== 'object' || value === null) return short ?? JSON.stringify(value);
  const inner = `${indent}  `;
  if (Array.isArray(value) && value.every(isPlain)) return fill(value, indent, inner);
  const lines = Array.isArray(value) ? value.map((one) => layOut(one, inner, WIDTH - inner.length))
    : inOrder(value).map(([name, one]) => {
      const label = `${JSON.stringify(name)}: `;
      return label + layOut(one, inner, WIDTH - inner.length - label.length);
    });
  const [open, close] = Array.isArray(value) ? '[]' : '{}';
  if (!lines.length) return open + close;
  return `${open}\n${lines.map((line) => inner + line).join(',\n')}\n${indent}${close}`;
}

// On one line, or null where that is longer than `room`.
function inline(value, room = Infinity) {
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  if (JSON.stringify(value).length > room) return null;
  const parts = Array.isArray(value) ? value.map((one) => inline(one))
    : inOrder(value).map(([name, one]) => `${JSON.stringify(name)}: ${inline(one)}`);
  const object = parts.length ? `{ ${parts.join(', ')} }` : '{}';
  const text = Array.isArray(value) ? `[${parts.join(', ')}]` : object;
  return text.length <= room ? text : null;
}

const isScalar = (value) => typeof value !== 'object' || value === null;
const isPlain = (value) =>
  isScalar(value) || (Array.isArray(value) && value.length <= 4 && value.every(isScalar));

function fill(values, indent, inner) {
  const lines = [];
  let line = '';
  for (const [i, value] of values.entries()) {
    const text = inline(value) + (i < values.length - 1 ? ',' : '');
    if (line && inner.length + line.length + 1 + text.length > WIDTH) [line] = ['', lines.push(inner + line)];
    line += line ? ` ${text}` : text;
  }
  return `[\n${[...lines, inner + line].join('\n')}\n${indent}]`;
}

function inOrder(object) {
  const rank = ([name]) =>
    (FIRST.includes(name) ? FIRST.indexOf(name) - FIRST.length : 1 + LAST.indexOf(name));
  return Object.entries(object).sort((a, b) => rank(a) - rank(b));
}

/** What a JSON Pointer means in `json`; undefined where nothing. */
export function valueAt(json, pointer) {
  return tokens(pointer).reduce((value, name) =>
    value !== null && typeof value === 'object' && Object.hasOwn(value, name) ? value[name] : undefined, json);
}

/**
 * The text with `value` at `pointer`, undefined removes what is there; where the way to it is
 * missing, it is made. All else stays letter by letter. The text as it is where it is no JSON, or
 * where the pointer leads through what holds nothing.
 */
export function withValue(text, pointer, value) {
  const { value: json, places, faults } = parseScene(text);
  if (faults.length) return text;
  const place = places.get(pointer);
  if (value === undefined) return place ? without(text, places, pointer, place) : text;
  const edits = place ? changes(places, pointer, valueAt(json, pointer), value, text)
    : [addition(text, places, pointer, value, json)];
  return edits.filter(Boolean).sort((a, b) => b.start - a.start)
    .reduce((now, { start, end, words }) => now.slice(0, start) + words + now.slice(end), text);
}

// What differs, as small as can be: lists of the same length and objects of the same names keep
// their layout.
function changes(places, pointer, old, value, text) {
  if (JSON.stringify(old) === JSON.stringify(value)) return [];
  const { start, end } = places.get(pointer);
  if (!alike(old, value)) {
    const indent = indentAt(text, start);
    return [{ start, end, words: layOut(value, indent, WIDTH - columnOf(text, start)) }];
  }
  return Object.keys(value).flatMap((name) =>
    changes(places, `${pointer}/${token(name)}`, old[name], value[name], text));
}

function alike(a, b) {
  if (isScalar(a) || isScalar(b) || Array.isArray(a) !== Array.isArray(b)) return false;
  const names = Object.keys(b);
  return names.length > 0 && names.length === Object.keys(a).length && names.every((name) => Object.hasOwn(a, name));
}

function addition(text, places, pointer, value, json) {
  const cut = pointer.lastIndexOf('/');
  const parent = places.get(pointer.slice(0, cut));
  const [name] = tokens(pointer.slice(cut));
  const list = /^(?:-|\d+)$/.test(name);
  if (!parent)
    return addition(text, places, pointer.slice(0, cut), list ? [value] : { [name]: value }, json);
  if (!parent.items) return null;
  const label = Array.isArray(valueAt(json, pointer.slice(0, cut))) ? '' : JSON.stringify(name);
  if (!label && !list) return null;
  return parent.items.length ? after(text, parent, label, value) : only(text, parent, label, value);
}

// Behind the last of its neighbours and spaced as they are.
function after(text, { start, end, items }, label, value) {
  const last = items.at(-1);
  const from = beginOf(last);
  const before = text.slice(items.length > 1 ? items.at(-2).end : start + 1, from);
  const gap = last.name ? text.slice(last.name[1], last.start) : '';
  const tight = last.name ? gap === ':' : before === ',';
  const colon = label && (tight ? ':' : ': ');
  const indent = indentAt(text, from);
  const way = before.includes('\n') ? `,\n${indent}` : tight ? ',' : ', ';
  const room = before.includes('\n') ? WIDTH - indent.length - label.length - 2 : Infinity;
  const words = tight ? JSON.stringify(value) : layOut(value, indent, room);
  return { start: last.end, end: last.end, words: way + label + colon + words };
}

function only(text, { start, end }, label, value) {
  const indent = indentAt(text, start);
  const open = text.slice(start + 1, end - 1).includes('\n');
  const inner = `${indent}  `;
  const words = (label && `${label}: `) + layOut(value, open ? inner : indent, Infinity);
  const around = open ? [`\n${inner}`, `\n${indent}`] : label ? [' ', ' '] : ['', ''];
  return { start: start + 1, end: end - 1, words: around.join(words) };
}

function without(text, places, pointer, place) {
  const { start, end, items } = places.get(pointer.slice(0, Math.max(0, pointer.lastIndexOf('/'))));
  const at = items?.indexOf(place) ?? -1;
  if (at < 0) return text;
  const next = items[at + 1];
  const [from, to] = next ? [beginOf(place), beginOf(next)]
    : at > 0 ? [items[at - 1].end, place.end] : [start + 1, end - 1];
  return text.slice(0, from) + text.slice(to);
}

const beginOf = ({ name, start }) => name?.[0] ?? start;
const lineStart = (text, at) => text.lastIndexOf('\n', at - 1) + 1;
const columnOf = (text, at) => at - lineStart(text, at);
const indentAt = (text, at) => /^[ \t]*/.exec(text.slice(lineStart(text, at), at))[0];
