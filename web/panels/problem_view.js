// The place under the picture where a problem is told. Where the server has named a time, the
// button counts it down and then tries by itself.

import { problemWords } from '../picture/problem.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const told = document.getElementById('problem');
const retry = document.getElementById('retry');
let countdown = null;

/** Tells a problem, or with null clears the one told. */
export function showProblem(problem) {
  clearInterval(countdown);
  const words = problem && problemWords(problem);
  told.replaceChildren(...(words ? paragraphs(words) : []));
  retry.hidden = !words?.retry;
  retry.textContent = t('trouble.retry');
  if (words?.wait) count(words.wait);
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
    retry.click();
  }, 1000);
}

function paragraphs({ title, lines, next }) {
  return [element('strong', {}, title), ...lines.map((line) => element('p', {}, line)), element('p', {}, next)];
}
