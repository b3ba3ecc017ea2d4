// What outlives a reload. Storage may be denied to the page; it then forgets.

/** What was remembered under `name`, or null. */
export function recall(name, storage = 'localStorage') {
  try {
    return globalThis[storage].getItem(`tia.${name}`);
  } catch {
    return null;
  }
}

/** Remembers a text under `name`; null forgets it. Returns whether that worked. */
export function remember(name, text, storage = 'localStorage') {
  try {
    if (text === null) globalThis[storage].removeItem(`tia.${name}`);
    else globalThis[storage].setItem(`tia.${name}`, text);
    return true;
  } catch (error) {
    console.info('Kept for this visit only:', error.message);
    return false;
  }
}
