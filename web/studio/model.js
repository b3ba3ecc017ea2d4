// What is wanted and what is shown: the one place that holds them. Panels change what is wanted;
// the picture's passes tell what is shown; whoever listens draws itself.

import { tidy } from '../state/request.js';

/**
 * Model: `request`, what is wanted; `source`, the JSON of its scene as it was fetched or written,
 * null until known; `shown`, the last picture with its request, null at first; `world`, the scene
 * of the picture shown after its key, light and camera, null until known; `asked`, the pixel [x, y]
 * whose colour is to be explained, or null; `rays`, what explains it, as [{ from, to, aim, kind,
 * current, blocked }] in the scene (a blocked one aims farther than it gets), or null.
 * Events: `want`, `source`, `show` (a picture came), `fail` (none came, and why), `rest` (nothing finer
 * follows), `pause` (for now), `world`, `ask`, `rays`, and `tab` (another one was opened).
 */
export class Model {
  request = {};
  source = null;
  shown = null;
  world = null;
  asked = null;
  rays = null;
  #listeners = new Map();

  on(event, listener) {
    this.#listeners.set(event, [...(this.#listeners.get(event) ?? []), listener]);
  }

  /** The same for what is seen only: once an animation frame, however often the event comes. */
  onFrame(event, listener) {
    let due = false;
    this.on(event, () => {
      if (due) return;
      due = true;
      requestAnimationFrame(() => ((due = false), listener(this)));
    });
  }

  tell(event, about) {
    for (const listener of this.#listeners.get(event) ?? []) listener(this, about);
  }

  /** Wants `patch` on top of what is wanted; null takes a parameter away. */
  change(patch) {
    this.want({ ...this.request, ...patch });
  }

  /** Wants a request as it stands. Another scene needs its source again. */
  want(request, source = null) {
    const other = ['scene', 'model'].some((name) => request[name] !== this.request[name]);
    this.request = tidy(request);
    if (source || other) this.source = source ?? (typeof request.scene === 'object' ? request.scene : null);
    this.tell('want');
    if (this.source && (source || other)) this.tell('source');
  }

  know(source) {
    this.source = source;
    this.tell('source');
  }

  show(shown) {
    this.shown = shown;
    this.tell('show');
  }

  /** Asks about the pixel [x, y]; null asks no more. */
  ask(pixel) {
    this.asked = pixel;
    this.tell('ask');
  }
}
