// The controls of a path: which way, how many frames, how long, and the film's own buttons.

import { numberText } from '../state/request.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const [LEAST, MOST, USUAL] = [8, 120, 36];

/**
 * The form: `state` as { kind, places, closed, frames, seconds }, `draw({ playing, showing, there, count })`,
 * `at(index)`, `tell(words)`; it calls `place()` for where the lamp is, `changed`, `play`, `pause`,
 * `seek(index)`, `keep`, `use` and `close`.
 */
export function pathForm({ place, changed, play, pause, seek, keep, use, close }) {
  const state = { kind: 'circle', places: [], closed: true, frames: USUAL, seconds: 3 };
  const button = (name, press) => element('button', { type: 'button', onclick: press }, t(`path.${name}`));
  const progress = element('p', { class: 'note' });
  const told = element('p', { class: 'told', role: 'status' });
  const list = element('ol', { class: 'places' });
  const closed = element('input', { type: 'checkbox', checked: true,
    onchange: () => set({ closed: closed.checked }) });
  const toggle = button('play', () => (toggle.dataset.playing ? pause() : play()));
  const frames = numberField('frames', LEAST, MOST, 1);
  const seconds = numberField('seconds', 0.5, 30, 0.5);
  const scrub = element('input', { type: 'range', min: 0, max: USUAL - 1, step: 1, value: 0,
    oninput: () => seek(scrub.valueAsNumber) });
  const kinds = ['circle', 'places'].map((kind) => element('input', {
    type: 'radio', name: 'path-kind', value: kind, checked: kind === state.kind, onchange: () => set({ kind }) }));
  const adder = button('add', add);
  const through = element('div', { class: 'through' },
    adder, list,
    element('label', { class: 'check' }, closed, t('path.closed')));
  const used = element('div', { class: 'row wrap' }, button('use', use), button('close', close));

  function numberField(name, min, max, step) {
    const field = element('input', { type: 'number', min, max, step, value: state[name] });
    field.addEventListener('change', () => {
      if (field.checkValidity() && field.value) set({ [name]: field.valueAsNumber });
      else field.value = state[name];
    });
    return element('label', {}, element('span', {}, t(`path.${name}`)), field);
  }

  function add() {
    const light = place();
    tell(light ? '' : t('path.lampOff'));
    if (light) set({ places: [...state.places, light] });
  }

  function tell(words) {
    told.textContent = words;
  }

  function set(patch) {
    Object.assign(state, patch);
    scrub.max = state.frames - 1;
    list.replaceChildren(...state.places.map(placeItem));
    changed();
  }

  function placeItem(light, i) {
    const drop = () => {
      set({ places: state.places.filter((_, other) => other !== i) });
      adder.focus();
    };
    const remove = element('button', { type: 'button', 'aria-label': t('path.removeAt', { at: i + 1 }),
      onclick: drop }, t('path.remove'));
    return element('li', {}, element('span', {}, light.map(numberText).join(', ')), ' ', remove);
  }

  function draw({ playing = false, showing = false, there = 0, count = 0 } = {}) {
    through.hidden = state.kind !== 'places';
    toggle.textContent = t(playing ? 'path.pause' : 'path.play');
    toggle.dataset.playing = playing ? 'yes' : '';
    used.hidden = !showing || playing;
    progress.textContent = count ? t('path.there', { there, count }) : '';
  }

  draw();
  return {
    state, draw, tell,
    nodes: [
      element('fieldset', { class: 'choices' }, element('legend', {}, t('path.kinds')),
        kinds.map((radio) => element('label', {}, radio, t(`path.${radio.value}`)))),
      through,
      element('div', { class: 'take-form' }, frames, seconds),
      element('label', { class: 'wide' }, t('path.scrub'), scrub),
      element('div', { class: 'row wrap' }, toggle, button('keep', keep)),
      progress, used, told,
    ],
    at: (index) => {
      scrub.value = index;
      scrub.setAttribute('aria-valuetext', t('path.frame', { at: index + 1, count: state.frames }));
    },
  };
}
