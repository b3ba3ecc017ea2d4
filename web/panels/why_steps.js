// The rays one by one: a list of them as a tree, buttons and keys to step through it, and the sum
// of the ray that one has come to.

import { numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { sample } from './rays.js';
import { sumTable } from './why_sum.js';
import { stepWords } from './why_words.js';

const WAYS = {
  first: ['\u21e4', () => 0],
  previous: ['\u2190', (at) => at - 1],
  next: ['\u2192', (at) => at + 1],
  last: ['\u21e5', (_, all) => all - 1],
};
const KEYS = {
  ArrowUp: 'previous', ArrowLeft: 'previous', k: 'previous',
  ArrowDown: 'next', ArrowRight: 'next', j: 'next',
  Home: 'first', End: 'last',
};

/** Makes { element, show({ steps, left, transfer }, again), rays }; `moved()` hears of each step. */
export function makeSteps(moved) {
  const count = element('span', { class: 'count' });
  const said = element('p', { class: 'spoken', role: 'status' });
  const list = element('ol', { class: 'steps' });
  const left = element('p', { class: 'note' });
  const detail = element('div', { class: 'detail' });
  const ways = Object.entries(WAYS).map(([name, [sign]]) => {
    const label = t(`why.${name}`);
    const properties = { type: 'button', 'aria-label': label, title: label, onclick: () => turn(name, true) };
    return element('button', properties, sign);
  });
  const whole = element('div', { class: 'walk', onkeydown: press },
    element('h2', {}, t('why.rays')), element('p', { class: 'note' }, t('why.keys')),
    element('div', { class: 'row' }, ways[0], ways[1], count, ways[2], ways[3]), said, list, left, detail);
  let shown = { steps: [] };
  let at = 0;
  let buttons = [];

  function press(event) {
    const way = KEYS[event.key];
    if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    turn(way, ways.includes(event.target));
  }

  // A button of the list tells its ray itself once it has the focus.
  function turn(way, aloud) {
    const { steps } = shown;
    go(Math.min(steps.length - 1, Math.max(0, WAYS[way][1](at, steps.length))));
    if (!aloud) return buttons[at].focus({ preventScroll: true });
    said.textContent = t('why.stepTold', { number: at + 1, all: steps.length, label: stepWords(steps[at]) });
  }

  function go(to) {
    at = to;
    mark();
    moved();
  }

  function mark() {
    const { steps, transfer } = shown;
    for (const [i, button] of buttons.entries()) {
      button.tabIndex = i === at ? 0 : -1;
      if (i === at) button.setAttribute('aria-current', 'step');
      else button.removeAttribute('aria-current');
    }
    count.textContent = t('why.step', { number: at + 1, all: steps.length });
    for (const [i, way] of ways.entries())
      way.setAttribute('aria-disabled', i < 2 ? at === 0 : at === steps.length - 1);
    detail.replaceChildren(...detailOf(steps[at], { transfer, stepOf, go: follow }));
    keepInSight(list, buttons[at]);
  }

  const stepOf = (node) => shown.steps.find((step) => step.kind !== 'shadow' && step.node === node);

  function follow({ index }) {
    go(index);
    buttons[index].focus();
  }

  /** Shows other rays; `again`: of the same pixel, where one stays at the ray that one has come to. */
  function show(told, again) {
    const focused = list.contains(document.activeElement);
    shown = told;
    at = again ? Math.min(at, told.steps.length - 1) : 0;
    said.textContent = '';
    buttons = told.steps.map((step) => stepButton(step, () => follow(step)));
    list.replaceChildren(...branch(told.steps, null, buttons));
    left.textContent = told.left ? t('why.left', { count: told.left }) : '';
    mark();
    if (focused) buttons[at].focus({ preventScroll: true });
  }

  const raysOf = () => shown.steps.map(({ from, to, aim, kind, blocked, index }) =>
    ({ from, to, aim, kind, blocked, current: index === at }));
  return { element: whole, show, get rays() { return raysOf(); } };
}

// The steps that `parent` made, each with those that it made.
function branch(steps, parent, buttons) {
  return steps.filter((step) => step.parent === parent).map((step) => {
    const made = branch(steps, step, buttons);
    return element('li', {}, buttons[step.index], made.length > 0 && element('ol', {}, ...made));
  });
}

function stepButton(step, onclick) {
  return element('button', { type: 'button', onclick },
    element('span', { class: 'number' }, `${step.index + 1}`),
    sample(step.kind),
    element('span', { class: 'spoken' }, `${t(`why.kind_${step.kind}`)}. `),
    element('span', {}, stepWords(step)));
}

function detailOf(step, tools) {
  const { kind, parent, weight } = step;
  const made = kind !== 'shadow' && parent;
  const into = made && t('why.into', { weight: numberWords(weight), number: parent.index + 1 });
  return [
    element('h3', {}, sample(kind), `${step.index + 1}. ${stepWords(step)}`),
    into && element('p', { class: 'note' }, into),
    ...sumTable(step, tools),
  ].filter(Boolean);
}

// Only the list scrolls: the picture must stay where it is.
function keepInSight(list, button) {
  const [outer, inner] = [list.getBoundingClientRect(), button.getBoundingClientRect()];
  if (inner.top < outer.top) list.scrollTop -= outer.top - inner.top;
  if (inner.bottom > outer.bottom) list.scrollTop += inner.bottom - outer.bottom;
}
