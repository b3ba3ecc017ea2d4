// The film as a file, drawn by the server and saved here.

import { fetchFilm, filmFormats } from '../picture/film.js';
import { Problem } from '../picture/problem.js';
import { fileName } from '../state/request.js';
import { scaled, sizeOf } from '../state/window.js';
import { countWords, numberWords, t, wordsOr } from '../words/words.js';
import { save } from './carry.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const SCALES = [1, 1 / 2, 1 / 4];
const USUAL = 'webm';
const ENDINGS = { apng: 'png' };

/** The form as { node, draw() }. */
export function filmForm(studio, timeline) {
  let abort = null;
  const [format, size] = [element('select'), element('select')];
  const keep = element('button', { type: 'button', disabled: true, onclick: begin }, t('timeline.save'));
  const cancel = element('button', { type: 'button', onclick: () => abort?.abort() }, t('timeline.cancel'));
  const bar = element('progress', { 'aria-label': t('timeline.film') });
  const counted = element('p', { class: 'note' });
  const told = element('p', { class: 'told', role: 'status' });
  const going = element('div', { class: 'film-going', hidden: true }, bar, counted, cancel);
  const field = (name, select) => element('label', {}, element('span', {}, t(`timeline.${name}`)), select);
  const node = element('details', { class: 'film', ontoggle: () => node.open && learn() }, element('summary', {}, t('timeline.film')),
    element('div', { class: 'row wrap end' }, field('format', format), field('size', size), keep), going, told);

  // Which formats there are, the server knows.
  async function learn() {
    if (format.options.length) return;
    try {
      const names = await filmFormats();
      format.replaceChildren(...names.map((name) => element('option', { value: name, selected: name === USUAL },
        wordsOr(`timeline.format_${name}`, name))));
      keep.disabled = false;
    } catch (problem) {
      showProblem(problem);
    }
  }

  function draw() {
    const sizes = SCALES.map((scale) => sizeOf(scaled(studio.model.request, scale)).join(' \u00d7 '));
    if (size.dataset.all === sizes.join()) return;
    size.dataset.all = sizes.join();
    size.replaceChildren(...sizes.map((words, i) => element('option', { value: SCALES[i] }, words)));
  }

  async function begin() {
    if (!timeline.moves) return (told.textContent = t('timeline.still'));
    abort = new AbortController();
    told.textContent = counted.textContent = '';
    bar.removeAttribute('value');
    [going.hidden, keep.disabled] = [false, true];
    cancel.focus();
    try {
      const request = { ...scaled(studio.final, Number(size.value)), format: format.value };
      const film = await fetchFilm(request, abort.signal, progress);
      save(film, `tia${fileName({ ...studio.model.request, time: null })}-film.${ENDINGS[format.value] ?? format.value}`);
      told.textContent = t('timeline.saved', { kilobytes: kilobytes(film.size) });
    } catch (problem) {
      if (problem.name === 'AbortError') told.textContent = t('timeline.cancelled');
      else showProblem(problem instanceof Problem ? problem : new Problem({ title: problem.message }));
    } finally {
      [going.hidden, keep.disabled] = [true, false];
      keep.focus();
    }
  }

  function progress({ bytes, frames, count }) {
    if (frames !== undefined && count) [bar.max, bar.value] = [count, Math.min(frames, count)];
    counted.textContent = frames === undefined ? t('timeline.bytes', { kilobytes: kilobytes(bytes) })
      : t('timeline.there', { there: countWords(frames), count: countWords(count) });
  }

  return { node, draw };
}

const kilobytes = (bytes) => numberWords(bytes / 1024);
