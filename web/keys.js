// The keyboard: a, d, s, w and Escape act while the picture has focus, or everywhere if so wished.

const KEYS = ['a', 'd', 's', 'w', 'Escape'];
const TYPING = 'input:not([type=checkbox]), textarea, select, [contenteditable]';
const MEMORY = 'tia.keys-everywhere';

/** Calls `act(key)` for a key that the picture, or with the `everywhere` box the page, takes. */
export function bindKeys(picture, everywhere, act) {
  everywhere.checked = recall() === 'yes';
  everywhere.addEventListener('change', () => remember(everywhere.checked ? 'yes' : 'no'));

  document.addEventListener('keydown', (event) => {
    const key = keyOf(event);
    if (!key || !listens(event.target)) return;
    event.preventDefault();
    if (!event.repeat) act(key);
  });

  function listens(target) {
    return target === picture || (everywhere.checked && !target.closest?.(TYPING));
  }
}

// Layouts without Latin letters go by the key's place, the others by its letter.
function keyOf(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return undefined;
  const latin = /^[\x20-\x7e]+$/.test(event.key);
  const name = latin ? event.key : event.code.replace(/^Key/, '');
  return KEYS.find((key) => key.toLowerCase() === name.toLowerCase());
}

// Storage may be denied to the page; the wish then lasts as long as the page.
function recall() {
  try {
    return localStorage.getItem(MEMORY);
  } catch {
    return null;
  }
}

function remember(value) {
  try {
    localStorage.setItem(MEMORY, value);
  } catch (error) {
    console.info('The choice is kept for this visit only:', error.message);
  }
}
