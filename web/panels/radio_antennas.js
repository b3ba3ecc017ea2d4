// The antennas by number: each with its place, and which of them are told.

import { KINDS, MOST } from '../studio/radio.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const AXES = ['x', 'y', 'z'];

/** The antennas as { node, draw() }. */
export function antennaForm(radio) {
  const rows = element('div', { class: 'radio-antennas' });
  const adders = Object.fromEntries(KINDS.map((kind) => [kind, element('button', { type: 'button', onclick: () => radio.add(kind) }, t(`radio.add_${kind}`))]));
  const choosers = Object.fromEntries(KINDS.map((kind) => [kind, element('select', { onchange: ({ target }) => radio.choose(kind, target.value) })]));
  const chosen = element('div', { class: 'take-form' },
    KINDS.map((kind) => element('label', {}, element('span', {}, t(`radio.choose_${kind}`)), choosers[kind])));
  const node = element('div', { class: 'radio-places', role: 'group', 'aria-label': t('radio.antennas') }, element('h2', {}, t('radio.antennas')),
    rows, element('div', { class: 'row wrap' }, Object.values(adders)), chosen);
  let fields = new Map();

  function draw() {
    const names = radio.antennas.map(({ name }) => name);
    if ([...fields.keys()].join() !== names.join()) {
      fields = new Map(radio.antennas.map((antenna) => [antenna.name, row(antenna)]));
      rows.replaceChildren(...[...fields.values()].map(({ made }) => made));
    }
    for (const antenna of radio.antennas) fields.get(antenna.name).draw(antenna);
    for (const kind of KINDS) {
      const all = radio.antennas.filter((one) => one.kind === kind);
      adders[kind].disabled = all.length >= MOST;
      choosers[kind].replaceChildren(...all.map(({ name }) => element('option', { selected: name === radio.of(kind).name }, name)));
    }
    chosen.hidden = radio.antennas.length <= KINDS.length;
  }

  function row({ name, kind }) {
    const now = () => radio.antennas.find((one) => one.name === name);
    const inputs = AXES.map((axis, i) => element('input', { type: 'number', step: 'any', required: true, 'aria-label': t('radio.axis', { name, axis }),
      onchange: ({ target }) => target.checkValidity() && radio.move(now(), now().position.with(i, target.valueAsNumber)) }));
    const remove = element('button', { type: 'button', 'aria-label': t('radio.remove', { name }), title: t('radio.remove', { name }), onclick() {
      radio.remove(now());
      adders[kind].focus();
    } }, '\u00d7');
    const made = element('div', { class: `radio-antenna is-${kind}` }, element('span', { class: 'name' }, name),
      inputs.map((input, i) => element('label', {}, element('span', { 'aria-hidden': 'true' }, AXES[i]), input)), remove);
    return { made, draw({ position }) {
      for (const [i, input] of inputs.entries()) if (input !== document.activeElement || input.valueAsNumber !== position[i]) input.value = position[i];
      remove.disabled = radio.antennas.filter((one) => one.kind === kind).length < 2;
    } };
  }

  return { node, draw };
}
