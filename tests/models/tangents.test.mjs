// Tangents of what has none are those of the reference, npm mikktspace, as a picture shows them: of
// a map that turns the normal into the tangent.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';

import { withFile } from './flat.mjs';
import { chance, glbOf } from './random_gltf.mjs';

const { generateTangents } = createRequire(import.meta.url)('mikktspace');
const NEAR = 1e-4;
const SIDE = 96;

// One pixel of red 255, green and blue 128: in tangent space (1, 1/255, 1/255).
const PNG = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP439AAAASBAgCFVE/wAAAAAElFTkSuQmCC';
const MAPPED = [1, 1 / 255, 1 / 255];

const dot = (a, b) => a.reduce((sum, each, i) => sum + each * b[i], 0);
const scale = (a, by) => a.map((each) => each * by);
const unit = (a) => scale(a, 1 / Math.hypot(...a));
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const mix = (vectors, weights) => vectors[0].map((_, k) => dot(vectors.map((each) => each[k]), weights));

/** A bent sheet in [-1, 1]²: { position, normal, uv } of each corner of its triangles; seams, mirrored ones too. */
function sheet(c, n) {
  const f32 = (list) => list.map(Math.fround);
  const inner = (i) => (i > 0 && i < n ? c.within(-0.3, 0.3) : 0);
  const grid = Array.from({ length: (n + 1) ** 2 }, (_, i) => {
    const [x, y] = [i % (n + 1), Math.floor(i / (n + 1))];
    const [u, v] = [Math.abs((2 * x) / n - 1) + c.within(-0.05, 0.05), y / n + c.within(-0.05, 0.05)];
    const place = [(2 * (x + inner(x))) / n - 1, (2 * (y + inner(y))) / n - 1, c.within(-0.2, 0.2)];
    return { position: f32(place), normal: f32(unit([c.within(-0.4, 0.4), c.within(-0.4, 0.4), 1])), uv: f32([u, v]) };
  });
  const corners = [];
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const i = y * (n + 1) + x;
      for (const triangle of [[i, i + 1, i + n + 2], [i, i + n + 2, i + n + 1]]) {
        const turn = c.maybe(0.2) ? c.within(-3, 3) : 0, [s, k] = [Math.sin(turn), Math.cos(turn)];
        for (const at of triangle) {
          const { position, normal, uv: [u, v] } = grid[at];
          corners.push({ position, normal, uv: f32([k * u - s * v, s * u + k * v]) });
        }
      }
    }
  return corners;
}

const listed = (corners, name) => Float32Array.from(corners.flatMap((each) => each[name]));

function sheetGlb(corners) {
  const lists = ['position', 'normal', 'uv'].map((name) => Buffer.from(listed(corners, name).buffer));
  const places = lists.map((_, i) => Buffer.concat(lists.slice(0, i)).length);
  return glbOf({
    asset: { version: '2.0' },
    buffers: [{ byteLength: Buffer.concat(lists).length }],
    bufferViews: lists.map(({ length }, i) => ({ buffer: 0, byteOffset: places[i], byteLength: length })),
    accessors: ['VEC3', 'VEC3', 'VEC2'].map((type, i) =>
      ({ bufferView: i, componentType: 5126, count: corners.length, type })),
    images: [{ uri: `data:image/png;base64,${PNG}` }],
    textures: [{ source: 0 }],
    materials: [{ normalTexture: { index: 0 } }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, material: 0 }] }],
    cameras: [{ type: 'orthographic', orthographic: { xmag: 1, ymag: 1, znear: 0.1, zfar: 10 } }],
    nodes: [{ mesh: 0 }, { camera: 0, translation: [0, 0, 5] }],
    scenes: [{ nodes: [0, 1] }],
  }, Buffer.concat(lists));
}

// The normals of a picture: a vector for each pixel, row by row from below, as PFM has them.
function normalsOf(glb) {
  const pfm = withFile(glb, (name, tia) => tia(['still', name, '--camera', '0', '--integrator', 'normal',
    '--format', 'pfm', '--background', '0,0,0', '--ground', 'none', '--samples', '1', '--width', String(SIDE),
    '--height', String(SIDE), '-o', '-']));
  const numbers = new Float32Array(Uint8Array.from(pfm.subarray(pfm.length - 12 * SIDE * SIDE)).buffer);
  return Array.from({ length: SIDE * SIDE }, (_, i) => [...numbers.subarray(3 * i, 3 * i + 3)]);
}

// The weights of a triangle's corners at (x, y), seen along z.
function weightsAt(x, y, [a, b, c]) {
  const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  const at = [x, y], all = area(a, b, c);
  return [area(at, b, c) / all, area(a, at, c) / all, area(a, b, at) / all];
}

test('tangents are those of mikktspace wherever a picture shows them', () => {
  for (const seed of [1, 2, 3]) {
    const corners = sheet(chance(seed), 7), seen = normalsOf(sheetGlb(corners));
    const given = generateTangents(...['position', 'normal', 'uv'].map((name) => listed(corners, name)));
    const tangents = corners.map((_, i) => [...given.subarray(4 * i, 4 * i + 4)]);
    let pixels = 0;
    for (let at = 0; at < seen.length; ++at) {
      const x = (2 * ((at % SIDE) + 0.5)) / SIDE - 1, y = (2 * (Math.floor(at / SIDE) + 0.5)) / SIDE - 1;
      for (let i = 0; i < corners.length; i += 3) {
        const three = corners.slice(i, i + 3), weights = weightsAt(x, y, three.map(({ position }) => position));
        if (Math.min(...weights) < 1e-3) continue;  // another triangle's, or too near to one
        const n = unit(mix(three.map(({ normal }) => normal), weights));
        const along = mix(tangents.slice(i, i + 3).map((each) => each.slice(0, 3)), weights);
        const t = unit(along.map((each, k) => each - n[k] * dot(along, n)));
        // The sign is of v upward, and files have it downward.
        const b = scale(cross(n, t), -tangents[i][3]);
        const expected = unit(mix([t, b, n], MAPPED));
        const off = Math.hypot(...expected.map((each, k) => each - seen[at][k]));
        assert.ok(off < NEAR, `seed ${seed} at ${x}, ${y}: ${seen[at]} instead of ${expected}`);
        ++pixels;
      }
    }
    assert.ok(pixels > 0.8 * seen.length, `${pixels} pixels`);
  }
});
