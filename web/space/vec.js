// Vectors as arrays of three numbers.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(...a);
export const normalize = (a) => scale(a, 1 / length(a));

/** `a` turned about the unit axis `k`, counter-clockwise seen from its tip. Source: Rodrigues 1840. */
export function turn(a, k, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return add(add(scale(a, c), scale(cross(k, a), s)), scale(k, dot(k, a) * (1 - c)));
}

/** Rounded to `digits` significant digits of the largest: what a hand can mean. */
export function tidyVector(a, digits = 4) {
  const most = Math.max(...a.map(Math.abs), 1e-30);
  const places = Math.min(12, Math.max(0, digits - 1 - Math.floor(Math.log10(most))));
  return a.map((value) => Number(value.toFixed(places)) + 0);
}
