// Wires the page. The controls and the curl line show what is wanted; the picture, its words and
// its figures show what came. Where the two differ, a problem says why.

import { bindCopy } from './copy.js';
import { showFigures } from './figures.js';
import { bindKeys } from './keys.js';
import { latest } from './latest.js';
import { bindLightForm } from './light_form.js';
import { showProblem } from './problem_view.js';
import { curlLine, lightText, renderPath } from './request.js';
import { fetchPicture, fetchScene } from './server.js';
import { pictureWords, stateWords } from './words.js';

const SLOW_MS = 1000;
const part = Object.fromEntries([...document.querySelectorAll('[id]')].map((it) => [it.id, it]));
const buttons = [...document.querySelectorAll('[data-key]')];

let scene = null;
let wanted = {};
let shown = null;
let sceneProblem = null; // what kept the scene away, until it comes

const ask = latest(render);
const showLight = bindLightForm(part.light, part.fault, (light) => want({ light }));

function want(state) {
  wanted = state;
  const on = state.key ?? (state.light ? 'typed' : 'Escape');
  for (const button of buttons) button.setAttribute('aria-pressed', button.dataset.key === on);
  part.pad.dataset.on = on;
  part.curl.textContent = curlLine(state, document.baseURI);
  ask(state);
}

function press(key) {
  const state = key === 'Escape' ? {} : { key };
  showLight(lampOf(state));
  want(state);
}

// Where a state's lamp stands; null where there is none, or where it is not known yet.
function lampOf({ key, light }) {
  return light ?? scene?.keys?.[key]?.light ?? null;
}

async function render(state) {
  const slow = setTimeout(() => (part.status.textContent = 'Rendering\u2026'), SLOW_MS);
  part.frame.setAttribute('aria-busy', true);
  try {
    show(state, await fetchPicture(renderPath(state)));
    showProblem(sceneProblem);
  } catch (problem) {
    showProblem(problem);
  } finally {
    clearTimeout(slow);
    part.frame.setAttribute('aria-busy', false);
    describe();
  }
}

function show(state, { image, timing, rays }) {
  const old = part.picture.src;
  part.picture.src = image.src;
  if (old) URL.revokeObjectURL(old);
  shown = state;
  showFigures(part.figures, { timing, rays });
}

function describe() {
  const lamp = shown && lampOf(shown);
  part.status.textContent = shown ? `${stateWords(shown, lamp)}.` : 'No picture yet.';
  part.picture.alt = shown ? pictureWords(scene?.title, shown, lamp) : 'No picture yet';
}

async function loadScene() {
  try {
    scene = await fetchScene('thesis');
    if (sceneProblem) showProblem(sceneProblem = null);
    if (wanted.key) showLight(lampOf(wanted));
    if (shown) describe();
  } catch (problem) {
    sceneProblem = problem;
    showProblem(problem);
  }
}

function start() {
  if (!scene) loadScene();
  want(wanted);
  part.picture.focus({ preventScroll: true });
}

for (const button of buttons) button.addEventListener('click', () => press(button.dataset.key));
part.retry.addEventListener('click', start);
bindKeys(part.picture, part.everywhere, press);
bindCopy(part['copy-light'], () => lightText(lampOf(wanted)), (words) => (part.said.textContent = words));
bindCopy(part['copy-curl'], () => part.curl.textContent, (words) => (part.said.textContent = words));
start();
