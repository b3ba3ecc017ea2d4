// What must not get lost, nor get in the way: work at a link, focus at a retry, the next picture
// after a bad one; and the pure parts behind it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { mergePatch } from '../../web/state/merge_patch.js';
import { History } from '../../web/state/scene_history.js';
import { ownersOf, readPfm } from '../../web/picture/feature_image.js';
import { finerOf, quickOf } from '../../web/picture/passes.js';
import { orbit, pan } from '../../web/space/eye.js';
import { project, viewOf } from '../../web/space/view.js';
import { STATUS, addressOf, rests, shows, told } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
const { look } = on;
const spheres = (radius) => JSON.stringify({
  objects: [{ type: 'sphere', center: [0, 0, -20], radius }], lights: [{ type: 'point', position: [4, 6, -3] }] });
const edited = (page) => page.evaluate(() => location.hash.startsWith('#z=') || location.search.includes('scene=%7B'));

async function typeScene(page, text) {
  await page.getByRole('tab', { name: 'Scene' }).click();
  await page.locator('#scene-text').fill(text);
  await page.waitForFunction(() => /^#z=|scene=%7B/.test(location.hash + location.search));
  await rests(page);
}

test('an answer that is no picture keeps none of the next ones away', () =>
  look(async (page) => {
    await page.route(/render\?.*key=d/, (route) => route.fulfill({ contentType: 'image/png', body: 'none' }));
    await page.keyboard.press('d');
    await page.locator('#problem').getByText('not a picture').waitFor();
    await page.keyboard.press('s');
    await told(page, STATUS.s);
    assert.equal(await page.locator('#problem').innerText(), '');
  }));

test('links within the page leave scene and address as they are', () =>
  look(async (page) => {
    await typeScene(page, spheres(2.25));
    const address = page.url();
    await page.getByRole('link', { name: 'Gallery' }).click();
    await page.waitForTimeout(300);
    assert.equal(page.url(), address);
    assert.ok(await page.evaluate(() => document.querySelector('#gallery').contains(document.activeElement)));
    assert.ok((await page.locator('#scene-text').inputValue()).includes('2.25'));
  }));

test('a retry by itself leaves the focus where one types', () =>
  look(async (page) => {
    let busy = true;
    await page.route(/\/render/, (route) => (busy
      ? route.fulfill({ status: 503, headers: { 'Retry-After': '1' }, body: '' }) : route.continue()));
    await page.keyboard.press('d');
    await page.locator('#retry').waitFor();
    await page.getByRole('tab', { name: 'Scene' }).click();
    await page.locator('#scene-text').focus();
    busy = false;
    await told(page, STATUS.d);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'scene-text');
  }, { failing: true }));

test('the form does not storm a server that does not answer', () =>
  look(async (page) => {
    let asked = 0;
    await page.route(/schema\/scene/, (route) => ((asked += 1), route.abort()));
    await page.getByRole('tab', { name: 'Scene' }).click();
    await page.waitForTimeout(1500);
    assert.ok(asked >= 1 && asked <= 2, `${asked} times`);
    await page.unroute(/schema\/scene/);
    await page.getByLabel('Radius').first().waitFor();
  }, { failing: true }));

test('a link with a question, opened: who stops asking has the smooth picture', () =>
  look(async (page) => {
    assert.equal(new URLSearchParams(addressOf(page)).get('threshold'), '0.02');
    await page.getByRole('button', { name: 'Stop asking' }).click();
    await page.waitForURL((url) => !url.searchParams.has('pixel'));
    await rests(page);
    assert.ok(await shows(page, await on.tia.get('/render?scene=thesis&key=a&threshold=0.02')));
  }, { path: '/?scene=thesis&key=a&threshold=0.02&pixel=320,240' }));

for (const [link, words] of [['?scene=thesis&key=a&fbclid=abc', 'fbclid'], ['#z=zZnRboIwbroken', 'damaged']])
  test(`a link with what is none of the page’s is told and shows the rest: ${words}`, () =>
    look(async (page) => {
      await told(page, STATUS.a);
      assert.ok((await page.locator('#problem').innerText()).includes(words));
    }, { path: `/${link}` }));

test('where there is no scene of that name the gallery is there, and starting again leads on', () =>
  look(async (page) => {
    await page.locator('#scenes button').first().waitFor();
    assert.ok(!(await page.locator('#problem').innerText()).includes('last picture'));
    await page.getByRole('button', { name: 'Start again' }).click();
    await told(page, STATUS.a);
  }, { path: '/?scene=nosuch', failing: true }));

test('a text with Windows’ line ends stays whole under the form’s sliders and typing', () =>
  look(async (page) => {
    const text = JSON.stringify(JSON.parse(spheres(2)), null, 2).replaceAll('\n', '\r\n');
    await page.getByRole('tab', { name: 'Scene' }).click();
    await page.locator('#scene-file ~ input').setInputFiles(
      { name: 'ball.json', mimeType: 'application/json', buffer: Buffer.from(text) });
    await page.waitForFunction(() => /^#z=|scene=%7B/.test(location.hash + location.search));
    await page.getByLabel('Radius').first().fill('3');
    await rests(page);
    await page.locator('#scene-text').press('End');
    await page.keyboard.type(' ');
    const now = await page.locator('#scene-text').inputValue();
    assert.equal(JSON.parse(now).objects[0].radius, 3);
    assert.ok(await edited(page));
  }));

test('a light moved in the text counts after the hand has moved it', () =>
  look(async (page) => {
    await typeScene(page, spheres(2));
    await page.getByRole('tab', { name: 'Light' }).click();
    await page.locator('#hand').focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => /light=/.test(location.search + location.hash) || location.hash);
    await rests(page);
    await typeScene(page, spheres(2).replace('[4,6,-3]', '[-7,6,-3]'));
    await told(page, 'Light at -7, 6, -3.');
  }));

// ---- pure -----------------------------------------------------------------------------------

test('steps that join to nothing take no other step with them', () => {
  const history = new History();
  history.begin('5');
  for (const [text, now] of [['6', 0], ['5', 100], ['7', 200]]) history.record(text, 'slider', now);
  assert.equal(history.text, '7');
  history.undo();
  assert.equal(history.text, '5');
  assert.equal(history.canUndo, false);
});

test('the camera does not walk over the pole, and leaves it again', () => {
  let camera = { location: [0, 0, 10], look_at: [0, 0, 0] };
  for (let i = 0; i < 8; ++i) camera = { ...camera, ...orbit(camera, [0, 0, 0], 0, -0.7) };
  const [x, y, z] = camera.location;
  assert.ok(Math.abs(x) < 1e-9 && y > 9.9 && z > 0, `${camera.location}`);
  camera = { ...camera, ...orbit(camera, [0, 0, 0], 0, 0.7) };
  assert.ok(camera.location[1] < 8.5, `${camera.location}`);
});

test('a pan moves what one looks at by as many pixels as the hand, in every spelling', () => {
  const spellings = [
    { location: [0, 0, 10], look_at: [0, 0, 0], fov_degrees: 70 },
    { location: [0, 0, 10], direction: [0, 0, -2], up: [0, 1.5, 0], right: [2, 0, 0] },
    { location: [0, 0, 10], direction: [0, 0, -1], projection: 'orthographic', height: 7 },
    { location: [0, 0, 10], basis: { u: [1, 0, 0], v: [0, 1, 0], w: [0, 0, 1] }, distance: 2, pixel_size: 0.01 },
  ];
  for (const camera of spellings) {
    const view = viewOf(camera, 640, 480);
    const moved = viewOf({ ...camera, ...pan(camera, view, [0, 0, 0], -48 / 480, 24 / 480) }, 640, 480);
    const [before, after] = [project(view, [0, 0, 0]), project(moved, [0, 0, 0])];
    assert.ok(Math.hypot(after[0] - before[0] - 48, after[1] - before[1] - 24) < 1e-6, JSON.stringify([camera, before, after]));
  }
});

test('numbers of the object image: members of groups belong to their group', () => {
  const group = { type: 'group', children: [{ type: 'sphere' }, { type: 'group', children: [{ type: 'box' }, { type: 'csg', children: [{}, {}] }] }] };
  assert.deepEqual(ownersOf({ objects: [{ type: 'plane' }, group, { type: 'box' }] }), [0, 1, 1, 1, 2]);
});

test('numbers of the object image: walls are as many as the server lowers them to', async () => {
  // Two right angles, an oblique corner, a door at a corner, a window, a gate of full height.
  const walls = { type: 'walls', points: [[0, 0], [-4, 0], [-4, -5], [1, -5], [4, -8]], height: 3, thickness: 0.5,
    openings: [{ from: 12, to: 13, sill: 1, lintel: 2 }, { from: 4.25, to: 5.5, lintel: 2 }, { from: 1, to: 3 }] };
  const scene = { objects: [walls, { type: 'sphere', name: 'last', center: [0, 50, 0], radius: 1 }], lights: [],
    camera: { location: [0, 50, 9], look_at: [0, 50, 0] } };
  const answer = await fetch(`${on.tia.base}/render`, { method: 'POST',
    body: JSON.stringify({ scene, width: 1, height: 1, integrator: 'object', format: 'pfm' }) });
  const number = readPfm(await answer.arrayBuffer()).at(0, 0)[0];
  assert.deepEqual(ownersOf(scene), [...Array(number - 1).fill(0), 1]);
});

test('what a scene says of its sampling holds from the first picture on, known late or not', () => {
  const wish = { scene: 'creature' };
  const quick = quickOf(wish, undefined, { perPixel: 1e-9, way: 0 });
  assert.equal(quick, wish);
  assert.equal(finerOf(quick, wish, { samples: 8 }, true), null);
  assert.deepEqual(finerOf(quick, wish, {}, true), { scene: 'creature', threshold: 0.02 });
});

test('a merge patch as RFC 7396 has it', () => {
  const target = { a: 'b', c: { d: 'e', f: 'g' }, list: [1] };
  assert.deepEqual(mergePatch(target, { a: 'z', c: { f: null }, list: [2] }), { a: 'z', c: { d: 'e' }, list: [2] });
  assert.deepEqual(target.c, { d: 'e', f: 'g' });
  assert.equal(mergePatch(target, [1, 2, 3]), target);
});
