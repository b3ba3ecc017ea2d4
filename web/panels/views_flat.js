// Ways of seeing that are one picture: for red and blue glasses, the views of a display side by side, and
// all that is around the eye.

import { distanceOf } from '../space/lamp.js';
import { scaled } from '../state/window.js';

export const VIEWS = 9;
const CONE_DEGREES = 30;

/** How far what the camera looks at is; the plane that stays where it is lies there. */
export const focusOf = ({ pivot, camera }) => (pivot ? distanceOf(pivot, camera.location) : 10);

/** A request with fields of its camera replaced, and no display but what they say. */
export const seenBy = (request, fields) =>
  ({ ...request, crop: null, camera: { ...request.camera, display: null, interlace: null, ...fields } });

/** The display of `columns` views in a row, `scale` times the picture's size each. */
export function rowOfViews(studio, request, columns, scale) {
  const display = { type: 'quilt', columns, rows: 1, cone_degrees: CONE_DEGREES, focus_distance: focusOf(studio) };
  return seenBy(scaled({ ...request, crop: null }, scale), { display });
}

export const anaglyph = ({ studio }) => ({
  name: 'anaglyph',
  request(base) {
    const convergence = focusOf(studio);
    return seenBy(base, { display: { type: 'stereo', separation: convergence / 30, convergence, layout: 'anaglyph', matrix: 'dubois' } });
  },
  show: (image) => image,
});

export const quilt = ({ studio }) => ({
  name: 'quilt',
  request: (base) => rowOfViews(studio, base, 3, 1 / 3),
  show: (image) => whole(image),
});

export const panorama = () => ({
  name: 'panorama',
  request(base) {
    const wide = { ...base, width: 1024, height: 512 };
    return seenBy(wide, { projection: 'equirectangular', fov_degrees: null, aperture: null, focus_distance: null, height: null });
  },
  show: (image) => whole(image),
});

// As it is, all of it.
function whole(image) {
  image.classList.add('whole');
  return image;
}
