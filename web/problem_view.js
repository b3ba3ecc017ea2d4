// The place under the picture where a problem is told.

import { problemWords } from './problem.js';

const told = document.getElementById('problem');
const retry = document.getElementById('retry');

/** Tells a problem, or with null clears the one told. */
export function showProblem(problem) {
  const words = problem && problemWords(problem);
  told.replaceChildren(...(words ? paragraphs(words) : []));
  retry.hidden = !words?.retry;
}

function paragraphs({ title, lines, next }) {
  return [element('strong', title), ...lines.map((line) => element('p', line)), element('p', next)];
}

function element(tag, words) {
  const made = document.createElement(tag);
  made.textContent = words;
  return made;
}
