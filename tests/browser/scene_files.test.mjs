// Files dropped on the page or chosen: scenes, pictures drawn by Tia, and others.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { pictureOf, sceneStage, showsPicture, tellsFaults, textOf } from './scene_stage.mjs';

const { open } = sceneStage();
const SMOOTH = { threshold: 0.02 };
const SCENE = `{"title":"Mine",  "background": [0.1, 0.2, 0.3],
  "objects": [ {"type":"sphere", "center":[0,0,-9], "radius":2} ],
  "lights": [{"type":"point","position":[5,9,0]}]}`;

// Drags a file over the page and drops it on `at`.
async function drop(page, name, bytes, at = '#picture') {
  const transfer = await page.evaluateHandle(([file, base64]) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(base64), (it) => it.charCodeAt(0))], file));
    return data;
  }, [name, Buffer.from(bytes).toString('base64')]);
  await page.locator(at).dispatchEvent('dragenter', { dataTransfer: transfer });
  await page.locator(at).dispatchEvent('dragover', { dataTransfer: transfer });
  assert.ok(await page.locator('.drop-target').isVisible());
  await page.locator(at).dispatchEvent('drop', { dataTransfer: transfer });
  assert.ok(await page.locator('.drop-target').isHidden());
}

test('a scene dropped anywhere is drawn, its text as it was written', () =>
  open(async (page, tia) => {
    await page.locator('#frame[aria-busy=false]').waitFor();
    await drop(page, 'mine.json', SCENE);
    await page.waitForFunction((text) => document.getElementById('scene-text').value === text, SCENE);
    assert.equal(await page.locator('#tab-scene').getAttribute('aria-selected'), 'true');
    await showsPicture(page, tia, { scene: JSON.parse(SCENE), ...SMOOTH });
    await page.locator('#scene-undo').click();
    assert.match(await textOf(page), /Two balls/);
    await showsPicture(page, tia, { scene: 'thesis', ...SMOOTH });
  }, { tab: false }));

test('a scene chosen by its button is the same, dropped on the text too', () =>
  open(async (page, tia) => {
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Open a file' }).click();
    await (await chooser).setFiles({ name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(SCENE) });
    await page.waitForFunction((text) => document.getElementById('scene-text').value === text, SCENE);
    await showsPicture(page, tia, { scene: JSON.parse(SCENE), ...SMOOTH });
    const other = SCENE.replace('"radius":2', '"radius":1');
    await drop(page, 'other.json', other, '#scene-text');
    await showsPicture(page, tia, { scene: JSON.parse(other), ...SMOOTH });
  }));

test('a picture drawn by Tia becomes the request that drew it', () =>
  open(async (page, tia) => {
    await page.locator('#frame[aria-busy=false]').waitFor();
    const request = 'scene=whitted&light=-3,8,2&width=320&height=200&threshold=0.05';
    await drop(page, 'tia.png', await tia.get(`/render?${request}`));
    await showsPicture(page, tia, { scene: 'whitted', light: [-3, 8, 2], width: 320, height: 200, threshold: 0.05 });
    await page.waitForFunction(() => /hitted/.test(document.getElementById('scene-text').value));
  }, { tab: false }));

test('a broken scene comes into the text with its fault; the picture stays', () =>
  open(async (page) => {
    const shown = await pictureOf(page);
    await drop(page, 'broken.json', SCENE.replace('"Mine",', '"Mine"'));
    await tellsFaults(page, [[1, 18]]);
    assert.equal(await pictureOf(page), shown);
  }));

const refused = {
  'notes.txt': ['Hello', 'is neither a scene'],
  'list.json': ['[1, 2]', 'is neither a scene'],
  'empty.json': ['', 'is neither a scene'],
  'cut.png': [Buffer.from('89504e470d0a1a0a0000', 'hex'), 'does not tell its scene'],
  'half.png': [Buffer.from('89504e470d0a1a0a00ffffff4948445200000000000000', 'hex'), 'cannot be read'],
  'other.png': [Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTw3lgAAAABJRU5ErkJggg==', 'base64'), 'does not tell its scene'],
  'photo.jpg': [Buffer.from('ffd8ffe000104a464946', 'hex'), 'is neither a scene'],
};

test('other files are refused in words and change nothing', () =>
  open(async (page) => {
    const text = await textOf(page);
    for (const [name, [bytes, words]] of Object.entries(refused)) {
      await drop(page, name, bytes);
      await page.locator('#scene-file-said').filter({ hasText: name }).filter({ hasText: words }).waitFor();
      assert.equal(await textOf(page), text);
    }
    await drop(page, 'thesis.json', readFileSync(new URL('../../web/scenes/thesis.json', import.meta.url)));
    await page.waitForFunction(() => document.getElementById('scene-file-said').textContent === '');
  }));

test('leaving the page with the file takes the target away', () =>
  open(async (page) => {
    const transfer = await page.evaluateHandle(() => {
      const data = new DataTransfer();
      data.items.add(new File(['{}'], 'a.json'));
      return data;
    });
    for (const name of ['dragenter', 'dragenter', 'dragleave']) await page.locator('#picture').dispatchEvent(name, { dataTransfer: transfer });
    assert.ok(await page.locator('.drop-target').isVisible());
    await page.locator('#picture').dispatchEvent('dragleave', { dataTransfer: transfer });
    assert.ok(await page.locator('.drop-target').isHidden());
  }));
