// A picture as an element that can lie anywhere in the page.

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
