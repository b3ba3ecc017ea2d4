// How the picture is drawn: its size, its edges, and how many rays it takes.

import { aboutOf, countingOptions, lightNames, usualOf } from '../picture/integrators.js';
import { resized, sizeOf, usualSizeOf } from '../state/window.js';
import { t, wordsOr } from '../words/words.js';
import { element } from './element.js';

const SIZES = [[320, 240], [512, 512], [640, 480], [800, 600], [1024, 768], [1280, 960], [1600, 1200], [1920, 1440]];
// Least, most and step.
const NUMBERS = { samples: [1, 65536, 1], noise: [0, 1, 'any'], max_depth: [0, 64, 1], exposure: [-32, 32, 'any'],
  seed: [0, Number.MAX_SAFE_INTEGER, 1] };

/** The form as { node, draw() }. */
export function takeForm(studio) {
  const { model } = studio;
  const size = element('select', { name: 'size',
    onchange: () => resize(studio, size.value.split('x').map(Number)) });
  const method = element('select', { name: 'integrator',
    onchange: () => model.change({ integrator: method.value || null }) });
  const smooth = element('input', { type: 'checkbox', name: 'smooth',
    onchange: () => (studio.smooth = smooth.checked) });
  const fault = element('p', { class: 'fault', id: 'take-fault', role: 'status' });
  const numbers = Object.entries(NUMBERS).map(([name, range]) => numberField(name, range, fault, model));
  const node = element('form', { class: 'take-form', 'aria-label': t('take.form'),
    onsubmit: (event) => event.preventDefault() },
    labelled('size', size), labelled('integrator', method),
    ...numbers.map(({ name, field }) => labelled(name, field)),
    element('label', { class: 'check' }, smooth, t('take.smooth')), fault);

  function draw() {
    const { request, source } = model;
    const [width, height] = sizeOf(request);
    choices(size, SIZES.map((one) => one.join('x')), `${width}x${height}`,
      (value) => value.replace('x', ' \u00d7 '));
    choices(method, ['', ...lightNames()], request.integrator ?? '',
      (value) => (value ? wordsOr(`take.method_${value}`, aboutOf(value)) : t('take.asScene')));
    smooth.checked = studio.smooth;
    const integrator = request.integrator ?? source?.options?.integrator ?? 'whitted';
    const own = countingOptions(request, source?.options);
    for (const { name, field } of numbers) {
      if (field === document.activeElement) continue;
      field.value = request[name] ?? '';
      field.placeholder = own?.[name] ?? usualOf(integrator, name) ?? '';
    }
  }

  return { node, draw };
}

function labelled(name, field) {
  return element('label', {}, element('span', {}, t(`take.${name}`)), field);
}

function numberField(name, [least, most, step], fault, model) {
  const field = element('input', { type: 'number', name, min: least, max: most, step,
    'aria-describedby': fault.id });
  field.addEventListener('change', () => {
    const good = field.checkValidity();
    field.setAttribute('aria-invalid', !good);
    fault.textContent = good ? '' : t(step === 1 ? 'take.range' : 'take.anyRange', { name: t(`take.${name}`), least, most });
    if (good) model.change({ [name]: field.value === '' ? null : Number(field.value) });
  });
  return { name, field };
}

// What a link asks for may be none of the usual ones: it is one of the choices, then.
function choices(select, usual, value, words) {
  const all = usual.includes(value) ? usual : [...usual, value];
  if (select.dataset.all !== all.join()) {
    select.replaceChildren(...all.map((one) =>
      element('option', { value: one }, usual.includes(one) ? words(one) : one)));
    select.dataset.all = all.join();
  }
  select.value = value;
}

// The point that is asked about stays where it is in the picture.
function resize({ model }, [width, height]) {
  const before = sizeOf(model.request);
  if (model.asked) model.asked = model.asked.map((at, i) => Math.floor((at * [width, height][i]) / before[i]));
  const usual = [width, height].join() === usualSizeOf(model.request).join();
  const { crop } = resized(model.request, [width, height]);
  model.change(usual ? { width: null, height: null, crop } : { width, height, crop });
  if (model.asked) model.tell('ask');
}
