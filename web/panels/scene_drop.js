// Files: a scene's JSON, or a picture drawn by Tia with its recipe, dropped anywhere on the page
// or chosen; dropped, those of models and folders too. Anything else is refused in words.

import { readRecipe } from '../picture/png_text.js';
import { parseScene } from '../state/scene_text.js';
import { t } from '../words/words.js';
import { element } from './element.js';

const MOST_BYTES = 64 * 1024 * 1024;
const PNG = [137, 80, 78, 71];
const MODEL = /\.(gltf|glb|obj|ply|stl|zip)$/i;

/** Takes files; `desk.open(text, request)` shows a scene's text. */
export function mountDrop(studio, desk) {
  const target = element('div', { class: 'drop-target', hidden: true },
    element('p', {}, t('scene.dropHere')));
  const said = element('p', { class: 'fault', role: 'status', id: 'scene-file-said' });
  const words = t('scene.openFile');
  const accept = '.json,.png,application/json,image/png';
  const input = element('input', { type: 'file', accept, hidden: true, 'aria-label': words });
  const open = () => input.click();
  const button = element('button', { type: 'button', id: 'scene-file', onclick: open }, words);
  document.body.append(target);
  document.querySelector('.scene-bar').append(button, input);
  document.querySelector('.scene-bar').after(said);

  const take = async (file) => {
    const refused = await openFile(file, studio, desk);
    said.textContent = refused ?? '';
    studio.openTab('tab-scene');
    if (refused) said.scrollIntoView({ block: 'nearest' });
  };
  input.addEventListener('change', async () => {
    const [file] = input.files;
    input.value = '';
    if (file) await take(file);
  });
  bindDrop(target, async (files, folder) => {
    if (folder || files.some(({ path }) => MODEL.test(path))) await studio.openModel(files);
    else if (files[0]) await take(files[0].file);
  });
}

function bindDrop(target, take) {
  let inside = 0; // enter and leave come for every element that the file is dragged across
  const carries = ({ dataTransfer }) => dataTransfer?.types.includes('Files');
  const on = (name, act) => addEventListener(name, (event) => {
    if (!carries(event)) return;
    event.preventDefault();
    act(event);
    target.hidden = inside <= 0;
  });
  on('dragenter', () => (inside += 1));
  on('dragleave', () => (inside -= 1));
  on('dragover', ({ dataTransfer }) => (dataTransfer.dropEffect = 'copy'));
  on('drop', ({ dataTransfer }) => {
    inside = 0;
    const entries = [...dataTransfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
    const files = [...dataTransfer.files].map((file) => ({ path: file.name, file }));
    const folder = entries.some((entry) => entry.isDirectory);
    if (folder) filesBelow(entries).then((all) => take(all, true));
    else take(files, false);
  });
}

/** All files of folders and what is in them, as [{ path, file }]. */
async function filesBelow(entries) {
  const each = entries.map(async (entry) => {
    if (entry.isDirectory) return filesBelow(await entriesOf(entry.createReader()));
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    return [{ path: entry.fullPath.replace(/^\//, ''), file }];
  });
  return (await Promise.all(each)).flat();
}

// A reader gives some at a time, and none at its end.
async function entriesOf(reader) {
  const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
  return some.length ? [...some, ...await entriesOf(reader)] : [];
}

// Opens a file, or says why not.
async function openFile(file, studio, desk) {
  const { name, size } = file;
  if (size > MOST_BYTES) return t('scene.fileLarge', { name });
  try {
    const start = new Uint8Array(await file.slice(0, PNG.length).arrayBuffer());
    return PNG.every((byte, i) => start[i] === byte) ? await openPicture(file, studio)
      : openText(name, await file.text(), studio, desk);
  } catch (error) {
    return t('scene.fileUnreadable', { name, reason: error.message });
  }
}

async function openPicture(file, studio) {
  const recipe = await readRecipe(file);
  if (!recipe?.request) return t('scene.fileNoRecipe', { name: file.name });
  studio.model.asked = null;
  await studio.open(recipe.request);
  return null;
}

// A broken scene is shown too, with what is wrong; what is none at all is not.
function openText(name, text, studio, desk) {
  const { value, faults } = parseScene(text);
  const object = value !== null && typeof value === 'object' && !Array.isArray(value);
  if (faults.length ? !/^\s*\{/.test(text) : !object) return t('scene.fileNone', { name });
  const { width, height } = studio.model.request;
  studio.model.asked = null;
  if (object && 'scene' in value) studio.open(value); // a whole request
  else desk.open(text, { width, height });
  return null;
}
