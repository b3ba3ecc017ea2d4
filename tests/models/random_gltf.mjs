// glTF files by chance, the same for the same seed: every kind of accessor, primitive and node that
// Tia, three and gltf-validator all take.

/** Numbers by chance (mulberry32): next() in [0, 1), and what is made of it. */
export function chance(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  const within = (least, most) => least + (most - least) * next();
  const integer = (least, most) => Math.floor(within(least, most + 1));
  const vector = (size) => {
    const all = Array.from({ length: size }, () => within(-1, 1) + 1e-3);
    const length = Math.hypot(...all);
    return all.map((each) => each / length);
  };
  return { next, within, integer, vector, pick: (list) => list[integer(0, list.length - 1)], maybe: (p) => next() < p };
}

const COMPONENTS = {
  5120: { bytes: 1, most: 127, set: 'setInt8' }, 5121: { bytes: 1, most: 255, set: 'setUint8' },
  5122: { bytes: 2, most: 32767, set: 'setInt16' }, 5123: { bytes: 2, most: 65535, set: 'setUint16' },
  5125: { bytes: 4, most: 2 ** 32 - 1, set: 'setUint32' }, 5126: { bytes: 4, set: 'setFloat32' },
};
const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const FLOAT = 5126, FLOATS = [{ component: FLOAT }];
const UNITS = [5121, 5123].map((component) => ({ component, normalized: true }));
const DIRECTIONS = [5120, 5122].map((component) => ({ component, normalized: true }));
const INTEGERS = [5120, 5121, 5122, 5123].map((component) => ({ component, normalized: false }));

/** A file that grows: its JSON and its bytes. */
class File {
  constructor(chances) {
    this.c = chances;
    this.json = { asset: { version: '2.0' }, buffers: [{}], bufferViews: [], accessors: [] };
    this.bytes = [];
  }

  view(bytes, more = {}) {
    while (this.bytes.length % 4 !== 0 || this.c.maybe(0.2)) this.bytes.push(0);
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.bytes.length, byteLength: bytes.length, ...more });
    for (const byte of bytes) this.bytes.push(byte);
    return this.json.bufferViews.length - 1;
  }

  /** Elements packed into bytes, of attributes with a stride of their own; gives the accessor's number. */
  accessor(type, elements, { component, normalized = false }, use = {}) {
    const { c } = this, { bytes, set } = COMPONENTS[component];
    const element = SIZES[type] * bytes, aligned = Math.ceil(element / 4) * 4;
    const stride = use.attribute ? aligned + 4 * c.integer(0, 2) : element;
    // Elements do not cross the end of a stride, of which the last is whole: three wants it so.
    const before = stride * c.integer(0, 1) + 4 * c.integer(0, Math.floor((stride - element) / 4));
    const pack = (list, step, start = 0) => {
      const view = new DataView(new ArrayBuffer(Math.ceil((start + element) / step) * step + step * (list.length - 1)));
      list.forEach((numbers, i) => numbers.forEach((n, k) => view[set](start + i * step + k * bytes, n, true)));
      return new Uint8Array(view.buffer);
    };
    const accessor = { componentType: component, count: elements.length, type };
    if (normalized) accessor.normalized = true;
    const view = (list, step, start) => this.view(pack(list, step, start), use.target ? { target: use.target } : {});
    if (use.attribute && c.maybe(0.2)) this.sparse(accessor, elements, pack, c.maybe(0.5) && element % 4 === 0);
    else {
      accessor.bufferView = view(elements, stride, use.attribute ? before : 0);
      if (use.attribute && before > 0) accessor.byteOffset = before;
      if (stride !== element) this.json.bufferViews[accessor.bufferView].byteStride = stride;
      else if (use.attribute && element % 4 === 0 && c.maybe(0.5))
        this.json.bufferViews[accessor.bufferView].byteStride = stride;
    }
    if (use.bounds) this.bound(accessor, elements);
    this.json.accessors.push(accessor);
    return this.json.accessors.length - 1;
  }

  /** Only what differs from a view of other numbers, or from zeros, is written. */
  sparse(accessor, elements, pack, based) {
    const { c } = this;
    const differs = elements.map((each) => !based || each.some((n) => n !== 0) && c.maybe(0.5));
    if (!differs.includes(true)) differs[0] = true;
    const places = [...differs.keys()].filter((i) => differs[i]);
    const size = elements[0].length * COMPONENTS[accessor.componentType].bytes;
    const zeros = elements[0].map(() => 0);
    if (based) accessor.bufferView = this.view(pack(elements.map((each, i) => (differs[i] ? zeros : each)), size));
    const component = c.pick([5121, 5123, 5125]), { bytes, set } = COMPONENTS[component];
    const indices = new DataView(new ArrayBuffer(bytes * places.length));
    places.forEach((place, i) => indices[set](i * bytes, place, true));
    accessor.sparse = {
      count: places.length,
      indices: { bufferView: this.view(new Uint8Array(indices.buffer)), componentType: component },
      values: { bufferView: this.view(pack(places.map((i) => elements[i]), size)) },
    };
  }

  bound(accessor, elements) {
    const each = (choose) => elements[0].map((_, k) => choose(...elements.map((e) => e[k])));
    accessor.min = each(Math.min);
    accessor.max = each(Math.max);
  }

  glb() {
    this.json.buffers[0].byteLength = this.bytes.length;
    return glbOf(this.json, Uint8Array.from(this.bytes));
  }
}

/** A GLB of that JSON and those bytes. */
export function glbOf(json, bytes) {
  const padded = (from, fill) => Buffer.concat([from, Buffer.alloc((4 - (from.length % 4)) % 4, fill)]);
  const chunk = (type, from) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(from.length, 0);
    head.writeUInt32LE(type, 4);
    return Buffer.concat([head, from]);
  };
  const chunks = [chunk(0x4e4f534a, padded(Buffer.from(JSON.stringify(json)), ' '))];
  if (bytes.length > 0) chunks.push(chunk(0x004e4942, padded(Buffer.from(bytes), 0)));
  const all = Buffer.concat(chunks), head = Buffer.alloc(12);
  head.write('glTF');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + all.length, 8);
  return Buffer.concat([head, all]);
}

const { fround } = Math;

// A number that the format can hold, about so large.
function held(c, { component, normalized }, size = 1) {
  const { most } = COMPONENTS[component];
  if (component === FLOAT) return fround(c.within(-size, size));
  const range = normalized ? most : Math.min(most, 1000);
  return component === 5120 || component === 5122 ? c.integer(-range, range) : c.integer(0, range);
}

// A direction in numbers that the format can hold, of length 1 nearly.
const direction = (c, format) => c.vector(3).map((n) =>
  format.component === FLOAT ? fround(n) : Math.round(n * COMPONENTS[format.component].most));

// So many lists of so many.
function elements(count, size, one) {
  return Array.from({ length: count }, () => Array.from({ length: size }, one));
}

function primitive(file, targets, skinned) {
  const { c } = file, count = c.integer(3, 40), quantized = c.maybe(0.4);
  const attribute = (type, list, format, more) => file.accessor(type, list, format, { attribute: true, ...more });
  const choose = (...formats) => c.pick(quantized ? formats.flat() : formats[0]);
  if (quantized) file.quantized = true;
  const places = choose(FLOATS, INTEGERS, UNITS, DIRECTIONS);
  const attributes = {
    POSITION: attribute('VEC3', elements(count, 3, () => held(c, places, 10)), places, { bounds: true }),
  };
  if (c.maybe(0.7)) {
    const format = choose(FLOATS, [DIRECTIONS[1]]);
    attributes.NORMAL = attribute('VEC3', Array.from({ length: count }, () => direction(c, format)), format);
  }
  for (const set of [0, 1])
    if (c.maybe(0.6) && (set === 0 || attributes.TEXCOORD_0 !== undefined)) {
      const format = choose([...FLOATS, ...UNITS], INTEGERS, DIRECTIONS);
      attributes[`TEXCOORD_${set}`] = attribute('VEC2', elements(count, 2, () => held(c, format, 3)), format);
    }
  if (skinned) addWeights(file, attributes, count);
  // three bends no points.
  const made = { attributes, mode: c.pick([targets > 0 || skinned ? 4 : 0, 4, 4, 4, 5, 6]) };
  const indexed = c.maybe(0.7) || (count % 3 !== 0 && made.mode === 4);
  if (made.mode !== 0 && indexed) made.indices = indices(file, made.mode, count);
  if (targets > 0)
    made.targets = Array.from({ length: targets }, () => ({
      POSITION: attribute('VEC3', elements(count, 3, () => held(c, FLOATS[0], 2)), FLOATS[0], { bounds: true }),
    }));
  return made;
}

function indices(file, mode, count) {
  const { c } = file, many = mode === 4 ? 3 * c.integer(1, 20) : c.integer(3, 30);
  const all = elements(many, 1, () => c.integer(0, count - 1));
  [[0], [1], [2]].forEach((corner, i) => (all[i] = corner));  // one triangle at least
  return file.accessor('SCALAR', all, { component: c.pick([5121, 5123, 5125]) });
}

const JOINTS = 4;

// All joints, for none may stand twice beside weights.
const rotated = (c, first = c.integer(0, JOINTS - 1)) => [0, 1, 2, 3].map((i) => (i + first) % JOINTS);

function addWeights(file, attributes, count) {
  const { c } = file;
  const joints = Array.from({ length: count }, () => rotated(c));
  attributes.JOINTS_0 = file.accessor('VEC4', joints, { component: c.pick([5121, 5123]) }, { attribute: true });
  attributes.WEIGHTS_0 = file.accessor('VEC4', elements(count, 4, () => c.within(0.1, 1)).map((weights) => {
    const sum = weights.reduce((a, b) => a + b);
    return weights.map((each) => fround(each / sum));
  }), { component: FLOAT }, { attribute: true });
}

const three = (one) => [one(), one(), one()];

// T R S, or the matrix of random axes.
function place(c, node) {
  if (c.maybe(0.3)) {
    node.matrix = matrixOf(three(() => c.within(-5, 5)), c.vector(4), three(() => c.within(0.3, 2)));
    return;
  }
  if (c.maybe(0.7)) node.translation = three(() => c.within(-5, 5));
  if (c.maybe(0.7)) node.rotation = c.vector(4);
  if (c.maybe(0.7)) node.scale = three(() => c.within(0.3, 2) * (c.maybe(0.3) ? -1 : 1));
}

function matrixOf(t, [x, y, z, w], s) {
  const rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]];
  const column = (k) => [...rows.map((row) => row[k] * s[k]), 0];
  return [...column(0), ...column(1), ...column(2), ...t, 1];
}

/** A file by chance: { json, bytes }, of which glbOf makes a GLB. */
export function randomGltf(seed) {
  const c = chance(seed), file = new File(c), { json } = file;
  const skinned = c.maybe(0.3), targets = c.maybe(0.4) ? c.integer(1, 3) : 0;
  const weights = () => elements(targets, 1, () => c.within(-1, 1)).flat();
  json.meshes = Array.from({ length: c.integer(1, 3) }, (_, i) => ({
    primitives: Array.from({ length: c.integer(1, 3) },
      () => primitive(file, i === 0 ? targets : 0, i === 0 && skinned)),
  }));
  json.nodes = Array.from({ length: c.integer(json.meshes.length, 12) }, () => ({}));
  json.nodes.forEach((node, i) => {
    place(c, node);
    const parent = i > 0 && c.maybe(0.7) ? json.nodes[c.integer(0, i - 1)] : null;
    if (parent) (parent.children ??= []).push(i);
    if (i < json.meshes.length) node.mesh = i;
    else if (c.maybe(0.4)) node.mesh = c.integer(0, json.meshes.length - 1);
    if (node.mesh === 0 && targets > 0 && c.maybe(0.7)) node.weights = weights();
  });
  if (targets > 0 && c.maybe(0.5)) json.meshes[0].weights = weights();
  if (skinned) addSkin(file);
  instance(file);
  const below = json.nodes.flatMap(({ children }) => children ?? []);
  json.scenes = [{ nodes: [...json.nodes.keys()].filter((i) => !below.includes(i)) }];
  json.scene = 0;
  if (file.quantized) json.extensionsUsed = [...(json.extensionsUsed ?? []), 'KHR_mesh_quantization'];
  if (file.quantized) json.extensionsRequired = ['KHR_mesh_quantization'];
  json.buffers[0].byteLength = file.bytes.length;
  return { json, bytes: Uint8Array.from(file.bytes) };
}

function addSkin(file) {
  const { c, json } = file, first = json.nodes.length;
  for (let i = 0; i < JOINTS; ++i) {
    json.nodes.push({});
    place(c, json.nodes[first + i]);
    if (i > 0) (json.nodes[first + c.integer(0, i - 1)].children ??= []).push(first + i);
  }
  const binds = Array.from({ length: JOINTS }, () =>
    matrixOf(three(() => c.within(-2, 2)), c.vector(4), [1, 1, 1]).map((n) => fround(n)));
  json.skins = [{
    joints: Array.from({ length: JOINTS }, (_, i) => first + i),
    inverseBindMatrices: file.accessor('MAT4', binds, { component: FLOAT }),
  }];
  for (const node of json.nodes) if (node.mesh === 0) node.skin = 0;
}

function instance(file) {
  const { c, json } = file;
  for (const node of json.nodes) {
    // three places nothing but triangles so, and bends none of them.
    if (!node.mesh || json.meshes[node.mesh].primitives.some(({ mode }) => mode === 0) || !c.maybe(0.5)) continue;
    const count = c.integer(1, 4), format = { component: FLOAT };
    const attributes = {
      TRANSLATION: file.accessor('VEC3', elements(count, 3, () => fround(c.within(-5, 5))), format),
      ROTATION: file.accessor('VEC4', Array.from({ length: count }, () => c.vector(4).map((n) => fround(n))), format),
      SCALE: file.accessor('VEC3', elements(count, 3, () => fround(c.within(0.3, 2))), format),
    };
    node.extensions = { EXT_mesh_gpu_instancing: { attributes } };
    json.extensionsUsed = ['EXT_mesh_gpu_instancing'];
  }
}
