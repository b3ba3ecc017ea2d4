// Taking the picture along: as a file, a link, an address, a shell line, a scene.

import { finalPicture } from '../studio/studio.js';
import { curlLine, fetchable, fileName } from '../state/request.js';
import { t } from '../words/words.js';
import { pageAddress } from './address.js';
import { bindCopy, save } from './carry.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';
import { takeForm } from './take_form.js';

const LONGEST_LINE = 120_000; // a shell takes arguments of up to 128 KiB

export default function mountTake(studio, panel) {
  const { model } = studio;
  const form = takeForm(studio);
  const lines = [
    line('link', () => linkOf(studio)),
    line('address', () => addressOf(studio.final)),
    line('shell', () => shellLine(studio.final)),
  ];
  panel.append(
    element('div', { class: 'row wrap' },
      button('savePicture', () => savePicture(studio)),
      button('saveScene', () => save(new Blob([sceneText(studio)]), `tia${fileName(model.request)}.json`)),
      copyButton(null, t('take.copyScene'), () => sceneText(studio))),
    form.node,
    ...lines.map(({ node }) => node));

  const draw = () => {
    if (studio.tab !== 'tab-take') return;
    form.draw();
    for (const { draw } of lines) draw();
  };
  for (const event of ['want', 'rest', 'source', 'world', 'ask', 'tab']) model.on(event, draw);
}

function button(name, press) {
  return element('button', { type: 'button', onclick: press }, t(`take.${name}`));
}

function copyButton(label, words, text) {
  const made = element('button', { type: 'button', 'aria-label': label }, words);
  bindCopy(made, text);
  return made;
}

// A text to be read, and copied as it is; null where there is none that short.
function line(name, text) {
  const title = `take-${name}`;
  const shown = element('pre', { tabindex: 0, role: 'group', 'aria-labelledby': title });
  const copy = copyButton(t(`take.${name}Copy`), t('take.copy'), async () => (await text()) ?? '');
  const note = element('p', { class: 'note' }, t(`take.${name}Note`));
  let newest = 0;
  const node = element('div', { class: `take-${name}` },
    element('h2', { id: title }, t(`take.${name}`)), element('div', { class: 'line' }, shown, copy), note);
  return { node, draw };

  async function draw() {
    const mine = ++newest;
    const words = await text();
    if (mine !== newest) return;
    if (shown.textContent !== (words ?? '')) shown.textContent = words ?? '';
    shown.parentElement.hidden = words === null;
    note.textContent = t(words === null ? `take.${name}Long` : `take.${name}Note`);
  }
}

/** The page's address for what is shown, whole. */
async function linkOf(studio) {
  return `${location.origin}${location.pathname}${await pageAddress(studio)}`;
}

/** Where the picture itself lies; null where its request is too long for an address. */
function addressOf(request) {
  const { path, init } = fetchable('render', request);
  return init.body ? null : new URL(path, document.baseURI).href;
}

function shellLine(request) {
  const text = curlLine(request, document.baseURI);
  return new Blob([text]).size < LONGEST_LINE ? text : null;
}

/** The scene of the picture, its key, light and camera in it. */
function sceneText({ model }) {
  return `${JSON.stringify(model.world ?? model.source, null, 2)}\n`;
}

async function savePicture(studio) {
  try {
    const { blob, request } = await finalPicture(studio);
    save(blob, `tia${fileName(request)}.png`);
  } catch (problem) {
    showProblem(problem);
  }
}
