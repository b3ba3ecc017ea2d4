// The picture, what it shows in words, and what went wrong.

import { isOfPaths } from '../picture/passes.js';
import { decode } from '../picture/server.js';
import { windowOf } from '../state/window.js';
import { lampWords, t } from '../words/words.js';
import { onRetry, showProblem } from './problem_view.js';
import { lookAround } from './seen.js';

const SLOW_MS = 1000;
const part = (id) => document.getElementById(id);

export function mountPicture(studio) {
  const { model } = studio;
  const [frame, picture, status] = [part('frame'), part('picture'), part('status')];
  let slow;
  let asked = false; // for another picture, not for a finer one
  let shown = false;

  studio.display({
    async show({ blob }) {
      const image = await decode(blob);
      for (const side of ['width', 'height']) if (picture[side] !== image[side]) picture[side] = image[side];
      const context = picture.getContext('2d');
      context.globalCompositeOperation = 'copy'; // one that is transparent hides the one before, too
      context.drawImage(image, 0, 0);
      const { width, height } = windowOf(model.request);
      frame.style.setProperty('--ratio', width / height);
      image.close();
      shown = true;
      frame.classList.remove('empty');
    },
    failed(problem) {
      showProblem(problem);
      if (problem) settle();
    },
  });

  function settle() {
    hurry();
    frame.setAttribute('aria-busy', false);
    describe();
  }

  // Waiting shows only when it lasts.
  function wait() {
    frame.classList.add('waiting');
    if (asked) status.textContent = t('picture.rendering');
  }

  function hurry() {
    clearTimeout(slow);
    asked = false;
    frame.classList.remove('waiting');
  }

  function describe() {
    const light = studio.lightShown;
    const known = !shown || light !== undefined; // else the words of before stay until it is
    const words = shown ? lampWords(model.shown.request, light) : t('picture.none');
    if (known && status.textContent !== words) status.textContent = words;
    const title = model.source?.title ?? t(model.request.model ? 'model.still' : 'picture.rendered');
    picture.setAttribute('aria-label', shown ? `${title}. ${known ? words : ''}`.trim() : words);
  }

  model.on('want', () => {
    if (frame.getAttribute('aria-busy') !== 'true') frame.setAttribute('aria-busy', true);
    if (asked) return;
    asked = true;
    clearTimeout(slow);
    slow = setTimeout(wait, SLOW_MS);
  });
  model.on('show', () => (hurry(), (slow = setTimeout(wait, SLOW_MS))));
  for (const event of ['rest', 'pause']) model.on(event, settle);
  model.on('show', () => isOfPaths(model.request, model.source?.options) && clearUp(studio));
  model.on('held', () => tellHeld(studio));
  model.on('world', () => (describe(), lookAround(studio, part('seen'))));
  model.on('source', describe);
  onRetry((by) => {
    studio.again();
    if (by === 'hand') part('hand').focus({ preventScroll: true });
  });
}

// What belongs to a picture that clears up is loaded with the first.
let clearing = null;
function clearUp(studio) {
  clearing ??= import('./clearing.js').then(({ mountClearing }) => mountClearing(studio, part('clearing')))
    .catch((error) => console.warn(error.message));
}

// What says that a track moves what a hand has moved is loaded with the first of it.
let held = null;
function tellHeld(studio) {
  held ??= import('./held.js').then(({ mountHeld }) => mountHeld(studio, part('held')))
    .catch((error) => ((held = null), console.warn(error.message)));
}
