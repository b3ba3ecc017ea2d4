// The paths of a pair of antennas, the first to arrive first, of which one can be chosen.

import { kindOf } from '../space/radio.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { waveSample, widthOf } from './radio_waves.js';

const MOST = 60; // rows

/** The list as { node, draw(), current }; `chosen()` hears when another path is the current one, or none. */
export function pathList(radio, chosen) {
  const head = element('tr', {}, ['way', 'delay', 'length', 'gain'].map((name) => element('th', { scope: 'col' }, t(`radio.${name}`))));
  const body = element('tbody');
  const more = element('p', { class: 'note' });
  const whole = element('input', { type: 'radio', name: 'radio-path', onchange: () => choose(null) });
  const node = element('div', { class: 'radio-list' }, element('h2', { id: 'radio-paths' }, t('radio.paths')),
    element('label', { class: 'check' }, whole, t('radio.all')),
    element('div', { class: 'radio-rows' }, element('table', { class: 'radio-table', 'aria-labelledby': 'radio-paths' }, element('thead', {}, head), body)), more);
  const list = { node, draw, current: null };
  let shown = [];

  function choose(path) {
    list.current = path;
    chosen();
  }

  function draw() {
    const { paths } = radio.found;
    const at = shown.indexOf(list.current);
    shown = paths;
    list.current = at >= 0 ? paths[at] ?? null : null; // the one that stands where it stood
    const strongest = Math.max(...paths.map(({ gain_db: gain }) => gain));
    body.replaceChildren(...paths.slice(0, MOST).map((path) => row(path, strongest)));
    whole.checked = !list.current;
    more.textContent = paths.length > MOST ? t('radio.more', { count: countWords(paths.length - MOST) }) : '';
    node.hidden = !paths.length;
  }

  function row(path, strongest) {
    const input = element('input', { type: 'radio', name: 'radio-path', checked: path === list.current, onchange: () => choose(path) });
    const words = [numberWords(path.delay_s * 1e9, 5), numberWords(path.length_m, 5), numberWords(path.gain_db, 4)];
    return element('tr', {}, element('td', {}, element('label', {}, input, waveSample(kindOf(path), widthOf(path.gain_db, strongest)), element('span', {}, wayWords(path)))),
      words.map((one) => element('td', {}, one)));
  }

  return list;
}

/** What happens on a path: "off the wall, through the door". */
export function wayWords({ interactions }) {
  if (!interactions.length) return t('radio.direct');
  const through = (at) => interactions[at]?.kind === 'transmission' && interactions[at].object;
  const all = interactions.filter((_, i) => !through(i) || through(i) !== through(i - 1)); // both faces of a wall are one
  return all.map(({ kind, object }) => t(`radio.at_${kind}`, { object })).join(', ');
}
