// Films by the server, as they come.

import { fetchable } from '../state/request.js';
import { unanswered, readProblem } from './problem.js';
import { ask, fetchJson } from './server.js';

// What stands before each frame, where that can be told from bytes.
const MARKS = { apng: 'fcTL', zip: 'PK\x03\x04', webp: 'ANMF' };
const NOT_OF_FILMS = ['time', 'frame', 'pixel', 'budget_ms', 'max_rays'];
const LIVE = ['mjpeg'];

/** The formats of files that this server gives. */
export async function filmFormats() {
  const { films } = await fetchJson('version');
  return films.filter((name) => !LIVE.includes(name));
}

/**
 * A film as a Blob; `came({ bytes, frames, count })` hears while it comes: `frames` undefined where the
 * format does not tell them, `count` how many there will be.
 */
export async function fetchFilm(request, signal, came) {
  const asked = Object.fromEntries(Object.entries(request).filter(([name]) => !NOT_OF_FILMS.includes(name)));
  const { path, init } = fetchable('film', asked);
  try {
    const response = await ask(path, { ...init, signal });
    if (!response.ok) throw await readProblem(response);
    return await read(response, request.format, came);
  } catch (error) {
    throw error instanceof TypeError ? unanswered(error) : error; // cut short, too
  }
}

async function read(response, format, came) {
  const numbers = (response.headers.get('Tia-Frames') ?? '').match(/\d+/g)?.map(Number) ?? [];
  const count = numbers.reduce((sum, one) => sum + one, 0);
  const parts = [];
  const marks = MARKS[format] && new Counter(MARKS[format]);
  let bytes = 0;
  for (const reader = response.body.getReader(); ;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    bytes += value.length;
    came({ bytes, frames: marks?.add(value), count });
  }
  return new Blob(parts, { type: response.headers.get('Content-Type') });
}

// How often some letters come in a stream of bytes.
class Counter {
  #letters;
  #rest = '';
  #count = 0;

  constructor(letters) {
    this.#letters = letters;
  }

  add(bytes) {
    const text = this.#rest + new TextDecoder('latin1').decode(bytes);
    this.#count += text.split(this.#letters).length - 1;
    this.#rest = text.slice(1 - this.#letters.length);
    return this.#count;
  }
}
