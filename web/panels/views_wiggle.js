// Many views of a display one after another, as the hand goes from side to side: depth on a flat screen.

import { t } from '../words/words.js';
import { element } from './element.js';
import { rowOfViews, VIEWS } from './views_flat.js';

export function wiggle({ studio, tell }) {
  let image = null;
  const canvas = element('canvas', { class: 'touched', role: 'img', 'aria-label': t('views.wiggle') });
  const range = element('input', { type: 'range', min: 0, max: VIEWS - 1, step: 1, value: (VIEWS - 1) / 2,
    oninput: () => draw() });

  function draw() {
    if (!image) return;
    const view = range.valueAsNumber;
    const wide = image.naturalWidth / VIEWS;
    canvas.getContext('2d').drawImage(image, view * wide, 0, wide, image.naturalHeight, 0, 0, canvas.width, canvas.height);
    range.setAttribute('aria-valuetext', t('views.viewOf', { view: view + 1, count: VIEWS }));
  }

  canvas.addEventListener('pointermove', ({ clientX }) => {
    const { left, width } = canvas.getBoundingClientRect();
    range.value = Math.min(VIEWS - 1, Math.floor(((clientX - left) / width) * VIEWS));
    draw();
  });

  return {
    name: 'wiggle',
    controls: [element('label', { class: 'wide' }, t('views.stand'), range)],
    request: (base) => rowOfViews(studio, base, VIEWS, 1 / 2),
    show(next) {
      image = next;
      [canvas.width, canvas.height] = [next.naturalWidth / VIEWS, next.naturalHeight];
      tell('');
      draw();
      return canvas;
    },
  };
}
