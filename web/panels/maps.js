// Two plans beside the picture, from above and from the right: the server's own parallel views,
// and on them what a hand can take: the lamp, the camera, what it looks at, and the objects.

import { fetchPfm, fetchPicture } from '../picture/server.js';
import { centersIn, ownersOf, readPfm } from '../picture/feature_image.js';
import { placeIn, placeWithin, planCamera, plansOf, regionOf, wayIn } from '../space/plan.js';
import { aimMoved, eyeMoved } from '../space/eye.js';
import { distanceOf } from '../space/lamp.js';
import { add, tidyVector } from '../space/vec.js';
import { rayThrough } from '../space/view.js';
import { t } from '../words/words.js';
import { element, svg } from './element.js';
import { bindHandle } from './handle.js';
import { drawnRay } from './rays.js';

const [WIDTH, HEIGHT] = [240, 180];
const MOST = 12; // objects that a hand can take
const LARGEST = 0.4; // of the plan: what fills more is a floor or a wall
const [ROOM, ROOMIER] = [0.3, 0.4]; // around what the camera looks at, of its distance
const FAR = 2.5; // times as far as the eye: a lamp out there stands at the plan's edge
const COARSE = { width: WIDTH / 3, height: HEIGHT / 3 };
const DRAWN = { width: 480, height: 360, samples: 1, threshold: 0, crop: null };

export function mountMaps(studio) {
  const maps = ['top', 'side'].map((name) => new PlanMap(studio, name));
  document.getElementById('maps').replaceChildren(...maps.map(({ figure }) => figure));
  for (const event of ['world', 'show', 'source', 'rays', 'ways', 'radio'])
    studio.model.onFrame(event, () => maps.forEach((map) => map.follow(event)));
}

class PlanMap {
  #studio;
  #name;
  #backdrop = svg('image', { width: WIDTH, height: HEIGHT, preserveAspectRatio: 'none' });
  #rays = svg('g', { class: 'rays' });
  #sight = svg('path', { class: 'sight' });
  #ways = svg('g', { class: 'ways' });
  #handles = svg('g');
  #plan = null;
  #region = null;
  #near; // points shown instead of camera and lamp
  #drawn = ''; // what the backdrop shows
  #drawing = null;
  #aimed = null; // the last camera that a handle has moved, and what it looks `at`
  #held = new Map(); // handles by name; they live on while the hand holds them

  constructor(studio, name) {
    [this.#studio, this.#name] = [studio, name];
    const label = t(`maps.${name}`);
    this.figure = element('figure', { class: 'map' },
      svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'group', 'aria-label': label },
        this.#backdrop, this.#sight, this.#ways, this.#rays, this.#handles),
      element('figcaption', { class: 'note' }, label));
  }

  /** Draws what an event has changed. */
  follow(event) {
    const { pivot, light, camera } = this.#studio;
    if (!pivot) return;
    const held = [...this.#held.values()].some((handle) => handle.held);
    const { near } = this.#studio;
    if ((event === 'world' || near !== this.#near) && !held) this.#settle(pivot, light, camera, (this.#near = near));
    if (!this.#plan) return;
    this.#placeHandles(pivot, light, camera);
    this.#drawSight(camera);
    if (event !== 'show') this.#drawRays();
    if (event === 'world' || event === 'ways') this.#studio.drawWays?.(this.#ways, (point) => this.#at(point));
  }

  #settle(pivot, light, camera, instead) {
    this.#plan = plansOf(camera).find(({ name }) => name === this.#name);
    const away = distanceOf(pivot, camera.location);
    const near = light && distanceOf(pivot, light) < FAR * away;
    const around = [-away, away].flatMap((by) => [0, 1, 2].map((i) => pivot.with(i, pivot[i] + by * (instead ? ROOMIER : ROOM))));
    this.#region = regionOf(this.#plan, [...around, ...(instead ?? [camera.location, ...(near ? [light] : [])])]);
    // What is above the eye and what it looks at is left away: ceilings, walls on this side.
    const start = regionOf(this.#plan, [pivot, camera.location]).center;
    this.#region.center = this.#plan.into.map((axis, i) => (axis ? start : this.#region.center)[i]);
    this.#drawBackdrop();
  }

  async #drawBackdrop() {
    const request = { ...this.#studio.held.from(this.#studio.inScene), ...DRAWN, camera: planCamera(this.#plan, this.#region) };
    const drawn = JSON.stringify(request);
    if (drawn === this.#drawn) return;
    this.#drawn = drawn;
    this.#drawing?.abort();
    const { signal } = (this.#drawing = new AbortController());
    try {
      const { blob } = await fetchPicture({ ...request, integrator: 'albedo' }, signal);
      const objects = readPfm(await fetchPfm({ ...request, ...COARSE, integrator: 'object' }, signal));
      if (signal.aborted) return;
      this.#show(blob);
      const centers = centersIn(objects, ownersOf(this.#studio.model.world ?? {}));
      this.#placeObjects(centers.filter(({ share }) => share < LARGEST).slice(0, MOST));
    } catch (problem) {
      if (!signal.aborted) this.#drawn = '';
    }
  }

  #show(blob) {
    const old = this.#backdrop.getAttribute('href');
    this.#backdrop.setAttribute('href', URL.createObjectURL(blob));
    if (old) URL.revokeObjectURL(old);
  }

  // ---- handles --------------------------------------------------------------------------------

  #placeObjects(centers) {
    const there = new Set(centers.map(({ index }) => `object-${index}`));
    for (const [name, handle] of this.#held) // the others stay: one of them may have the focus
      if (name.startsWith('object') && !handle.held && !there.has(name)) this.#drop(name);
    const objects = this.#studio.model.world?.objects ?? [];
    for (const { index, x, y } of centers) {
      if (!objects[index]) continue;
      const name = objects[index].name ?? `${objects[index].type} ${index + 1}`;
      this.#handle(`object-${index}`, [x * WIDTH, y * HEIGHT], t('maps.moveObject', { name, map: t(`maps.${this.#name}`) }),
        this.#objectMover(index));
    }
  }

  // Each move is counted from where the object was when it was taken.
  #objectMover(index) {
    let taken = null;
    return {
      take: () => (taken = this.#objectNow(index)),
      move: (way) => Boolean(taken) && this.#studio.put(movedObject(taken, index, way)),
    };
  }

  // As the scene says, or where a track has led it.
  #objectNow(index) {
    const { source, world } = this.#studio.model;
    const object = source?.objects?.[index] ?? null;
    if (!object) return null;
    const [[place]] = movedObject(object, index, [0, 0, 0]);
    return (this.#studio.held.leads(place) && world?.objects?.[index]) || object;
  }

  #placeHandles(pivot, light, camera) {
    const map = t(`maps.${this.#name}`);
    this.#handle('camera', this.#within(camera.location), t('maps.moveCamera', { map }), this.#cameraMover(eyeMoved));
    this.#handle('target', this.#within(this.#target), t('maps.moveTarget', { map }), this.#cameraMover(aimMoved));
    if (light) this.#handle('lamp', this.#within(light), t('maps.moveLamp', { map }), this.#lampMover());
    else this.#drop('lamp');
    const plan = { ...this.#plan, region: this.#region, height: HEIGHT, sheet: this.#rays.parentNode, map, names: [...this.#held.keys()],
      at: (point) => this.#within(point),
      handle: (...all) => this.#handle(...all), drop: (name) => this.#held.get(name)?.held || this.#drop(name) };
    this.#studio.placeArrows?.(plan);
    this.#studio.placeRadio?.(plan);
  }

  #lampMover() {
    const studio = this.#studio;
    let taken = null;
    return {
      take: () => (taken = studio.light),
      move: (way) => (studio.moveLight(tidyVector(add(taken, way))), true),
    };
  }

  // `moved(taken, way)` gives the camera's fields that change, null where it cannot go there.
  #cameraMover(moved) {
    const studio = this.#studio;
    let taken = null;
    return {
      take: () => (taken = { camera: studio.camera, pivot: this.#target }),
      move: (way) => {
        const fields = moved(taken, way);
        if (!fields) return false;
        studio.moveCamera(fields);
        this.#aimed = { camera: studio.model.request.camera, at: fields.look_at ?? taken.pivot };
        return true;
      },
    };
  }

  // What the camera looks at: where a hand has just put it, else what the server has found there.
  get #target() {
    const { model, pivot } = this.#studio;
    return this.#aimed && this.#aimed.camera === model.request.camera ? this.#aimed.at : pivot;
  }

  #handle(name, at, label, mover) {
    const known = this.#held.get(name);
    if (known) return known.held || known.place(at, label);
    const handle = bindHandle(this.#handles, name.split('-')[0], at, label, {
      take: mover.take,
      move: (way) => mover.move(wayIn(this.#plan, this.#region, HEIGHT, way)),
    });
    this.#held.set(name, handle);
  }

  #drop(name) {
    this.#held.get(name)?.remove();
    this.#held.delete(name);
  }

  // ---- lines ----------------------------------------------------------------------------------

  #at(point) {
    return placeIn(this.#plan, this.#region, HEIGHT, point);
  }

  #within(point) {
    return placeWithin(this.#plan, this.#region, HEIGHT, point);
  }

  #drawSight(camera) {
    const { view } = this.#studio;
    const reach = this.#region.half;
    const lines = [[0, view.height / 2], [view.width, view.height / 2], [view.width / 2, 0], [view.width / 2, view.height]]
      .slice(this.#name === 'top' ? 0 : 2, this.#name === 'top' ? 2 : 4)
      .map(([x, y]) => rayThrough(view, x, y))
      .map(({ origin, direction }) => `M${this.#at(origin)}L${this.#at(add(origin, direction.map((it) => it * reach)))}`);
    this.#sight.setAttribute('d', lines.join(''));
    this.#sight.dataset.of = camera.projection;
  }

  #drawRays() {
    const place = (from, to) => ({ a: this.#at(from), b: this.#at(to), ends: true });
    const rays = this.#studio.model.rays ?? [];
    this.#rays.replaceChildren(...rays.map((ray) => drawnRay(ray, place, HEIGHT / 24)));
  }
}

// The edits, [[JSON Pointer, value]], that move an object by `way`.
function movedObject(object, index, way) {
  const pointer = `/objects/${index}`;
  if (object.center && !object.transform) return [[`${pointer}/center`, tidyVector(add(object.center, way), 5)]];
  const steps = object.transform ?? [];
  const last = steps.at(-1)?.translate;
  const translate = tidyVector(add(last ?? [0, 0, 0], way), 5);
  if (last) return [[`${pointer}/transform/${steps.length - 1}/translate`, translate]];
  return [[`${pointer}/transform`, [...steps, { translate }]]];
}
