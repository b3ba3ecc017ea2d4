// Buttons that copy a text.

const SHOWN_MS = 2000;

/** Makes `button` copy what `text()` gives and `say` whether that worked. */
export function bindCopy(button, text, say) {
  const label = button.textContent;
  let timer;
  button.addEventListener('click', async () => {
    const words = text();
    const done = words !== '' && (await copy(words));
    say(done ? `Copied: ${words}` : 'Nothing was copied');
    button.textContent = done ? 'Copied' : 'Not copied';
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
