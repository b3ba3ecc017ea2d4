// The hand turns a model: the eye of its still goes around it. Both its lights and its frame follow.

const DEFAULT = [30, 20]; // degrees: azimuth and elevation of a still that says nothing
const ZOOMS = [0.1, 1000];
const rounded = (value, digits) => Number(value.toPrecision(digits));

/** A tool of the hand (panels/hand.js) for stills. One of the file's own cameras is left by it. */
export function orbitTool({ model }) {
  const begin = () => ({ from: model.request.orbit ?? DEFAULT, height: model.request.height ?? 512 });

  function drag({ from: [azimuth, elevation], height }, { start, at }) {
    const [x, y] = [0, 1].map((i) => (180 * (at[i] - start[i])) / height);
    const around = azimuth - x - 360 * Math.round((azimuth - x) / 360);
    const above = Math.min(90, Math.max(-90, elevation + y));
    model.change({ camera: null, orbit: [around, above].map((angle) => Number(angle.toFixed(1))) });
  }

  const turn = (at) => drag(begin(), { start: [0, 0], at });

  function nearer(factor) {
    const zoom = rounded(Math.min(ZOOMS[1], Math.max(ZOOMS[0], (model.request.zoom ?? 1) / factor)), 4);
    model.change({ camera: null, zoom });
  }

  return { begin, drag, turn, nearer, pan: () => {} };
}
