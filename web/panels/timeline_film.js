// The film as a file: one picture a frame, each as the server draws it, put together here.

import { fetchPicture } from '../picture/server.js';
import { Problem } from '../picture/problem.js';
import { fileName } from '../state/request.js';
import { scaled, sizeOf } from '../state/window.js';
import { t } from '../words/words.js';
import { save } from './carry.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const MOST = 720; // frames that a browser keeps at once
const SCALES = [1, 1 / 2, 1 / 4];

/** The form as { node, draw() }. */
export function filmForm(studio, timeline) {
  let abort = null;
  const size = element('select');
  const keep = element('button', { type: 'button', onclick: begin }, t('timeline.save'));
  const cancel = element('button', { type: 'button', onclick: () => abort?.abort() }, t('timeline.cancel'));
  const bar = element('progress', { 'aria-label': t('timeline.film') });
  const counted = element('p', { class: 'note' });
  const told = element('p', { class: 'told', role: 'status' });
  const going = element('div', { class: 'film-going', hidden: true }, bar, counted, cancel);
  const node = element('details', { class: 'film' }, element('summary', {}, t('timeline.film')),
    element('p', { class: 'note' }, t('timeline.filmNote')),
    element('div', { class: 'row wrap end' }, element('label', {}, element('span', {}, t('timeline.size')), size), keep), going, told);

  function draw() {
    const { request } = studio.model;
    const sizes = SCALES.map((scale) => sizeOf(scaled(request, scale)).join(' \u00d7 '));
    if (size.dataset.all === sizes.join()) return;
    size.dataset.all = sizes.join();
    size.replaceChildren(...sizes.map((words, i) => element('option', { value: SCALES[i] }, words)));
  }

  async function begin() {
    const { fps, duration } = timeline.animation;
    const count = Math.ceil(duration * fps);
    if (!timeline.moves || count > MOST) return (told.textContent = t(timeline.moves ? 'timeline.tooMany' : 'timeline.still', { most: MOST }));
    abort = new AbortController();
    told.textContent = '';
    [going.hidden, keep.disabled] = [false, true];
    cancel.focus();
    try {
      const pngs = await frames(count, fps, abort.signal);
      const { apngOf } = await import('../picture/apng.js');
      save(apngOf(pngs, 1000 / fps), `tia${fileName({ ...studio.model.request, time: null })}-film.png`);
      told.textContent = t('timeline.saved', { count });
    } catch (problem) {
      if (problem.name === 'AbortError') told.textContent = t('timeline.cancelled');
      else showProblem(problem instanceof Problem ? problem : new Problem({ title: t('trouble.unreadable'), status: 502, detail: problem.message }));
    } finally {
      [going.hidden, keep.disabled] = [true, false];
      keep.focus();
    }
  }

  async function frames(count, fps, signal) {
    const request = scaled(studio.final, Number(size.value));
    const pngs = [];
    bar.max = count;
    while (pngs.length < count) {
      bar.value = pngs.length;
      counted.textContent = t('timeline.there', { there: pngs.length, count });
      const { blob } = await fetchPicture({ ...request, time: pngs.length / fps }, signal);
      pngs.push(new Uint8Array(await blob.arrayBuffer()));
    }
    return pngs;
  }

  return { node, draw };
}
