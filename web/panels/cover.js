// Pictures that lie over the page's own.

import { Problem } from '../picture/problem.js';
import { t } from '../words/words.js';

/** A blob's picture, decoded, its `src` an object URL that whoever is done with it revokes. */
export async function imageOf(blob) {
  const image = new Image();
  image.src = URL.createObjectURL(blob);
  try {
    await image.decode();
    return image;
  } catch {
    URL.revokeObjectURL(image.src);
    throw new Problem({ title: t('trouble.unreadable'), status: 502 });
  }
}

const place = document.getElementById('compare');
let owner = null;

/** Lays nodes over the picture. `leave()` hears when somebody else lays something there. */
export function cover(leave, ...nodes) {
  if (owner && owner !== leave) owner();
  owner = leave;
  place.replaceChildren(...nodes);
  place.hidden = false;
  delete place.dataset.stale;
}

/** Tells that what was laid there with the same `leave` is of a picture that has gone. */
export function stale(leave) {
  if (owner === leave) place.dataset.stale = '';
}

/** Takes away what was laid there with the same `leave`. */
export function uncover(leave) {
  if (owner !== leave) return;
  owner = null;
  place.hidden = true;
  place.replaceChildren();
}
