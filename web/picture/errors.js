// How far rounds of one picture are from what they come to. Loaded with the first chart of it.

/**
 * The errors of rounds [{ samples, ms, blob }], the finest last, as [{ samples, ms, error }], in 0 to 1
 * of what is shown; `read(blob)` gives red, green, blue and alpha of its pixels. An error is the root
 * mean square of the difference from the finest, without the noise of that: of independent samples the
 * difference of the means of n, and of N with these among them, has the variance s^2 (1/n - 1/N). The
 * finest's own, `expected`, is what the one before it leaves by s^2 / N.
 */
export async function errorsOf(rounds, read) {
  const finest = rounds.at(-1);
  const data = await read(finest.blob);
  const errors = [];
  for (const { samples, ms, blob } of rounds.slice(0, -1))
    errors.push({ samples, ms, error: rms(await read(blob), data) / Math.sqrt(1 - samples / finest.samples) });
  const { samples, error } = errors.at(-1);
  return [...errors, { samples: finest.samples, ms: finest.ms, expected: true,
    error: error * Math.sqrt(samples / finest.samples) }];
}

function rms(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) if (i % 4 < 3) sum += (a[i] - b[i]) ** 2;
  return Math.sqrt(sum / (0.75 * a.length)) / 255;
}

/** The slope of the line of least squares through the logarithms of points [x, y]. */
export function slopeOf(points) {
  const [xs, ys] = [0, 1].map((i) => points.map((point) => Math.log(point[i])));
  const mean = (all) => all.reduce((sum, each) => sum + each, 0) / all.length;
  const [x, y] = [mean(xs), mean(ys)];
  return mean(xs.map((each, i) => (each - x) * (ys[i] - y))) / mean(xs.map((each) => (each - x) ** 2));
}
