// Radio: antennas in the scene, and what the server tells of the waves between them. It holds no element of
// the page; panels/radio_*.js show it. Loaded when the panel is first opened.

import { fetchMap, fetchMethods, fetchPaths } from '../picture/radio.js';
import { plansOf } from '../space/plan.js';
import { distanceOf } from '../space/lamp.js';
import { add, scale, tidyVector } from '../space/vec.js';
import { airAt } from './air.js';
import { Latest } from './latest.js';

export const KINDS = ['transmitter', 'receiver'];
export const MOST = 4; // antennas of a kind
export const METHODS = ['hybrid', 'image', 'sbr'];
export const BAND_HZ = 200e6; // around the frequency, of the channel
const POINTS = 201; // of the channel
const ROWS = [12, 36, 72]; // of a map's cells: while a hand moves, then finer
const PATIENCE_MS = 8000; // a map that would take longer is not asked for
const REST_MS = 350; // without a move: the hand rests
const SIDES = [0.27, 0.73]; // of the picture's width, where the first antennas stand

/**
 * Radio: `antennas` [{ kind, name, position }], `settings`; of the server `map` and, of the `pair` of antennas that
 * was chosen, `found`; `problem`, what kept either away, or null. Who asks hears of `radio` with what is new: 'antennas',
 * 'map', 'paths', 'methods', 'problem', or 'rest' once a hand has let go.
 */
export class Radio {
  antennas = [];
  chosen = {}; // a name of each kind
  settings = { frequency_hz: 5e9, quantity: 'gain', height: 1.5, power_dbm: 20, method: 'hybrid', max_reflections: 2, max_transmissions: 2, max_diffractions: 0 };
  map = null;
  found = null;
  methods = null; // what each of them found, once somebody compares
  comparing = false;
  held = false; // by a hand that moves
  area = null; // [x0, z0, x1, z1] of the plan from above; null where that plan is not level
  around = []; // where the first antennas stood
  #problems = {};
  #studio;
  #shown = { of: '', level: -1 }; // of the map: what it was asked, and how fine it is
  #fresh = true; // another scene: antennas stand where nobody has put them
  #asks = 0;
  #resting;
  #work = {};
  #told = {}; // what each work was asked that is told, as a text

  constructor(studio) {
    this.#studio = studio;
    for (const [name, work] of Object.entries({ map: this.#drawMap, paths: this.#findPaths, methods: this.#compare }))
      this.#work[name] = new Latest((_, signal) => work.call(this, signal), (problem) => this.#failed(name, problem));
    const { model } = studio;
    model.on('want', () => (this.#fresh ||= !studio.pivot));
    for (const event of ['rest', 'world', 'tab']) model.on(event, () => this.follow());
    model.on('tab', () => this.open || Object.values(this.#work).forEach((one) => one.leave()));
  }

  get open() {
    return this.#studio.tab === 'tab-radio';
  }

  get problem() {
    return this.#problems.paths ?? this.#problems.map ?? null;
  }

  /** The antenna of a kind whose paths are told. */
  of(kind) {
    const all = this.#all(kind);
    return all.find(({ name }) => name === this.chosen[kind]) ?? all[0];
  }

  /** Asks for what is not known yet, once the scene is known. */
  follow() {
    const { pivot, model } = this.#studio;
    if (!this.open || !pivot || !model.world) return;
    if (this.#fresh) this.#place();
    else this.#ask();
  }

  /** Changes settings, or which antennas are told. */
  set(settings) {
    Object.assign(this.settings, settings);
    this.#ask();
  }

  choose(kind, name) {
    this.chosen[kind] = name;
    this.#tell('antennas');
    this.#ask();
  }

  /** Puts an antenna somewhere; `held` by a hand that may move on. */
  move(antenna, position, held = false) {
    Object.assign(antenna, { position: tidyVector(position) });
    this.chosen[antenna.kind] = antenna.name;
    this.#hold(held);
    this.#tell('antennas');
    this.#ask();
  }

  /** One more of a kind, beside the last of it. */
  add(kind) {
    const all = this.#all(kind);
    const { pivot, camera } = this.#studio;
    const number = 1 + Math.max(...all.map((one) => one.number));
    const position = add(all.at(-1).position, scale(plansOf(camera)[0].across, distanceOf(pivot, camera.location) / 10));
    const one = antenna(kind, number, tidyVector(position));
    this.antennas = KINDS.flatMap((each) => [...this.#all(each), ...(each === kind ? [one] : [])]);
    this.choose(kind, one.name);
  }

  remove(gone) {
    this.antennas = this.antennas.filter((one) => one !== gone);
    this.#tell('antennas');
    this.#ask();
  }

  compare(on) {
    this.comparing = on;
    if (on) this.#ask();
  }

  /** Where the plan from above lies, as far as it is level. */
  see(area) {
    if (String(area) === String(this.area)) return;
    this.area = area;
    this.#ask();
  }

  // ---- places -------------------------------------------------------------------------------

  // On both sides of the picture, as high as the map where such places are seen.
  async #place() {
    this.#fresh = false;
    const { model } = this.#studio;
    const { world } = model;
    [this.antennas, this.chosen, this.map, this.found, this.#problems] = [[], {}, null, null, {}];
    this.#tell('antennas');
    try {
      const [left, right] = await Promise.all(SIDES.map((share) => airAt(this.#studio, share, this.settings.height)));
      if (model.world !== world) return (this.#fresh = true), this.follow();
      this.antennas = [antenna('transmitter', 1, tidyVector(left)), antenna('receiver', 1, tidyVector(right))];
    } catch (problem) {
      this.#fresh = true;
      return this.#failed('map', problem);
    }
    this.around = this.antennas.map(({ position }) => position);
    this.settings.height = this.of('receiver').position[1];
    this.#tell('antennas');
    this.#ask();
  }

  // ---- requests -----------------------------------------------------------------------------

  #ask() {
    if (!this.open || !this.antennas.length || this.#fresh || !this.#studio.model.world) return;
    this.#asks += 1;
    if (this.#finer) this.#work.map.leave();
    for (const name of ['paths', 'map']) this.#work[name].ask();
    if (this.comparing && !this.held) this.#work.methods.ask();
  }

  #finer = false; // a map that a hand need not wait for is under way

  #hold(held) {
    clearTimeout(this.#resting);
    this.held = held;
    if (held) this.#resting = setTimeout(() => ((this.held = false), this.#tell('rest'), this.#ask()), REST_MS);
  }

  #all(kind) {
    return this.antennas.filter((one) => one.kind === kind);
  }

  // By its name where that says it all; a moment of it, or what a key makes of its bodies, as it is shown.
  get #scene() {
    const { inScene: { scene, key, time }, model: { world, source } } = this.#studio;
    const patched = ['objects', 'materials'].some((name) => name in (source?.keys?.[key] ?? {}));
    if (time == null && !patched) return scene ?? 'thesis';
    const { camera, key_light, lights, ...bodies } = world;
    return bodies;
  }

  get #common() {
    const { frequency_hz, method, max_reflections, max_transmissions, max_diffractions, power_dbm } = this.settings;
    const sent = ({ name, position }) => ({ name, position, power_dbm });
    return { scene: this.#scene, transmitters: this.#all('transmitter').map(sent), frequency_hz, method,
      max_reflections, max_transmissions, max_diffractions };
  }

  get #pair() {
    const [{ name, position }, sender] = [this.of('receiver'), this.of('transmitter')];
    const common = this.#common;
    return { ...common, transmitters: common.transmitters.filter((one) => one.name === sender.name), receivers: [{ name, position }] };
  }

  async #findPaths(signal) {
    const offsets_hz = Array.from({ length: POINTS }, (_, i) => (i / (POINTS - 1) - 0.5) * BAND_HZ);
    const asked = { ...this.#pair, channel: { offsets_hz } };
    const of = JSON.stringify(asked);
    if (this.#told.paths === of) return;
    this.found = { ...await fetchPaths(asked, signal), asked };
    this.#told.paths = of;
    this.#tell('paths');
    this.#failed('paths', null);
  }

  // From coarse to fine, until a hand wants another.
  async #drawMap(signal) {
    const { quantity, height } = this.settings;
    const { area } = this;
    if (!area) return;
    const mine = this.#asks;
    const asked = { ...this.#common, quantity, height, area };
    const of = JSON.stringify(asked);
    for (const [level, rows] of ROWS.slice(0, this.held ? 1 : ROWS.length).entries()) {
      if (this.#shown.of === of && level <= this.#shown.level) continue;
      const start = performance.now();
      this.#finer = level > 0;
      const map = await fetchMap({ ...asked, cell: Math.min(area[2] - area[0], area[3] - area[1]) / rows }, signal).finally(() => (this.#finer = false));
      this.map = map;
      this.#shown = { of, level };
      this.#tell('map');
      this.#failed('map', null);
      const next = (performance.now() - start) * (ROWS[level + 1] / rows) ** 2;
      if (this.#asks !== mine || next > PATIENCE_MS) return;
    }
  }

  async #compare(signal) {
    const asked = this.#pair;
    const of = JSON.stringify({ ...asked, method: null });
    if (this.#told.methods === of) return;
    this.methods = await fetchMethods(asked, METHODS, signal);
    this.#told.methods = of;
    this.#tell('methods');
  }

  #failed(name, problem) {
    if (problem) this.#told[name] = null;
    if (problem === (this.#problems[name] ?? null)) return;
    this.#problems[name] = problem;
    this.#tell('problem');
  }

  #tell(what) {
    this.#studio.model.tell('radio', what);
  }
}

const antenna = (kind, number, position) => ({ kind, number, name: `${kind === 'receiver' ? 'Rx' : 'Tx'} ${number}`, position });
