// Taking the picture along: as a file, a link, an address, a shell line, a scene.

import { finalPicture } from '../studio/studio.js';
import { curlLine, fetchable, fileName, routeOf } from '../state/request.js';
import { mergePatch } from '../state/merge_patch.js';
import { moves } from '../state/tracks.js';
import { t } from '../words/words.js';
import { pageAddress } from './address.js';
import { save } from './carry.js';
import { copiedLine, copyButton } from './copied_line.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';
import { takeForm } from './take_form.js';

const LONGEST_LINE = 120_000; // a shell takes arguments of up to 128 KiB

export default function mountTake(studio, panel) {
  const { model } = studio;
  const form = takeForm(studio);
  const lines = [
    copiedLine('take-link', 'take.link', () => linkOf(studio)),
    copiedLine('take-address', 'take.address', () => addressOf(studio.final)),
    copiedLine('take-shell', 'take.shell', () => shellLine(studio.final)),
  ];
  panel.append(
    element('div', { class: 'row wrap' },
      button('savePicture', () => savePicture(studio)),
      button('saveScene', () => save(new Blob([sceneText(studio)]), `tia${fileName({ ...model.request, time: null })}.json`)),
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

/** The page's address for what is shown, whole. */
async function linkOf(studio) {
  return `${location.origin}${location.pathname}${await pageAddress(studio)}`;
}

/** Where the picture itself lies; null where its request is too long for an address. */
function addressOf(request) {
  const { path, init } = fetchable(routeOf(request), request);
  return init.body ? null : new URL(path, document.baseURI).href;
}

function shellLine(request) {
  const text = curlLine(request, document.baseURI);
  return new Blob([text]).size < LONGEST_LINE ? text : null;
}

/** The scene of the picture, its key, light and camera in it; all of one that moves, seen as now. */
function sceneText({ model }) {
  const { source, world, request } = model;
  const whole = moves(source) && request.camera ? mergePatch(source, { camera: request.camera }) : source;
  return `${JSON.stringify(moves(source) ? whole : world ?? source, null, 2)}\n`;
}

async function savePicture(studio) {
  try {
    const { blob, request } = await finalPicture(studio);
    save(blob, `tia${fileName(request)}.png`);
  } catch (problem) {
    showProblem(problem);
  }
}
