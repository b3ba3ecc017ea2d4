// A picture's size, and its window: the part of it that a `crop` leaves. Pixels are counted in the
// whole picture, wherever the window is.

/** What a picture's size is where a request names none: of a scene, and of a model. */
export const usualSizeOf = ({ model }) => (model ? [512, 512] : [640, 480]);

/** The whole picture's [width, height]. */
export function sizeOf(request) {
  return [request.width ?? usualSizeOf(request)[0], request.height ?? usualSizeOf(request)[1]];
}

/** What is seen of it: { x, y, width, height }. A crop that the server will refuse is none. */
export function windowOf(request) {
  const { crop } = request;
  const [width, height] = sizeOf(request);
  const [x0, y0, x1, y1] = Array.isArray(crop) ? crop : [0, 0, width, height];
  const good = 0 <= x0 && x0 < x1 && x1 <= width && 0 <= y0 && y0 < y1 && y1 <= height;
  return good ? { x: x0, y: y0, width: x1 - x0, height: y1 - y0 } : { x: 0, y: 0, width, height };
}

/** The middle of what is seen, a pixel. */
export function middleOf(request) {
  const { x, y, width, height } = windowOf(request);
  return [Math.floor(x + width / 2), Math.floor(y + height / 2)];
}

/** How many pixels are seen. */
export function pixelsOf(request) {
  const { width, height } = windowOf(request);
  return width * height;
}

/** The same picture at another size, its crop rounded outwards. */
export function resized(request, [width, height]) {
  const [before, high] = sizeOf(request);
  if (!Array.isArray(request.crop)) return { ...request, width, height };
  const [x0, y0, x1, y1] = request.crop;
  const [across, down] = [(x) => (x * width) / before, (y) => (y * height) / high];
  const crop = [Math.floor(across(x0)), Math.floor(down(y0)), Math.ceil(across(x1)), Math.ceil(down(y1))];
  return { ...request, width, height, crop };
}

/** The same picture at `scale` times its size, at least a pixel. */
export function scaled(request, scale) {
  return resized(request, sizeOf(request).map((length) => Math.max(1, Math.round(length * scale))));
}
