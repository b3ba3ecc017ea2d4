// Pictures drawn large: they are the server's, go on without the page, and can be left.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, lab, saved } from './lab.mjs';

const on = lab();
const SMALL = { at: '/?scene=thesis&key=a&width=160&height=120', panel: 'jobs' };

async function begin(page, size, samples) {
  const panel = page.locator('#panel-jobs');
  await panel.getByLabel('Size in pixels').selectOption(size);
  await panel.getByLabel('Rays a pixel').selectOption(samples);
  await page.getByRole('button', { name: 'Draw it large' }).click();
}

test('the picture is the one of /render, piece by piece, and still there after a reload', () =>
  on.open(async (page) => {
    await begin(page, '320 \u00d7 240', '4');
    await page.getByText(/^Done\. (\d+) of \1 pieces\.$/).waitFor();
    const { name, bytes } = await saved(page, 'Save the picture');
    assert.equal(name, 'tia-thesis-a-320x240.png');
    assert.ok(bytes.equals(await on.tia.get('/render?scene=thesis&key=a&width=320&height=240&samples=4&threshold=0.02')));
    assert.equal(await page.locator('.job-card progress').evaluate((it) => it.value), 1);
    assert.ok(await page.locator('.job-map rect').count() > 0);
    assert.deepEqual(await faults(page), []);

    await page.reload();
    await page.locator('#tab-jobs').click();
    await page.getByText(/^Done\./).waitFor();
    await page.getByRole('button', { name: 'Remove it from the list' }).click();
    await page.locator('.job-card').waitFor({ state: 'detached' });
    await page.reload();
    await page.locator('#tab-jobs').click();
    await page.getByRole('button', { name: 'Draw it large' }).waitFor();
    assert.equal(await page.locator('.job-card').count(), 0);
  }, SMALL));

test('cancelled, it is drawn no further', () =>
  on.open(async (page) => {
    await begin(page, '1280 \u00d7 960', '1024');
    const coming = page.waitForRequest((one) => one.method() === 'DELETE');
    await page.getByRole('button', { name: 'Cancel' }).click();
    const { pathname } = new URL((await coming).url());
    await page.locator('.job-card').waitFor({ state: 'detached' });
    const { state } = await (await fetch(on.tia.base + pathname)).json();
    assert.equal(state, 'cancelled');
  }, SMALL));

test('a key goes with all that is asked for, stays in the tab, and is in no link', () =>
  on.open(async (page) => {
    await page.getByText('Key of this server').click();
    await page.getByLabel('Key', { exact: true }).fill('me.secret');
    await page.getByRole('button', { name: 'Use it' }).click();
    await page.getByText('The key goes with all').waitFor();
    const coming = page.waitForRequest((one) => new URL(one.url()).pathname === '/render');
    await page.locator('#hand').press('d');
    assert.equal((await (await coming).allHeaders()).authorization, 'Bearer me.secret');
    assert.doesNotMatch(page.url(), /secret/);
    await page.locator('#tab-take').click();
    assert.doesNotMatch(await page.locator('#panel-take').innerText(), /secret/);
    assert.equal(await page.evaluate(() => JSON.stringify(localStorage).includes('secret')), false);
    await page.locator('#tab-jobs').click();
    await page.getByRole('button', { name: 'Forget it' }).click();
    const bare = page.waitForRequest((one) => new URL(one.url()).pathname === '/render');
    await page.locator('#hand').press('s');
    assert.equal((await (await bare).allHeaders()).authorization, undefined);
  }, SMALL));
