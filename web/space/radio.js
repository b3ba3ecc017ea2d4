// How radio's maps and paths are drawn: kinds of paths, colours of a map's steps, ticks of an axis.

/** What a path is called by: the rarest thing that happens on it. */
export function kindOf({ interactions }) {
  const kinds = interactions.map(({ kind }) => kind);
  return ['diffraction', 'transmission', 'reflection'].find((kind) => kinds.includes(kind)) ?? 'direct';
}

/** The same path found by another method has the same: what happens on it, in order, and where. */
export const sequenceOf = ({ interactions }) =>
  interactions.map(({ kind, object, element }) => [kind, object, element].join(' ')).join(', ') || 'direct';

/** The loss of a way of `metres` through empty space, as a gain in dB. Source: Friis (1946), equation 1, of isotropic antennas. */
export const emptySpaceDb = (metres, frequency_hz) => 20 * Math.log10(299_792_458 / (4 * Math.PI * metres * frequency_hz));

// Viridis at tenths. Source: van der Walt and Smith, matplotlib's colour maps (2015): lightness rises evenly,
// for colour-blind eyes, too.
const VIRIDIS = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137],
  [53, 183, 121], [109, 205, 89], [180, 222, 44], [223, 227, 24], [253, 231, 37]];

/** The colour of a share from 0 to 1: [r, g, b]. */
export function viridis(share) {
  const at = Math.max(0, Math.min(1, share)) * (VIRIDIS.length - 1);
  const [low, high] = [VIRIDIS[Math.floor(at)], VIRIDIS[Math.ceil(at)]];
  return low.map((value, i) => Math.round(value + (at - Math.floor(at)) * (high[i] - value)));
}

// Okabe and Ito's, which stay apart for colour-blind eyes.
const APART = [[86, 180, 233], [230, 159, 0], [0, 158, 115], [240, 228, 66]];
const [DECIBELS, DARKEST] = [3, 0.02]; // a step, and the share of cells that may be darker than the scale
const round = (x) => Math.floor(x + 1e-9); // what lies on a step's border belongs to it

/**
 * The scale of a map: { low, high, step, colorOf(value), shareOf(value) } in the map's unit, whole steps of 3 dB, of
 * best_server of one server each; null where no cell has a value.
 */
export function scaleOf({ quantity, values }) {
  const all = values.flat().filter((value) => value !== null).sort((a, b) => a - b);
  if (!all.length) return null;
  const most = all.at(-1);
  if (quantity === 'best_server') return scaled(0, most + 1, 1, (value) => APART[Math.round(value) % APART.length], 0.5);
  const least = quantity === 'delay_spread' ? 0 : all[round(all.length * DARKEST)];
  const step = quantity === 'delay_spread' ? niceStep(most - least, 12) || 1e-9 : DECIBELS;
  const low = round(least / step) * step;
  const high = Math.max(round(most / step) + 1, round(low / step) + 1) * step;
  return scaled(low, high, step, (value) => viridis((round(value / step) * step - low) / Math.max(high - low - step, step)));
}

function scaled(low, high, step, colorOf, inside = 0) {
  return { low, high, step, colorOf, shareOf: (value) => Math.max(0, Math.min(1, (value + inside - low) / (high - low))) };
}

/** A step of 1, 2 or 5 times a power of ten of which at most `most` fit into `length`; 0 where there is none. */
export function niceStep(length, most) {
  if (!(length > 0)) return 0;
  const ten = 10 ** Math.floor(Math.log10(length / most));
  return [1, 2, 5, 10].map((by) => by * ten).find((step) => length / step <= most);
}

/** Round numbers from `low` to `high`, at most `most` and one. */
export function ticksOf(low, high, most) {
  const step = niceStep(high - low, most);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
