// A text to be read, and copied as it is.

import { t } from '../words/words.js';
import { bindCopy } from './carry.js';
import { element } from './element.js';

/** A button that copies what `text()` gives, now or by a promise. */
export function copyButton(label, words, text) {
  const made = element('button', { type: 'button', 'aria-label': label }, words);
  bindCopy(made, text);
  return made;
}

/**
 * The text with its title, button and note as { node, draw() }; the words called `words` are the title,
 * `words`Copy, Note, and Long where `text()` gives null, for there is none that short.
 */
export function copiedLine(id, words, text) {
  const shown = element('pre', { tabindex: 0, role: 'group', 'aria-labelledby': id });
  const copy = copyButton(t(`${words}Copy`), t('take.copy'), async () => (await text()) ?? '');
  const note = element('p', { class: 'note' }, t(`${words}Note`));
  let newest = 0;
  const node = element('div', { class: id },
    element('h2', { id }, t(words)), element('div', { class: 'line' }, shown, copy), note);
  return { node, draw };

  async function draw() {
    const mine = ++newest;
    const now = await text();
    if (mine !== newest) return;
    if (shown.textContent !== (now ?? '')) shown.textContent = now ?? '';
    shown.parentElement.hidden = now === null;
    note.textContent = t(now === null ? `${words}Long` : `${words}Note`);
  }
}
