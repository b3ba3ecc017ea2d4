// Two pictures in one frame, one on each side of a line that a hand moves.

import { element } from './element.js';

const KNOB = '\u25c0\u2009\u25b6';

/** The view as { nodes, place(share), name(left, right), left(image) }; `moved(share)` hears the hand. */
export function slidingView(moved) {
  const under = element('div', { class: 'half' });
  const names = [element('span', { class: 'side left' }), element('span', { class: 'side right' })];
  const handle = element('div', { class: 'handle', 'aria-hidden': 'true' }, element('span', {}, KNOB));

  handle.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener('pointermove', (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const box = under.getBoundingClientRect();
    moved(Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)));
  });

  return {
    nodes: [under, ...names, handle],
    left: (image) => under.replaceChildren(image),
    name: (...words) => names.forEach((name, i) => (name.textContent = words[i])),
    place(share) {
      under.style.clipPath = `inset(0 ${100 - share * 100}% 0 0)`;
      handle.style.left = `${share * 100}%`;
    },
  };
}
