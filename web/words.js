// The page's sentences about a picture.

const PLACES = {
  a: 'Light to the left',
  d: 'Light to the right',
  s: 'Light above, near the eye',
  w: 'Light above, far from the eye',
};

/** A state in words; `light` is where its lamp stands, where that is known. */
export function stateWords(state, light) {
  if (!state.key && !state.light) return 'Light off';
  const place = state.key ? (PLACES[state.key] ?? `Light of key ${state.key}`) : 'Light';
  const at = light ? `at ${light.join(', ')}` : '';
  return [place, at].filter(Boolean).join(state.key ? ', ' : ' ');
}

/** The picture's text alternative. */
export function pictureWords(title, state, light) {
  return `${title ?? 'Rendered picture'}. ${stateWords(state, light)}.`;
}

/** A duration with three digits that mean something. */
export function msWords(ms) {
  return `${ms.toLocaleString('en', { maximumSignificantDigits: ms < 1000 ? 3 : 4 })} ms`;
}

/** A count with its thousands set apart. */
export function countWords(count) {
  return count.toLocaleString('en');
}
