// Make it fall: which objects do, how heavy they are, how they bounce, how fast they begin.

import { isRigid } from '../state/bodies.js';
import { numberText, readNumbers } from '../state/request.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const MOST = 40; // objects
const ROLES = ['falls', 'stands', 'out'];
const NUMBERS = { mass: [1e-6, 1e15], restitution: [0, 1], friction: [0, 100] };

/** The form as { node, draw() }; `tell(words)` says what it comes to, `begun()` hears when things fall. */
export function fallForm(timeline, bodies, { tell, begun }) {
  const list = element('ul', { class: 'bodies' });
  const begin = element('button', { type: 'button', class: 'add', onclick: start }, t('timeline.fall'));
  const end = element('button', { type: 'button', onclick: () => bodies.end() && (draw(), begin.focus()) }, t('timeline.noFall'));
  const node = element('details', { class: 'fall' }, element('summary', {}, t('timeline.fallTitle')),
    element('p', { class: 'note' }, t('timeline.fallNote')), list, element('div', { class: 'row wrap' }, begin, end));
  let drawn = '';

  function start() {
    const done = bodies.begin();
    if (done) begun();
    else tell(t(done === null ? 'timeline.nothingFalls' : 'timeline.broken'));
  }

  function draw() {
    const roles = bodies.roles.slice(0, MOST);
    const falls = Boolean(bodies.physics);
    [begin.hidden, end.hidden] = [falls, !falls];
    const now = JSON.stringify(roles);
    if (now === drawn) return;
    drawn = now;
    const { name } = node.contains(document.activeElement) ? document.activeElement.dataset : {};
    const rigid = isRigid(roles);
    list.replaceChildren(...roles.map((one) => row(bodies, one, rigid)));
    if (name) list.querySelector(`[data-name="${name}"]`)?.focus({ preventScroll: true });
  }

  return { node, draw };
}

function row(bodies, { index, name, role, body }, rigid) {
  const select = element('select', { 'aria-label': t('timeline.does', { name }), dataset: { name: `role-${index}` },
    onchange: () => bodies.set(index, { role: select.value }) },
  ROLES.map((one) => element('option', { value: one, selected: one === role }, t(`timeline.role_${one}`))));
  const falls = role === 'falls';
  const numbers = Object.keys(NUMBERS).filter((one) => falls && (rigid || one !== 'friction') && (one !== 'mass' || body.density === undefined));
  return element('li', {},
    element('div', { class: 'body-head' }, element('span', {}, name), select),
    falls && element('div', { class: 'take-form', role: 'group', 'aria-label': name },
      numbers.map((one) => numberField(bodies, index, one, body[one])), velocityField(bodies, index, body.velocity)));
}

const labelled = (name, field) => element('label', {}, element('span', {}, t(`timeline.${name}`)), field);

function numberField(bodies, index, name, value) {
  const [min, max] = NUMBERS[name];
  const field = element('input', { type: 'number', min, max, step: 'any', value, dataset: { name: `${name}-${index}` },
    onchange: () => {
      const good = field.value !== '' && field.checkValidity();
      field.setAttribute('aria-invalid', !good);
      if (good) bodies.set(index, { [name]: field.valueAsNumber });
    } });
  return labelled(name, field);
}

function velocityField(bodies, index, velocity) {
  const field = element('input', { spellcheck: 'false', value: velocity.map((one) => numberText(one)).join(', '), dataset: { name: `velocity-${index}` },
    onchange: () => {
      const read = readNumbers(field.value);
      field.setAttribute('aria-invalid', read?.length !== 3);
      if (read?.length === 3) bodies.set(index, { velocity: read });
    } });
  return labelled('velocity', field);
}
