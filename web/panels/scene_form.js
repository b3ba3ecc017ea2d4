// The form: one part of the scene at a time, its usual fields by the server's schema. What is
// changed here goes into the text.

import { fetchJson } from '../picture/server.js';
import { fieldsOf, materialOf, partsOf } from '../state/scene_fields.js';
import { has, t } from '../words/words.js';
import { element } from './element.js';
import { fieldElement } from './scene_field.js';

const PAUSE_MS = 3000; // before what did not come is asked for again
const GROUPS = ['objects', 'materials', 'lights', 'picture'];

/** SceneForm: `box` is its element; `edit(pointer, value)` hears of each change. */
export class SceneForm {
  #choice = element('select', { id: 'scene-part', onchange: () => this.#draw() });
  #fields = element('div', { class: 'scene-fields' });
  #about = element('p', { class: 'note scene-about', id: 'scene-about', lang: 'en' });
  box = element('details', { class: 'scene-form', open: true, ontoggle: () => this.#draw() },
    element('summary', {}, t('scene.form')),
    element('label', { for: 'scene-part', class: 'scene-part' }, t('scene.part'), this.#choice),
    this.#fields, this.#about);
  #edit;
  #scene = null;
  #schema = null;
  #parts = [];
  #shown = ''; // the names of the parts listed
  #made = { key: '', fields: [] };

  constructor(edit) {
    this.#edit = edit;
    this.#fields.addEventListener('focusin', ({ target }) => this.#tell(target));
  }

  /** Shows a scene; null where the text is broken: nothing can be changed then. */
  show(scene) {
    this.#scene = scene;
    this.#draw();
  }

  async #learn() {
    this.#schema = 'asked';
    try {
      this.#schema = await fetchJson('schema/scene.json');
      this.#draw();
    } catch {
      setTimeout(() => ((this.#schema = null), this.#draw()), PAUSE_MS);
    }
  }

  #draw() {
    for (const box of [this.#choice, ...this.#fields.children]) box.disabled = !this.#scene;
    if (!this.#scene || !this.box.open) return;
    if (!this.#schema) this.#learn();
    this.#list();
    if (this.#schema && this.#schema !== 'asked') this.#fill();
  }

  #list() {
    this.#parts = partsOf(this.#scene);
    const labels = this.#parts.map((part) => partWords(part));
    const shown = JSON.stringify([labels, this.#parts]);
    if (shown === this.#shown) return;
    const chosen = this.#shown ? this.#choice.value : null;
    this.#shown = shown;
    const optionsOf = (group) => this.#parts.flatMap((part, i) =>
      (part.group === group ? element('option', { value: part.pointer }, labels[i]) : []));
    this.#choice.replaceChildren(...GROUPS
      .map((group) => element('optgroup', { label: t(`scene.group_${group}`) }, optionsOf(group)))
      .filter((group) => group.children.length));
    if (this.#parts.some(({ pointer }) => pointer === chosen)) this.#choice.value = chosen;
  }

  // The elements stay while they mean the same fields, so that a slider is not lost under the hand.
  #fill() {
    const part = this.#parts.find(({ pointer }) => pointer === this.#choice.value);
    const material = materialOf(this.#scene, part);
    const sections = [{ pointer: part.pointer, words: partWords(part).trim() }];
    if (material) sections.push({ pointer: material.pointer, words: materialWords(material) });
    const filled = sections.map((section) =>
      ({ ...section, fields: fieldsOf(this.#schema, this.#scene, section.pointer) }));
    const shapeOf = ({ pointer, kind, value }) => [pointer, kind, Array.isArray(value) && value.length];
    const key = JSON.stringify(filled.map(({ words, fields }) => [words, fields.map(shapeOf)]));
    if (key !== this.#made.key) this.#make(key, filled);
    const all = filled.flatMap(({ fields }) => fields);
    this.#made.fields.forEach((field, i) => field.show(all[i].value));
  }

  #make(key, sections) {
    const fields = [];
    this.#fields.replaceChildren(...sections.map(({ words, fields: own }) => element('fieldset', {},
      element('legend', {}, words),
      own.map((field) => {
        const made = fieldElement(field, labelOf(field.name), (value) => this.#edit(field.pointer, value));
        fields.push(made);
        return made.box;
      }),
      own.length === 0 && element('p', { class: 'note' }, t('scene.noFields')))));
    this.#made = { key, fields };
    this.#about.textContent = '';
  }

  // What the schema says of the field that has focus.
  #tell(target) {
    const about = target.closest('[data-about]')?.dataset.about;
    if (about !== undefined) this.#about.textContent = about;
  }
}

const labelOf = (name) => (has(`scene.field_${name}`) ? t(`scene.field_${name}`) : name);

function partWords({ group, pointer, name, type, depth = 0 }) {
  const kind = type && has(`scene.type_${type}`) ? t(`scene.type_${type}`) : type;
  const fixed = { '/camera': 'camera', '': 'whole', '/options': 'options', '/key_light': 'keyLight' }[pointer];
  const number = Number(pointer.split('/').at(-1)) + 1;
  const words = fixed ? t(`scene.part_${fixed}`)
    : name ?? t(group === 'lights' ? 'scene.part_light' : 'scene.part_object', { number });
  return `${'\u00a0\u00a0'.repeat(depth)}${words}${kind ? ` (${kind})` : ''}`;
}

function materialWords({ name }) {
  return name === undefined ? t('scene.material') : t('scene.materialNamed', { name });
}
