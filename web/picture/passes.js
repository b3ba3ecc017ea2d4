// How a wish becomes pictures: at once one that is quick enough for the hand, then the one that was
// asked for, where rays are chance in rounds, then the same with smooth edges. Where rays are chance and
// it takes long, it is one answer that clears up: its first parts are there as soon as a quick picture,
// which is left out unless the hand moves. One request at a time; of wishes that come meanwhile only the
// newest counts, and it does not wait for a finer picture of an older one.

import { ONE_RAY } from '../state/request.js';
import { pixelsOf, scaled } from '../state/window.js';
import { countingOptions, isChance, isFeature, usualOf } from './integrators.js';
import { roundAfter } from './rounds.js';

const FRAME_MS = 36; // for 30 pictures a second: while one is decoded the next is under way
const LEAST_MS = 8; // that the server may draw for, however slow the way to it is
const FIRST_GUESS = { perPixel: 1 / 5000, way: 0 }; // ms: begin small
const CHANCE_MS = 1 / 1000; // of a sample where rays are chance, as a first guess
const QUIET_MS = 120; // so long the hand must rest before a finer picture is begun
const LONG_MS = 1000; // for a picture to be drawn: then it clears up
const SCALES = [1, 1 / 2, 1 / 4, 1 / 8];

/** The threshold with which edges are smooth. */
export const SMOOTH = 0.02;

/** What holds of a picture's rays: the request's own word, else its scene's. */
const said = (name, request, options) => request[name] ?? countingOptions(request, options)?.[name];

/** The request with one ray a pixel, through its centre. */
export function plain(request, options) {
  return single(request, options) ? request : { ...request, ...ONE_RAY };
}

function single(request, options) {
  const others = ['threshold', 'noise', 'budget_ms', 'max_rays'];
  return samplesOf(request, options) === 1 && !others.some((name) => said(name, request, options));
}

/** How many samples a pixel has, at most. */
export const samplesOf = (request, options) =>
  said('samples', request, options) ?? usualOf(said('integrator', request, options), 'samples') ?? 1;

/** Whether its light is gathered along paths, by chance. */
export const isOfPaths = (request, options) => said('integrator', request, options) === 'path';

/** The request with the finest picture that the page draws of it: what it says itself holds. */
export function finest(request, options, smooth) {
  const feature = isFeature(said('integrator', request, options));
  const silent = request.samples == null && request.threshold == null;
  return smooth && silent && !feature && single(request, options) ? { ...request, threshold: SMOOTH } : request;
}

/**
 * The quickest picture of a wish. `pace` is what it took by now, in ms: `perPixel` to draw, `way`
 * for all that does not depend on the pixels.
 */
export function quickOf(request, options, { perPixel, way }) {
  const coarse = plain(request, options);
  const budget = Math.max(FRAME_MS - way, LEAST_MS);
  const affordable = (scale) => pixelsOf(request) * scale * scale * perPixel <= budget;
  const scale = SCALES.find(affordable) ?? SCALES.at(-1);
  return scale === 1 ? coarse : scaled(coarse, scale);
}

/** Whether a picture is to be seen while it is drawn: by chance, for long, and to no end of its own. */
export function clearsUp(request, options, pace) {
  const perPixel = pace === FIRST_GUESS ? CHANCE_MS : pace.perPixel;
  const ends = ['budget_ms', 'max_rays'].some((name) => said(name, request, options));
  return !ends && isChance(said('integrator', request, options))
    && pixelsOf(request) * samplesOf(request, options) * perPixel > LONG_MS;
}

/** The smallest picture of a request, with one ray a pixel. */
export const smallest = (request, options) => scaled(plain(request, options), SCALES.at(-1));

/** The next finer picture of a wish after `drawn`; null where that is the finest. */
export function finerOf(drawn, request, options, smooth, pace = FIRST_GUESS) {
  const last = finest(request, options, smooth);
  if (same(drawn, last)) return null;
  const round = isChance(said('integrator', request, options)) && !clearsUp(request, options, pace)
    ? roundAfter(drawn, request, samplesOf(request, options), said('noise', request, options)) : null;
  return round ?? (same(drawn, request) ? last : request);
}

const same = (a, b) => a === b || JSON.stringify(a) === JSON.stringify(b);

/**
 * Passes: `ask(request)` draws; `draw(request, signal, learn)` fetches and shows, giving { ms, drawn, cached },
 * the milliseconds in all and of the server's drawing, or throwing a Problem; where there is `learn`, it shows
 * also what there is until then, each part told to that as { ms, drawn, samples }; `told(problem or null, last,
 * request)` hears how it went; `optionsOf(request)` gives a scene's options as far as known.
 */
export class Passes {
  still = false; // not for now: one ray a pixel is wanted
  #draw;
  #told;
  #optionsOf;
  #pace = FIRST_GUESS;
  #took = []; // what the pace is the middle of
  #waiting = null; // { request, from, rested }
  #asked = -Infinity; // when something was asked for
  #running = false;
  #paused = false;
  #underWay = null; // { request, abort, finer, clearing }
  #wake = () => {};

  constructor({ draw, told, optionsOf }) {
    [this.#draw, this.#told, this.#optionsOf] = [draw, told, optionsOf];
  }

  /** Another scene may be another matter: begin small again. */
  forget() {
    [this.#pace, this.#took, this.#asked] = [FIRST_GUESS, [], -Infinity];
  }

  /** Whether something newer is wanted than what is being drawn. */
  get behind() {
    return this.#waiting !== null;
  }

  /**
   * Draws `request`, now or when the picture under way has come; `anew`, without waiting for that, unless it
   * is the same, clearing up; after `from`, the request of a coarser picture of the same that is there.
   */
  async ask(request, { anew = false, from = null } = {}) {
    if (anew && this.#underWay?.clearing && same(this.#underWay.request, request)) return;
    const now = performance.now();
    this.#waiting = { request, from, rested: anew || now - this.#asked > QUIET_MS };
    this.#asked = now;
    this.#paused = false;
    if (anew || this.#underWay?.finer) this.#underWay?.abort.abort();
    this.#wake();
    if (this.#running) return;
    this.#running = true;
    try {
      while (this.#waiting) await this.#drawWish();
    } finally {
      this.#running = false;
    }
  }

  /** Leaves what is under way, until something is asked for; gives whether anything was. */
  pause() {
    this.#paused = true;
    if (this.#underWay?.finer) this.#underWay.abort.abort();
    this.#wake();
    return this.#running;
  }

  async #drawWish() {
    const { request: wish, from, rested } = this.#waiting;
    this.#waiting = null;
    try {
      const options = this.#optionsOf(wish);
      const atOnce = !from && rested && clearsUp(wish, options, this.#pace);
      let pass = atOnce ? wish : quickOf(wish, options, this.#pace);
      if (from) pass = finerOf(from, wish, options, !this.still, this.#pace) ?? wish;
      for (let finer = atOnce || Boolean(from); pass && !this.#waiting && !this.#paused; finer = true) {
        await this.#drawPass(pass, finer);
        // How a scene that came by its name wants to be drawn may be known only now.
        const next = finerOf(pass, wish, this.#optionsOf(wish), !this.still, this.#pace);
        this.#told(null, !next, pass);
        if (next && !finer) await this.#quiet();
        pass = next;
      }
    } catch (problem) {
      if (problem.name !== 'AbortError') this.#told(problem, true, wish);
    }
  }

  async #drawPass(request, finer) {
    const clearing = finer && clearsUp(request, this.#optionsOf(request), this.#pace);
    this.#underWay = { request, abort: new AbortController(), finer, clearing };
    try {
      const took = await this.#draw(request, this.#underWay.abort.signal, clearing && ((part) => this.#learn(request, part)));
      if (!finer && !took.cached) this.#learn(request, took);
    } finally {
      this.#underWay = null;
    }
  }

  // The middle of the last few: one late picture is no reason for a coarse one.
  #learn(request, { ms, drawn, samples = 1 }) {
    this.#took = [{ perPixel: drawn / pixelsOf(request) / samples, way: ms - drawn }, ...this.#took].slice(0, 5);
    const middle = (name) => this.#took.map((each) => each[name]).sort((a, b) => a - b)[this.#took.length >> 1];
    this.#pace = { perPixel: middle('perPixel'), way: middle('way') };
  }

  // Resolves when nothing has been asked for QUIET_MS, or at once when something is.
  #quiet() {
    return new Promise((resolve) => {
      if (this.#waiting || this.#paused) return resolve();
      const timer = setTimeout(resolve, QUIET_MS);
      this.#wake = () => (clearTimeout(timer), resolve());
    });
  }
}
