// A handle on a plan: a mark that pointer and arrow keys move.

import { svg } from './element.js';

const STEP = 3; // of a plan 240 wide, for an arrow key; with Shift four times that
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * Puts a handle of a `kind` into `parent` at [x, y]. `take()` is called when it is taken, then
 * `move([dx, dy])` with the whole way since; it says whether the handle may go there. Returns
 * { place(at, label), remove(), held }.
 */
export function bindHandle(parent, kind, at, label, { take, move }) {
  const mark = svg('g', { class: `handle handle-${kind}`, role: 'button', tabindex: 0, 'aria-label': label },
    svg('circle', { class: 'reach', r: 12 }), svg('circle', { class: 'mark', r: kind === 'object' ? 4 : 6 }));
  const handle = { held: false, place, remove: () => mark.remove() };
  let start = null;
  parent.append(mark);
  place(at, label);

  function place(to, words) {
    at = to;
    mark.setAttribute('transform', `translate(${to.map((value) => value.toFixed(2))})`);
    mark.setAttribute('aria-label', words);
  }

  const pointOf = (event) => {
    const box = mark.ownerSVGElement.getBoundingClientRect();
    const { width, height } = mark.ownerSVGElement.viewBox.baseVal;
    return [((event.clientX - box.left) / box.width) * width, ((event.clientY - box.top) / box.height) * height];
  };

  mark.addEventListener('pointerdown', (event) => {
    if (event.button) return;
    mark.setPointerCapture(event.pointerId);
    mark.focus({ preventScroll: true });
    start = { pointer: pointOf(event), at };
    handle.held = true;
    take();
  });
  mark.addEventListener('pointermove', (event) => {
    if (!start) return;
    const to = pointOf(event);
    const way = [to[0] - start.pointer[0], to[1] - start.pointer[1]];
    if (move(way)) place([start.at[0] + way[0], start.at[1] + way[1]], mark.getAttribute('aria-label'));
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
    mark.addEventListener(end, () => ([start, handle.held] = [null, false]));

  mark.addEventListener('keydown', (event) => {
    const step = ARROWS[event.key];
    if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const way = step.map((part) => part * STEP * (event.shiftKey ? 4 : 1));
    take();
    if (move(way)) place([at[0] + way[0], at[1] + way[1]], mark.getAttribute('aria-label'));
  });
  return handle;
}
