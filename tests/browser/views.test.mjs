// Other ways to see the picture: what lies over it is the server's picture of that way.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, lab, shownPixels } from './lab.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const SMALL = { at: '/?scene=thesis&key=a&width=160&height=120', panel: 'views' };
const choose = (page, words) => page.getByLabel(words, { exact: true }).check();

// What was asked for last, as an object.
function lastAsked(seen) {
  const url = new URL(seen.asked.at(-1).url());
  return Object.fromEntries([...url.searchParams].map(([name, text]) => [name, name === 'camera' ? JSON.parse(text) : text]));
}
const drawn = async (seen) => pixelsOf(await on.tia.get(new URL(seen.asked.at(-1).url()).pathname + new URL(seen.asked.at(-1).url()).search));

test('red and cyan: the two eyes meet in what the camera looks at', () =>
  on.open(async (page, seen) => {
    await choose(page, 'with red and cyan glasses');
    await page.locator('#compare > img').waitFor();
    const { camera: { display } } = lastAsked(seen);
    // The ball's middle, which is 20 from the eye.
    assert.ok(Math.abs(display.convergence / 20 - 1) < 1e-4, String(display.convergence));
    assert.deepEqual(await shownPixels(page, '#compare > img'), await drawn(seen));
    await choose(page, 'as it is');
    await page.locator('#compare').waitFor({ state: 'hidden' });
  }, SMALL));

test('from side to side: where the hand is says which of the views is seen', () =>
  on.open(async (page, seen) => {
    await choose(page, 'from side to side');
    await page.locator('#compare canvas').waitFor();
    const all = await drawn(seen);
    const viewAt = async (share) => {
      const box = await page.locator('#frame').boundingBox();
      await page.mouse.move(box.x + share * box.width, box.y + box.height / 2);
      return shownPixels(page, '#compare canvas');
    };
    for (const [share, view] of [[0.02, 0], [0.5, 4], [0.98, 8]]) {
      const { width, height, data } = await viewAt(share);
      assert.deepEqual([width, height], [all.width / 9, all.height]);
      for (let y = 0; y < height; y += 7) {
        const from = 3 * (y * all.width + view * width);
        assert.deepEqual(data.subarray(3 * y * width, 3 * (y + 1) * width), all.data.subarray(from, from + 3 * width));
      }
    }
    await page.getByRole('slider', { name: 'Where you stand' }).press('Home');
    assert.equal(await page.getByRole('slider').getAttribute('aria-valuetext'), 'View 1 of 9');
  }, SMALL));

test('looking around: an arrow turns the eye by five degrees, where it is', () =>
  on.open(async (page, seen) => {
    await choose(page, 'looking around');
    await page.locator('#compare .around img').waitFor();
    const before = lastAsked(seen).camera;
    await page.locator('#compare .around').press('ArrowRight');
    await page.getByText('5\u00b0 to the right, 0\u00b0 up.').waitFor();
    await page.waitForTimeout(300);
    const { camera } = lastAsked(seen);
    assert.deepEqual(camera.location, before.location);
    const dot = camera.direction.reduce((sum, value, i) => sum + value * before.direction[i], 0);
    assert.ok(Math.abs((Math.acos(dot) * 180) / Math.PI - 5) < 1e-6);
  }, SMALL));

test('for one gaze: sharp there, with a part of the rays, and beside the full picture at a line', () =>
  on.open(async (page) => {
    await choose(page, 'for one gaze');
    await page.getByText(/points are traced instead of 19,200 pixels: [\d.]+ %/).waitFor();
    const box = await page.locator('#frame').boundingBox();
    await page.mouse.move(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
    await page.waitForTimeout(500);
    const [seenThere, full] = [await shownPixels(page, '#compare .touched img'), pixelsOf(await on.tia.get('/render?scene=thesis&key=a&width=160&height=120'))];
    for (const dx of [-1, 0, 1]) {
      const at = 3 * (60 * 160 + 40 + dx);
      assert.deepEqual(seenThere.data.subarray(at, at + 3), full.data.subarray(at, at + 3));
    }
    await page.getByRole('button', { name: 'Beside the full picture' }).click();
    await page.locator('#compare .half img').waitFor();
    await page.getByRole('slider', { name: 'Where the two meet' }).press('End');
    assert.equal(await page.getByRole('slider').getAttribute('aria-valuetext'), '100 % from the left');
  }, SMALL));

test('a scene that has a display of its own is seen in every other way, and in the plans', () =>
  on.open(async (page) => {
    await page.locator('.map image[href]').nth(1).waitFor({ state: 'attached' });
    for (const words of ['for one gaze', 'looking around', 'all around at once', 'with red and cyan glasses']) {
      await choose(page, words);
      await page.locator(`#compare img[alt="${words}"]`).waitFor();
    }
  }, { ...SMALL, at: '/?scene=quilt&width=64&height=48' })); // nothing has failed to load

for (const locale of ['en-US', 'vi-VN']) {
  test(`axe finds nothing, whatever is chosen, ${locale}`, () =>
    on.open(async (page) => {
      for (const radio of await page.getByRole('radio').and(page.locator('[name=view-way]')).all()) {
        await radio.check();
        await page.waitForTimeout(150);
        assert.deepEqual(await faults(page), []);
      }
    }, { ...SMALL, locale }));
}

test('the gallery opens a scene for one gaze, with its rings', () =>
  on.open(async (page, seen) => {
    await page.getByRole('button', { name: 'Barth\u2019s sextic for one gaze' }).click();
    await page.locator('#compare .gaze-rings').waitFor();
    const { scene, gaze } = lastAsked(seen);
    assert.deepEqual([scene, gaze], ['barth', '80,60']);
    assert.ok(await page.getByLabel('for one gaze', { exact: true }).isChecked());
  }, { at: '/?scene=thesis&key=a&width=160&height=120' }));
