// Reads JSON (RFC 8259) and keeps where everything stands. Stops at the first break, for what
// follows one is guesswork; keys that come twice are faults too, as the server refuses them.

const DEEPEST = 100; // nobody writes that by hand, and the reader calls itself
const NUMBER = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
const WORD = /[\w.+-]+/y;
const MARKED = /[\w.+-]+|"(?:[^"\\\n]|\\.)*"?|/y;
const BLANKS = /[ \t\r\n]*/y;

/**
 * { value, places, faults } of a text: `value` undefined where there are faults; `places` by JSON
 * Pointer { start, end, line, column, name, items }, `name` a member's name as [start, end], `items`
 * the places of what is in it; `faults` [{ offset, end, line, column, reason, got }] with a reason
 * `value`, `comma`, `trailing`, `colon`, `name`, `string`, `escape`, `number`, `word`, `after`,
 * `open`, `twice` or `deep`. Lines and columns count from 1.
 */
export function parseScene(text) {
  if (last?.text !== text) last = { text, read: read(text) };
  return last.read;
}

let last = null; // who writes reads the same text several times over

function read(text) {
  const reader = new Reader(text);
  try {
    reader.skip();
    reader.value('', 0);
    reader.skip();
    if (reader.at < text.length) reader.fail('after');
  } catch (error) {
    if (!(error instanceof Broken)) throw error;
  }
  const { places, faults } = reader;
  return { value: faults.length ? undefined : JSON.parse(text), places, faults };
}

/** A name as it stands in a JSON Pointer (RFC 6901). */
export const token = (name) => String(name).replaceAll('~', '~0').replaceAll('/', '~1');

/** The names and numbers that a JSON Pointer consists of. */
export const tokens = (pointer) =>
  pointer.split('/').slice(1).map((one) => one.replaceAll('~1', '/').replaceAll('~0', '~'));

class Broken extends Error {}

class Reader {
  places = new Map();
  faults = [];
  at = 0;
  #line = 1;
  #lineStart = 0;

  constructor(text) {
    this.text = text;
  }

  skip() {
    if (this.text.charCodeAt(this.at) > 32) return;
    BLANKS.lastIndex = this.at;
    const end = this.at + BLANKS.exec(this.text)[0].length;
    for (; this.at < end; this.at += 1)
      if (this.text[this.at] === '\n') [this.#line, this.#lineStart] = [this.#line + 1, this.at + 1];
  }

  value(pointer, depth, name) {
    const { at: start } = this;
    const place = { start, end: start, line: this.#line, column: start - this.#lineStart + 1, name };
    this.places.set(pointer, place);
    if (depth > DEEPEST) this.fail('deep');
    const first = this.text[start];
    if (first === '{') this.#list(place, '}', (items, seen) => this.#member(pointer, depth, seen));
    else if (first === '[')
      this.#list(place, ']', (items) => this.value(`${pointer}/${items.length}`, depth + 1));
    else if (first === '"') this.#string();
    else this.#scalar();
    place.end = this.at;
    return place;
  }

  #list(place, close, readOne) {
    const seen = new Set();
    place.items = [];
    this.at += 1;
    this.skip();
    while (this.text[this.at] !== close) {
      if (this.at >= this.text.length) this.fail('open', place.start, place);
      place.items.push(readOne(place.items, seen));
      this.skip();
      if (this.text[this.at] === close) break;
      if (this.at >= this.text.length) this.fail('open', place.start, place);
      if (this.text[this.at] !== ',') this.fail('comma');
      const comma = this.at;
      this.at += 1;
      const [line, lineStart] = [this.#line, this.#lineStart];
      this.skip();
      if (this.text[this.at] === close) this.fail('trailing', comma, { line, column: comma - lineStart + 1 });
    }
    this.at += 1;
  }

  #member(pointer, depth, seen) {
    const [start, line, column] = [this.at, this.#line, this.at - this.#lineStart + 1];
    if (this.text[start] !== '"') this.fail('name');
    this.#string();
    const name = [start, this.at];
    const key = JSON.parse(this.text.slice(...name));
    if (seen.has(key)) this.#note('twice', start, this.at, { line, column });
    seen.add(key);
    this.skip();
    if (this.text[this.at] !== ':') this.fail('colon');
    this.at += 1;
    this.skip();
    return this.value(`${pointer}/${token(key)}`, depth + 1, name);
  }

  #string() {
    const start = this.at;
    for (this.at += 1; this.text[this.at] !== '"'; this.at += 1) {
      const letter = this.text[this.at];
      if (letter === undefined || letter < ' ') this.fail('string', start);
      if (letter === '\\') this.#escape();
    }
    this.at += 1;
  }

  #escape() {
    const after = this.text.slice(this.at + 1, this.at + 6);
    const known = /^(?:["\\/bfnrt]|u[\da-fA-F]{4})/.exec(after);
    if (!known) this.fail('escape');
    this.at += known[0].length;
  }

  #scalar() {
    WORD.lastIndex = NUMBER.lastIndex = this.at;
    const word = WORD.exec(this.text)?.[0];
    if (!word) this.fail('value');
    const number = NUMBER.exec(this.text)?.[0] === word;
    if (number && !Number.isFinite(Number(word))) this.fail('number');
    if (!number && !['true', 'false', 'null'].includes(word))
      this.fail(/^[-+.\d]/.test(word) ? 'number' : 'word');
    this.at += word.length;
  }

  /** Notes what is wrong, here or from `start` on, and stops. */
  fail(reason, start = this.at, place = undefined) {
    MARKED.lastIndex = start;
    const length = MARKED.exec(this.text)[0].length || 1;
    const end = reason === 'string' ? this.at : start + length;
    this.#note(reason, start, Math.min(end, this.text.length), place);
    throw new Broken();
  }

  #note(reason, offset, end, place = { line: this.#line, column: offset - this.#lineStart + 1 }) {
    const got = this.text.slice(offset, Math.min(end, offset + 40));
    this.faults.push({ reason, offset, end, line: place.line, column: place.column, got });
  }
}
