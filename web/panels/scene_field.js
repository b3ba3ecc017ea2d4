// One field of the form, by its kind.

import { hexOf, linearOf } from '../picture/srgb.js';
import { numberText, readNumber } from '../state/request.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const AXES = ['x', 'y', 'z', 'w'];
const CHANNELS = ['red', 'green', 'blue'];
const ABOUT = { 'aria-describedby': 'scene-about' };
const MAKERS = {
  number: numberField, numbers: numbersField, color: colorField,
  choice: choiceField, truth: truthField, text: textField,
};

/** { box, show(value) } for a field of a part; `tell(value)` hears what a person makes of it. */
export function fieldElement(field, label, tell) {
  const { box, show } = MAKERS[field.kind](field, label, tell);
  box.dataset.field = field.name;
  box.dataset.about = aboutWords(field);
  return { box, show };
}

function aboutWords({ name, schema }) {
  const { description = '', minimum, exclusiveMinimum, maximum, default: usual } = schema;
  const least = exclusiveMinimum ?? minimum;
  const range = least !== undefined && maximum !== undefined && ` ${least} \u2026 ${maximum}.`;
  const standard = usual !== undefined && ` (${JSON.stringify(usual)})`;
  return `${name}: ${description}.${range || ''}${standard || ''}`;
}

// Shows a value but where somebody is just typing it.
const put = (input, value) => document.activeElement !== input && (input.value = value);

/** An input for a number that tells only what is one. */
function numberInput(name, tell) {
  const input = element('input', { inputmode: 'text', spellcheck: 'false', autocomplete: 'off',
    class: 'scene-number', 'aria-label': name, ...ABOUT });
  input.addEventListener('input', () => {
    const number = readNumber(input.value);
    input.setAttribute('aria-invalid', !Number.isFinite(number));
    if (Number.isFinite(number)) tell(number);
  });
  return input;
}

function numberField({ schema, range }, label, tell) {
  const slider = element('input', { type: 'range', ...range, 'aria-label': label, ...ABOUT });
  const whole = schema.type === 'integer';
  const exact = numberInput(t('scene.exactly', { label }), (number) => tell(number));
  slider.addEventListener('input', () => tell(whole ? Math.round(slider.valueAsNumber) : slider.valueAsNumber));
  return {
    box: element('div', { class: 'field' }, element('span', { 'aria-hidden': 'true' }, label), slider, exact),
    show(value) {
      if (document.activeElement !== slider) slider.value = value;
      slider.setAttribute('aria-valuetext', numberText(value));
      put(exact, numberText(value));
    },
  };
}

function numberRow(names, label, change) {
  let values = [];
  const inputs = names.map((name, i) => numberInput(`${label}, ${name}`, (number) => change(values.with(i, number))));
  return {
    inputs,
    show(shown) {
      values = shown;
      inputs.forEach((input, i) => put(input, numberText(shown[i])));
    },
  };
}

function numbersField({ value }, label, tell) {
  const { inputs, show } = numberRow(AXES.slice(0, value.length), label, tell);
  return {
    box: element('div', { class: 'field', role: 'group', 'aria-label': label },
      element('span', { 'aria-hidden': 'true' }, label),
      element('span', { class: 'scene-row' }, inputs)),
    show,
  };
}

// The picker shows codes as screens do, the numbers are linear light; a lone number means grey.
function colorField(field, label, tell) {
  let shown = [0, 0, 0];
  const picker = element('input', { type: 'color', 'aria-label': label, ...ABOUT });
  picker.addEventListener('input', () => tell(linearOf(picker.value, shown)));
  const { inputs, show } = numberRow(CHANNELS.map((name) => t(`scene.${name}`)), label, tell);
  return {
    box: element('div', { class: 'field', role: 'group', 'aria-label': label },
      element('span', { 'aria-hidden': 'true' }, label),
      element('span', { class: 'scene-row' }, picker, inputs)),
    show(value) {
      shown = typeof value === 'number' ? [value, value, value] : value;
      picker.value = hexOf(shown);
      show(shown);
    },
  };
}

function choiceField({ schema }, label, tell) {
  const onchange = () => tell(select.value);
  const select = element('select', { 'aria-label': label, ...ABOUT, onchange },
    schema.enum.map((name) => element('option', { value: name }, name)));
  return { box: row(label, select), show: (value) => (select.value = value) };
}

function truthField(field, label, tell) {
  const onchange = () => tell(box.checked);
  const box = element('input', { type: 'checkbox', 'aria-label': label, ...ABOUT, onchange });
  return { box: row(label, box), show: (value) => (box.checked = value) };
}

function textField(field, label, tell) {
  const input = element('input', { 'aria-label': label, ...ABOUT, spellcheck: 'false' });
  input.addEventListener('input', () => tell(input.value));
  return { box: row(label, input), show: (value) => put(input, value) };
}

function row(label, ...children) {
  return element('div', { class: 'field' }, element('span', { 'aria-hidden': 'true' }, label), ...children);
}
