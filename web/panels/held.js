// Says that what a hand has moved is moved by the timeline, and offers a key for it. Loaded when a hand
// first does.

import { learn, t } from '../words/words.js';
import { element } from './element.js';

/** Fills `place` now and whenever something is held. */
export async function mountHeld(studio, place) {
  const [{ Timeline }, { added }, { secondsWords, trackName }] = await Promise.all([
    import('../studio/timeline.js'), import('./timeline_add.js'), import('./timeline_words.js'), learn('timeline')]);
  const { model } = studio;
  const timeline = (studio.timeline ??= new Timeline(studio));
  const words = element('p', { role: 'status' });
  const add = element('button', { type: 'button', onclick: () => leave(timeline.addHeld() ? added(timeline) : t('timeline.broken')) });
  const back = element('button', { type: 'button', onclick: () => (studio.held.letGo(), leave('')) }, t('timeline.putBack'));
  const buttons = element('div', { class: 'row wrap' }, add, back);
  place.append(words, buttons);
  place.setAttribute('aria-label', t('timeline.heldTitle'));

  function leave(told) {
    document.getElementById('said').textContent = told;
    document.getElementById('hand').focus({ preventScroll: true });
  }

  function draw() {
    const held = Object.keys(studio.held.values);
    place.hidden = !held.length;
    if (place.hidden) return (words.textContent = '');
    const at = secondsWords(timeline.time);
    const names = held.map((target) => trackName(timeline.scene, target)).join(', ');
    const told = t('timeline.held', { names, at });
    if (words.textContent !== told) words.textContent = told;
    add.textContent = t('timeline.add', { at });
  }

  model.on('held', draw);
  draw();
}
