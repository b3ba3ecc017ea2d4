// The studio: what all panels share. It holds the model, draws what is wanted, and knows where
// camera, lamp and what one looks at are in the picture shown.

import { isChance } from '../picture/integrators.js';
import { finest, Passes, plain, samplesOf, smallest, SMOOTH } from '../picture/passes.js';
import { readRecipe } from '../picture/png_text.js';
import { fetchExplanation, fetchPicture, fetchScene, fetchStillScene } from '../picture/server.js';
import { countOf, totalMs } from '../picture/timing.js';
import { lightOf, pivotOf } from '../space/lamp.js';
import { completeCamera, viewOf } from '../space/view.js';
import { mergePatch } from '../state/merge_patch.js';
import { inScene, ONE_RAY, queryOf, spelled } from '../state/request.js';
import { lampPlace } from '../state/tracks.js';
import { middleOf, pixelsOf, sizeOf } from '../state/window.js';
import { Held } from './held.js';
import { Model } from './model.js';

export class Studio {
  model = new Model();
  paused = false; // the picture that is clearing up
  pivot = null; // what the camera looks at, once the server has told
  held = new Held(this.model); // hears first what is wanted
  carry = (request) => request; // another request of the same picture, which is sent
  #passes;
  #shower = async () => {};
  #failed = () => {};
  #sourceProblem = null; // what kept the scene's text away, until it comes
  #notice = null; // what is wrong with the link that was opened, until something else is
  #showing = null; // the picture that is being decoded
  #matter = ''; // scene and key of the world that is known
  #moment; // and its time
  #middle = ''; // and what the pivot depends on

  constructor() {
    this.#passes = new Passes({
      draw: (...asked) => this.#draw(...asked),
      told: (problem, last, request) => this.#told(problem, last, request),
      optionsOf: () => this.model.source?.options,
    });
    for (const event of ['want', 'ask']) this.model.on(event, () => this.#askAfter(this.#wish()));
    let left = false; // pages that are left may come back as they were
    addEventListener('pagehide', () => (left = !this.paused && this.#passes.pause()));
    addEventListener('pageshow', () => left && ((left = false), this.again()));
  }

  /** Starts with a request and, where one is asked for, a pixel; `problem` is told beside the picture. */
  async begin({ request, asked, problem }) {
    this.model.asked = asked ?? null;
    const opened = this.open(request);
    this.#notice = problem ?? null;
    await opened;
  }

  /** Wants another scene or the same anew; what is known of the old one is forgotten. */
  async open(request, source = null) {
    this.pivot = null;
    this.model.world = null;
    [this.#sourceProblem, this.#notice] = [null, null];
    this.#passes.forget();
    this.model.want(spelled(request), source);
    if (!this.model.source) await this.#learnSource();
  }

  /** Draws what is wanted once more, such as after a failure. */
  again() {
    if (!this.model.source) this.#learnSource();
    this.#passes.ask(this.#wish());
  }

  /** Leaves the picture under way and keeps what is shown. */
  pause() {
    this.paused = true;
    this.#passes.pause();
    this.model.tell('pause');
  }

  /** Draws on from there. */
  goOn() {
    this.model.tell('want');
  }

  // Goes on from what is shown after a pause, and where only the denoiser is another.
  #askAfter(wish) {
    const { shown } = this.model;
    const goesOn = this.paused || Boolean(shown?.request.denoise) !== Boolean(wish.denoise);
    this.paused = false;
    this.#passes.ask(wish, { from: goesOn && samplesThere(shown, wish) !== null ? shown.request : null });
  }

  /** Whether edges are smoothed: the request's word, so that a link to the picture holds it. */
  get smooth() {
    const { request, source } = this.model;
    const { threshold } = finest(request, source?.options, true);
    return (threshold ?? source?.options?.threshold ?? 0) > 0;
  }

  set smooth(on) {
    this.model.change({ threshold: on ? this.model.source?.options?.threshold || SMOOTH : 0 });
  }

  /** The request whose picture the page ends on: what a file or a shell gets. */
  get final() {
    const wish = this.#wish();
    return this.#lasting(finest(wish, this.model.source?.options, !this.model.asked));
  }

  /** The same while nothing is asked: what a link says, beside the pixel that is asked about. */
  get unasked() {
    return this.#lasting(finest(this.model.request, this.model.source?.options, true));
  }

  // What a budget has come to is the same picture at any time.
  #lasting(request) {
    const { shown } = this.model;
    return shown?.reached && queryOf(shown.request) === queryOf(request)
      ? { ...request, samples: shown.reached, budget_ms: null, max_rays: null } : request;
  }

  /** The camera that is wanted, every spelling as the scene has it. */
  get camera() {
    const { world, source } = this.model;
    return completeCamera(this.held.cameraOf((world ?? source)?.camera, this.inScene.camera));
  }

  /** What is wanted as a request of /render: a still as the scene of the picture shown. */
  get inScene() {
    const { request, world, source } = this.model;
    return inScene(request, world ?? source);
  }

  /** The camera of the picture wanted, in the whole picture's pixels. */
  get view() {
    return viewOf(this.camera, ...sizeOf(this.model.request));
  }

  /** Where the lamp is that is wanted; null where it is out, or not known yet. */
  get light() {
    const { request, source, world } = this.model;
    const place = lampPlace(source);
    const own = this.held.leads(place) ? this.held.now(place) : request.light;
    return own ?? (world ? lightOf(world, this.pivot) : null);
  }

  /** Where the lamp is in the picture shown; null where it is out, undefined where not known yet. */
  get lightShown() {
    const { shown, world } = this.model;
    if (shown?.request.light && !this.held.leads(lampPlace(this.model.source))) return shown.request.light;
    return shown && this.#knows(shown.request) && shown.request.time === this.#moment ? lightOf(world, this.pivot) : undefined;
  }

  /** Puts the lamp there. What a key has changed beside the light stays as it is. */
  moveLight(light) {
    const place = lampPlace(this.model.source);
    if (this.held.leads(place)) this.held.put({ [place]: light });
    else this.model.change(this.lightPatch(light));
  }

  /** What changes in a request when the lamp is put there. */
  lightPatch(light) {
    const { request, source, world } = this.model;
    if (request.model) return { ...this.#scenePatch, light };
    const patches = request.key && Object.keys(source?.keys?.[request.key] ?? {}).some((it) => it !== 'light');
    if (!patches) return { light, key: null };
    return this.#knows(request) ? { light, key: null, scene: world, camera: null } : {};
  }

  /** Changes fields of the camera. */
  moveCamera(fields) {
    const { model } = this;
    const all = Object.entries(fields);
    const led = all.filter(([name]) => this.held.leads(`/camera/${name}`));
    if (led.length) this.held.put(Object.fromEntries(led.map(([name, value]) => [`/camera/${name}`, value])));
    const own = Object.fromEntries(all.filter((one) => !led.includes(one)));
    if (led.length < all.length) model.change({ ...this.#scenePatch, camera: { ...this.inScene.camera, ...own } });
  }

  /** Changes values of the scene, [[JSON Pointer, value]], or holds what a track moves; false: it cannot be. */
  put(pairs) {
    if (!pairs.some(([place]) => this.held.leads(place))) return Boolean(this.editScene?.(pairs));
    this.held.put(Object.fromEntries(pairs));
    return true;
  }

  // What a still does not know makes a scene of it.
  get #scenePatch() {
    const { request } = this.model;
    const gone = Object.keys(request).map((name) => [name, null]);
    return request.model ? { ...Object.fromEntries(gone), ...this.inScene } : {};
  }

  /** How the picture is shown: `show(picture, request, last)`, and what is told of failures. */
  display({ show, failed }) {
    [this.#shower, this.#failed] = [show, failed];
  }

  // While a pixel is asked about, the picture has one ray a pixel: the ray that is explained. A model
  // is seen by the method whose rays can be.
  #wish() {
    const { request: own, source, asked } = this.model;
    const wanted = this.held.of(own);
    this.#passes.still = Boolean(asked);
    if (!asked) return wanted;
    const request = wanted.model ? { ...wanted, integrator: 'whitted' } : wanted;
    return source ? plain(request, source.options) : { ...request, ...ONE_RAY };
  }

  async #draw(request, signal, learn) {
    const start = performance.now();
    const show = (picture, of) => this.#showNext(picture, of, start);
    const there = samplesThere(this.model.shown, request, this.model.source?.options);
    const picture = await fetchPicture(await this.carry(request), signal, learn && (async (round) => {
      const samples = Math.floor(countOf(round.rays, 'primary') / pixelsOf(request));
      const drawn = totalMs(round.timing);
      if (samples > 0 && drawn > 0 && !round.resumed) learn({ ms: round.ms, drawn, samples });
      if (samples < (there ?? 0)) return; // it is coarser than what is there
      const of = { ...request, samples };
      await show(round, of);
      if (!this.#knows(of)) this.#told(null, false, of);
    }));
    await show(picture, request);
    return { ms: picture.ms, drawn: totalMs(picture.timing), cached: picture.cached };
  }

  // Where the hand has gone on, the next picture is fetched while this one is decoded.
  async #showNext(picture, request, start) {
    await this.#showing?.catch(() => {}); // one that cannot be decoded is in nobody's way
    this.#showing = this.#show(picture, request, start);
    if (!this.#passes.behind) await this.#showing;
    else this.#showing.catch(() => {});
  }

  async #show(picture, request, start) {
    await this.#shower(picture, request);
    this.model.show({ ...picture, request, ms: performance.now() - start });
  }

  async #told(problem, last, request) {
    if (problem) {
      this.model.tell('fail', problem);
      return this.#failed(problem);
    }
    this.#failed(this.#sourceProblem ?? this.#notice);
    if (this.#passes.behind) return; // the hand has gone on
    if (last) this.model.tell('rest');
    if (!last && this.#knows(request)) return; // a hand moves things: one look is enough, at its end
    if (!this.#isShown(request)) return; // the hand was quicker
    await this.#look(request, this.model.shown.blob)
      .catch((error) => console.warn('The scene of the picture:', error.message));
  }

  // Whether what is shown is that, or the same of other samples.
  #isShown(request) {
    return samplesThere(this.model.shown, request) !== null;
  }

  // Whether the world is the one of this request's scene and key.
  #knows(request) {
    return this.model.world !== null && this.#matter === matterOf(request);
  }

  // What the picture was drawn from, told by itself, or by a small one while it clears up, and what its
  // middle shows.
  async #look(request, blob) {
    const recipe = await readRecipe(blob) ?? await this.#recipeOf(request);
    if (!recipe || !this.#isShown(request)) return;
    [this.#matter, this.#moment] = [matterOf(request), request.time];
    this.model.world = this.#whole(recipe.request.scene, request.key);
    // An edited scene goes on about the same point: what moves away from there is not run after.
    const middle = JSON.stringify([request.key, request.camera, request.crop]);
    if (request.model && this.model.source) this.model.know(this.model.world); // its eye and lights go with it
    if (middle !== this.#middle || !this.pivot)
      await this.#findPivot(request, middle).catch((error) => console.warn('The picture\u2019s middle:', error.message));
    if (this.#isShown(request)) this.model.tell('world');
  }

  async #recipeOf(request) {
    const { blob } = await fetchPicture(smallest(request, this.model.source?.options));
    return readRecipe(blob);
  }

  // A recipe does not tell very many objects again; they are the source's, as the key leaves them.
  #whole(scene, key) {
    const { source } = this.model;
    const { objects, materials } = mergePatch(source ?? {}, source?.keys?.[key]);
    return { ...scene, ...(typeof scene.objects === 'string' && { objects, materials }), options: source?.options };
  }

  // Of light only `whitted` explains; what a ray hits is the same for all.
  async #findPivot(request, middle) {
    const [x, y] = middleOf(request);
    const asked = { ...request, ...ONE_RAY, integrator: 'whitted' };
    const { hits } = await fetchExplanation({ ...asked, x, y });
    if (!this.#isShown(request)) return; // the hand was quicker
    this.#middle = middle;
    this.pivot = pivotOf(this.view, this.camera, hits);
  }

  async #learnSource() {
    const { request } = this.model;
    if (typeof request.scene === 'object') return;
    const held = () => matterOf({ ...this.model.request, key: null }) === matterOf({ ...request, key: null });
    try {
      const source = await (request.model ? fetchStillScene(request) : fetchScene(request.scene ?? 'thesis'));
      if (!held()) return;
      this.model.know(source);
      // What was begun without knowing that has all its samples.
      if (isChance(source.options?.integrator)) this.#passes.ask(this.#wish(), { anew: true });
      if (this.#sourceProblem) this.#failed((this.#sourceProblem = null));
    } catch (problem) {
      if (held()) this.#failed((this.#sourceProblem = problem));
    }
  }
}

/** The studio's final picture, as fetchPicture gives it; what is shown already is not asked for. */
export async function finalPicture({ final, model }, signal) {
  const { shown } = model;
  const there = shown && queryOf(shown.request) === queryOf(final);
  return there ? shown : { ...await fetchPicture(final, signal), request: final };
}

// How many samples there are of a request's picture; null: what is shown is of another.
function samplesThere(shown, request, options) {
  const bare = (one) => queryOf({ ...one, ...Object.fromEntries(Object.keys(ONE_RAY).map((name) => [name, null])) });
  return shown && bare(shown.request) === bare(request) ? samplesOf(shown.request, options) : null;
}

// What decides which scene a request's picture is of, but for light and camera.
const matterOf = ({ scene = 'thesis', key = null, model }) => JSON.stringify([scene, key, model]);
