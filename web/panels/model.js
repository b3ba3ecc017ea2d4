// The model's panel: where files of a model come in. What tells of one and how it is shown is loaded
// with the first.

import { Problem } from '../picture/problem.js';
import { fetchJson } from '../picture/server.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const ENDINGS = '.glb,.gltf,.bin,.obj,.mtl,.ply,.stl,.zip,.png,.jpg,.jpeg,.webp';

/** Mounts the panel and gives the studio `openModel([{ path, file }])`. */
export default function mountModel(studio, panel) {
  const { model } = studio;
  let view = null;
  const learn = () => import('./model_view.js').then(({ makeModelView }) => (view ??= makeModelView(studio, panel)))
    .catch(() => showProblem(new Problem({ title: t('trouble.unreachable') })));
  studio.openModel = async (files) => {
    studio.openTab('tab-model');
    (await learn())?.take(files);
  };
  panel.append(element('p', {}, t('model.intro')), element('div', { class: 'row wrap' },
    chooser(studio, 'files', { multiple: true, accept: ENDINGS }), chooser(studio, 'folder', { webkitdirectory: true })));
  mountShelf(studio, panel);
  model.on('want', async () => (model.request.model || view) && (await learn())?.follow());
}

// The models of the gallery, asked for by who opens the panel.
function mountShelf(studio, panel) {
  const { model } = studio;
  const shelf = element('div', { class: 'row wrap', role: 'group', 'aria-label': t('model.gallery'), hidden: true });
  panel.append(shelf);
  const choose = (name) => {
    model.asked = null;
    studio.open({ model: name });
  };
  let asked = false;
  model.on('tab', async () => {
    if (asked || studio.tab !== 'tab-model') return;
    asked = true;
    const { models } = await fetchJson('models').catch(() => ({ models: [] }));
    asked = models.length > 0; // else when it is opened again
    shelf.hidden = !asked;
    shelf.append(...models.map(({ name }) =>
      element('button', { type: 'button', lang: 'en', onclick: () => choose(name) }, name)));
  });
}

function chooser(studio, name, properties) {
  const words = t(`model.${name}`);
  const input = element('input', { type: 'file', hidden: true, 'aria-label': words, ...properties });
  input.addEventListener('change', () => {
    const files = [...input.files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
    input.value = '';
    if (files.length) studio.openModel(files);
  });
  return [element('button', { type: 'button', onclick: () => input.click() }, words), input];
}
