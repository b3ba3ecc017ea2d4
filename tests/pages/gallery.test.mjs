// The gallery's models are what their scripts in tests/gallery write, byte for byte, and small.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join, parse } from 'node:path';
import { test } from 'node:test';
import { ROOT } from './pages.mjs';

const MODELS = join(ROOT, 'web/models');
const files = readdirSync(MODELS).filter((name) => name !== 'README.md');

for (const file of files)
  test(`web/models/${file} is what its script writes`, () => {
    const script = join(ROOT, 'tests/gallery', `${parse(file).name}.py`);
    const written = spawnSync('python3', ['-B', script], { maxBuffer: 1 << 24 });
    assert.equal(written.stderr.toString(), '');
    assert.equal(Buffer.compare(written.stdout, readFileSync(join(MODELS, file))), 0);
  });

test('the models come to 1 MB at most, of each format that needs no other file', () => {
  const bytes = files.reduce((sum, file) => sum + readFileSync(join(MODELS, file)).length, 0);
  assert.ok(bytes <= 1_000_000, `${bytes} bytes`);
  assert.deepEqual([...new Set(files.map((file) => parse(file).ext))].sort(), ['.glb', '.ply', '.stl']);
});

test('Tia reads all of them without a warning', () => {
  const tia = process.env.TIA ?? join(ROOT, 'build/release/tia');
  for (const file of files) {
    const told = JSON.parse(spawnSync(tia, ['model', join(MODELS, file)], { encoding: 'utf8' }).stdout);
    assert.deepEqual(told.warnings, [], file);
  }
});
