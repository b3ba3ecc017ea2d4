// The coloured copy of the editor's text that lies under it. JSON's words do not go over the end
// of a line, so a change costs no more than the lines that it touches.

import { element } from './element.js';

const WORDS = /("(?:[^"\\]|\\.)*"?)(\s*:)?|(-?\d[\w.+-]*)|([a-z]+)/gi;

/** Highlight: `layer` shows a text; `marks` are its faults { start, end, line }. */
export class Highlight {
  layer = element('pre', { class: 'code-layer', 'aria-hidden': 'true' });
  #keys = [];

  /** Shows `text`, or nothing where it is null. */
  show(text, marks = []) {
    if (text === null) return this.#clear();
    const lines = text.split('\n');
    const marked = marksByLine(text, marks);
    const keys = lines.map((line, i) =>
      (marked.has(i) ? `${line}\n${JSON.stringify(marked.get(i))}` : line));
    const [from, tail] = sameEnds(this.#keys, keys);
    for (const old of [...this.layer.children].slice(from, this.#keys.length - tail)) old.remove();
    const made = lines.slice(from, lines.length - tail).map((line, i) => lineOf(line, marked.get(from + i) ?? []));
    const before = this.layer.children[from] ?? null;
    const fresh = document.createDocumentFragment();
    fresh.append(...made);
    this.layer.insertBefore(fresh, before);
    this.#keys = keys;
  }

  #clear() {
    this.layer.replaceChildren();
    this.#keys = [];
  }
}

function sameEnds(old, keys) {
  const most = Math.min(old.length, keys.length);
  let from = 0;
  while (from < most && old[from] === keys[from]) from += 1;
  let tail = 0;
  while (tail < most - from && old[old.length - 1 - tail] === keys[keys.length - 1 - tail]) tail += 1;
  return [from, tail];
}

// The ranges [from, to] to underline by their line, counted from 0; each ends with its line.
function marksByLine(text, marks) {
  const lines = new Map();
  for (const { start, end, line } of marks) {
    const begin = text.lastIndexOf('\n', start - 1) + 1;
    const range = [start - begin, Math.max(end, start + 1) - begin];
    lines.set(line - 1, [...(lines.get(line - 1) ?? []), range]);
  }
  return lines;
}

function lineOf(line, marks) {
  const made = element('span', { class: 'code-line' });
  let at = 0;
  for (const word of line.matchAll(WORDS)) {
    add(made, line, at, word.index, '', marks);
    const [, string, colon, number, name] = word;
    at = word.index + (string ?? number ?? name).length;
    const kind = string ? (colon ? 'tok-name' : 'tok-text') : number ? 'tok-number' : 'tok-word';
    add(made, line, word.index, at, kind, marks);
  }
  add(made, line, at, line.length, '', marks);
  if (marks.some(([from]) => from >= line.length)) made.append(element('span', { class: 'tok-bad' }, ' '));
  return made;
}

// A piece of a line, parted where an underline begins or ends.
function add(made, line, from, to, kind, marks) {
  const cuts = [from, to, ...marks.flat().filter((at) => at > from && at < to)].sort((a, b) => a - b);
  for (let i = 1; i < cuts.length; i += 1) {
    const [a, b] = [cuts[i - 1], cuts[i]];
    if (a === b) continue;
    const bad = marks.some(([start, end]) => start <= a && b <= end) ? ' tok-bad' : '';
    const text = line.slice(a, b);
    made.append(kind || bad ? element('span', { class: kind + bad }, text) : text);
  }
}
