// What a picture cost, drawn: the server's time by phase and the rays by kind.

import { totalMs } from './timing.js';
import { countWords, msWords } from './words.js';

/** Fills the figures' section with a picture's timing and rays. */
export function showFigures(section, { timing, rays }) {
  const phases = timing.filter(({ name }) => name !== 'total');
  const cast = rays.filter(({ count }) => count > 0);
  const sum = rays.reduce((total, { count }) => total + count, 0);

  text(section, '.time', timing.length ? msWords(totalMs(timing)) : 'not told');
  text(section, '.rays', rays.length ? countWords(sum) : 'not told');
  section.querySelector('.bar').replaceChildren(...phases.map(slice));
  fill(section, '.phases', phases.map(({ name, ms }) => [name, msWords(ms)]));
  fill(section, '.kinds', cast.map(({ name, count }) => [name, countWords(count)]));
}

function slice({ name, ms }) {
  const part = document.createElement('span');
  part.className = name;
  part.style.flexGrow = ms;
  return part;
}

function fill(section, selector, rows) {
  section.querySelector(selector).replaceChildren(...rows.map(row));
}

function row([name, value]) {
  const pair = document.createElement('div');
  pair.className = name;
  pair.append(element('dt', name), element('dd', value));
  return pair;
}

function element(tag, words) {
  const made = document.createElement(tag);
  made.textContent = words;
  return made;
}

function text(section, selector, words) {
  section.querySelector(selector).textContent = words;
}
