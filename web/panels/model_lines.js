// A model taken along: the line for a shell that sends its file and brings the picture, the link, and
// the still as a scene.

import { fetchStillScene } from '../picture/server.js';
import { curlLine, fileName, inScene, queryOf, quoted } from '../state/request.js';
import { t } from '../words/words.js';
import { pageAddress } from './address.js';
import { copiedLine } from './copied_line.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

/** The nodes, `named(bundle, id)`, which hears the names of its files, and `draw()`. */
export function modelLines(studio) {
  const { model } = studio;
  let sent = null; // the bundle that came here, and the id of its model
  const shell = copiedLine('model-shell', 'model.shell', shellLine);
  const link = copiedLine('model-link', 'take.link', async () => `${location.origin}${location.pathname}${await pageAddress(studio)}`);
  const scene = element('button', { type: 'button', onclick: asScene }, t('model.asScene'));

  async function asScene() {
    const { request } = model;
    try {
      const still = await fetchStillScene(request);
      if (model.request !== request) return; // the hand was quicker
      studio.open(inScene(request, still));
      studio.openTab('tab-scene');
      document.getElementById('tab-scene').focus();
    } catch (problem) {
      showProblem(problem);
    }
  }

  // Of a model that did not come here the page has no file's name: its picture comes by the id.
  function shellLine() {
    const { model: id, ...how } = studio.final;
    if (sent?.id !== id) return curlLine(studio.final, document.baseURI);
    const { files, main } = sent;
    const many = files.length > 1;
    const forms = files.map(({ path }) => `-F ${quoted(`file=@"${path}";filename="${path}"`)}`);
    const body = many ? forms.join(' ') : `--data-binary ${quoted(`@${files[0].path}`)}`;
    const url = new URL(`still?${queryOf({ ...(many && { main }), ...how })}`, document.baseURI).href;
    return `curl ${body} ${quoted(url)} -o tia${fileName({ model: id })}.png`;
  }

  return {
    nodes: [element('div', { class: 'row wrap' }, scene), shell.node, link.node],
    named: (bundle, id) => (sent = { ...bundle, id }),
    draw() {
      shell.draw();
      link.draw();
    },
  };
}
