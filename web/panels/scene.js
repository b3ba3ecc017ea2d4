// The scene's panel: its text, what is wrong with it, a form for the usual fields, and files.
// What is typed is drawn as soon as the server finds nothing wrong; until then the last good
// picture stays.

import { fetchExplanation } from '../picture/server.js';
import { movedLight } from '../space/lamp.js';
import { serverFaults, syntaxFaults } from '../state/scene_faults.js';
import { subjectOf } from '../state/request.js';
import { formatScene, parseScene, withValue } from '../state/scene_text.js';
import { momentIn } from '../state/tracks.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { Editor } from './scene_editor.js';
import { showFaults } from './scene_faults.js';
import { mountDrop } from './scene_drop.js';
import { SceneForm } from './scene_form.js';
import { forget, keep, kept } from '../state/scene_keep.js';

const PAUSE_MS = 200; // so long the typing rests before the server is asked
const TAB = 'tab-scene';

/**
 * Mounts the panel and gives the studio `editScene(pointer, value)` or `([[pointer, value], ...])`, and
 * `steps`: `take(pairs)`, the same as a step of its own, `undo()`, `redo()`, `canUndo` and `canRedo`.
 */
export default function mountScene(studio, panel) {
  const desk = new Desk(studio, panel);
  studio.editScene = (pointer, value) => desk.edit(Array.isArray(pointer) ? pointer : [[pointer, value]]);
  studio.steps = desk.steps;
  mountDrop(studio, desk);
}

// Where the light stands that the hand moves, as words of the scene.
function placeOf(scene) {
  const { position, direction, corner, u, v } = movedLight(scene) ?? {};
  return JSON.stringify([position, direction, corner, u, v]);
}

class Desk {
  #studio;
  #editor = new Editor(() => this.#typed());
  #form;
  #names = new Map(); // by their text what asks for scenes of the gallery, and of models: these keep it
  #home = null; // what asks for the one that the text began as
  #seen = null; // the studio's source that the text has taken, or given
  #value = null; // the scene that the text means and the studio wants
  #late = false; // whether another scene waits to be shown in the text
  #timer = null;
  #judging = new AbortController();
  #kept = kept();
  #parts;

  constructor(studio, panel) {
    this.#studio = studio;
    this.#form = new SceneForm((pointer, value) => this.edit([[pointer, value]]));
    this.#furnish(panel);
    studio.model.on('source', () => this.#take());
    studio.model.on('tab', () => this.#late && studio.tab === TAB && this.#load());
    addEventListener('pagehide', () => this.#keep());
  }

  #furnish(panel) {
    const button = (name, press) =>
      element('button', { type: 'button', id: `scene-${name}`, onclick: press }, t(`scene.${name}`));
    this.#parts = {
      undo: button('undo', () => this.#editor.undo()),
      redo: button('redo', () => this.#editor.redo()),
      discard: button('discard', () => this.#discard()),
      state: element('p', { id: 'scene-state', class: 'note', role: 'status' }),
      faults: element('ul', { id: 'scene-faults', class: 'scene-faults' }),
    };
    const { undo, redo, discard, state, faults } = this.#parts;
    panel.append(
      element('div', { class: 'bar scene-bar' }, undo, redo, discard),
      this.#form.box, this.#editor.box, state, faults);
    this.#tell([]);
  }

  // ---- what the studio shows comes into the text ---------------------------------------------

  #take() {
    if (this.#studio.model.source === this.#seen) return;
    this.#late = true;
    if (this.#kept) this.#restore();
    else if (this.#studio.tab === TAB) this.#load();
  }

  #load() {
    const { source, request } = this.#studio.model;
    this.#late = false;
    if (!source || source === this.#seen) return;
    const same = this.#value && JSON.stringify(source) === JSON.stringify(this.#value);
    if (same) this.#seen = source; // such as from the address
    else this.#show(source, request);
  }

  #show(source, request) {
    const text = formatScene(source);
    if (typeof request.scene !== 'object') {
      this.#home = subjectOf(request);
      this.#names.set(text, this.#home);
    }
    this.#mean(source, text);
    this.#editor.load(text);
    this.#changed([]);
    this.#keep();
    if (typeof request.scene === 'object') this.#soon(0);
  }

  // After a reload the text comes back as it was, and with it what it means.
  #restore() {
    const text = this.#kept(this.#studio.model.request.scene);
    this.#kept = null;
    if (!text) return this.#take();
    this.#late = false;
    this.#home = Object(text.home) === text.home ? text.home : null;
    this.#mean(this.#studio.model.source);
    this.#editor.load(text.text);
    this.#editor.area.setSelectionRange(...text.caret);
    this.#judge();
  }

  #mean(source, text = formatScene(source)) {
    this.#seen = source;
    this.#value = parseScene(text).value;
  }

  /** Opens a text as the scene; `request` is wanted beside it. */
  open(text, request = {}) {
    if (this.#late) this.#load();
    const { value } = parseScene(text);
    this.#editor.load(text);
    if (value) {
      this.#seen = this.#value = value;
      this.#studio.open({ ...request, scene: value }, value);
    }
    this.#judge();
  }

  // ---- the text is what the studio shall show ------------------------------------------------

  /**
   * Changes values in the text, all else stays; false where the text cannot be read. Of one `kind` that
   * follow each other they are undone together.
   */
  edit(pairs, kind = pairs.map(([pointer]) => pointer).join()) {
    if (this.#late) this.#load();
    const { text } = this.#editor;
    if (!text || parseScene(text).faults.length) return false;
    const changed = pairs.reduce((now, [pointer, value]) => withValue(now, pointer, value), text);
    this.#editor.replace(changed, kind);
    this.#want();
    this.#changed([]);
    this.#soon(PAUSE_MS);
    return true;
  }

  get steps() {
    const [desk, editor] = [this, this.#editor];
    return {
      take: (pairs) => desk.edit(pairs, null),
      undo: () => editor.undo(),
      redo: () => editor.redo(),
      get canUndo() { return editor.history.canUndo; },
      get canRedo() { return editor.history.canRedo; },
    };
  }

  #typed() {
    this.#changed([]);
    this.#soon(PAUSE_MS);
  }

  #soon(ms) {
    this.#judging.abort();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#judge(), ms);
  }

  async #judge() {
    clearTimeout(this.#timer);
    this.#judging.abort();
    const { signal } = (this.#judging = new AbortController());
    const { text } = this.#editor;
    const broken = syntaxFaults(text);
    const faults = broken.length ? broken : await this.#faultsOf(text, signal);
    if (signal.aborted) return;
    this.#changed(faults);
    if (!faults.length) this.#want();
    this.#keep();
  }

  // Explaining one ray reads the whole scene and costs next to nothing.
  async #faultsOf(text, signal) {
    const scene = parseScene(text).value;
    try {
      const ray = { x: 0, y: 0, integrator: 'whitted', samples: 1, threshold: 0 };
      await fetchExplanation({ ...this.#wish(scene), scene, ...ray }, signal);
    } catch (problem) {
      return serverFaults(text, problem.errors ?? []) ?? []; // of all else the picture tells
    }
    return [];
  }

  #want() {
    const { text } = this.#editor;
    const { model } = this.#studio;
    const value = parseScene(text).value;
    if (!value || JSON.stringify(value) === JSON.stringify(this.#value)) return;
    const request = this.#wish(value);
    this.#seen = this.#value = value;
    model.want({ ...request, ...(this.#names.get(text) ?? { scene: value }) }, value);
  }

  // Light and camera stay where the hand has put them, but where the text has moved them since.
  #wish(scene) {
    const request = this.#studio.inScene;
    const moved = (name) => JSON.stringify(scene?.[name]) !== JSON.stringify(this.#value?.[name]);
    const lamp = placeOf(scene) !== placeOf(this.#value);
    const key = lamp || (request.key && !scene?.keys?.[request.key]);
    return {
      ...request,
      ...(moved('camera') && { camera: null }),
      ...(key && { key: null }),
      ...(lamp && { light: null }),
      time: momentIn(scene, request.time),
    };
  }

  // ---- what is told ---------------------------------------------------------------------------

  #changed(faults) {
    const { undo, redo, discard } = this.#parts;
    this.#editor.mark(faults);
    this.#tell(faults);
    undo.disabled = !this.#editor.history.canUndo;
    redo.disabled = !this.#editor.history.canRedo;
    discard.disabled = !this.#modified || !this.#home;
    const { value } = parseScene(this.#editor.text);
    this.#form.show(value ?? null);
  }

  #tell(faults) {
    const { state, faults: list } = this.#parts;
    const words = faults.length === 1 ? t('scene.oneFault')
      : faults.length ? t('scene.faults', { count: faults.length })
      : this.#editor.text && this.#modified ? t('scene.changed') : t('scene.unchanged');
    if (state.textContent !== words) state.textContent = words;
    showFaults(list, faults, {
      jump: ({ start, end }) => this.#editor.jump(start, end),
      fix: ({ fix }) => {
        this.#editor.replace(fix, null);
        this.#editor.area.focus({ preventScroll: true });
        this.#judge();
      },
    });
  }

  get #modified() {
    return !this.#names.has(this.#editor.text);
  }

  #discard() {
    const { request } = this.#studio.model;
    this.#seen = null;
    if (typeof request.scene === 'object') this.#studio.open({ ...request, ...this.#home, time: null });
    else this.#show(this.#studio.model.source, request);
    this.#editor.area.focus({ preventScroll: true });
  }

  #keep() {
    if (!this.#editor.text) return;
    if (!this.#modified || this.#late) return forget();
    const { text, area } = this.#editor;
    const caret = [area.selectionStart, area.selectionEnd];
    const told = keep({ text, caret, home: this.#home }, this.#studio.model.request.scene);
    if (told) this.#parts.state.textContent = t('scene.tooLarge');
  }
}
