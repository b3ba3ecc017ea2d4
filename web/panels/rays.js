// Rays over the picture: each kind has its colour and its dashes, with a dark edge that shows on any
// ground. The colours are Okabe and Ito's, which stay apart for colour-blind eyes.

import { beforeEye, project } from '../space/view.js';
import { svg } from './element.js';

export const DASHES = { primary: null, shadow: '2 5', mirror: '12 5', refracted: '10 4 2 4', scattered: '6 2' };

/** A layer of `overlay`: `draw(view, window, pixel, rays)`, rays as the model has them, and `clear()`. */
export function raysLayer(overlay) {
  const layer = overlay.appendChild(svg('g', { class: 'rays' }));
  return {
    clear: () => layer.replaceChildren(),
    draw(view, window, [x, y], rays) {
      const place = (from, to) => seen(view, from, to);
      const sorted = [...(rays ?? [])].sort((a, b) => a.current - b.current);
      layer.replaceChildren(...sorted.map((ray) => drawnRay(ray, place, window.height / 40)),
        crosshair(window, x + 0.5, y + 0.5));
    },
  };
}

/** A ray drawn, as wide as its `share` where it has one; `place(from, to)` says where as { a, b, ends }, or null; heads are `size` long. */
export function drawnRay({ from, to, aim, kind, current, blocked, share }, place, size) {
  const wide = (by) => (share === undefined ? {} : { style: { strokeWidth: by * (1 + 4 * share) } });
  const way = place(from, to);
  const rest = aim && place(to, aim);
  return svg('g', { class: `ray ray-${kind}${current ? ' current' : ''}`, 'data-kind': kind },
    rest && line(rest, { class: 'rest' }),
    way && line(way, { class: 'edge', ...wide(2) }),
    way && line(way, { class: 'core', 'stroke-dasharray': DASHES[kind], ...wide(1) }),
    way?.ends && (blocked && aim ? bar(way, size / 1.5) : head(way, size)) || null);
}

/** A segment in the picture as { a, b, ends: whether b is its end }; null where it is not seen. */
export function seen(view, from, to) {
  const before = beforeEye(view, from, to);
  const [a, b] = before?.map((point) => project(view, point)) ?? [];
  return a && b ? clipped(a, b, view) : null;
}

// To the picture and half of it around: dashes along what is far outside cost time.
// Source: Liang, Barsky, "A new concept and method for line clipping" (1984).
function clipped(a, b, { width, height }) {
  let [first, last] = [0, 1];
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const sides = [[-dx, a[0] + width / 2], [dx, 1.5 * width - a[0]],
    [-dy, a[1] + height / 2], [dy, 1.5 * height - a[1]]];
  for (const [p, q] of sides) {
    if (p === 0 && q < 0) return null;
    if (p < 0) first = Math.max(first, q / p);
    if (p > 0) last = Math.min(last, q / p);
  }
  const at = (share) => [a[0] + share * dx, a[1] + share * dy];
  if (first > last) return null;
  return { a: first > 0 ? at(first) : a, b: last < 1 ? at(last) : b, ends: last === 1 };
}

function line({ a, b }, properties) {
  return svg('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], ...properties });
}

// An arrow's head, where the ray is long enough to have one.
function head({ a, b }, size) {
  const [x, y, long] = unit(a, b);
  if (long < 1.5 * size) return null;
  const wide = 0.45 * size;
  const wing = (side) => [b[0] - size * x + side * wide * y, b[1] - size * y - side * wide * x];
  return svg('polygon', { class: 'head', points: [b, wing(1), wing(-1)].join(' ') });
}

// Where something is in the way.
function bar({ a, b }, size) {
  const [x, y, long] = unit(a, b);
  if (long === 0) return null;
  const end = (side) => [b[0] + side * size * y, b[1] - side * size * x];
  return ['edge', 'core'].map((name) => line({ a: end(1), b: end(-1) }, { class: name }));
}

function unit(a, b) {
  const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
  return [(b[0] - a[0]) / long, (b[1] - a[1]) / long, long];
}

function crosshair({ height }, x, y) {
  const [inner, outer] = [height / 80, height / 30];
  const d = [[1, 0], [-1, 0], [0, 1], [0, -1]]
    .map(([s, t]) => `M${x + s * inner} ${y + t * inner}L${x + s * outer} ${y + t * outer}`).join('');
  return svg('g', { class: 'crosshair' }, ...['edge', 'core'].map((name) => svg('path', { class: name, d })));
}

/** A piece of a kind's line, to stand before its words. */
export function sample(kind) {
  const at = { x1: 1, y1: 5, x2: 31, y2: 5 };
  const size = { viewBox: '0 0 32 10', width: 32, height: 10 };
  return svg('svg', { class: `sample ray ray-${kind}`, ...size, 'aria-hidden': 'true' },
    svg('line', { class: 'edge', ...at }),
    svg('line', { class: 'core', 'stroke-dasharray': DASHES[kind], ...at }));
}
