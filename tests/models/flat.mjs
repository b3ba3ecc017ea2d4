// A model as Tia's own reader has it: what `tia read-model` answers, taken apart as
// core/models/archive.h puts it together.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const BINARY = process.env.TIA ?? fileURLToPath(new URL('../../build/release/tia', import.meta.url));

const LIMITS = {
  triangles: 8388608, vertices: 2 ** 24, nodes: 65536, depth: 256, instances: 2 ** 20, polygon_corners: 4096,
  json_values: 1e6, texture_pixels: 2 ** 26, texture_side: 16384,
};
const [MEMORY_BYTES, CPU_S] = [2 ** 31, 20];

/** Runs tia with that input; gives standard output. */
export function tia(args, input) {
  const { status, signal, stdout, stderr, error } = spawnSync(BINARY, args, { input, maxBuffer: 2 ** 28 });
  if (status !== 0) throw error ?? new Error(`tia ${args.join(' ')} ended with ${status ?? signal}: ${stderr}`);
  return stdout;
}

/** What the reader makes of a file: { nodes, meshes } or { faults: [{ pointer, … }] }. */
export function readModel(file) {
  const head = { files: [{ path: 'a.glb', bytes: file.length }], main: 0, ...LIMITS };
  const request = Buffer.concat([Buffer.from(`${JSON.stringify(head)}\n`), file]);
  const answer = tia(['read-model', String(MEMORY_BYTES), String(CPU_S)], request);
  if (answer[0] === 'F'.charCodeAt()) return { faults: JSON.parse(answer.subarray(1)) };
  return modelIn(new Archive(answer.subarray(1)));
}

class Archive {
  constructor(bytes) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    this.at = 0;
  }

  number(size, name) {
    this.at += size;
    return this.view[`get${name}`](this.at - size, true);
  }

  u8 = () => this.number(1, 'Uint8');
  u32 = () => this.number(4, 'Uint32');
  u64 = () => Number(this.number(8, 'BigUint64'));
  f32 = () => this.number(4, 'Float32');
  f64 = () => this.number(8, 'Float64');
  times = (count, one) => Array.from({ length: count }, () => one());
  list = (one) => this.times(this.u64(), one);
  maybe = (one) => (this.u8() === 1 ? one() : null);
  text = () => String.fromCharCode(...this.list(this.u8));
}

function modelIn(archive) {
  const { u8, u32, f32, f64, list, maybe, text, times } = archive;
  archive.u64(); // the archive's length
  times(3, text); // format, generator, copyright
  u8(); // z_up
  const scenes = list(() => ({ name: text(), nodes: list(u32) }));
  const scene = u32();
  const placement = () => times(10, f64);
  const nodes = list(() => ({
    name: text(), children: list(u32), placement: placement(), matrix: maybe(() => times(16, f64)),
    mesh: maybe(u32), camera: maybe(u32), light: maybe(u32), skin: maybe(u32),
    weights: list(f64), instances: list(placement),
  }));
  const target = () => ({ positions: list(f32), normals: list(f32), tangents: list(f32) });
  const part = () => ({
    positions: list(f64), normals: list(f32), tangents: list(f32), uvs: [list(f64), list(f64)], colors: list(f32),
    joints: list(u32), weights: list(f32), targets: list(target), indices: list(u32), points: u8() === 1,
    material: maybe(u32), variants: list(() => [u32(), u32()]),
  });
  return { scenes, scene, nodes, meshes: list(() => ({ name: text(), parts: list(part), weights: list(f64) })) };
}

/** What use(name, tia) makes of a file of that name, which lives as long. */
export function withFile(file, use) {
  const folder = mkdtempSync(join(tmpdir(), 'tia-models-'));
  try {
    writeFileSync(join(folder, 'a.glb'), file);
    return use(join(folder, 'a.glb'), tia);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The box around what a file shows, as `tia model` tells it. */
export const modelBounds = (file) => withFile(file, (name) => JSON.parse(tia(['model', name])).bounds);
