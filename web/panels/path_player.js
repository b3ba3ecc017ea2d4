// Frames of a film that come one after the other and are kept, and the clock that shows them.

import { fetchPicture } from '../picture/server.js';
import { imageOf } from './cover.js';

/**
 * A film: `requests`, one a frame. `show(image, index)` shows one, `came(count)` hears of each that
 * has come, `failed(problem)` of the one that has not.
 */
export class Film {
  frames = []; // { blob, image }, in order, without gaps
  at = 0; // the frame that is wanted
  playing = false;
  #hooks;
  #loading = null;
  #abort = new AbortController();

  constructor(requests, hooks) {
    this.requests = requests;
    this.#hooks = hooks;
  }

  get complete() {
    return this.frames.length === this.requests.length;
  }

  /** Fetches what is missing; resolves whether all is there. */
  load() {
    this.#loading ??= this.#fetchAll().finally(() => (this.#loading = null));
    return this.#loading;
  }

  async #fetchAll() {
    const { signal } = this.#abort;
    try {
      while (!this.complete) {
        const { blob } = await fetchPicture(this.requests[this.frames.length], signal);
        const image = await imageOf(blob);
        if (signal.aborted) {
          URL.revokeObjectURL(image.src);
          break;
        }
        this.frames.push({ blob, image });
        this.#hooks.came(this.frames.length);
        if (this.frames.length === this.at + 1) this.seek(this.at);
      }
    } catch (problem) {
      this.playing = false;
      if (problem.name !== 'AbortError') this.#hooks.failed(problem);
    }
    return this.complete;
  }

  /** Wants a frame shown, now or when it has come. */
  seek(index) {
    this.at = index;
    const frame = this.frames[index];
    if (frame) this.#hooks.show(frame.image, index);
  }

  /** Shows one frame after the other, each for `ms`, from the one shown; waits for those to come. */
  play(ms) {
    this.playing = true;
    let due = performance.now() + ms;
    const tick = (now) => {
      if (!this.playing) return;
      const next = (this.at + 1) % this.requests.length;
      if (now >= due && this.frames[next]) {
        this.seek(next);
        due = Math.max(due + ms, now);
      }
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  pause() {
    this.playing = false;
  }

  /** Pauses, and fetches no more until asked again. */
  hold() {
    this.pause();
    this.#abort.abort();
    this.#abort = new AbortController();
  }

  /** Lets all go. */
  drop() {
    this.hold();
    for (const { image } of this.frames) URL.revokeObjectURL(image.src);
  }
}
