// What the panel shows: an invitation, an explanation, or why there is none.

import { problemWords } from '../picture/problem.js';
import { t } from '../words/words.js';
import { element } from './element.js';

/** Fills `panel`; `stop()`, `middle()` and `moved()` hear of what a person does there. */
export function makeView(panel, { stop, middle, moved }) {
  const button = (words, onclick) => element('button', { type: 'button', onclick }, t(words));
  const start = button('why.middle', middle);
  const invitation = [element('p', {}, t('why.intro')), element('div', {}, start)];
  const stopping = element('div', {}, button('why.stop', stop));
  let told = null; // once learn() has brought it
  const put = (parts) => parts[0].parentNode === panel || panel.replaceChildren(...parts);

  panel.classList.add('why');
  put(invitation);
  return {
    /** Brings what tells an explanation. */
    async learn() {
      const { makeTold } = await import('./why_told.js');
      told ??= makeTold(moved, stopping);
    },
    /** The rays to be drawn, as the model has them. */
    get rays() {
      return told.rays;
    },
    invite(focus) {
      put(invitation);
      if (focus) start.focus();
    },
    busy: () => put([element('p', {}, t('why.busy'))]),
    refuse: (words) => put([element('p', { class: 'fault' }, words), stopping]),
    fail(problem) {
      const { title, lines } = problemWords(problem);
      const said = [element('strong', {}, title), ...lines];
      put([...said.map((line) => element('p', { class: 'fault' }, line)), stopping]);
    },
    /** An explanation with its pixel and transfer; `again` where the pixel is the one shown before. */
    show(explained, about, again) {
      if (stopping.parentNode !== panel || !panel.contains(told.nodes[0])) panel.replaceChildren(...told.nodes);
      return told.show(explained, about, again);
    },
  };
}
