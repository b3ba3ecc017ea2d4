// Models that the tests make: a GLB of one triangle above another, cameras, variants, an animation.

import { crc32 } from './png.mjs';

/** A GLB: `parts` are put over the document. */
export function glbOf(parts = {}) {
  const corners = Float32Array.of(-1, 0, 0, 1, 0, 0, 0, 2, 0.5);
  const times = Float32Array.of(0, 2);
  const moves = Float32Array.of(0, 0, 0, 1, 0, 0);
  const binary = Buffer.concat([corners, times, moves].map(({ buffer }) => Buffer.from(buffer)));
  const document = {
    asset: { version: '2.0', generator: 'Tia tests' },
    scene: 0,
    scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0, name: 'Sail' }, { camera: 0, translation: [0, 1, 6], name: 'Eye' }],
    cameras: [{ name: 'Front', type: 'perspective', perspective: { yfov: 0.7, znear: 0.1 } }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0,
      extensions: { KHR_materials_variants: { mappings: [{ material: 1, variants: [0] }] } } }] }],
    materials: [{ name: 'red', doubleSided: true, pbrMetallicRoughness: { baseColorFactor: [0.8, 0.1, 0.1, 1], metallicFactor: 0 } },
      { name: 'blue', doubleSided: true, pbrMetallicRoughness: { baseColorFactor: [0.1, 0.1, 0.8, 1], metallicFactor: 0 } }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [-1, 0, 0], max: [1, 2, 0.5] },
      { bufferView: 1, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [2] },
      { bufferView: 2, componentType: 5126, count: 2, type: 'VEC3' }],
    bufferViews: [[0, 36], [36, 8], [44, 24]].map(([byteOffset, byteLength]) => ({ buffer: 0, byteOffset, byteLength })),
    buffers: [{ byteLength: binary.length }],
    animations: [{ name: 'Glide', samplers: [{ input: 1, output: 2 }], channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }] }],
    extensionsUsed: ['KHR_materials_variants', 'EXT_unheard_of'],
    extensions: { KHR_materials_variants: { variants: [{ name: 'blue one' }] } },
    ...parts,
  };
  const text = JSON.stringify(document);
  const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const chunk = (type, data) => Buffer.concat([words(data.length, type), data]);
  const body = Buffer.concat([chunk(0x4e4f534a, json), chunk(0x004e4942, binary)]);
  return Buffer.concat([words(0x46546c67, 2, 12 + body.length), body]);
}

function words(...all) {
  const bytes = Buffer.alloc(4 * all.length);
  all.forEach((word, i) => bytes.writeUInt32LE(word, 4 * i));
  return bytes;
}

/** A triangle as OBJ, with its material in a file beside it. */
export const OBJ = 'mtllib sail.mtl\nv -1 0 0\nv 1 0 0\nv 0 2 0\nusemtl red\nf 1 2 3\n';
export const MTL = 'newmtl red\nKd 0.8 0.1 0.1\n';

/** A ZIP of files, { path: bytes }, stored as they are. */
export function zipOf(files) {
  const entries = [];
  const directory = [];
  let offset = 0;
  for (const [path, bytes] of Object.entries(files)) {
    const [name, data] = [Buffer.from(path), Buffer.from(bytes)];
    const common = Buffer.alloc(26); // what stands in both headers
    common.writeUInt16LE(20, 0); // the version that can read it
    common.writeUInt32LE(crc32(data), 10);
    common.writeUInt32LE(data.length, 14);
    common.writeUInt32LE(data.length, 18);
    common.writeUInt16LE(name.length, 22);
    entries.push(words(0x04034b50), common, name, data);
    directory.push(words(0x02014b50), Buffer.alloc(2), common, Buffer.alloc(10), words(offset), name);
    offset += 30 + name.length + data.length;
  }
  const central = Buffer.concat(directory);
  const end = Buffer.alloc(18);
  for (const at of [4, 6]) end.writeUInt16LE(Object.keys(files).length, at);
  end.writeUInt32LE(central.length, 8);
  end.writeUInt32LE(offset, 12);
  return Buffer.concat([...entries, central, words(0x06054b50), end]);
}
