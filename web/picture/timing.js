// What a picture cost, read from its headers.

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

/** The server's whole time in ms: its `total` where it sends one, else the sum of the phases. */
export function totalMs(timing) {
  const total = timing.find(({ name }) => name === 'total');
  return total ? total.ms : timing.reduce((sum, { ms }) => sum + ms, 0);
}

function split(header) {
  return (header ?? '').split(',').map((entry) => entry.trim()).filter(Boolean);
}
