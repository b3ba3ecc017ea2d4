// The curve of sRGB and a picture's 8-bit codes: the same arithmetic as the server's
// core/film/tonemap. Source of the curve: IEC 61966-2-1:1999.

const DIGITS = 5; // of a stored number: enough for each of 256 codes to come back as itself

const toSignal = (light) => (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
const toLight = (signal) => (signal <= 0.04045 ? signal / 12.92 : ((signal + 0.055) / 1.055) ** 2.4);
const codeOf = (light) => Math.round(255 * toSignal(clamp(light)));

/** Linear RGB as "#rrggbb". */
export function hexOf(rgb) {
  return `#${rgb.map((value) => codeOf(value).toString(16).padStart(2, '0')).join('')}`;
}

/** "#rrggbb" in linear light; channels that `old` shows the same keep its number, also above 1. */
export function linearOf(hex, old = []) {
  return [1, 3, 5].map((at, i) => {
    const code = parseInt(hex.slice(at, at + 2), 16);
    const stays = old[i] !== undefined && codeOf(old[i]) === code;
    return stays ? old[i] : Number(toLight(code / 255).toPrecision(DIGITS));
  });
}

/** Whether codesOf knows what stores a colour; else it shows it as sRGB. */
export const storesPlainly = (transfer) => transfer === 'srgb' || transfer === 'linear';

/** The codes that store a colour: `transfer` is `srgb` or `linear`. */
export function codesOf(color, transfer = 'srgb') {
  return color.map(transfer === 'linear' ? linearCode : srgbCode);
}

// In float, as the server rounds it.
function linearCode(light) {
  return Math.floor(Math.fround(Math.fround(clamp(light) * 255) + 0.5));
}

// The server compares with the light at which a code changes; so does this, next to the curve.
function srgbCode(light) {
  const code = Math.floor(255 * toSignal(clamp(light)) + 0.5);
  if (code > 0 && light < toLight((code - 0.5) / 255)) return code - 1;
  return code < 255 && light >= toLight((code + 0.5) / 255) ? code + 1 : code;
}

function clamp(light) {
  return light > 0 ? Math.min(light, 1) : 0;
}
