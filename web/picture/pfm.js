// PFM: linear light or a feature as floats. Source: Paul Debevec, PFM Portable FloatMap.

/** { width, height, at(x, y) } of a PFM's bytes; at() gives [r, g, b] and row 0 is the top. */
export function readPfm(buffer) {
  const head = /^PF\n(\d+) (\d+)\n-1(?:\.0+)?\n/.exec(new TextDecoder('latin1').decode(buffer.slice(0, 64)));
  if (!head) throw new Error('not a little-endian PFM of three channels');
  const [all, width, height] = [head[0].length, Number(head[1]), Number(head[2])];
  const view = new DataView(buffer, all);
  const at = (x, y) => [0, 4, 8].map((byte) =>
    view.getFloat32(((height - 1 - y) * width + x) * 12 + byte, true));
  return { width, height, at };
}
