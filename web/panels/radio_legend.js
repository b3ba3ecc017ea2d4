// The legend of a radio map: its colours in steps with their numbers, and the value of one place.

import { scaleOf, ticksOf } from '../space/radio.js';
import { numberWords, t } from '../words/words.js';
import { element } from './element.js';

const TICKS = 5;

/** The legend as { node, draw(map, radio), hover(place) }; `draw` gives the map's scale. */
export function radioLegend() {
  const title = element('p', { class: 'title' });
  const [mark, bar, ticks] = [element('span', { class: 'mark', hidden: true }), element('span', { class: 'bar' }), element('div', { class: 'ticks' })];
  const here = element('p', { class: 'here', 'aria-hidden': 'true' });
  const strip = element('div', { class: 'strip', 'aria-hidden': 'true' }, bar, mark);
  const node = element('div', { class: 'radio-legend', role: 'group', 'aria-label': t('radio.legend'), hidden: true }, title, strip, ticks, here);
  let scale = null;

  function draw(map, radio) {
    scale = scaleOf(map);
    strip.hidden = !scale;
    hover(null);
    title.textContent = t(scale ? 'radio.legendOf' : 'radio.legendEmpty', { quantity: t(`radio.is_${map.quantity}`), height: numberWords(map.y), cell: numberWords(map.cell, 2) });
    bar.style.backgroundImage = scale ? `linear-gradient(to right, ${bands(scale)})` : '';
    ticks.replaceChildren(...(scale ? ticksIn(map, scale, radio) : []));
    return scale;
  }

  /** Shows a place { x, z, value, words }, or null none; gives its words. */
  function hover(place) {
    here.textContent = place ? t('radio.here', { x: numberWords(place.x), z: numberWords(place.z), value: place.words }) : t('radio.point');
    mark.hidden = !scale || place?.value == null;
    if (!mark.hidden) mark.style.left = `${100 * scale.shareOf(place.value)}%`;
    return here.textContent;
  }

  return { node, draw, hover };
}

/** A value of the map in words, with its unit; of best_server whose it is. */
export function valueWords(map, value, radio) {
  if (map.quantity === 'best_server') return radio.antennas.filter(({ kind }) => kind === 'transmitter')[value]?.name ?? String(value);
  const [number, unit] = shownAs(map, value);
  return `${numberWords(number)} ${unit}`;
}

// Seconds are shown as ns.
const shownAs = ({ unit }, value) => (unit === 's' ? [value * 1e9, 'ns'] : [Number(value.toFixed(1)), unit]);

function bands({ low, high, step, colorOf }) {
  const count = Math.round((high - low) / step);
  return Array.from({ length: count }, (_, i) => `rgb(${colorOf(low + i * step)}) ${(100 * i) / count}% ${(100 * (i + 1)) / count}%`).join(', ');
}

function ticksIn(map, scale, radio) {
  const all = map.quantity === 'best_server' ? Array.from({ length: scale.high }, (_, i) => i) : ticksOf(scale.low, scale.high, TICKS);
  return all.map((tick) => element('span', { style: { left: `${100 * scale.shareOf(tick)}%` } }, valueWords(map, tick, radio)));
}
