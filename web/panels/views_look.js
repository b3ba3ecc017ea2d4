// Looking around from where the eye is: a hand turns it, and the server draws each view.

import { turnedEye } from '../space/sight.js';
import { scaled } from '../state/window.js';
import { numberWords, t } from '../words/words.js';
import { element } from './element.js';

const FOV = 75;
const STEP = 5; // degrees, of an arrow key
const MOST_UP = 85;
const KEYS = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, STEP], ArrowDown: [0, -STEP] };

export function look({ studio, again, tell }) {
  let [right, up] = [0, 0];
  let coarse = false; // while the hand moves
  const place = element('div', { class: 'touched around', tabindex: 0, role: 'application', 'aria-label': t('views.lookLabel') });

  function turn(by, upwards) {
    right = ((right + by + 540) % 360) - 180;
    up = Math.max(-MOST_UP, Math.min(MOST_UP, up + upwards));
    again();
  }

  place.addEventListener('keydown', (event) => {
    const way = KEYS[event.key];
    if (!way) return;
    event.preventDefault();
    turn(...way);
    tell(t('views.turned', { right: numberWords(right), up: numberWords(up) }));
  });
  place.addEventListener('pointerdown', (event) => {
    place.setPointerCapture(event.pointerId);
    coarse = true;
  });
  place.addEventListener('pointermove', (event) => {
    if (!place.hasPointerCapture(event.pointerId)) return;
    const degrees = FOV / place.clientHeight;
    turn(-event.movementX * degrees, event.movementY * degrees);
  });
  for (const end of ['pointerup', 'pointercancel']) place.addEventListener(end, () => {
    coarse = false;
    again();
  });

  return {
    name: 'look',
    begin: () => ([right, up] = [0, 0]),
    request(base) {
      const request = { ...base, crop: null, camera: turnedEye(studio.view, right, up, FOV) };
      return coarse ? { ...scaled(request, 1 / 2), samples: 1, threshold: 0 } : request;
    },
    show(image) {
      place.replaceChildren(image);
      return place;
    },
  };
}
