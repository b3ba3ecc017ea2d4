// The chosen key, exactly: its time, its value, the way to the next one; and its track.

import { easedKey, joined, repeated, valuedKey } from '../state/keys.js';
import { numberText, readNumbers } from '../state/request.js';
import { tracksOf } from '../state/tracks.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { trackName } from './timeline_words.js';

const CHOICES = { ease: ['none', 'in', 'out', 'in_out'], interpolation: ['linear', 'smooth', 'step', 'bezier'],
  repeat: ['once', 'loop', 'pingpong'] };

/** The form as { node, draw() }; `gone()` hears when what it shows is deleted. */
export function keyForm(timeline, gone) {
  const legend = element('legend');
  const field = (name, input) => element('label', {}, element('span', {}, t(`timeline.${name}`)), input);
  const choice = (name, act) => {
    const select = element('select', { onchange: () => act(select.value) },
      CHOICES[name].map((one) => element('option', { value: one }, t(`timeline.${name}_${one}`))));
    return select;
  };
  const button = (name, press) => element('button', { type: 'button', onclick: press }, t(`timeline.${name}`));
  const scene = () => timeline.scene;
  const [track, key] = [() => timeline.chosen.track, () => timeline.chosen.key];
  const time = element('input', { type: 'number', min: 0, step: 'any', onchange: () =>
    (time.checkValidity() && time.value ? timeline.moveKey(track(), key(), time.valueAsNumber) : draw()) });
  const value = element('input', { spellcheck: 'false', onchange: () => setValue(timeline, value, draw) });
  const ease = choice('ease', (one) => timeline.edit(easedKey(scene(), track(), key(), one)));
  const interpolation = choice('interpolation', (one) => timeline.edit(joined(scene(), track(), one)));
  const repeat = choice('repeat', (one) => timeline.edit(repeated(track(), one)));
  const remove = button('removeKey', () => (timeline.removeKey(track(), key()), gone()));
  const removeAll = button('removeTrack', () => (timeline.removeTrack(track()), gone()));
  const ofKey = [field('keyTime', time), field('keyValue', value)];
  const easing = field('ease', ease);
  const ofTrack = [field('interpolation', interpolation), field('repeat', repeat)];
  const node = element('fieldset', { class: 'key-form' }, legend,
    element('div', { class: 'take-form' }, ...ofKey, easing, ...ofTrack), element('div', { class: 'row wrap' }, remove, removeAll));

  function draw() {
    const chosen = tracksOf(scene())[timeline.chosen?.track];
    const keys = chosen?.keys;
    const one = keys?.[key()];
    node.hidden = !chosen;
    if (!chosen) return;
    const name = trackName(scene(), chosen.target);
    legend.textContent = one ? t('timeline.keyOf', { name, at: key() + 1, count: keys.length }) : name;
    for (const each of [...ofKey, remove]) each.hidden = !one;
    for (const each of ofTrack) each.hidden = !keys;
    const way = chosen.interpolation ?? 'linear';
    easing.hidden = !one || key() === keys.length - 1 || way === 'bezier' || way === 'step';
    interpolation.value = way;
    repeat.value = chosen.repeat ?? 'once';
    if (!one) return;
    show(time, numberText(Number(one[0].toFixed(6))));
    show(value, textOf(one[1]));
    value.setAttribute('aria-invalid', false);
    ease.value = typeof one[2] === 'string' ? one[2] : 'none';
  }

  return { node, draw };
}

// What somebody is typing stays.
function show(field, text) {
  if (document.activeElement !== field || field.dataset.shown !== text) field.value = text;
  field.dataset.shown = text;
}

const textOf = (value) => (Array.isArray(value) && value.every(Number.isFinite) ? value.map((one) => numberText(one)).join(', ')
  : JSON.stringify(value));

// As many numbers as there were, or what JSON writes.
function setValue(timeline, field, draw) {
  const { track, key } = timeline.chosen;
  const [, old] = tracksOf(timeline.scene)[track].keys[key];
  const numbers = readNumbers(field.value);
  let value = Array.isArray(old) ? numbers : numbers?.length === 1 ? numbers[0] : undefined;
  if (typeof old !== 'number' && !Array.isArray(old)) value = parsed(field.value);
  const good = value != null && (!Array.isArray(old) || value.length === old.length);
  field.setAttribute('aria-invalid', !good);
  if (good && timeline.edit(valuedKey(track, key, value))) draw();
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
