// Comparing: A beside now, what differs in numbers, and what lies behind a picture.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lab, light, saved, shownPixels } from './lab.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const get = async (query) => pixelsOf(await on.tia.get(`/render?${query}`));
const keep = (page) => page.getByRole('button', { name: 'Keep this picture as A' }).click();
const halfOf = (page) => page.locator('#compare .half').evaluate((it) => parseFloat(it.style.clipPath.split(' ')[1]));

test('A stays, whatever comes: it is the picture that was kept, and one goes back to it', () =>
  on.open(async (page) => {
    await keep(page);
    await page.locator('#compare .half img').waitFor();
    await light(page, 'd');
    assert.deepEqual(await shownPixels(page, '#compare .half img'), await get('key=a&threshold=0.02'));
    assert.deepEqual(await shownPixels(page, '#picture'), await get('key=d&threshold=0.02'));
    await page.getByText('Light to the left, at -20, 20, -10.').and(page.locator('.kept p')).waitFor();
    await page.getByRole('button', { name: 'Go back to A' }).click();
    await page.waitForURL(/key=a/);
    await page.getByRole('button', { name: 'Forget A' }).click();
    await page.locator('#compare').waitFor({ state: 'hidden' });
    assert.ok(await page.getByRole('radio', { name: 'A', exact: true }).isDisabled());
  }, { panel: 'compare' }));

test('the line goes where keys, a mouse and a finger put it', () =>
  on.open(async (page) => {
    await keep(page);
    const range = page.getByRole('slider', { name: 'Where the two meet' });
    await range.focus();
    await page.keyboard.press('End');
    assert.equal(await halfOf(page), 0);
    await page.keyboard.press('Home');
    assert.equal(await halfOf(page), 100);
    assert.equal(await range.getAttribute('aria-valuetext'), '0 % from the left');

    await page.locator('#frame').scrollIntoViewIfNeeded();
    const box = await page.locator('#frame').boundingBox();
    await page.mouse.move(box.x + 5, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2, { steps: 4 });
    await page.mouse.up();
    assert.ok(Math.abs(await halfOf(page) - 75) < 0.5, String(await halfOf(page)));
    assert.match(page.url(), /key=a/, 'the hand held the line, not the lamp');

    const touch = await page.context().newCDPSession(page);
    const finger = (type, share) => touch.send('Input.dispatchTouchEvent',
      { type, touchPoints: share ? [{ x: box.x + share * box.width, y: box.y + box.height / 2 }] : [] });
    await finger('touchStart', 0.25);
    for (const share of [0.3, 0.5, 0.8]) await finger('touchMove', share);
    await finger('touchEnd');
    assert.ok(Math.abs(await halfOf(page) - 20) < 0.5, String(await halfOf(page)));
    assert.ok(Math.abs(await range.inputValue() - 0.8) < 0.005);
  }, { panel: 'compare', hasTouch: true }));

test('what differs is told exactly, and drawn as many times brighter as is chosen', () =>
  on.open(async (page) => {
    await keep(page);
    await light(page, 'w');
    await page.getByLabel('only what differs').check();
    await page.locator('#compare canvas').waitFor();
    const [a, b] = [await get('key=a&threshold=0.02'), await get('key=w&threshold=0.02')];
    const by = Array.from(a.data, (value, i) => Math.abs(value - b.data[i]));
    const pixels = Array.from({ length: 640 * 480 }, (_, i) => Math.max(...by.slice(3 * i, 3 * i + 3)));
    const differing = pixels.filter((most) => most > 0).length;
    const words = (number) => number.toLocaleString('en', { maximumSignificantDigits: 3 });
    const mean = by.reduce((sum, one) => sum + one, 0) / by.length;
    assert.equal(await page.locator('#panel-compare .told').textContent(),
      `${differing.toLocaleString('en')} of 307,200 pixels differ (${words(differing / 3072)} %). `
      + `The largest difference is ${pixels.reduce((a, one) => Math.max(a, one))} of 255, the mean ${words(mean)}.`);
    for (const factor of [1, 4, 16]) {
      await page.getByLabel(`${factor}\u00d7`, { exact: true }).check();
      const wanted = Buffer.from(by.map((one) => Math.min(255, factor * one)));
      await page.waitForFunction(([at, value]) => {
        const canvas = document.querySelector('#compare canvas');
        return canvas.getContext('2d').getImageData(at % 640, Math.floor(at / 640), 1, 1).data[0] === value;
      }, [pixels.indexOf(3), wanted[3 * pixels.indexOf(3)]]);
      assert.deepEqual((await shownPixels(page, '#compare canvas')).data, wanted);
    }
    await light(page, 'a');
    await page.getByText('The two are the same in all 307,200 pixels.').waitFor();
  }, { panel: 'compare' }));

test('pictures of two sizes are not compared number by number, and that is said', () =>
  on.open(async (page) => {
    await keep(page);
    await page.locator('#tab-take').click();
    await page.getByLabel('Size in pixels').selectOption('320x240');
    await page.locator('#tab-compare').click();
    await page.getByText('A has 640 \u00d7 480 pixels, the picture now 320 \u00d7 240.').waitFor();
    await page.getByLabel('only what differs').check();
    assert.equal(await page.locator('#compare canvas').count(), 0);
    await page.getByText('A has 640 \u00d7 480 pixels').waitFor();
  }, { panel: 'compare' }));

const FEATURES = { directions: 'normal', distance: 'depth', 'bare colours': 'albedo', objects: 'object',
  shadows: 'shadow', work: 'cost' };

test('each image behind the picture is the server\u2019s own, said in a sentence, and follows the light', () =>
  on.open(async (page) => {
    const sentences = new Set();
    for (const [name, integrator] of Object.entries(FEATURES)) {
      await page.getByRole('radio', { name, exact: true }).check();
      await page.locator(`#compare .half img[alt="${name}"]`).waitFor();
      const wanted = await get(`key=a&integrator=${integrator}`);
      assert.deepEqual(await shownPixels(page, '#compare .half img'), wanted, integrator);
      sentences.add(await page.locator('#compare-about').textContent());
    }
    assert.equal(sentences.size, 6);
    await page.getByRole('radio', { name: 'shadows', exact: true }).check();
    await page.locator('#compare .half img[alt="shadows"]').waitFor();
    const asked = page.waitForResponse(/key=d&integrator=shadow$/);
    await light(page, 'd');
    const wanted = pixelsOf(await (await asked).body());
    await page.locator('#compare:not([data-stale])').waitFor();
    assert.deepEqual(await shownPixels(page, '#compare .half img'), wanted);
    assert.match(page.url(), /key=d&threshold=0.02$/, 'the page\u2019s own picture stays what it was');
    assert.deepEqual((await page.locator('#tab-take').click(), await saved(page, 'Save the picture')).bytes,
      await on.tia.get('/render?scene=thesis&key=d&threshold=0.02'));
  }, { panel: 'compare' }));

test('what is compared is let go: as many object URLs after ten rounds as after one', () =>
  on.open(async (page) => {
    const round = async () => {
      await keep(page);
      await page.locator('#compare .half img[alt="A"]').waitFor();
      await page.getByRole('radio', { name: 'distance', exact: true }).check();
      await page.locator('#compare .half img[alt="distance"]').waitFor();
      await page.getByRole('button', { name: 'Forget A' }).click();
      await page.locator('#compare').waitFor({ state: 'hidden' });
      return page.evaluate(() => globalThis.urls.size);
    };
    const after = await round();
    for (let i = 0; i < 9; ++i) assert.equal(await round(), after);
  }, { panel: 'compare', init: countUrls, at: '/?scene=thesis&key=a&width=160&height=120' }));

function countUrls() {
  globalThis.urls = new Set();
  const { createObjectURL, revokeObjectURL } = URL;
  URL.createObjectURL = (blob) => {
    const url = createObjectURL.call(URL, blob);
    globalThis.urls.add(url);
    return url;
  };
  URL.revokeObjectURL = (url) => (globalThis.urls.delete(url), revokeObjectURL.call(URL, url));
}
