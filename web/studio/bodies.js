// Bodies: what physics says of the scene, and what the server has found out about their motion.

import { fetchMotion } from '../picture/motion.js';
import { trackValue } from '../space/track.js';
import { add, dot, normalize, scale } from '../space/vec.js';
import { middleOf, physicsOf, rolesOf } from '../state/bodies.js';
import { placeOf, tracksOf } from '../state/tracks.js';

/** Bodies: `motion`, what /simulate has told of the scene, or null; whoever asks hears of `motion`. */
export class Bodies {
  motion = null;
  #timeline;
  #model;
  #draft = null; // roles, as long as nothing falls
  #of = null; // the scene that the motion is of
  #abort = new AbortController();

  constructor(studio, timeline) {
    [this.#model, this.#timeline] = [studio.model, timeline];
    this.#model.on('source', () => this.#learn());
    this.#learn();
  }

  get physics() {
    return this.#timeline.scene?.physics ?? null;
  }

  get roles() {
    const told = rolesOf(this.#timeline.scene);
    return this.physics ? told : told.map((one, i) => ({ ...one, ...this.#draft?.[i] }));
  }

  /** Changes what object `index` does, or of its body; at once, where bodies fall. */
  set(index, { role, ...body }) {
    const roles = this.roles.map((one) => (one.index !== index ? one
      : { ...one, ...(role && { role }), body: { ...one.body, ...body } }));
    if (this.physics) return this.#write(roles, true);
    this.#draft = roles;
    this.#model.tell('timeline');
    return true;
  }

  /** Lets fall what is to; null where nothing is. */
  begin() {
    return physicsOf(this.#timeline.scene, this.roles, 1) && this.#write(this.roles);
  }

  /** Lets nothing fall any more. */
  end() {
    this.#draft = this.roles;
    return this.#timeline.edit([['/physics', undefined]]);
  }

  #write(roles, joined = false) {
    const { scene, animation: { duration } } = this.#timeline;
    const physics = physicsOf(scene, roles, duration);
    return this.#timeline.edit([['/physics', physics ?? undefined]], joined);
  }

  async #learn() {
    const { scene } = this.#timeline;
    if (scene === this.#of) return;
    this.#of = scene;
    this.#abort.abort();
    const { signal } = (this.#abort = new AbortController());
    if (!scene?.physics) return this.#take(null);
    try {
      this.#take(await fetchMotion(scene, signal));
    } catch (problem) {
      if (!signal.aborted) this.#take(null); // of what is wrong the picture tells
    }
  }

  #take(motion) {
    if (motion === this.motion) return;
    this.motion = motion;
    this.#model.tell('motion');
  }

  /** The bodies' ways: [{ index, at(time) }], the place of what stood at the object's own. */
  get ways() {
    if (!this.motion) return [];
    const { scene } = this.motion;
    return tracksOf(scene).flatMap((track) => {
      const [, index] = /^\/objects\/(\d+)\/transform\/\d+\/translate$/.exec(placeOf(scene, track.target)) ?? [];
      if (index === undefined || !this.roles[index] || this.roles[index].role !== 'falls') return [];
      const base = middleOf(scene.objects[index]); // the step that is led stands at its zero there
      return [{ index: Number(index), at: (time) => add(base, trackValue(track, time) ?? [0, 0, 0]) }];
    });
  }

  get scene() {
    return this.#timeline.scene;
  }

  /** Where a way is at its contacts; those of other bodies are on it only by chance, and are told apart by name. */
  contactsAt(way) {
    const { name } = this.roles[way.index] ?? {};
    return (this.motion?.contacts ?? []).filter(({ a, b }) => a === name || b === name).slice(0, 100).map(({ time }) => way.at(time));
  }

  /** How high a body is, against gravity. */
  heightOf({ at }, time) {
    const gravity = this.physics?.gravity ?? [0, -9.81, 0];
    const up = Math.hypot(...gravity) > 0 ? normalize(scale(gravity, -1)) : [0, 1, 0];
    return dot(at(time), up);
  }

  /** The last contact until a time, or null. */
  lastUntil(time) {
    return (this.motion?.contacts ?? []).findLast((one) => one.time <= time + 1e-9) ?? null;
  }
}
