// What can be wrong with a glTF's views, accessors, indices and nodes: one change by chance.

// Numbers that are no good in many a place.
const WRONG = [-1, 0, 1, 2, 3, 5, 7, 1.5, 255, 256, 300, 65536, 1e6, 2 ** 31, 2 ** 32, 2 ** 53, '1', null, true,
  [], {}];

const KEYS = {
  bufferViews: ['buffer', 'byteOffset', 'byteLength', 'byteStride', 'target'],
  accessors: ['bufferView', 'byteOffset', 'componentType', 'normalized', 'count', 'type'],
  nodes: ['children', 'mesh', 'skin', 'matrix', 'translation', 'rotation', 'scale', 'weights'],
  scenes: ['nodes'],
};
const LENGTHS = { matrix: 16, translation: 3, rotation: 4, scale: 3 };
const TYPES = ['SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4', 'VEC5'];

function wrongValue(c, key, json) {
  const node = () => c.integer(0, json.nodes.length + (c.maybe(0.2) ? 1 : -1));
  if (key === 'type' && c.maybe(0.8)) return c.pick(TYPES);
  if (key === 'componentType' && c.maybe(0.8)) return c.integer(5119, 5127);
  if (['children', 'nodes'].includes(key) && c.maybe(0.8)) return Array.from({ length: c.integer(1, 3) }, node);
  if (key in LENGTHS && c.maybe(0.6))
    return Array.from({ length: LENGTHS[key] + c.integer(-1, 0) }, () => c.integer(-1, 1));
  return c.pick(WRONG);
}

function changeList(c, json) {
  const list = c.pick(Object.keys(KEYS)), object = c.pick(json[list]), key = c.pick(KEYS[list]);
  if (c.maybe(0.2)) delete object[key];
  else if (typeof object[key] === 'number' && c.maybe(0.5)) object[key] += c.pick([-8, -4, -2, -1, 1, 2, 4, 8, 16]);
  else object[key] = wrongValue(c, key, json);
}

function changeSparse(c, json) {
  const all = json.accessors.filter(({ sparse }) => sparse);
  if (all.length === 0) return changeList(c, json);
  const { sparse } = c.pick(all), object = c.pick([sparse, sparse.indices, sparse.values]);
  const key = c.pick(
    object === sparse ? ['count', 'indices', 'values'] : ['bufferView', 'byteOffset', 'componentType']);
  if (c.maybe(0.2)) delete object[key];
  else if (typeof object[key] === 'number' && c.maybe(0.5)) object[key] += c.pick([-1, 1, 2, 4]);
  else object[key] = wrongValue(c, key, json);
}

function changePrimitive(c, json) {
  const primitive = c.pick(c.pick(json.meshes).primitives);
  const object = c.maybe(0.5) ? primitive.attributes : primitive;
  const key = object === primitive ? c.pick(['indices', 'mode', 'attributes', 'targets']) : c.pick(Object.keys(object));
  if (c.maybe(0.8) && key !== 'mode') object[key] = c.integer(0, json.accessors.length);
  else object[key] = c.pick(WRONG);
}

// The bytes of an index of a primitive or of a sparse accessor.
function changeIndex(c, json, bytes) {
  const places = [];
  const add = ({ bufferView, byteOffset = 0 }) =>
    bufferView !== undefined && places.push((json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset);
  for (const mesh of json.meshes)
    for (const { indices } of mesh.primitives) if (indices !== undefined) add(json.accessors[indices]);
  for (const { sparse } of json.accessors) if (sparse) add(sparse.indices);
  if (places.length === 0) return changeList(c, json);
  const at = c.pick(places) + c.integer(0, 5);
  bytes[Math.min(at, bytes.length - 1)] = c.pick([0, 1, 40, 127, 254, 255]);
}

/** Changes one thing of a file. */
export function mutate(c, { json, bytes }) {
  c.pick([changeList, changeList, changeList, changeSparse, changePrimitive, changeIndex])(c, json, bytes);
}
