// The picture that the page ends on, which may not be the one that it shows by now.

import { fetchPicture } from '../picture/server.js';
import { queryOf } from './request.js';

/** The studio's final picture, as fetchPicture gives it; what is shown already is not asked for. */
export async function finalPicture({ final, model }, signal) {
  const { shown } = model;
  const there = shown && queryOf(shown.request) === queryOf(final);
  return there ? shown : { ...await fetchPicture(final, signal), request: final };
}
