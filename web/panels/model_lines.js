// A model taken along: the lines for a shell that send its file and fetch the picture, the link, and
// the still as a scene.

import { curlLine, quoted } from '../state/request.js';
import { t } from '../words/words.js';
import { pageAddress } from './address.js';
import { copiedLine } from './copied_line.js';
import { element } from './element.js';

/** The nodes, `named(bundle, id)`, which hears the names of its files, and `draw(description)`. */
export function modelLines(studio) {
  let sent = null; // the files that came here, and the id of their model
  let known = null;
  const shell = copiedLine('model-shell', 'model.shell', () => `${sendLine()}\n${curlLine(studio.final, document.baseURI)}`);
  const link = copiedLine('model-link', 'take.link', async () => `${location.origin}${location.pathname}${await pageAddress(studio)}`);
  const scene = element('button', { type: 'button', onclick: asScene }, t('model.asScene'));

  function asScene() {
    studio.open(studio.inScene);
    studio.openTab('tab-scene');
    document.getElementById('tab-scene').focus();
  }

  // Names of files are known of those that came here; else a file has its format's.
  function sendLine() {
    const url = quoted(new URL('models', document.baseURI).href);
    const named = known.files.map(({ path }) => ({ path: path ?? `model.${known.format}` }));
    const files = sent?.id === known.id ? sent.files : named;
    if (files.length === 1) return `curl --data-binary ${quoted(`@${files[0].path}`)} ${url}`;
    const forms = files.map(({ path }) => `-F ${quoted(`file=@"${path}";filename="${path}"`)}`);
    return `curl ${forms.join(' ')} ${url}`;
  }

  return {
    nodes: [element('div', { class: 'row wrap' }, scene), shell.node, link.node],
    named: ({ files }, id) => (sent = { files, id }),
    draw(description) {
      known = description;
      shell.draw();
      link.draw();
    },
  };
}
