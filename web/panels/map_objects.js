// The objects of a plan: where they are, told by its object image, and moved, as edits of the scene.

import { ownerAt } from '../picture/feature_image.js';
import { add, tidyVector } from '../space/vec.js';

const MOST = 12;
const LARGEST = 0.4; // of the plan: what fills more is a floor or a wall

/** Where each object's visible part has its middle, as parts of the image: [{ index, x, y, share }]. */
export function centersIn(image, owners) {
  const { width, height } = image;
  const sums = new Map();
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const index = ownerAt(image, owners, x, y);
      if (index < 0) continue;
      const sum = sums.get(index) ?? { index, count: 0, x: 0, y: 0 };
      sum.count += 1;
      sum.x += x + 0.5;
      sum.y += y + 0.5;
      sums.set(index, sum);
    }
  }
  return [...sums.values()].sort((a, b) => b.count - a.count)
    .map(({ index, count, x, y }) => ({ index, x: x / count / width, y: y / count / height, share: count / (width * height) }))
    .filter(({ share }) => share < LARGEST).slice(0, MOST);
}

/** The edits, [[JSON Pointer, value]], that move an object by `way`. */
export function movedObject(object, index, way) {
  const pointer = `/objects/${index}`;
  if (object.center && !object.transform) return [[`${pointer}/center`, tidyVector(add(object.center, way), 5)]];
  const steps = object.transform ?? [];
  const last = steps.at(-1)?.translate;
  const moved = { translate: tidyVector(add(last ?? [0, 0, 0], way), 5) };
  return [[`${pointer}/transform`, [...(last ? steps.slice(0, -1) : steps), moved]]];
}
