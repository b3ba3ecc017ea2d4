// A model's turntable: so many views from all around on one sheet, drawn as it is seen now, and saved;
// and the line for a shell that fetches it.

import { fetchPicture } from '../picture/server.js';
import { curlLine, fileName } from '../state/request.js';
import { sizeOf } from '../state/window.js';
import { t } from '../words/words.js';
import { save } from './carry.js';
import { copiedLine } from './copied_line.js';
import { imageOf } from './cover.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const [LEAST, MOST, USUAL] = [2, 64, 8];
const NOT_OF_SHEETS = { camera: null, crop: null, budget_ms: null, max_rays: null };

/** The form. */
export function modelTurn(studio) {
  const number = (name, properties) => element('input', { type: 'number', name, step: 1, min: 1, max: MOST, ...properties });
  const [views, columns] = [number('views', { min: LEAST, value: USUAL }), number('columns')];
  const labelled = (name, field) => element('label', {}, element('span', {}, t(`model.${name}`)), field);
  const said = element('p', { role: 'status' });
  const sheet = element('div');
  const node = element('form', { class: 'turn', novalidate: true, autocomplete: 'off', onsubmit: draw },
    element('h2', {}, t('model.turn')),
    element('div', { class: 'row' }, labelled('views', views), labelled('columns', columns),
      element('button', { type: 'submit' }, t('model.turnSave'))), said, sheet);
  let abort = new AbortController();
  let [image, asked] = [null, null];
  const shell = copiedLine('turn-shell', 'take.shell', () => curlLine(asked, document.baseURI));

  async function draw(event) {
    event.preventDefault();
    drop();
    if (!fits()) return;
    const [request, count] = [studio.model.request, views.valueAsNumber];
    const { signal } = abort;
    said.textContent = t('model.turnBusy', { views: count });
    try {
      asked = { ...request, ...NOT_OF_SHEETS, turntable: count, columns: columns.valueAsNumber || null };
      const { blob } = await fetchPicture(asked, signal);
      const made = await imageOf(blob);
      if (signal.aborted) return URL.revokeObjectURL(made.src);
      save(blob, `tia${fileName(asked)}.png`);
      shell.draw();
      image = made;
      image.alt = t('model.turnShown', { views: count });
      sheet.replaceChildren(image, shell.node);
      const [width, height] = sizeOf(request);
      said.textContent = t('model.turnDone', { views: count, width, height });
    } catch (problem) {
      if (signal.aborted) return;
      said.textContent = '';
      showProblem(problem);
    }
  }

  // More columns than views are none.
  function fits() {
    columns.max = views.valueAsNumber || MOST;
    const wrong = [views, columns].filter((field) => (field.setAttribute('aria-invalid', !field.checkValidity()), !field.checkValidity()));
    const [first] = wrong;
    if (!first) return true;
    said.textContent = t('take.range', { name: t(`model.${first.name}`), least: first.min, most: first.max });
    first.focus();
    return false;
  }

  // A sheet of how the model was seen before is none of it now.
  function drop() {
    abort.abort();
    abort = new AbortController();
    if (image) URL.revokeObjectURL(image.src);
    image = null;
    sheet.replaceChildren();
    said.textContent = '';
  }

  studio.model.on('want', drop);
  return node;
}
