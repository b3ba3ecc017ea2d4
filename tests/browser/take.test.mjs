// Sharing: what is taken along is the picture, byte for byte.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { deflateRawSync } from 'node:zlib';
import { queryOf } from '../../web/state/request.js';
import { lab, light, rest, saved, shownPixels } from './lab.mjs';
import { until } from './page.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const textOf = (page, name) => page.locator(`.take-${name} pre`).textContent();
const fragment = (request) => `/#z=${deflateRawSync(queryOf(request)).toString('base64url')}`;

// A scene of at least `length` characters, with all that a shell could trip over.
async function sceneOf(length) {
  const scene = JSON.parse(await on.tia.get('/scenes/thesis'));
  const tricky = 'Ann\'s "two" balls: $HOME `id` \\ 100 % & \u00e4 \u2603; ';
  return { ...scene, title: 'Ann\'s "balls" & $PATH', description: tricky.repeat(Math.ceil(length / tricky.length)) };
}

const STATES = {
  'a short request': async () => '/?scene=thesis&key=d&max_depth=2&camera={"location":[0,2,1]}',
  'a link in the fragment, a GET': async () => fragment({ scene: await sceneOf(500), key: 'a' }),
  'a link in the fragment, a POST': async () => fragment({ scene: await sceneOf(6000), light: [-20, 20, -1e-7] }),
};

for (const [name, at] of Object.entries(STATES)) {
  test(`${name}: file, link and shell give the bytes that the page shows`, async () => {
    await on.open(async (page) => {
      const file = await saved(page, 'Save the picture');
      assert.match(file.name, /^tia-[\w-]+\.png$/);
      assert.deepEqual(await shownPixels(page, '#picture'), pixelsOf(file.bytes));

      const link = await textOf(page, 'link');
      await on.open(async (other) => {
        assert.deepEqual((await saved(other, 'Save the picture')).bytes, file.bytes);
        assert.equal(await textOf(other, 'link'), link);
      }, { at: link, panel: 'take' });

      assert.deepEqual(await runInShell(await textOf(page, 'shell')), file.bytes);

      const address = page.locator('.take-address pre');
      if (name.endsWith('POST')) assert.equal(await address.isVisible(), false);
      else assert.deepEqual(await on.tia.get((await address.textContent()).slice(on.tia.base.length)), file.bytes);
    }, { at: await at(), panel: 'take' });
  });
}

// The file that the line writes, where it runs; it has to be one line.
async function runInShell(line) {
  assert.ok(!line.includes('\n'));
  const folder = await mkdtemp(join(tmpdir(), 'tia-shell-'));
  try {
    await promisify(execFile)('sh', ['-c', line], { cwd: folder });
    const [name, ...others] = await readdir(folder);
    assert.deepEqual(others, []);
    return await readFile(join(folder, name));
  } finally {
    await rm(folder, { recursive: true });
  }
}

const copied = (page, text) =>
  until(async () => await page.evaluate(() => navigator.clipboard.readText()) === text, `a copy of ${text}`);

test('what is copied is what is shown, and the file comes from the server as it is', () =>
  on.open(async (page, { context, pictures }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    for (const name of ['link', 'address', 'shell']) {
      await page.locator(`.take-${name} button`).click();
      await page.getByText('Copied: http').or(page.getByText('Copied: curl')).waitFor({ state: 'attached' });
      const text = await textOf(page, name);
      await copied(page, text);
    }
    const asked = pictures.length;
    const { bytes } = await saved(page, 'Save the picture');
    assert.equal(pictures.length, asked, 'what is shown was asked for again');
    assert.deepEqual(bytes, await on.tia.get('/render?scene=thesis&key=a&threshold=0.02'));
  }, { panel: 'take' }));

test('the scene saved and copied draws the same pixels by itself', () =>
  on.open(async (page, { context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await light(page, 'w');
    await page.waitForFunction(() => document.querySelector('#seen').textContent !== '');
    const { name, bytes } = await saved(page, 'Save the scene');
    assert.equal(name, 'tia-thesis-w.json');
    const scene = JSON.parse(bytes);
    assert.deepEqual(scene.key_light.position, [0, 25, -35]);
    const body = JSON.stringify({ scene, threshold: 0.02 });
    const answer = await fetch(`${on.tia.base}/render`, { method: 'POST', body });
    assert.equal(answer.status, 200);
    const drawn = pixelsOf(Buffer.from(await answer.arrayBuffer()));
    assert.deepEqual(drawn, pixelsOf((await saved(page, 'Save the picture')).bytes));
    await page.getByRole('button', { name: 'Copy the scene' }).click();
    await copied(page, String(bytes));
  }, { panel: 'take' }));

test('a size is drawn, and the point that is asked about stays where it is', () =>
  on.open(async (page) => {
    await page.getByLabel('Size in pixels').selectOption('320x240');
    await page.waitForURL(/width=320&height=240/);
    const file = pixelsOf((await saved(page, 'Save the picture')).bytes);
    assert.deepEqual([file.width, file.height], [320, 240]);
    await page.getByLabel('Size in pixels').selectOption('1280x960');
    await page.waitForURL(/width=1280&height=960.*pixel=400,200/);
    await page.getByLabel('Size in pixels').selectOption('640x480');
    await page.waitForURL((url) => !url.search.includes('width') && url.search.endsWith('pixel=200,100'));
  }, { at: '/?scene=thesis&key=a&pixel=200,100', panel: 'take' }));

test('without smooth edges the picture has one ray a pixel, and its link says so', () =>
  on.open(async (page) => {
    const smooth = page.getByRole('checkbox', { name: /^Smooth edges/ });
    assert.ok(await smooth.isChecked());
    await smooth.uncheck();
    await rest(page);
    const { bytes } = await saved(page, 'Save the picture');
    assert.deepEqual(bytes, await on.tia.get('/render?scene=thesis&key=a'));
    await on.open(async (other) => {
      assert.equal(await other.getByRole('checkbox', { name: /^Smooth edges/ }).isChecked(), false);
      assert.deepEqual((await saved(other, 'Save the picture')).bytes, bytes);
      await other.getByRole('checkbox', { name: /^Smooth edges/ }).check();
      await rest(other);
      const smoothed = await on.tia.get('/render?key=a&threshold=0.02');
      assert.deepEqual((await saved(other, 'Save the picture')).bytes, smoothed);
    }, { at: await textOf(page, 'link'), panel: 'take' });
  }, { panel: 'take' }));

test('rays, noise, bounces, exposure, seed and method are asked for; what is out of range is not, and is said', () =>
  on.open(async (page, { asked }) => {
    const before = asked.length;
    const refused = async (label, value, words) => {
      await page.getByLabel(label).fill(value);
      await page.keyboard.press('Tab');
      await page.getByText(`${label}: ${words}`).waitFor();
    };
    await refused('Rays a pixel', '0', 'a whole number from 1 to 65536');
    await refused('Noise at most', '1.5', 'a number from 0 to 1');
    assert.equal(asked.length, before);
    await page.getByLabel('Way of drawing').selectOption('path');
    const values = { 'Rays a pixel': '40', 'Noise at most': '0.05', 'Bounces at most': '3', 'Exposure in stops': '-1.5', 'Random seed': '7' };
    for (const [label, value] of Object.entries(values)) await page.getByLabel(label).fill(value);
    await page.keyboard.press('Tab');
    const query = 'integrator=path&max_depth=3&seed=7&width=64&height=48&samples=40&noise=0.05&exposure=-1.5';
    await page.waitForURL((url) => url.search.endsWith(query));
    await rest(page);
    const { bytes } = await saved(page, 'Save the picture');
    assert.deepEqual(bytes, await on.tia.get(`/render?key=a&${query}`));
  }, { at: '/?scene=thesis&key=a&width=64&height=48', panel: 'take' }));

test('where nothing is filled in, the form shows what the server takes: the scene\'s number, or the method\'s own', () =>
  on.open(async (page) => {
    const shown = (label) => page.getByLabel(label).getAttribute('placeholder');
    const method = page.getByLabel('Way of drawing');
    for (const [name, rays, bounces] of [['thesis', '8', '5'], ['path', '64', '16'], ['', '8', '5']]) {
      await method.selectOption(name);
      await until(async () => (await shown('Rays a pixel')) === rays);
      assert.equal(await shown('Bounces at most'), bounces);
    }
  }, { at: '/?scene=cornell&width=64&height=48', panel: 'take' }));
