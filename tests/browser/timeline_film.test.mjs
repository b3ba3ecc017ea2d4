// A film saved from the timeline: the server's own, as it comes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lab, saved } from './lab.mjs';

const on = lab();
const SCENE = { camera: { location: [0, 1, 6], look_at: [0, 0, 0] }, lights: [{ type: 'point', position: [3, 5, 4] }],
  objects: [{ name: 'ball', type: 'sphere', center: [0, 0, 0], radius: 1 }],
  animation: { duration: 2, fps: 4, tracks: [{ target: '/objects/ball/center', keys: [[0, [-1, 0, 0]], [2, [1, 0, 0]]] }] } };
const SMALL = { at: `/?scene=${encodeURIComponent(JSON.stringify(SCENE))}&width=160&height=120`, panel: 'timeline' };

const save = (page) => page.getByRole('button', { name: 'Save', exact: true });

async function openFilm(page, format) {
  await page.getByText('Save as a film').click();
  await page.locator('.film option[value=zip]').waitFor({ state: 'attached' });
  await page.getByRole('combobox', { name: 'Format' }).selectOption(format);
}

for (const [format, ending] of [['apng', 'png'], ['zip', 'zip']]) {
  test(`saved as ${format}, it is the server\u2019s film at the size asked for, byte for byte`, () =>
    on.open(async (page) => {
      await openFilm(page, format);
      await page.getByRole('combobox', { name: 'Size' }).selectOption('80 \u00d7 60');
      const { name, bytes } = await saved(page, 'Save');
      assert.equal(name, `tia-scene-film.${ending}`);
      await page.getByText(/^Saved: [\d.]+ KB\.$/).waitFor();
      const asked = { scene: SCENE, width: 80, height: 60, threshold: 0.02, format };
      const film = await fetch(`${on.tia.base}/film`, { method: 'POST', body: JSON.stringify(asked) });
      assert.equal(film.status, 200);
      assert.ok(bytes.equals(Buffer.from(await film.arrayBuffer())));
      assert.equal(await page.locator('.film-going progress').getAttribute('value'), '8');
    }, SMALL));
}

test('every format that this server gives can be chosen, live pictures aside: MP4 only where it has ffmpeg', () =>
  on.open(async (page) => {
    await openFilm(page, 'zip');
    const { components } = JSON.parse(await on.tia.get('/openapi.json'));
    const known = components.schemas.film_request.properties.format.enum;
    assert.ok(known.includes('mp4'));
    const offered = known.filter((one) => one !== 'mjpeg' && one !== 'mp4');
    assert.deepEqual(await page.locator('.film select').first().locator('option').evaluateAll((all) => all.map((it) => it.value)), offered);
  }, SMALL));

test('cancelled, nothing is saved, and the server hears it', () =>
  on.open(async (page) => {
    let left = () => {};
    const gone = new Promise((resolve) => (left = resolve));
    page.on('requestfailed', (one) => one.url().includes('/film') && left(one.failure().errorText));
    await page.route(/\/film(\?|$)/, () => {}); // no answer comes
    await openFilm(page, 'apng');
    await save(page).click();
    await page.keyboard.press('Enter'); // Cancel has the focus
    await page.getByText('Cancelled: nothing was saved.').waitFor();
    assert.match(await gone, /ABORTED/);
    assert.ok(await save(page).evaluate((it) => it === document.activeElement));
  }, SMALL));

test('what was cut short is not called a film', () =>
  on.open(async (page) => {
    await page.route(/\/film(\?|$)/, (route) => route.abort('connectionreset'));
    await openFilm(page, 'apng');
    await save(page).click();
    await page.getByText('The server cannot be reached').waitFor();
    assert.equal(await page.locator('.film .told').textContent(), '');
  }, { ...SMALL, failing: true }));
