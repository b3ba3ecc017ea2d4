// The letters a, d, s, w and Escape: while the picture has focus, everywhere, or not at all
// (WCAG 2.1.4, Character Key Shortcuts).

const KEYS = ['a', 'd', 's', 'w', 'Escape'];
const TYPING = 'input:not([type=checkbox], [type=range]), textarea, select, [contenteditable]';

/** Calls `act(key)` for a key that `where()`, "picture", "everywhere" or "off", lets through. */
export function bindKeys(picture, where, act) {
  document.addEventListener('keydown', (event) => {
    const key = keyOf(event);
    if (!key || !listens(event.target)) return;
    event.preventDefault();
    if (!event.repeat) act(key);
  });

  function listens(target) {
    if (where() === 'off') return false;
    return target === picture || (where() === 'everywhere' && !target.closest?.(TYPING));
  }
}

// Layouts without Latin letters go by the key's place, the others by its letter.
function keyOf(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return undefined;
  const latin = /^[\x20-\x7e]+$/.test(event.key);
  const name = latin ? event.key : event.code.replace(/^Key/, '');
  return KEYS.find((key) => key.toLowerCase() === name.toLowerCase());
}
