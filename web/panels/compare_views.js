// The two ways to see two pictures at once: side by side at a line that slides, and their difference.

import { countWords, numberWords, t } from '../words/words.js';
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

/** The view as { node, draw(a, b, factor), words(difference) }; `a` and `b` are blobs of one size. */
export function differenceView() {
  const node = element('canvas', { class: 'difference', role: 'img', 'aria-label': t('compare.difference') });

  async function draw(a, b, factor) {
    const { differenceOf, pixelsOf } = await import('../picture/difference.js');
    const [left, right] = await Promise.all([pixelsOf(a), pixelsOf(b)]);
    const difference = differenceOf(left, right, factor);
    [node.width, node.height] = [left.width, left.height];
    node.getContext('2d').putImageData(difference.image, 0, 0);
    return difference;
  }

  return { node, draw, words };
}

function words({ differing, count, largest, mean }) {
  if (differing === 0) return t('compare.same', { count: countWords(count) });
  const share = numberWords((100 * differing) / count);
  return t('compare.differ', {
    differing: countWords(differing), count: countWords(count), share, largest, mean: numberWords(mean),
  });
}
