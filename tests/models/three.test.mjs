// The same files as three's GLTFLoader has them.

import assert from 'node:assert/strict';
import test from 'node:test';
import { Box3, Matrix4, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

import { modelBounds, readModel } from './flat.mjs';
import { glbOf, randomGltf } from './random_gltf.mjs';

const FILES = 24;
const NEAR = 1e-6;

async function readByThree(glb) {
  const file = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.length), '');
  file.scene.updateMatrixWorld(true);
  return file;
}

// What each primitive of each mesh has become; behind them hangs what is below the mesh's node.
async function geometries({ parser }) {
  const meshes = await parser.getDependencies('mesh');
  return meshes.map((mesh, i) => (mesh.isGroup ? mesh.children : [mesh])
    .slice(0, parser.json.meshes[i].primitives.length).map(({ geometry }) => geometry));
}

// An attribute's numbers, of what is normalised in [-1, 1].
function numbers(attribute) {
  const get = ['getX', 'getY', 'getZ', 'getW'].slice(0, attribute.itemSize);
  return Array.from({ length: attribute.count }, (_, i) => get.map((name) => attribute[name](i))).flat();
}

function near(actual, expected, what, size = 1) {
  assert.equal(actual.length, expected.length, `${what}: how many`);
  const wrong = actual.findIndex((each, i) => !(Math.abs(each - expected[i]) <= NEAR * size));
  assert.ok(wrong < 0, `${what}: number ${wrong} is ${actual[wrong]} instead of ${expected[wrong]}`);
}

// Triangles from their least corner on, those of three corners: so that who begins where is the same.
function triangles(indices) {
  const all = [];
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const corners = [...indices.slice(i, i + 3)], least = corners.indexOf(Math.min(...corners));
    if (new Set(corners).size === 3) all.push([...corners.slice(least), ...corners.slice(0, least)]);
  }
  return all;
}

const LISTS = [['position', (part) => part.positions], ['normal', (part) => part.normals],
  ['uv', (part) => part.uvs[0]], ['uv1', (part) => part.uvs[1]]];

function samePart(part, { attributes, morphAttributes, index }, what) {
  for (const [name, list] of LISTS)
    if (attributes[name]) near(list(part), numbers(attributes[name]), `${what} ${name}`);
    else assert.equal(list(part).length, 0, `${what} ${name}`);
  (morphAttributes.position ?? []).forEach((each, i) =>
    near(part.targets[i].positions, numbers(each), `${what} target ${i}`));
  if (part.points) return;
  const all = index ? [...index.array] : [...Array(attributes.position.count).keys()];
  assert.deepEqual(triangles(part.indices), triangles(all), `${what} triangles`);
}

test('positions, normals, uvs, morph targets and triangles are those of three', async () => {
  for (let seed = 0; seed < FILES; ++seed) {
    const { json, bytes } = randomGltf(seed), glb = glbOf(json, bytes);
    const { meshes } = readModel(glb), expected = await geometries(await readByThree(glb));
    assert.equal(meshes.length, expected.length);
    meshes.forEach(({ parts }, m) => {
      assert.equal(parts.length, expected[m].length, `seed ${seed} mesh ${m}`);
      parts.forEach((part, p) => samePart(part, expected[m][p], `seed ${seed} mesh ${m} part ${p}`));
    });
  }
});

// Where all that is shown is: nodes, skins, weights and instances.
function boundsByThree(scene) {
  const box = new Box3(), at = new Vector3(), instance = new Matrix4();
  scene.traverse((object) => {
    for (let i = 0; i < (object.geometry?.attributes.position.count ?? 0); ++i)
      for (let k = 0; k < (object.isInstancedMesh ? object.count : 1); ++k) {
        if (object.isMesh) object.getVertexPosition(i, at);
        else at.fromBufferAttribute(object.geometry.attributes.position, i);
        if (object.isInstancedMesh) object.getMatrixAt(k, instance), at.applyMatrix4(instance);
        box.expandByPoint(at.applyMatrix4(object.matrixWorld));
      }
  });
  return { min: box.min.toArray(), max: box.max.toArray() };
}

test('what nodes, skins, morph weights and instances place is where three has it', async () => {
  for (let seed = 0; seed < FILES; ++seed) {
    const { json, bytes } = randomGltf(seed), glb = glbOf(json, bytes);
    const actual = modelBounds(glb), { min, max } = boundsByThree((await readByThree(glb)).scene);
    const size = Math.max(1, ...[...min, ...max].map(Math.abs));  // whose places are 32-bit floats
    near(actual.min, min, `seed ${seed} min`, size);
    near(actual.max, max, `seed ${seed} max`, size);
  }
});
