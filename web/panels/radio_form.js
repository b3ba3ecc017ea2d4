// What is asked of the waves: their frequency, what the map shows and where, and how paths are found.

import { METHODS } from '../studio/radio.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const GHZ = [2.4, 3.5, 5, 28];
const QUANTITIES = ['gain', 'power', 'sinr', 'best_server', 'delay_spread'];
// Of a setting: least, most, step, and what one of the field is in the server's units.
const NUMBERS = { frequency_hz: [0.001, 300, 'any', 1e9], height: [-1e4, 1e4, 'any', 1], power_dbm: [-100, 100, 'any', 1],
  max_reflections: [0, 10, 1, 1], max_transmissions: [0, 10, 1, 1], max_diffractions: [0, 1, 1, 1] };

/** The form of a Radio's settings as { node, draw() }. */
export function radioForm(radio) {
  const fault = element('p', { class: 'fault', id: 'radio-fault', role: 'status' });
  const field = (name, control) => element('label', {}, element('span', {}, t(`radio.${name}`)), control);
  const choice = (name, all, words) => element('select', { name, onchange: ({ target }) => radio.set({ [name]: target.value }) },
    all.map((one) => element('option', { value: one, selected: one === radio.settings[name] }, words(one))));
  const numbers = Object.fromEntries(Object.keys(NUMBERS).map((name) => [name, numberField(radio, name, fault, () => follow())]));
  const band = element('select', { name: 'band', onchange: () => take(band.value) },
    [...GHZ, ''].map((one) => element('option', { value: one }, one ? t('radio.ghz', { ghz: one.toLocaleString(document.documentElement.lang) }) : t('radio.free'))));

  function take(ghz) {
    const { frequency_hz: own } = numbers;
    if (!ghz) return own.focus();
    own.value = ghz;
    own.dispatchEvent(new Event('change'));
  }

  // A frequency that is typed may be one of the usual ones, or none.
  function follow() {
    const { value } = numbers.frequency_hz;
    band.value = GHZ.includes(Number(value)) ? value : '';
  }

  function draw() {
    for (const [name, input] of Object.entries(numbers))
      if (input !== document.activeElement) input.value = radio.settings[name] / NUMBERS[name][3];
    follow();
  }

  follow();
  const node = element('form', { class: 'take-form', 'aria-label': t('radio.form'), onsubmit: (event) => event.preventDefault() },
    field('band', band), field('frequency_hz', numbers.frequency_hz),
    field('quantity', choice('quantity', QUANTITIES, (one) => t(`radio.is_${one}`))), field('height', numbers.height),
    field('method', choice('method', METHODS, (one) => t(`radio.${one}`))),
    Object.keys(NUMBERS).slice(3).map((name) => field(name, numbers[name])), field('power_dbm', numbers.power_dbm), fault);
  return { node, draw };
}

function numberField(radio, name, fault, changed) {
  const [min, max, step, unit] = NUMBERS[name];
  const made = element('input', { type: 'number', name, min, max, step, required: true, value: radio.settings[name] / unit,
    'aria-describedby': fault.id, onchange() {
      const good = made.checkValidity();
      made.setAttribute('aria-invalid', !good);
      fault.textContent = good ? '' : t(step === 1 ? 'radio.whole' : 'radio.range', { name: t(`radio.${name}`), least: min, most: max });
      if (good) radio.set({ [name]: made.valueAsNumber * unit });
      changed();
    } });
  return made;
}
