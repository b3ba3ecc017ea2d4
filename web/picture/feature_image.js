// Feature images, as PFM files, and what the numbers of an `object` image mean: things from 1 on, in
// the order of core/scene/labels, where a group's members count and the group does not. Luminous
// lights follow the objects.

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

/** Of each number, from 1 on, which of the scene's own objects it belongs to. */
export function ownersOf({ objects = [] } = {}) {
  return objects.flatMap((object, index) => Array(membersOf(object)).fill(index));
}

function membersOf({ type, children = [] }) {
  return type === 'group' ? children.reduce((sum, child) => sum + membersOf(child), 0) : 1;
}

/** Which of the scene's objects a pixel of the image shows; -1 where none. */
export function ownerAt(image, owners, x, y) {
  return owners[image.at(x, y)[0] - 1] ?? -1;
}

/** The middle of what is seen of each object, as parts of the image: [{ index, x, y, share }], largest first. */
export function centersIn(image, owners) {
  const { width, height } = image;
  const sums = new Map();
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const index = ownerAt(image, owners, x, y);
      if (index < 0) continue;
      const sum = sums.get(index) ?? { index, count: 0, x: 0, y: 0 };
      sum.count += 1;
      sum.x += x + 0.5;
      sum.y += y + 0.5;
      sums.set(index, sum);
    }
  }
  return [...sums.values()].sort((a, b) => b.count - a.count)
    .map(({ index, count, x, y }) => ({ index, x: x / count / width, y: y / count / height, share: count / (width * height) }));
}
