// How a model is seen: its light, what it stands on, and what of the file is chosen.

import { hexOf, linearOf } from '../picture/srgb.js';
import { numberText } from '../state/request.js';
import { numberWords, t } from '../words/words.js';
import { element } from './element.js';

const STUDIOS = ['soft', 'neutral', 'sun', 'dark', 'headlight', 'none'];
const GROUNDS = ['shadow', 'floor', 'none'];
const BACKGROUNDS = ['transparent', 'color'];
const STEPS = 100; // of an animation
const MOST_HIDDEN = 64; // materials that can be hidden here

/** The form as { node, offer(description), draw() }. */
export function modelForm({ model }) {
  let cameras = [];
  let seconds = []; // of each animation
  const change = (patch) => () => model.change(patch());
  const select = (name, patch) => element('select', { name, onchange: change(patch) });
  const studio = select('studio', () => ({ studio: studio.value }));
  const ground = select('ground', () => ({ ground: ground.value }));
  const background = select('background', () => ({ background: background.value === 'color' ? [1, 1, 1] : null }));
  const color = element('input', { type: 'color', name: 'color',
    oninput: change(() => ({ background: linearOf(color.value, colorOf(model.request)) })) });
  const camera = select('camera', () => (camera.value === ''
    ? { camera: null } : { camera: Number(camera.value), orbit: null, zoom: null, fov: null }));
  const variant = select('variant', () => ({ variant: variant.value || null }));
  const animation = select('animation', () => (animation.value === ''
    ? { animation: null, time: null } : { animation: Number(animation.value), time: 0 }));
  const time = element('input', { type: 'range', name: 'time', min: 0, step: 'any',
    oninput: change(() => ({ time: Number(time.valueAsNumber.toFixed(4)) })) });
  const labels = Object.entries({ studio, ground, background, color, camera, variant, animation }).map(([name, field]) =>
    element('label', {}, element('span', {}, t(`model.${name}`)), field));
  const timing = element('label', { class: 'wide' }, element('span', {}, t('model.time')), time);
  const parts = element('div', { class: 'row wrap' });
  const hiding = element('fieldset', { class: 'choices check' }, element('legend', {}, t('model.hide')), parts);
  const node = element('form', { class: 'take-form', 'aria-label': t('model.form'),
    onsubmit: (event) => event.preventDefault() }, ...labels, hiding, timing);

  function offer(description) {
    cameras = description.cameras;
    seconds = description.animations.map((one) => one.seconds);
    const named = (list, word) => list.map(({ name }, i) => [i, name || t(`model.${word}Number`, { number: i + 1 })]);
    fill(studio, STUDIOS.map((name) => [name, t(`model.studio_${name}`)]));
    fill(ground, GROUNDS.map((name) => [name, t(`model.ground_${name}`)]));
    fill(background, BACKGROUNDS.map((name) => [name, t(`model.background_${name}`)]));
    const names = [...new Set(description.materials.map(({ name }) => name))]
      .filter((name) => /^[^\s,]([^,]*[^\s,])?$/.test(name)).slice(0, MOST_HIDDEN);
    parts.replaceChildren(...names.map((name) => element('label', {}, element('input', { type: 'checkbox', value: name,
      onchange: change(() => ({ hide: hidden().join() || null })) }), name)));
    hiding.hidden = names.length < 2;
    fill(camera, [['', t('model.around')], ...named(cameras, 'camera')]);
    fill(variant, [['', t('model.asItIs')], ...description.variants.map((name) => [name, name])]);
    fill(animation, [['', t('model.atRest')], ...named(description.animations, 'animation')]);
    for (const field of [camera, variant, animation]) field.parentElement.hidden = field.options.length < 2;
  }

  // What a link hides and is no material stays hidden.
  const boxes = () => [...parts.querySelectorAll('input')];
  const asked = () => (model.request.hide ?? '').split(',').filter(Boolean);
  const hidden = () => [...asked().filter((name) => !boxes().some((box) => box.value === name)),
    ...boxes().filter((box) => box.checked).map((box) => box.value)];

  function draw() {
    const { request } = model;
    for (const box of boxes()) box.checked = asked().includes(box.value);
    const seen = colorOf(request);
    show(background, seen ? 'color' : 'transparent');
    color.parentElement.hidden = !seen;
    if (seen) color.value = hexOf(seen);
    const named = cameras.findIndex(({ name }) => name === request.camera);
    show(studio, request.studio ?? 'soft');
    show(ground, request.ground ?? 'shadow');
    show(camera, named >= 0 ? named : request.camera ?? '');
    show(variant, request.variant ?? '');
    const playing = request.animation ?? (request.time == null ? '' : 0);
    show(animation, playing);
    const length = seconds[playing];
    timing.hidden = !length;
    if (!length) return;
    time.max = length;
    time.step = length / STEPS;
    if (time !== document.activeElement) time.value = request.time ?? 0;
    time.setAttribute('aria-valuetext', t('model.seconds', { at: numberWords(request.time ?? 0), all: numberWords(length) }));
  }

  return { node, offer, draw };
}

// The background's linear numbers, of which a link may tell one for grey; false: it is no colour.
const colorOf = ({ background: it }) => Array.isArray(it) && [0, 1, 2].map((i) => it[i] ?? it[0]);

function fill(select, choices) {
  select.replaceChildren(...choices.map(([value, words]) => element('option', { value }, words)));
}

// What a link asks for may be none of them: it is one of the choices, then.
function show(select, value) {
  const text = typeof value === 'number' ? numberText(value) : value;
  if (![...select.options].some((one) => one.value === text)) select.append(element('option', { value: text }, text));
  select.value = text;
}
