// Carrying things away from the page: a file saved, a text copied.

import { t } from '../words/words.js';

const TAKEN_MS = 10_000; // by then the browser has begun to write the file

/** Saves a blob as a file called `name`. */
export function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), TAKEN_MS);
}

const SHOWN_MS = 2000;
const said = document.getElementById('said');

/** Makes `button` copy what `text()` gives, now or by a promise, and says whether that worked. */
export function bindCopy(button, text) {
  const label = button.textContent;
  let timer;
  button.addEventListener('click', async () => {
    const words = await text();
    const done = words !== '' && (await copy(words));
    const short = words.length > 200 ? `${words.slice(0, 200)}\u2026` : words;
    said.textContent = done ? t('take.copied', { words: short }) : t('take.notCopied');
    button.textContent = done ? t('take.copiedShort') : t('take.notCopiedShort');
    clearTimeout(timer);
    timer = setTimeout(() => (button.textContent = label), SHOWN_MS);
  });
}

// The clipboard interface exists on https and localhost only; elsewhere a selection is copied.
async function copy(words) {
  try {
    await navigator.clipboard.writeText(words);
    return true;
  } catch {
    return copySelected(words);
  }
}

function copySelected(words) {
  const focused = document.activeElement;
  const area = document.createElement('textarea');
  area.value = words;
  document.body.append(area);
  area.select();
  const done = document.execCommand('copy');
  area.remove();
  focused?.focus({ preventScroll: true });
  return done;
}
