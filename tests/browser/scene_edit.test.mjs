// The scene's text in the page: what is typed is drawn, what is wrong is told at its place, and
// nothing that was written is lost.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asItCame, openScene, pictureOf, sceneStage, showsPicture, tellsFaults, textOf, type } from './scene_stage.mjs';

const on = sceneStage();
const { open } = on;
const shared = on.shared(asItCame);
const SMOOTH = { threshold: 0.02 };
const scene = async (page) => JSON.parse(await textOf(page));
const modified = (page) => page.getByText('Your own version of the scene.', { exact: false }).waitFor();

test('a typed radius gives the picture that the server draws of that scene, byte for byte', () =>
  shared(async (page, tia) => {
    const before = await scene(page);
    await type(page, '"radius": 4', '"radius": 2.5');
    await modified(page);
    const now = await scene(page);
    assert.equal(now.objects[0].radius, 2.5);
    assert.deepEqual({ ...now, objects: before.objects }, before);
    await showsPicture(page, tia, { scene: now, key: 'a', ...SMOOTH });
    await page.waitForURL(/radius%22:2\.5/);
  }));

test('light and camera stay where the hand has put them until the text moves them', () =>
  open(async (page, tia) => {
    await type(page, '"radius": 4', '"radius": 3');
    const light = { light: [5, 9, -8], camera: { fov_degrees: 40 }, ...SMOOTH };
    await showsPicture(page, tia, { scene: await scene(page), ...light });
    await type(page, '"look_at": [0, 0, -1]', '"look_at": [0, 0, -1], "fov_degrees": 30');
    await showsPicture(page, tia, { scene: await scene(page), light: light.light, ...SMOOTH });
  }, { path: `/?scene=thesis&light=5,9,-8&camera=${encodeURIComponent('{"fov_degrees":40}')}` }));

test('typing back what was there gives the gallery its scene and the address its name back', () =>
  shared(async (page) => {
    await type(page, '"radius": 4', '"radius": 3');
    await page.waitForURL(/radius/);
    await type(page, '"radius": 3', '"radius": 4');
    await page.waitForURL(/\?scene=thesis&key=a/);
    await page.getByText('The scene as it came.', { exact: false }).waitFor();
  }));

test('a wrong value is told on its line while the last good picture stays, also for the lamp', () =>
  shared(async (page, tia) => {
    await showsPicture(page, tia, { scene: 'thesis', key: 'a', ...SMOOTH });
    const shown = await pictureOf(page);
    await type(page, '"radius": 4', '"radius": -4');
    await tellsFaults(page, [[12, 17]]);
    await page.getByText('got -4; allowed: a number above 0', { exact: false }).waitFor();
    assert.equal(await pictureOf(page), shown);
    assert.equal(await page.locator('#scene-text').getAttribute('aria-invalid'), 'true');
    assert.equal(await page.locator('.code-wrong').innerText(), '12');
    assert.equal(await page.locator('.tok-bad').innerText(), '-4');
    await page.locator('#hand').focus();
    await page.keyboard.press('d');
    await showsPicture(page, tia, { scene: 'thesis', key: 'd', ...SMOOTH });
    await page.getByRole('button', { name: 'Line 12, column 17' }).click();
    await page.keyboard.type('2');
    await tellsFaults(page, []);
    assert.equal((await scene(page)).objects[0].radius, 2);
    assert.equal(await page.locator('#scene-text').getAttribute('aria-invalid'), 'false');
    await showsPicture(page, tia, { scene: await scene(page), key: 'd', ...SMOOTH });
  }));

test('unknown names and values are mended by their buttons; what is missing is told at what lacks it', () =>
  shared(async (page, tia) => {
    const before = await scene(page);
    await type(page, '"material": "white"', '"material": "whit"');
    await type(page, '"radius": 10000', '"radus": 10000');
    await tellsFaults(page, [[13, 19], [15, 5], [19, 7]]);
    await page.getByText('radius is missing', { exact: false }).waitFor();
    await page.getByRole('button', { name: 'Use \u201cradius\u201d' }).click();
    await tellsFaults(page, [[13, 19]]);
    await page.getByRole('button', { name: 'Use \u201cwhite\u201d' }).click();
    await tellsFaults(page, []);
    assert.deepEqual(await scene(page), before);
    await showsPicture(page, tia, { scene: 'thesis', key: 'a', ...SMOOTH });
  }));

test('broken JSON is told without asking the server, at line and column', () =>
  shared(async (page) => {
    const asked = [];
    page.on('request', (request) => request.resourceType() !== 'image' // the gallery's thumbnails
      && /objects|ball/.test(request.url() + request.postData()) && asked.push(request.url()));
    await type(page, '"name": "ball",', '"name": "ball"');
    await tellsFaults(page, [[10, 7]]);
    await page.getByText('a comma is missing before this').waitFor();
    await page.locator('#hand').focus();
    const drawn = page.waitForResponse(/key=d/);
    await page.keyboard.press('d');
    await drawn;
    assert.deepEqual(asked, []);
  }));

test('undo and redo by keys and buttons, over typing and the form alike', () =>
  open(async (page, tia) => {
    const text = await textOf(page);
    await type(page, '"radius": 4', '"radius": 3');
    await modified(page);
    const typed = await textOf(page);
    await page.locator('[data-field=radius] .scene-number').fill('2');
    const formed = await textOf(page);
    assert.equal(formed, typed.replace('"radius": 3', '"radius": 2'));
    await page.locator('#scene-text').focus();
    await page.keyboard.press('Control+z');
    assert.equal(await textOf(page), typed);
    while (await page.locator('#scene-undo').isEnabled()) await page.locator('#scene-undo').click();
    assert.equal(await textOf(page), text);
    await showsPicture(page, tia, { scene: 'thesis', key: 'a', ...SMOOTH });
    await page.locator('#scene-text').focus();
    while (await page.locator('#scene-redo').isEnabled()) await page.keyboard.press('Control+Shift+Z');
    assert.equal(await textOf(page), formed);
    await showsPicture(page, tia, { scene: JSON.parse(formed), key: 'a', ...SMOOTH });
  }));

test('the text and its caret survive a reload, broken or whole; discarding gives the gallery\u2019s back', () =>
  open(async (page, tia) => {
    const text = await textOf(page);
    await type(page, '"radius": 4', '"radius": 3');
    await page.waitForURL(/radius/);
    await type(page, '"name": "floor",', '"name": floor,');
    await tellsFaults(page, [[16, 15]]);
    const caret = () => page.locator('#scene-text').evaluate((it) => [it.selectionStart, it.selectionEnd]);
    const [broken, place] = [await textOf(page), await caret()];
    await page.reload();
    await openScene(page);
    assert.equal(await textOf(page), broken);
    assert.deepEqual(await caret(), place);
    await tellsFaults(page, [[16, 15]]);
    await type(page, 'floor,', '"floor",');
    await tellsFaults(page, []);
    const mine = await textOf(page);
    await page.reload();
    await openScene(page);
    assert.equal(await textOf(page), mine);
    await showsPicture(page, tia, { scene: JSON.parse(mine), key: 'a', ...SMOOTH });
    await page.locator('#scene-discard').click();
    await page.waitForFunction((wanted) => document.getElementById('scene-text').value === wanted, text);
    await showsPicture(page, tia, { scene: 'thesis', key: 'a', ...SMOOTH });
    await page.waitForURL(/\?scene=thesis&key=a/);
    await page.reload();
    await openScene(page);
    assert.equal(await textOf(page), text);
  }));

test('a link to another scene is not overruled by what was written for this one', () =>
  open(async (page, tia) => {
    await type(page, '"radius": 4', '"radius": 3');
    await page.waitForURL(/radius/);
    await page.goto(`${tia.base}/?scene=whitted&width=64&height=48&samples=1&threshold=0`);
    await openScene(page);
    assert.match(await textOf(page), /hitted/);
  }));

test('Tab leaves the text, Enter keeps the indentation', () =>
  shared(async (page) => {
    await type(page, '"radius": 4,', '"radius": 4,\n"name": "ball",');
    assert.ok((await textOf(page)).includes('\n      "radius": 4,\n      "name": "ball",'));
    await page.keyboard.press('Tab');
    assert.notEqual(await page.evaluate(() => document.activeElement.id), 'scene-text');
  }));
