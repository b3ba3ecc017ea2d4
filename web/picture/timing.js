// How long pictures took: what the server tells of each, and how many come a second.

/** `Server-Timing` as [{ name, ms }], in the order sent; entries without a duration are left out. */
export function readTiming(header) {
  return split(header).flatMap((entry) => {
    const [name, ...parameters] = entry.split(';').map((part) => part.trim());
    const duration = parameters.find((parameter) => /^dur=/i.test(parameter));
    const ms = duration ? Number(duration.slice(4).replaceAll('"', '')) : NaN;
    return Number.isFinite(ms) ? [{ name, ms }] : [];
  });
}

/** `Tia-Rays` as [{ name, count }], in the order sent. */
export function readRays(header) {
  return split(header).flatMap((entry) => {
    const [name, value] = entry.split('=');
    const count = Number(value);
    return Number.isFinite(count) ? [{ name, count }] : [];
  });
}

/** How many rays of a kind there are. */
export const countOf = (rays, kind) => rays.find(({ name }) => name === kind)?.count ?? 0;

/** The server's whole time in ms: its `total` where it sends one, else the sum of the phases. */
export function totalMs(timing) {
  const total = timing.find(({ name }) => name === 'total');
  return total ? total.ms : timing.reduce((sum, { ms }) => sum + ms, 0);
}

function split(header) {
  return (header ?? '').split(',').map((entry) => entry.trim()).filter(Boolean);
}

const LAST = 120;
const SECOND_MS = 1000;

/** What became of the last pictures: [{ at, ms, kind }], `kind` drawn, cached or failed. */
export class Pace {
  last = [];

  add(entry) {
    this.last.push(entry);
    if (this.last.length > LAST) this.last.shift();
  }

  /** How many of each kind. */
  get counts() {
    const counts = { drawn: 0, cached: 0, failed: 0 };
    for (const { kind } of this.last) counts[kind] += 1;
    return counts;
  }
}

/** Pictures a second over the second before `now`: the gaps between those that came; null: no gap. */
export function rateOf(last, now) {
  const times = last.filter(({ kind, at }) => kind !== 'failed' && now - at <= SECOND_MS).map(({ at }) => at);
  const span = times.at(-1) - times[0];
  return times.length > 1 && span > 0 ? ((times.length - 1) * SECOND_MS) / span : null;
}

/** The middle one of some numbers; NaN of none. */
export function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}
