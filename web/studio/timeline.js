// The timeline: the moment shown, what can be given keys, and the edits of its tracks. It holds no element
// of the page; panels/timeline_*.js show it. Loaded when the panel is first opened.

import { circle, trackValue } from '../space/track.js';
import { tidyVector } from '../space/vec.js';
import { keyed, movedKey, wholeAnimation, withoutKey, withoutTrack } from '../state/keys.js';
import { mergePatch } from '../state/merge_patch.js';
import { token, tokens, valueAt } from '../state/scene_text.js';
import { durationOf, lampPlace, momentIn, placeOf, trackAt, tracksOf } from '../state/tracks.js';

/** How many objects are offered by name. */
export const MOST_OBJECTS = 50;
const KEYS_AROUND = 8; // of a circle
const MOST_CHANGED = 5;

/** Timeline: `chosen`, the key that is edited, { track, key }, or null. Whoever asks hears of `timeline`. */
export class Timeline {
  chosen = null;
  thing = 'lamp'; // what was moved last: 'lamp', 'camera', 'object-N', or a place of the scene
  #changed = []; // places that were, the last one first
  #studio;
  #time = 0; // while nothing moves

  constructor(studio) {
    this.#studio = studio;
    studio.held.course = (place, time) => this.valueOf(place, time);
  }

  get scene() {
    return this.#studio.model.source;
  }

  get animation() {
    return wholeAnimation(this.scene);
  }

  get moves() {
    return durationOf(this.scene) > 0;
  }

  get time() {
    return Math.min(this.#studio.model.request.time ?? this.#time, this.animation.duration);
  }

  get frame() {
    return Math.round(this.time * this.animation.fps);
  }

  /** The last frame that the time can be put to, which is the animation's end. */
  get lastFrame() {
    const { duration, fps } = this.animation;
    return Math.round(duration * fps);
  }

  /** Frame k as a time, within the animation. */
  timeOf(frame) {
    const { duration, fps } = this.animation;
    return Math.min(duration, Math.max(0, frame / fps));
  }

  seek(time) {
    const { model } = this.#studio;
    if (time === this.time && (!this.moves || model.request.time != null)) return;
    this.#time = time;
    if (this.moves) model.change({ time });
    model.tell('timeline');
  }

  /** What a track, or none, makes of a place at a time; undefined where only the server knows. */
  valueOf(place, time) {
    const track = tracksOf(this.scene)[trackAt(this.scene, place)];
    return (track && trackValue(track, time)) ?? undefined;
  }

  // ---- edits ----------------------------------------------------------------------------------

  /** Edits the scene as a step that can be undone, or `joined` to one before; false where its text cannot be read. */
  edit(pairs, joined = false) {
    if (!pairs.length) return true;
    const { model, steps, editScene } = this.#studio;
    const done = joined ? editScene(pairs) : steps.take(pairs);
    if (done && this.moves && model.request.time == null) model.change({ time: momentIn(this.scene, this.#time) });
    model.tell('timeline');
    return done;
  }

  /** Sets how long it is, its `duration`, or its `fps`. */
  set(name, value) {
    const { animation, physics } = this.scene;
    const own = name === 'duration' && physics ? [['/physics/duration', value]] : [];
    if (animation) own.push([`/animation/${name}`, value]);
    return this.edit(own.length ? own : [['/animation', { ...this.animation, [name]: value }]]);
  }

  choose(chosen) {
    this.chosen = chosen;
    this.#studio.model.tell('timeline');
  }

  moveKey(track, key, time, joined) {
    return this.edit(movedKey(this.scene, track, key, time), joined);
  }

  removeKey(track, key) {
    this.chosen = null;
    return this.edit(withoutKey(this.scene, track, key));
  }

  removeTrack(track) {
    this.chosen = null;
    return this.edit(withoutTrack(this.scene, track));
  }

  /** A key more in a track, of what it makes at this moment. */
  addIn(track) {
    const place = placeOf(this.scene, tracksOf(this.scene)[track].target);
    const value = this.#studio.held.now(place) ?? valueAt(this.#studio.model.world, place);
    return value !== undefined && this.#add([{ place, value }]);
  }

  /** Keys for what is meant at this moment; null where it has no place now, false where the text cannot be read. */
  addFor(thing) {
    const { places, before = [], patch = {} } = this.#meant(thing);
    if (!places.length) return null;
    return this.#add(places, before, patch);
  }

  /** The same for all that a hand has put elsewhere than its track does. */
  addHeld() {
    const places = Object.entries(this.#studio.held.values).map(([place, value]) => ({ place, value }));
    return this.#add(places);
  }

  #add(places, before = [], patch = {}) {
    const { model } = this.#studio;
    const time = Number(this.time.toFixed(9));
    if (Object.keys(patch).length) model.change(patch);
    const done = this.edit([...before, ...keyed(this.scene, places, time)]);
    const track = done ? trackAt(this.scene, places[0].place) : -1;
    if (track >= 0) {
      const key = tracksOf(this.scene)[track].keys.findIndex(([t]) => t === time);
      this.choose(key < 0 ? null : { track, key });
    }
    return done;
  }

  /** The lamp once around what one looks at, in the time of the animation; null: it hangs straight above. */
  around() {
    const { light, pivot, model } = this.#studio;
    const places = light && pivot && circle(pivot, light, KEYS_AROUND);
    if (!places) return null;
    const { duration } = this.animation;
    const target = lampPlace(this.scene);
    const keys = [...places, places[0]].map((place, i) => [(i * duration) / KEYS_AROUND, place]);
    const track = { target, keys, interpolation: 'smooth', repeat: 'loop' };
    const at = trackAt(this.scene, target);
    const { tracks, ...rest } = this.animation;
    if (this.#ownLamp) model.change({ light: null, key: null });
    return this.edit(!this.scene.animation ? [['/animation', { ...rest, tracks: [track] }]]
      : [[`/animation/tracks/${at < 0 ? tracks.length : at}`, track]]);
  }

  // ---- what can be given keys ---------------------------------------------------------------------

  /** What is meant from now on is what stands at a place of the scene. */
  mean(place) {
    this.thing = place;
    this.#changed = [place, ...this.#changed.filter((one) => one !== place)].slice(0, MOST_CHANGED);
  }

  /** [{ id, name }], name null for lamp and camera, or { id, place }. */
  get things() {
    const objects = (this.scene?.objects ?? []).slice(0, MOST_OBJECTS);
    return ['lamp', 'camera'].map((id) => ({ id, name: null }))
      .concat(objects.map(({ name, type }, i) => ({ id: `object-${i}`, name: name ?? `${type} ${i + 1}` })),
        this.#changed.filter((place) => valueAt(this.scene, place) !== undefined).map((place) => ({ id: place, place })));
  }

  // { places: [{ place, target, value }], before: edits that they need, patch: of the request }
  #meant(thing) {
    if (thing === 'lamp') return this.#lampMeant();
    if (thing === 'camera') return this.#cameraMeant();
    if (thing.startsWith('/')) return this.#placeMeant(thing);
    return this.#objectMeant(Number(thing.slice(7)));
  }

  // Whether a request's light and key say nothing but where the lamp stands.
  get #ownLamp() {
    const patches = this.scene?.keys?.[this.#studio.model.request.key] ?? {};
    return Object.keys(patches).every((name) => name === 'light');
  }

  #lampMeant() {
    const place = lampPlace(this.scene);
    const value = this.#studio.light;
    if (!place || !value) return { places: [] };
    return { places: [{ place, target: place, value: [...value] }], patch: this.#ownLamp ? { light: null, key: null } : {} };
  }

  #cameraMeant() {
    const { camera, model } = this.#studio;
    const wanted = model.request.camera;
    const numbers = Object.keys(wanted ?? {}).filter((name) => typeof camera[name] === 'number');
    const names = ['location', camera.look_at ? 'look_at' : camera.direction ? 'direction' : null, ...numbers].filter(Boolean);
    const places = names.map((name) => ({ place: `/camera/${name}`, target: `/camera/${name}`,
      value: numbers.includes(name) ? camera[name] : tidyVector(camera[name], 6) }));
    return wanted ? { places, before: [['/camera', mergePatch(this.scene.camera ?? {}, wanted)]], patch: { camera: null } } : { places };
  }

  // A number, or a list of them, as it is written now.
  #placeMeant(place) {
    const value = valueAt(this.scene, place);
    if (value === undefined) return { places: [] };
    const [list, index, ...rest] = tokens(place);
    const target = list === 'objects' ? ['', list, this.#nameOf(Number(index)), ...rest.map(token)].join('/') : place;
    return { places: [{ place, target, value }] };
  }

  #objectMeant(index) {
    const object = this.scene?.objects?.[index];
    if (!object) return { places: [] };
    const steps = object.transform ?? [];
    const centred = object.center && !steps.length;
    const moves = steps.at(-1)?.translate;
    const at = moves ? steps.length - 1 : steps.length;
    const part = centred ? 'center' : `transform/${at}/translate`;
    const place = `/objects/${index}/${part}`;
    const value = this.#studio.held.now(place) ?? valueAt(this.scene, place) ?? [0, 0, 0];
    const before = centred || moves ? [] : [[`/objects/${index}/transform`, [...steps, { translate: [0, 0, 0] }]]];
    return { places: [{ place, target: `/objects/${this.#nameOf(index)}/${part}`, value }], before };
  }

  // By name where that means it alone: objects that come before it do not change what it is.
  #nameOf(index) {
    const { name } = this.scene.objects[index];
    const alone = this.scene.objects.filter((one) => one.name === name).length === 1;
    return name && alone && !/^(\d+|-)$/.test(name) ? token(name) : index;
  }
}
