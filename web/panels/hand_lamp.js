// The hand's lamp: where it is dragged to, and its mark on a ring around what one looks at.

import { atDistance, centreOf, distanceOf, lampAt, markOf, ringRadius } from '../space/lamp.js';
import { windowOf } from '../state/window.js';
import { tidyVector } from '../space/vec.js';
import { element, svg } from './element.js';

/** A tool of the hand (panels/hand.js); `draw(chosen)` shows its mark, or hides it. */
export function lampTool(studio) {
  const overlay = document.getElementById('overlay');
  const ring = overlay.appendChild(svg('circle', { class: 'ring' }));
  // Moved as a whole layer by the compositor: nothing is painted anew while the hand moves it.
  const lamp = element('div', { class: 'lamp' }, element('span', { class: 'lamp-mark' }));
  overlay.after(element('div', { class: 'lamp-room' }, lamp));

  function begin() {
    const { view, pivot, light, camera } = studio;
    if (!pivot) return null;
    const distance = light ? distanceOf(pivot, light) : 1.5 * distanceOf(pivot, camera.location);
    const window = windowOf(studio.model.request);
    return { view, window, pivot, distance, mark: light && markOf(view, window, pivot, light) };
  }

  function drag({ view, window, pivot, distance, mark }, { start, at }) {
    const to = mark ? [mark[0] + at[0] - start[0], mark[1] + at[1] - start[1]] : at;
    studio.moveLight(tidyVector(lampAt(view, window, pivot, distance, to)));
  }

  function turn([x, y]) {
    const grip = begin();
    if (!grip) return;
    const [from, down] = grip.mark ? [0, 0] : centreOf(grip.window);
    drag(grip, { start: [0, 0], at: [from + x, down + y] });
  }

  function nearer(factor) {
    const { pivot, light } = studio;
    if (pivot && light) studio.moveLight(tidyVector(atDistance(pivot, light, factor)));
  }

  function draw(chosen) {
    const { view, pivot, light } = studio;
    const seen = chosen && pivot && view;
    const window = windowOf(studio.model.request);
    setAttributes(overlay, { viewBox: `${window.x} ${window.y} ${window.width} ${window.height}` });
    ring.toggleAttribute('hidden', !seen);
    lamp.hidden = !seen || !light;
    const [cx, cy] = centreOf(window);
    setAttributes(ring, { cx, cy, r: ringRadius(window) });
    if (lamp.hidden) return;
    // What is beyond the picture is marked at its edge.
    const percent = (value, size) => `${Math.min(98, Math.max(2, (100 * value) / size)).toFixed(2)}%`;
    const [x, y] = markOf(view, window, pivot, light);
    lamp.style.translate = `${percent(x - window.x, window.width)} ${percent(y - window.y, window.height)}`;
  }

  return { begin, drag, turn, nearer, draw };
}

// What does not change is not set: nothing is painted anew for it.
function setAttributes(made, values) {
  for (const [name, value] of Object.entries(values))
    if (made.getAttribute(name) !== String(value)) made.setAttribute(name, value);
}
