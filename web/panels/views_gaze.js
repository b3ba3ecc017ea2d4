// A picture for one gaze: rays where the eye can use them. The eye is where the pointer is.

import { finalPicture } from '../studio/studio.js';
import { circleAround } from '../space/sight.js';
import { countWords, numberWords, t } from '../words/words.js';
import { sizeOf } from '../state/window.js';
import { slidingView } from './compare_views.js';
import { imageOf } from './cover.js';
import { element, svg } from './element.js';
import { showProblem } from './problem_view.js';
import { seenBy } from './views_flat.js';

const RINGS = [5, 15, 35]; // degrees from where the eye looks
const STEP = 1 / 20; // of the picture, of an arrow key
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export function gaze({ studio, again, tell, cover }) {
  let at = null; // where the eye looks, in pixels
  let last = null; // { image, picture } as it is shown
  const rings = svg('svg', { class: 'gaze-rings', 'aria-hidden': 'true' });
  const place = element('div', { class: 'touched', tabindex: 0, role: 'application', 'aria-label': t('views.gazeLabel') });
  const slider = slidingView((share) => slide(share));
  const range = element('input', { type: 'range', min: 0, max: 1, step: 'any', value: 0.5, oninput: () => slide(range.valueAsNumber) });
  const line = element('label', { class: 'wide', hidden: true }, t('views.line'), range);
  const compare = element('button', { type: 'button', onclick: () => beside().catch(showProblem) }, t('views.beside'));

  const size = () => sizeOf(studio.model.request);
  const within = ([x, y]) => [x, y].map((value, i) => Math.round(Math.max(0, Math.min(size()[i] - 1, value))));

  function turn(to) {
    at = within(to);
    line.hidden = true;
    again();
  }

  place.addEventListener('pointermove', (event) => {
    const box = place.getBoundingClientRect();
    turn([((event.clientX - box.left) / box.width) * size()[0], ((event.clientY - box.top) / box.height) * size()[1]]);
  });
  place.addEventListener('keydown', (event) => {
    const way = KEYS[event.key];
    if (!way) return;
    event.preventDefault();
    turn(at.map((value, i) => value + way[i] * STEP * size()[i]));
  });

  function drawRings() {
    const [width, height] = size();
    rings.setAttribute('viewBox', `0 0 ${width} ${height}`);
    rings.replaceChildren(...RINGS.map((degrees) => svg('polygon', { points: circleAround(studio.view, at, degrees).join(' ') })),
      svg('circle', { cx: at[0], cy: at[1], r: height / 120 }));
  }

  // What rays go through: pixels where the eye looks, points of rings elsewhere.
  function count({ gaze: told }) {
    const [fovea, periphery, full] = ['fovea', 'periphery', 'full'].map((name) => Number(new RegExp(`${name}=(\\d+)`).exec(told)?.[1]));
    const traced = fovea + periphery;
    tell(t('views.counted', { traced: countWords(traced), full: countWords(full), share: numberWords((100 * traced) / full) }));
  }

  // The full picture to the left of a line, this one to the right.
  async function beside() {
    if (!last) return;
    const full = await imageOf((await finalPicture(studio)).blob);
    slider.left(full);
    slider.name(t('views.full'), t('views.gaze'));
    line.hidden = false;
    slide(range.valueAsNumber);
    cover(last.image, ...slider.nodes);
    range.focus();
  }

  function slide(share) {
    range.value = share;
    range.setAttribute('aria-valuetext', t('views.share', { share: Math.round(share * 100) }));
    slider.place(share);
  }

  return {
    name: 'gaze',
    controls: [element('div', { class: 'row wrap' }, compare), line],
    begin: () => (at = size().map((length) => Math.floor(length / 2))),
    request: (base) => ({ ...seenBy(base, {}), threshold: 0, noise: null, denoise: null, budget_ms: null, max_rays: null, gaze: at }),
    show(image, picture) {
      last = { image, picture };
      count(picture);
      drawRings();
      place.replaceChildren(image, rings);
      return place;
    },
  };
}
