// The difference of two pictures as a picture of its own, and in numbers.

import { differenceOf, pixelsOf } from '../picture/difference.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';

/** The view as { node, draw(a, b, factor), words(difference) }; `a` and `b` are blobs of one size. */
export function differenceView() {
  const node = element('canvas', { class: 'difference', role: 'img', 'aria-label': t('compare.difference') });

  async function draw(a, b, factor) {
    const [left, right] = await Promise.all([pixelsOf(a), pixelsOf(b)]);
    const difference = differenceOf(left, right, factor);
    [node.width, node.height] = [left.width, left.height];
    node.getContext('2d').putImageData(difference.image, 0, 0);
    return difference;
  }

  return { node, draw, words };
}

function words({ differing, count, largest, mean }) {
  if (differing === 0) return t('compare.same', { count: countWords(count) });
  const share = numberWords((100 * differing) / count);
  return t('compare.differ', {
    differing: countWords(differing), count: countWords(count), share, largest, mean: numberWords(mean),
  });
}
