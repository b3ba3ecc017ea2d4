// Colours in linear light and as people pick them. Source: IEC 61966-2-1 (sRGB).

const DIGITS = 5; // of a stored number: enough for each of 256 codes to come back as itself

const coded = (light) => (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
const light = (code) => (code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4);
const codeOf = (value) => Math.round(255 * coded(Math.min(1, Math.max(0, value))));

/** Linear RGB as "#rrggbb". */
export function hexOf(rgb) {
  return `#${rgb.map((value) => codeOf(value).toString(16).padStart(2, '0')).join('')}`;
}

/** "#rrggbb" in linear light; channels that `old` shows the same keep its number, also above 1. */
export function linearOf(hex, old = []) {
  return [1, 3, 5].map((at, i) => {
    const code = parseInt(hex.slice(at, at + 2), 16);
    const stays = old[i] !== undefined && codeOf(old[i]) === code;
    return stays ? old[i] : Number(light(code / 255).toPrecision(DIGITS));
  });
}
