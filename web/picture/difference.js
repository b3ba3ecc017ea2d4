// How two pictures differ, pixel by pixel, in the codes that their PNGs hold. Loaded when that is asked.

/** The pixels of a blob's picture, as ImageData: the PNG's own codes, for these have no colour profile. */
export async function pixelsOf(blob) {
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/**
 * |a - b| of two ImageData of one size: `image`, that times `factor`, cut off at 255; `differing`,
 * the pixels with any difference, of `count`; `largest` and `mean` over all red, green and blue.
 */
export function differenceOf(a, b, factor) {
  const image = new ImageData(a.width, a.height);
  let [differing, largest, sum] = [0, 0, 0];
  for (let at = 0; at < a.data.length; at += 4) {
    let most = 0;
    for (let i = at; i < at + 3; ++i) {
      const by = Math.abs(a.data[i] - b.data[i]);
      image.data[i] = by * factor; // a clamped array
      sum += by;
      if (by > most) most = by;
    }
    image.data[at + 3] = 255;
    if (most > 0) differing += 1;
    if (most > largest) largest = most;
  }
  const count = a.width * a.height;
  return { image, differing, count, largest, mean: sum / (3 * count) };
}
