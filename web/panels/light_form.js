// The light's position as three typed numbers. Tells a position only when all three are numbers.

import { numberText, readNumber, readNumbers } from '../state/request.js';
import { t } from '../words/words.js';

const AXES = ['x', 'y', 'z'];

/** Wires the form; `move(light)` is told each new position. Returns `show(light or null)`. */
export function bindLightForm(form, message, move) {
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
