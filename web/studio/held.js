// What a hand has put elsewhere than its track does: it stands there in the picture until the time or the
// scene is another, or a key is made of it.

import { heldRequest, isTracked, unled } from '../state/tracks.js';

/** Held: `values` by JSON Pointer; `course(place, time)`, where a track leads, once somebody knows. */
export class Held {
  values = {};
  course = () => undefined;
  #model;
  #at = null; // the time and scene that it is of

  constructor(model) {
    this.#model = model;
    model.on('want', () => this.#follow());
  }

  /** Whether a track moves what is at a place of the scene. */
  leads(place) {
    const { source, request } = this.#model;
    return !request.model && isTracked(source, place);
  }

  /** Where what a track moves is now; undefined where only the picture's own scene tells. */
  now(place) {
    return this.values[place] ?? this.course(place, this.#model.request.time ?? 0);
  }

  /** Puts something elsewhere, values by place. */
  put(values) {
    const { request, source } = this.#model;
    this.values = { ...this.values, ...values };
    this.#at = { time: request.time, source };
    for (const event of ['want', 'held']) this.#model.tell(event);
  }

  /** Leaves all to the tracks again. */
  letGo() {
    if (this.#clear()) this.#model.tell('want');
  }

  #follow() {
    const { request, source } = this.#model;
    if (this.#at && (this.#at.time !== request.time || this.#at.source !== source)) this.#clear();
  }

  #clear() {
    if (!this.#at) return false;
    [this.#at, this.values] = [null, {}];
    this.#model.tell('held');
    return true;
  }

  /** The request of the picture with what is held. */
  of(request) {
    return heldRequest(request, this.#model.source, this.values);
  }

  /** What another camera sees of that: { scene, key, time }. */
  from(request) {
    const { scene, key, time } = this.of(request);
    const whole = typeof scene === 'object' ? scene : this.#model.source;
    return { scene: unled(whole) === whole ? scene : unled(whole), key, time };
  }

  /** A camera whose fields are the request's own, but for those that tracks move. */
  cameraOf(camera, own = {}) {
    const names = Object.keys({ ...camera, ...own }).filter((name) => this.leads(`/camera/${name}`));
    const led = names.map((name) => [name, this.now(`/camera/${name}`) ?? camera?.[name]]);
    return { ...camera, ...own, ...Object.fromEntries(led) };
  }
}
