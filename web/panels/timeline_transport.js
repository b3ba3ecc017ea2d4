// Play, pause, step, loop, speed, and the time to be dragged.

import { t } from '../words/words.js';
import { element, svg } from './element.js';
import { fixedWords, secondsWords } from './timeline_words.js';

const SPEEDS = [0.25, 0.5, 1, 2, 4];
const SHAPES = { play: 'M4 2l10 6-10 6z', pause: 'M3 2h4v12H3zM9 2h4v12H9z', back: 'M3 2h2v12H3zM13 2v12L6 8z', on: 'M11 2h2v12h-2zM3 2v12l7-6z' };

const icon = (name) => svg('svg', { viewBox: '0 0 16 16', width: 16, height: 16, 'aria-hidden': 'true', class: 'icon' },
  svg('path', { d: SHAPES[name] }));

/** The controls as { node, draw() }; `scrub` is the slider of the time, `toggle` what plays. */
export function transport(timeline, clock) {
  const [playIcon, playWords] = [element('span', { class: 'icon-room' }), element('span')];
  const toggle = element('button', { type: 'button', class: 'play', onclick: () => (clock.playing ? clock.pause() : clock.play()) },
    playIcon, playWords);
  const stepper = (name, by) => element('button', { type: 'button', 'aria-label': t(`timeline.${name}`),
    title: t(`timeline.${name}`), onclick: () => seek(timeline.frame + by) }, icon(name));
  const loop = element('input', { type: 'checkbox', onchange: () => (clock.loop = loop.checked) });
  const speed = element('select', { 'aria-label': t('timeline.speed'), onchange: () => (clock.speed = Number(speed.value)) },
    SPEEDS.map((one) => element('option', { value: one, selected: one === 1 }, t('timeline.times', { one: secondsWords(one) }))));
  const time = element('p', { class: 'time' });
  const scrub = element('input', { type: 'range', min: 0, step: 1, value: 0, 'aria-label': t('timeline.time'),
    oninput: () => seek(scrub.valueAsNumber) });

  function seek(frame) {
    clock.pause();
    timeline.seek(timeline.timeOf(frame));
  }

  function draw() {
    const { animation: { duration }, frame, lastFrame } = timeline;
    const name = clock.playing ? 'pause' : 'play';
    if (toggle.dataset.shows !== name) {
      toggle.dataset.shows = name;
      playIcon.replaceChildren(icon(name));
      playWords.textContent = t(`timeline.${name}`);
    }
    const words = timeWords(timeline);
    if (time.textContent !== words) time.textContent = words;
    if (scrub.max !== String(lastFrame)) scrub.max = lastFrame;
    if (scrub.valueAsNumber !== frame) scrub.value = frame;
    scrub.setAttribute('aria-valuetext', t('timeline.of', { at: secondsWords(timeline.time), all: secondsWords(duration) }));
  }

  return {
    draw, scrub, toggle,
    node: element('div', { class: 'transport' },
      element('div', { class: 'row wrap' }, toggle, stepper('back', -1), stepper('on', 1),
        element('label', { class: 'check' }, loop, t('timeline.loop')), speed),
      time),
  };
}

/** "2.50 / 5 s" */
function timeWords({ time, animation: { duration } }) {
  return t('timeline.short', { at: fixedWords(time), all: secondsWords(duration) });
}
