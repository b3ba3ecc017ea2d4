// The place under the picture where a problem is told. Where the server has named a time, the
// button counts it down and then tries by itself, a few times.

import { problemWords } from '../picture/problem.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const told = document.getElementById('problem');
const retry = document.getElementById('retry');
const MOST_TRIES = 5; // what still fails then may never work
let countdown = null;
let tries = 0; // by itself, since a picture came or somebody pressed the button
let again = () => {};

/** What a retry does; `by` is 'hand' or 'clock'. */
export function onRetry(retried) {
  again = retried;
}

retry.addEventListener('click', () => {
  tries = 0;
  again('hand');
});

/** Tells a problem, or with null clears the one told. */
export function showProblem(problem) {
  clearInterval(countdown);
  const words = problem && problemWords(problem, !document.querySelector('#frame.empty'));
  told.replaceChildren(...(words ? paragraphs(words) : []));
  retry.hidden = !words?.retry;
  retry.textContent = t('trouble.retry');
  if (!words) tries = 0;
  if (words?.wait && tries < MOST_TRIES) count(words.wait);
}

function count(seconds) {
  let left = seconds;
  const show = () => (retry.textContent = t('trouble.retryIn', { left }));
  show();
  countdown = setInterval(() => {
    left -= 1;
    if (left > 0) return show();
    clearInterval(countdown);
    retry.textContent = t('trouble.retry');
    tries += 1;
    again('clock');
  }, 1000);
}

function paragraphs({ title, lines, next }) {
  return [element('strong', {}, title), ...lines.map((line) => element('p', {}, line)), element('p', {}, next)];
}
