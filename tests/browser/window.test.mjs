// A picture's window, the part that `crop` leaves of it, and pictures of any shape: what is seen,
// where the hand is in it, and what is asked about.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addressOf, rests, shows } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
const { look } = on;
const CROP = [280, 260, 440, 400]; // of 640x480: the ball's lower edge and the floor
const LINK = `/?scene=thesis&key=a&crop=${CROP}`;

// The place on the screen of a pixel of the whole picture.
async function placeOf(page, [x, y]) {
  const box = await page.locator('#hand').boundingBox();
  const [x0, y0, x1, y1] = CROP;
  return [box.x + ((x + 0.5 - x0) / (x1 - x0)) * box.width, box.y + ((y + 0.5 - y0) / (y1 - y0)) * box.height];
}

test('a link with a crop shows the server’s bytes of it, and stays that link', () =>
  look(async (page) => {
    assert.equal(new URLSearchParams(addressOf(page)).get('crop'), `${CROP}`);
    assert.ok(await shows(page, await on.tia.get(`/render${addressOf(page)}`)), addressOf(page));
    const size = await page.locator('#picture').evaluate((it) => [it.width, it.height]);
    assert.deepEqual(size, [160, 140]);
  }, { path: LINK }));

test('a click in the window asks about the pixel that is there', () =>
  look(async (page) => {
    for (const pixel of [[300, 270], [431, 391]]) {
      const [x, y] = pixel;
      await page.mouse.click(...await placeOf(page, pixel));
      await page.locator('#panel-why').getByText(`Pixel ${x}, ${y}`, { exact: true }).waitFor();
      await rests(page);
      const told = JSON.parse(await on.tia.get(`/explain?scene=thesis&key=a&x=${x}&y=${y}`));
      const light = told.tree.color.map((value) => value.toFixed(4)).join(', ');
      assert.ok((await page.locator('#panel-why').innerText()).includes(light), light);
      // The cross stands where the click was.
      const cross = await page.locator('#overlay .crosshair').boundingBox();
      const [left, top] = await placeOf(page, pixel);
      assert.ok(Math.hypot(cross.x + cross.width / 2 - left, cross.y + cross.height / 2 - top) < 3);
    }
  }, { path: LINK }));

test('while the lamp is dragged the window stays the same part, however small it is drawn', () =>
  look(async (page) => {
    const failed = [];
    page.on('response', (response) => response.status() >= 400 && failed.push(response.url()));
    const box = await page.locator('#hand').boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    for (let i = 1; i <= 10; ++i)
      await page.mouse.move(box.x + (0.5 + 0.02 * i) * box.width, box.y + 0.5 * box.height);
    await page.mouse.up();
    await page.waitForURL((url) => url.searchParams.has('light'));
    await rests(page);
    assert.deepEqual(failed, []);
    assert.equal(new URLSearchParams(addressOf(page)).get('crop'), `${CROP}`);
    assert.ok(await shows(page, await on.tia.get(`/render${addressOf(page)}`)), addressOf(page));
  }, { path: LINK }));

test('another size keeps the part', () =>
  look(async (page) => {
    await page.getByRole('tab', { name: 'Share' }).click();
    await page.getByLabel('Size').selectOption('1280x960');
    await page.waitForURL((url) => url.searchParams.get('width') === '1280');
    await rests(page);
    assert.equal(new URLSearchParams(addressOf(page)).get('crop'), `${CROP.map((at) => 2 * at)}`);
    assert.ok(await shows(page, await on.tia.get(`/render${addressOf(page)}`)), addressOf(page));
  }, { path: LINK }));

for (const [width, height] of [[900, 300], [200, 600]])
  test(`a picture of ${width} x ${height} is not stretched, and no higher than a usual one`, () =>
    look(async (page) => {
      const box = await page.locator('#picture').boundingBox();
      assert.ok(Math.abs(box.width / box.height / (width / height) - 1) < 0.01, JSON.stringify(box));
      const room = await page.locator('.view').boundingBox();
      assert.ok(box.height <= 0.76 * room.width && box.width <= room.width + 1, JSON.stringify(box));
      const ring = await page.locator('.ring').boundingBox();
      assert.ok(ring.width <= box.width + 1 && ring.x >= box.x - 1, 'the lamp’s ring is in it');
    }, { path: `/?scene=thesis&key=a&width=${width}&height=${height}` }));
