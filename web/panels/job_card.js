// One job as it goes on: how far it is, where it is drawn already, and what may be done with it.

import { drawnWindows, dropJob, fetchJob, isLast, jobPicture, watchJob } from '../picture/jobs.js';
import { forgetJob } from '../state/own_jobs.js';
import { windowOf } from '../state/window.js';
import { countWords, numberWords, t } from '../words/words.js';
import { save } from './carry.js';
import { element, svg } from './element.js';
import { showProblem } from './problem_view.js';

const QUARTERS = [0.25, 0.5, 0.75];

/** The card of a job { id, name, width, height, crop }; `gone()` hears when it was let go, `tell(words)` what is said aloud. */
export function jobCard(job, { gone, tell }) {
  const { x, y, width, height } = windowOf(job);
  const leave = new AbortController();
  const bar = element('progress', { max: 1, 'aria-label': t('jobs.progress') });
  const words = element('p', { class: 'note' });
  const map = svg('svg', { class: 'job-map', viewBox: `${x} ${y} ${width} ${height}`, 'aria-hidden': 'true' });
  const button = (name, press) => element('button', { type: 'button', onclick: () => press().catch(showProblem) }, t(`jobs.${name}`));
  const [cancel, keep, drop] = [button('cancel', end), button('save', take), button('drop', end)];
  const card = element('article', { class: 'job-card', 'aria-label': job.name }, map,
    element('div', {}, element('h2', {}, job.name), bar, words, element('div', { class: 'row wrap' }, cancel, keep, drop)));
  let said = 0; // how much of it was told aloud
  let mapped = -1;

  async function end() {
    await dropJob(job.id).catch((problem) => {
      if (problem.status !== 404) throw problem;
    });
    forgetJob(job.id);
    leave.abort();
    gone();
  }

  async function take() {
    const blob = await jobPicture(job.id);
    save(blob, `${job.name}.png`);
    tell(t('jobs.saved', { kilobytes: countWords(Math.round(blob.size / 1024)) }));
  }

  function draw({ state, progress, problem }) {
    const { parts, done, remaining_s: left } = progress;
    bar.value = done / parts;
    const counted = t('jobs.parts', { done: countWords(done), parts: countWords(parts) });
    const rest = state === 'running' && left != null ? t('jobs.left', { left: numberWords(left, 2) }) : '';
    const why = problem ? problem.detail ?? problem.title : '';
    words.textContent = [t(`jobs.state_${state}`), counted, rest, why].filter(Boolean).join(' ');
    [cancel.hidden, keep.hidden, drop.hidden] = [isLast(state), state !== 'done', !isLast(state)];
    const reached = QUARTERS.filter((quarter) => done / parts >= quarter).length;
    if (isLast(state)) tell(`${job.name}: ${t(`jobs.state_${state}`)}`);
    else if (reached > said) tell(`${job.name}: ${counted}`);
    said = Math.max(said, reached);
    if (done > mapped) drawMap(done);
  }

  async function drawMap(done) {
    mapped = done;
    const windows = await drawnWindows(job.id).catch(() => []);
    if (windows.length) map.replaceChildren(...windows.map(([x0, y0, x1, y1]) =>
      svg('rect', { x: x0, y: y0, width: x1 - x0, height: y1 - y0 })));
  }

  // A state now, then what becomes of it: the status is asked for again at most twice a second.
  async function follow() {
    let status = await fetchJob(job.id);
    if (!status) return lost();
    draw(status);
    let asking = null;
    const again = () => (asking ??= new Promise((wake) => setTimeout(wake, 500)).then(() => fetchJob(job.id)).then((now) => {
      asking = null;
      if (now) draw((status = now));
    }, () => (asking = null)));
    if (!isLast(status.state)) await watchJob(job.id, leave.signal, again);
    await asking;
    status = await fetchJob(job.id);
    if (status && !leave.signal.aborted) draw(status);
  }

  function lost() {
    words.textContent = t('jobs.unknown');
    bar.hidden = cancel.hidden = keep.hidden = true;
  }

  follow().catch(showProblem);
  return card;
}
