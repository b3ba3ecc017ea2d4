// Paths of radio waves as lines: their kinds by dash and colour, their gain by thickness.

import { kindOf } from '../space/radio.js';
import { svg } from './element.js';

export const DASHES = { direct: null, reflection: '9 5', transmission: '3 4', diffraction: '10 4 2 4' };
const [THIN, THICK] = [0.9, 4.5]; // pixels
const FAINT_DB = 40; // below the strongest: as thin as lines get
const MOST = 80; // that are drawn, the strongest

/** How wide a path is drawn, in pixels. */
export const widthOf = (gain, strongest) => THIN + (THICK - THIN) * Math.max(0, 1 - (strongest - gain) / FAINT_DB);

/** All paths drawn, the `current` one apart, `by` times as wide; `place(from, to)` says where a piece is as { a, b }, or null. */
export function drawnWaves(paths, current, place, by = 1) {
  const byGain = [...paths].sort((a, b) => a.gain_db - b.gain_db).slice(-MOST);
  const strongest = byGain.at(-1)?.gain_db;
  const last = [...byGain.filter((path) => path !== current), ...byGain.filter((path) => path === current)];
  return last.map((path) => {
    const kind = kindOf(path);
    const width = by * Math.max(widthOf(path.gain_db, strongest), path === current ? THICK / 2 : 0);
    const pieces = path.points.slice(1).map((to, i) => place(path.points[i], to)).filter(Boolean);
    const line = ({ a, b }, name, wide, dash) => svg('line', { class: name, x1: a[0], y1: a[1], x2: b[0], y2: b[1],
      'stroke-width': wide, 'stroke-dasharray': dash });
    return svg('g', { class: `wave wave-${kind}${current ? (path === current ? ' current' : ' other') : ''}` },
      pieces.map((piece) => line(piece, 'edge', width + 1.5 * by)), pieces.map((piece) => line(piece, 'core', width, DASHES[kind])));
  });
}

/** A piece of a kind's line, to stand before its words. */
export function waveSample(kind, width = 3) {
  const at = { x1: 1, y1: 5, x2: 31, y2: 5 };
  return svg('svg', { class: `sample wave wave-${kind}`, viewBox: '0 0 32 10', width: 32, height: 10, 'aria-hidden': 'true' },
    svg('line', { class: 'edge', 'stroke-width': width + 1.5, ...at }),
    svg('line', { class: 'core', 'stroke-width': width, 'stroke-dasharray': DASHES[kind], ...at }));
}

/** The names of antennas beside their marks, `size` high; `place(position)` says where, or null. */
export function antennaNames(antennas, place, size) {
  return antennas.map(({ name, position }) => [name, place(position)]).filter(([, at]) => at)
    .map(([name, [x, y]]) => svg('text', { class: 'antenna', x, y: y - size, 'font-size': size, 'text-anchor': 'middle' }, name));
}
