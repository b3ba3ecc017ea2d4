#!/usr/bin/env node
// How long models take to be read, beside other programs; what their reader takes of memory; and a
// still beside the same mesh. Rounds alternate; times are of the processor, users' and system's. Some
// minutes. What is not installed (assimp, libtinyobjloader-dev, tests/models/node_modules) is left out.

import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const TIA = process.env.TIA ?? join(ROOT, 'build/release/tia');
const ROUNDS = Number(process.argv[2] ?? 5);
const MAX_BYTES = 2 ** 28;
const TICKS = Number(execFileSync('getconf', ['CLK_TCK']));
const folder = mkdtempSync(join(tmpdir(), 'tia-bench-'));

/** A hilly sheet of 2 n² triangles. */
function sheet(n) {
  const positions = new Float32Array(3 * (n + 1) ** 2), indices = new Uint32Array(6 * n * n);
  for (let i = 0; i < positions.length / 3; ++i) {
    const [x, y] = [i % (n + 1), Math.floor(i / (n + 1))];
    positions.set([x / n, 0.1 * Math.sin(x / 9) * Math.cos(y / 7), y / n], 3 * i);
  }
  for (let k = 0; k < n * n; ++k) {
    const i = k + Math.floor(k / n), j = i + n + 1;
    indices.set([i, j, i + 1, i + 1, j, j + 1], 6 * k);
  }
  return { positions, indices };
}

/** A box of these chunks. */
function boxed(document, binary) {
  const json = Buffer.from(JSON.stringify(document));
  const text = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, ' ')]);
  const words = (...all) => Buffer.from(Uint32Array.from(all).buffer);
  return Buffer.concat([words(0x46546c67, 2, 28 + text.length + binary.length, text.length, 0x4e4f534a), text,
    words(binary.length, 0x004e4942), binary]);
}

/** A GLB of it, another one for each name; its matter is the format's own unless one is told. */
function glb({ positions, indices }, name, material) {
  return boxed({
    asset: { version: '2.0', generator: name },
    buffers: [{ byteLength: positions.byteLength + indices.byteLength }],
    bufferViews: [{ buffer: 0, byteLength: positions.byteLength },
      { buffer: 0, byteOffset: positions.byteLength, byteLength: indices.byteLength }],
    accessors: [{ bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3',
      min: [0, -0.1, 0], max: [1, 0.1, 1] },
    { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' }],
    materials: material && [material],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: material && 0 }] }],
    nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }],
  }, Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]));
}

/** A PNG of n x n pixels, waves in three colours around grey. */
function png(n) {
  const rows = Buffer.alloc(n * (3 * n + 1));
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x)
      for (let c = 0; c < 3; ++c)
        rows[y * (3 * n + 1) + 1 + 3 * x + c] = 128 + 60 * Math.sin(x / (5 + c)) * Math.cos(y / (7 - c));
  const part = (type, data) => {
    const named = Buffer.concat([Buffer.from(type), data]), ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(named), 4);
    return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
  };
  const head = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0]);
  head.writeUInt32BE(n, 0);
  head.writeUInt32BE(n, 4);
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), part('IHDR', head),
    part('IDAT', deflateSync(rows)), part('IEND', Buffer.alloc(0))]);
}
function crc32(bytes) {  // PNG, third edition, annex D
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let k = 0; k < 8; ++k) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** A GLB of it whose matter has every texture of glTF's core, or none. */
function painted({ positions, indices }, textured) {
  const uvs = new Float32Array(positions.length / 3 * 2);
  for (let i = 0; i < uvs.length / 2; ++i) uvs.set([positions[3 * i], positions[3 * i + 2]], 2 * i);
  const parts = [positions, uvs, indices].map((list) => Buffer.from(list.buffer));
  const pictures = textured ? [png(1024)] : [];
  const all = [...parts, ...pictures];
  const offset = (i) => all.slice(0, i).reduce((sum, each) => sum + each.length, 0);
  const use = (texture) => (textured ? texture : undefined);
  return boxed({
    asset: { version: '2.0' },
    buffers: [{ byteLength: offset(all.length) }],
    bufferViews: all.map((each, i) => ({ buffer: 0, byteOffset: offset(i), byteLength: each.length })),
    accessors: [[5126, positions.length / 3, 'VEC3'], [5126, uvs.length / 2, 'VEC2'], [5125, indices.length, 'SCALAR']]
      .map(([componentType, count, type], bufferView) => ({ bufferView, componentType, count, type,
        ...(bufferView === 0 && { min: [0, -0.1, 0], max: [1, 0.1, 1] }) })),
    images: use([{ bufferView: 3, mimeType: 'image/png' }]), textures: use([{ source: 0 }]),
    materials: [{ emissiveFactor: textured ? [0.1, 0.1, 0.1] : [0.05, 0.05, 0.05],
      pbrMetallicRoughness: { metallicFactor: 0.5, roughnessFactor: 0.8, baseColorTexture: use({ index: 0 }),
        metallicRoughnessTexture: use({ index: 0 }) },
      normalTexture: use({ index: 0 }), occlusionTexture: use({ index: 0 }), emissiveTexture: use({ index: 0 }) }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material: 0 }] }],
    nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }],
  }, Buffer.concat([...all, Buffer.alloc((4 - (offset(all.length) % 4)) % 4)]));
}

function obj({ positions, indices }, name) {
  const lines = [`# ${name}`];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${positions[i].toFixed(6)} ${positions[i + 1].toFixed(6)} ${positions[i + 2].toFixed(6)}`);
  for (let i = 0; i < indices.length; i += 3)
    lines.push(`f ${indices[i] + 1} ${indices[i + 1] + 1} ${indices[i + 2] + 1}`);
  return Buffer.from(`${lines.join('\n')}\n`);
}

class Server {
  static async start() {
    const server = new Server();
    server.child = spawn(TIA, ['serve', '--port', '0', '--max-model-bytes', MAX_BYTES, '--max-body-bytes', MAX_BYTES,
      '--max-models-bytes', 4 * MAX_BYTES, '--max-nodes', 1e6, '--deadline-ms', 120000].map(String),
    { stdio: ['ignore', 'pipe', 'ignore'] });
    const line = await new Promise((resolve) => server.child.stdout.once('data', (data) => resolve(String(data))));
    server.base = /http:\S+/.exec(line)[0];
    return server;
  }

  /** Seconds of processors that it and the processes that it has waited for have taken. */
  seconds() {
    const fields = readFileSync(`/proc/${this.child.pid}/stat`, 'utf8').split(') ')[1].split(' ');
    return fields.slice(11, 15).reduce((sum, each) => sum + Number(each), 0) / TICKS;
  }

  async took(path, options, status) {
    // Kept, a connection may have been closed by the time that others have taken their turns.
    const before = this.seconds();
    const answer = await fetch(this.base + path, { ...options, headers: { connection: 'close' } });
    const body = await answer.text();
    if (answer.status !== status) throw new Error(`${path}: ${answer.status} ${body.slice(0, 300)}`);
    return [this.seconds() - before, body];
  }

  upload = (body) => this.took('/models', { method: 'POST', body }, 201);
}

/** Seconds of processors of a command; none where it is not installed. */
function command(...words) {
  const timed = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$@" > /dev/null 2>&1', 'bash', ...words]);
  return timed.status === 0 ? String(timed.stderr).trim().split(' ').reduce((a, b) => a + Number(b), 0) : NaN;
}

const LOADER = 'tests/models/node_modules/three/examples/jsm/loaders/GLTFLoader.js';
// three's own time, without node's start.
const BY_THREE = `import { readFileSync } from 'node:fs';
import { GLTFLoader } from '${pathToFileURL(join(ROOT, LOADER))}';
const before = process.cpuUsage(), bytes = readFileSync(process.argv[1]);
await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
const { user, system } = process.cpuUsage(before);
console.log((user + system) / 1e6);`;
function three(file) {
  const { status, stdout } = spawnSync('node', ['--input-type=module', '--eval', BY_THREE, file]);
  return status === 0 ? Number(stdout) : NaN;
}

const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const told = (name, times) => console.log(`${name}: ${median(times).toFixed(3)} s`);

/** Medians of what takes turns. */
async function race(runs) {
  const times = Object.fromEntries(Object.keys(runs).map((name) => [name, []]));
  for (let round = 0; round < ROUNDS; ++round)
    for (const [name, run] of Object.entries(runs)) times[name].push(await run(round));
  for (const [name, all] of Object.entries(times)) told(name, all);
  return (a, b) => console.log(`  ${a} / ${b}: ${(median(times[a]) / median(times[b])).toFixed(2)}`);
}

async function readGlb(server, mesh) {
  const file = join(folder, 'a.glb');
  writeFileSync(file, glb(mesh, 'file'));
  const ratio = await race({
    'GLB, upload to 201': async (round) => (await server.upload(glb(mesh, `round ${round}`)))[0],
    'assimp info': () => command('assimp', 'info', file),
    "three's GLTFLoader": () => three(file),
  });
  ratio('GLB, upload to 201', 'assimp info');
  ratio('GLB, upload to 201', "three's GLTFLoader");
  return file;
}

// Reads a file; none where the library is not installed.
const BY_TINYOBJ = `#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
int main(int, char** argv) { return tinyobj::ObjReader().ParseFromFile(argv[1]) ? 0 : 1; }`;
function tinyobj() {
  const program = join(folder, 'tinyobj');
  const built = spawnSync('c++', ['-O3', '-DNDEBUG', '-x', 'c++', '-', '-o', program], { input: BY_TINYOBJ });
  return built.status === 0 ? program : null;
}

async function readObj(server, mesh) {
  const file = join(folder, 'a.obj'), peer = tinyobj();
  writeFileSync(file, obj(mesh, 'file'));
  const ratio = await race({
    'OBJ, upload to 201': async (round) => (await server.upload(obj(mesh, `round ${round}`)))[0],
    ...(peer && { tinyobjloader: () => command(peer, file) }),
  });
  if (peer) ratio('OBJ, upload to 201', 'tinyobjloader');
  return file;
}

// The same matter to a model and, as its nearest finish, to a mesh.
const MATT = { doubleSided: true, pbrMetallicRoughness: { baseColorFactor: [0.8, 0.8, 0.8, 1], metallicFactor: 0 } };
const AS_FINISH = { type: 'finish', color: [0.8, 0.8, 0.8], diffuse: 1, specular: 0.04, roughness: 1, ambient: 1 };

// The still's scene, and the same with the mesh itself in it.
async function stills(server, mesh) {
  const { id } = JSON.parse((await server.upload(glb(mesh, 'still', MATT)))[1]);
  const query = 'integrator=whitted&background=1,1,1&width=512&height=512';
  const scene = JSON.parse((await server.took(`/still?model=${id}&as=scene&${query}`, {}, 200))[1]);
  scene.objects[0] = { type: 'mesh', material: AS_FINISH, positions: [...mesh.positions],
    indices: [...mesh.indices] };
  const kept = JSON.parse((await server.took('/scenes', { method: 'POST', body: JSON.stringify(scene) }, 201))[1]).id;
  const seed = (round) => `&seed=${round + 1}`;  // each is drawn
  const ratio = await race({
    'still by id': async (round) => (await server.took(`/still?model=${id}&${query}${seed(round)}`, {}, 200))[0],
    'the same mesh': async (round) =>
      (await server.took(`/render?scene=${kept}&width=512&height=512${seed(round)}`, {}, 200))[0],
  });
  ratio('still by id', 'the same mesh');
}

// Stills of one shape with every texture of glTF's core and with none.
async function textures(server, mesh) {
  const ids = [];
  for (const textured of [true, false])
    ids.push(JSON.parse((await server.upload(painted(mesh, textured)))[1]).id);
  for (const light of ['integrator=whitted', 'integrator=path&samples=16']) {
    const drawn = (id) => async (round) => (await server.took(
      `/still?model=${id}&${light}&width=512&height=512&seed=${round + 1}`, {}, 200))[0];
    const [painted, plain] = ['with textures', 'without'].map((each) => `${light}, ${each}`);
    const ratio = await race({ [painted]: drawn(ids[0]), [plain]: drawn(ids[1]) });
    ratio(painted, plain);
  }
}

// The most memory that the reader has had, of what is no library's.
function memory(file) {
  const bytes = readFileSync(file).length, limits = { triangles: 2 ** 23, vertices: 3 * 2 ** 23, nodes: 65536,
    depth: 256, instances: 2 ** 20, polygon_corners: 4096, json_values: 1e6, texture_pixels: 2 ** 26,
    texture_side: 16384 };
  const request = join(folder, 'request');
  const head = JSON.stringify({ files: [{ path: file, bytes }], main: 0, ...limits });
  writeFileSync(request, Buffer.concat([Buffer.from(`${head}\n`), readFileSync(file)]));
  const { stderr } = spawnSync('bash', ['-c', '/usr/bin/time -f %M "$0" read-model 2147483648 20 < "$1" > /dev/null',
    TIA, request]);
  const most = Number(String(stderr).trim().split('\n').pop()) * 1024;
  const [held, came] = [most, bytes].map((each) => (each / 1e6).toFixed(1));
  console.log(`memory to read ${came} MB: ${held} MB, ${(most / bytes).toFixed(2)} x`);
}

const server = await Server.start();
try {
  const million = sheet(708);
  const files = [await readGlb(server, million), await readObj(server, million)];
  await stills(server, sheet(224));
  await textures(server, sheet(100));
  files.forEach(memory);
} finally {
  server.child.kill();
  rmSync(folder, { recursive: true });
}
