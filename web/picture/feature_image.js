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

function membersOf(object) {
  if (object.type === 'walls') return piecesOf(object);
  const { type, children = [] } = object;
  return type === 'group' ? children.reduce((sum, child) => sum + membersOf(child), 0) : 1;
}

// How many boxes and corners walls are lowered to, as core/shapes/composite/wall_pieces does it.
function piecesOf({ points, closed = false, height, thickness, openings = [] }) {
  const runs = points.slice(closed ? 0 : 1).map((point, i) => {
    const [from, to] = closed ? [point, points[(i + 1) % points.length]] : [points[i], point];
    const [x, z] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(x, z);
    return { way: [x / length, z / length], length, from: 0, to: length };
  });
  let count = 0;
  for (let i = 0; i < (closed ? runs.length : runs.length - 1); ++i) count += cornerBetween(runs[i], runs[(i + 1) % runs.length], thickness / 2);
  let begin = 0;
  for (const { length, from, to } of runs) {
    let free = from;
    const inRun = openings.filter((each) => each.from >= begin && each.from < begin + length).sort((a, b) => a.from - b.from);
    for (const { from: left, to: right, sill = 0, lintel = height } of inRun) {
      count += (left - begin - free > thickness * 1e-9) + (sill > 0) + (lintel < height);
      free = right - begin;
    }
    count += to - free > thickness * 1e-9;
    begin += length;
  }
  return count;
}

// Shortens two runs by what their corner takes; 1 where it has a piece of its own.
function cornerBetween(a, b, half) {
  const sine = a.way[0] * b.way[1] - a.way[1] * b.way[0];
  const cosine = a.way[0] * b.way[0] + a.way[1] * b.way[1];
  if (Math.abs(sine) <= 1e-12) return 0;
  const right = Math.abs(cosine) <= 1e-12;
  const reach = half * Math.abs(sine) / (1 + cosine);
  a.to += right ? half : -reach;
  b.from = reach;
  return right ? 0 : 1;
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
