// Single paths of a pixel's light: buttons and keys to step through them, and each told and drawn.

import { along } from '../picture/explained.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { sample } from './rays.js';
import { decimals, swatch } from './why_sum.js';
import { vertexWords } from './why_words.js';

const KINDS = { specular: 'mirror', transmitted: 'refracted' };
const KEYS = { ArrowUp: -1, ArrowLeft: -1, ArrowDown: 1, ArrowRight: 1, Home: -Infinity, End: Infinity };
const brightness = (color) => color[0] + color[1] + color[2];
const kindAt = ({ vertices }, at) => (at ? KINDS[vertices[at - 1].event] ?? 'scattered' : 'primary');

/** Makes { element, show({ samples, reach, transfer }, again), rays }; `moved()` hears of each step. */
export function makePaths(moved) {
  const count = element('span', { class: 'count' });
  const said = element('p', { class: 'spoken', role: 'status' });
  const light = element('p', { class: 'row' });
  const list = element('ol', { class: 'path' });
  const button = (name, sign, by) =>
    element('button', { type: 'button', 'aria-label': t(`why.${name}`), title: t(`why.${name}`), onclick: () => go(by) }, sign);
  const ways = [button('previousPath', '\u2190', -1), button('nextPath', '\u2192', 1)];
  const whole = element('div', { class: 'walk', onkeydown: press }, element('h2', {}, t('why.paths')),
    element('p', { class: 'note' }, t('why.pathKeys')), element('div', { class: 'row' }, ways[0], count, ways[1]), said, light, list);
  let shown = { samples: [] };
  let at = 0;

  function press(event) {
    const by = KEYS[event.key];
    if (!by || !ways.includes(event.target) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    go(by);
  }

  function go(by) {
    at = Math.min(shown.samples.length - 1, Math.max(0, at + by));
    draw();
    said.textContent = t('why.pathTold', { number: at + 1, all: shown.samples.length, label: light.textContent });
    moved();
  }

  function draw() {
    const { samples, transfer } = shown;
    const path = samples[at];
    const [r, g, b] = path.color.map((value) => decimals(value));
    const words = brightness(path.color) ? t('why.pathLight', { r, g, b }) : t('why.path_dark');
    count.textContent = t('why.step', { number: at + 1, all: samples.length });
    for (const [i, way] of ways.entries()) way.setAttribute('aria-disabled', at === (i ? samples.length - 1 : 0));
    light.replaceChildren(swatch(path.color, transfer), words);
    list.replaceChildren(...path.vertices.map((_, i) =>
      element('li', {}, sample(kindAt(path, i)), ` ${vertexWords(path, i).join('. ')}.`)));
  }

  /** Shows other paths; `again`: of the same pixel, where one stays at the one that one has come to. */
  function show(told, again) {
    shown = told;
    at = again ? Math.min(at, told.samples.length - 1) : 0;
    said.textContent = '';
    draw();
  }

  return { element: whole, show, get rays() { return raysOf(shown.samples[at], shown.reach); } };
}

/** A path's rays as the model has them, and those to the lights that it was given; `share` of its light each. */
function raysOf(path, reach) {
  const all = brightness(path.color) || 1;
  const lightOf = ({ lights }) => lights.reduce((sum, { value }) => sum + brightness(value), 0);
  return path.vertices.flatMap((vertex, i) => {
    const { ray: { origin, direction }, point } = vertex;
    const share = Math.min(1, path.vertices.slice(i).reduce((sum, each) => sum + lightOf(each), 0) / all);
    const lit = vertex.lights.filter(({ asked, value }) => asked && brightness(value) > 0);
    return [{ from: origin, to: point ?? along(origin, direction, reach), kind: kindAt(path, i), share },
      ...lit.map((light) => ({ from: light.point, to: along(light.point, light.direction, light.distance ?? reach),
        kind: 'shadow', share: Math.min(1, brightness(light.value) / all) }))];
  }).map((ray) => ({ ...ray, blocked: false, current: true }));
}
