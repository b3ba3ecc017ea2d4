// The light's panel: keys laid out as seen from above, and the position in numbers.

import { recall, remember } from '../state/memory.js';
import { numberText, readNumber, readNumbers } from '../state/request.js';
import { lampPlace } from '../state/tracks.js';
import { t } from '../words/words.js';
import { bindCopy } from './carry.js';

// The letters and Escape: while the picture has focus, everywhere, or not at all (WCAG 2.1.4,
// Character Key Shortcuts).
const KEYS = ['a', 'd', 's', 'w', 'Escape'];
const TYPING = 'input:not([type=checkbox], [type=range]), textarea, select, [contenteditable]';

/** Calls `act(key)` for a key that `where()`, "picture", "everywhere" or "off", lets through. */
function bindKeys(picture, where, act) {
  document.addEventListener('keydown', (event) => {
    const key = keyOf(event);
    if (!key || !listens(event.target)) return;
    event.preventDefault();
    if (!event.repeat) act(key);
  });

  function listens(target) {
    if (where() === 'off') return false;
    return target === picture || (where() === 'everywhere' && !target.closest?.(TYPING));
  }
}

// Layouts without Latin letters go by the key's place, the others by its letter.
function keyOf(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return undefined;
  const latin = /^[\x20-\x7e]+$/.test(event.key);
  const name = latin ? event.key : event.code.replace(/^Key/, '');
  return KEYS.find((key) => key.toLowerCase() === name.toLowerCase());
}

const AXES = ['x', 'y', 'z'];

/** Wires the form; `move(light)` is told each new position. Returns `show(light or null)`. */
function bindLightForm(form, message, move) {
  const fields = AXES.map((axis) => form.elements[axis]);
  let shown = null;
  let sent = '';

  function show(light) {
    shown = light;
    sent = '';
    fields.forEach((field, i) => (field.value = light ? numberText(light[i]) : ''));
    explain([], '');
  }

  function explain(wrong, words) {
    fields.forEach((field) => field.setAttribute('aria-invalid', wrong.includes(field)));
    message.textContent = words;
  }

  // Leaving a field sends what is new once all three are there. Enter and the button insist: they
  // send again, or say which one is missing.
  function apply(insist) {
    const empty = fields.filter((field) => field.value.trim() === '');
    const wrong = fields.filter((field) => !empty.includes(field) && !isNumber(field.value));
    if (wrong.length) return explain(wrong, wrong.map(wrongWords).join(' '));
    if (empty.length) return explain(insist ? empty : [], missingWords(empty));
    explain([], '');
    const text = fields.map((field) => field.value).join();
    if (text === sent && !insist) return;
    sent = text;
    shown = fields.map((field) => readNumber(field.value));
    move(shown);
  }

  function press(event) {
    const by = { ArrowUp: 1, ArrowDown: -1 }[event.key] * (event.shiftKey ? 10 : 1);
    if (!fields.includes(event.target)) return;
    if (event.key === 'Escape') show(shown);
    if (by) step(event.target, by);
    if (by || event.key === 'Enter') event.preventDefault();
    if (event.key === 'Enter') apply(true);
  }

  function step(field, by) {
    if (!isNumber(field.value)) return;
    field.value = numberText(Number((readNumber(field.value) + by).toFixed(6)));
    apply(false);
  }

  function paste(event) {
    const light = readNumbers(event.clipboardData.getData('text'));
    if (light?.length !== 3) return;
    event.preventDefault();
    show(light);
    apply(true);
  }

  form.addEventListener('submit', (event) => (event.preventDefault(), apply(true)));
  form.addEventListener('change', () => apply(false));
  form.addEventListener('keydown', press);
  form.addEventListener('paste', paste);
  return show;
}

function isNumber(text) {
  return Number.isFinite(readNumber(text));
}

function wrongWords({ name, value }) {
  return t('light.noNumber', { name, value: value.trim() });
}

function missingWords(empty) {
  const names = empty.map(({ name }) => name).join(', ');
  return t(empty.length > 1 ? 'light.missingMany' : 'light.missingOne', { names });
}

const part = (id) => document.getElementById(id);

export default function mountLight(studio) {
  const { model } = studio;
  const buttons = [...document.querySelectorAll('[data-key]')];
  const showPosition = bindLightForm(part('light'), part('fault'), (light) => studio.moveLight(light));
  const letters = part('letters');

  function press(key) {
    if (model.request.model) return;
    const light = model.source?.keys?.[key]?.light;
    const led = studio.held.leads(lampPlace(model.source));
    if (led && key === 'Escape') studio.held.letGo();
    else if (led && light) studio.moveLight(light);
    else if (key === 'Escape') model.change({ key: null, light: null });
    else model.change({ key, light: null });
  }

  function show() {
    const { key, light } = model.request;
    const on = key ?? (light ? 'typed' : 'Escape');
    for (const button of buttons) {
      button.setAttribute('aria-pressed', button.dataset.key === on);
      button.disabled = Boolean(model.request.model); // whose studio has no keys
    }
    part('pad').dataset.on = on;
    const lit = !key && !light && studio.light;
    buttons.find((button) => button.dataset.key === 'Escape').lastElementChild.textContent = t(lit ? 'light.own' : 'light.off');
    if (!part('light').contains(document.activeElement)) showPosition(studio.light);
  }

  letters.value = recall('letters') ?? 'picture';
  letters.addEventListener('change', () => remember('letters', letters.value));
  bindKeys(part('hand'), () => letters.value, press);
  for (const button of buttons) button.addEventListener('click', () => press(button.dataset.key));
  bindCopy(part('copy-light'), () => (studio.light ?? []).map(numberText).join(','));
  for (const event of ['show', 'world', 'source']) model.onFrame(event, show);
}
