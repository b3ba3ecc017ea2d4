// What gltf-validator calls an error in views, accessors, indices and nodes is refused, where the
// validator has it.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';

import { readModel } from './flat.mjs';
import { mutate } from './mutate.mjs';
import { chance, glbOf, randomGltf } from './random_gltf.mjs';

const { validateBytes } = createRequire(import.meta.url)('gltf-validator');
const FILES = 60;

// Errors that Tia passes over: it does not use what is declared of elements, makes directions and
// weights what they should be, and finds joints wherever they are.
const PASSED_OVER = new RegExp([/^ACCESSOR_(M(IN|AX)_MISMATCH|ELEMENT_OUT_OF_.*)$/, /_WITHOUT_BOUNDS$/,
  /^ACCESSOR_(VECTOR3_NON_UNIT|WEIGHTS_.*|JOINTS_.*)$/, /^(ROTATION_NON_UNIT|NODE_SKIN_NO_SCENE)$/]
  .map(({ source }) => source).join('|'));
// To the validator unknown words are no errors, but whatever uses them is.
const UNKNOWN_WORD = 'VALUE_NOT_IN_LIST';
const ERROR = 0;

// What is not there is told of its owner there, of its own place here.
const placeOf = ({ code, pointer, message }) =>
  (code === 'UNDEFINED_PROPERTY' ? `${pointer}/${message.split("'")[1]}` : pointer);

async function judge(glb) {
  const { issues } = await validateBytes(new Uint8Array(glb), { maxIssues: 0 });
  const errors = issues.messages.filter(({ severity, code }) => severity === ERROR && !PASSED_OVER.test(code));
  const words = issues.messages.filter(({ code }) => code === UNKNOWN_WORD);
  return { errors, places: new Set([...errors, ...words].map(placeOf)) };
}

test('files by chance are good to both', async () => {
  for (let seed = 0; seed < FILES / 3; ++seed) {
    const { json, bytes } = randomGltf(seed), glb = glbOf(json, bytes);
    assert.deepEqual((await judge(glb)).errors, []);
    assert.equal(readModel(glb).faults, undefined, `seed ${seed}`);
  }
});

test('what the validator calls an error is refused at the same pointer', async () => {
  let refused = 0;
  for (let seed = 0; seed < FILES; ++seed) {
    const file = randomGltf(seed % 50);
    mutate(chance(1000 + seed), file);
    const glb = glbOf(file.json, file.bytes), found = await judge(glb).catch(() => null);  // some break it
    if (!found || found.errors.length === 0) continue;
    const { faults } = readModel(glb), told = JSON.stringify(found.errors.slice(0, 3));
    assert.ok(faults, `seed ${seed} is taken: ${told}`);
    assert.ok(found.places.has(faults[0].pointer), `seed ${seed} at ${faults[0].pointer} instead: ${told}`);
    ++refused;
  }
  assert.ok(refused > FILES / 2, `${refused} files were wrong`);
});
