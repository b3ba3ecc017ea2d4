// How fast pictures come: what the last ones took, and how many came a second.

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
