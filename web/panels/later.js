// Panels that are loaded when they are first opened, so that nobody waits for what he does not use.

import { Problem } from '../picture/problem.js';
import { learn, t } from '../words/words.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

/**
 * Mounts `NAME.js` once its tab is opened, with its words and its style, where it exports `style`. What
 * could not be loaded is tried again when the tab is opened again.
 */
export const later = (name) => (studio, panel) => {
  let asked = false;
  studio.model.on('tab', async () => {
    if (asked || studio.tab !== `tab-${name}`) return;
    asked = true;
    try {
      const [{ default: mount, style }] = await Promise.all([import(`./${name}.js`), learn(name)]);
      if (style) await sheet(style);
      mount(studio, panel);
    } catch (error) {
      asked = false;
      console.warn(error.message);
      showProblem(new Problem({ title: t('trouble.unreachable') }));
    }
  });
};

// Adds a style sheet and waits for it.
function sheet(href) {
  return new Promise((resolve, reject) =>
    document.head.append(element('link', { rel: 'stylesheet', href, onload: resolve, onerror: reject })));
}
