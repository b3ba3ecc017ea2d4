// Numbers: what the page tells of a picture is what the server's headers say.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Pace, median, rateOf } from '../../web/picture/timing.js';
import { lab, light, rest } from './lab.mjs';

const on = lab();
const words = (number) => number.toLocaleString('en', { maximumSignificantDigits: number < 1000 ? 3 : 4 });
const told = (page, list, name) => page.locator(`#panel-numbers .${list} .${name} dd`).textContent();

// "a;dur=1, b;dur=2" and "a=1, b=2" as [name, number].
const entries = (header) => header.split(', ').map((entry) => /^(\w+).*=([\d.]+)$/.exec(entry))
  .map(([, name, value]) => [name, Number(value)]);

test('time, rays, bytes and size are those of the last answer', () =>
  on.open(async (page, { pictures }) => {
    await light(page, 's');
    const last = pictures.at(-1);
    const headers = await last.allHeaders();
    const bytes = await last.body();
    await page.locator('.whole .bytes dd').getByText(bytes.length.toLocaleString('en'), { exact: true }).waitFor();
    const phases = entries(headers['server-timing']);
    assert.deepEqual(phases.map(([name]) => name), ['queue', 'wait', 'parse', 'build', 'trace', 'encode']);
    for (const [name, ms] of phases) assert.equal(await told(page, 'phases', name), `${words(ms)} ms`);
    const sum = phases.reduce((total, [, ms]) => total + ms, 0);
    assert.equal(await page.locator('#panel-numbers .figure').first().textContent(), `${words(sum)} ms`);
    const rays = entries(headers['tia-rays']);
    for (const [name, count] of rays) assert.equal(await told(page, 'kinds', name), count.toLocaleString('en'));
    assert.equal(rays.find(([name]) => name === 'refraction')[1], 0);
    const all = rays.reduce((total, [, count]) => total + count, 0);
    assert.equal(await page.locator('#panel-numbers .figure').nth(1).textContent(), all.toLocaleString('en'));
    assert.equal(await told(page, 'whole', 'size'), '640 \u00d7 480');
    assert.equal(await told(page, 'whole', 'each'), words(all / (640 * 480)));
  }, { panel: 'numbers' }));

test('whose time it is is said: drawn now, from the server\u2019s cache, or this browser\u2019s own copy', async () => {
  const at = `/?scene=thesis&light=${Date.now() % 100_000},20,-10&threshold=0.02`;
  const source = (page) => page.locator('#panel-numbers .from');
  await on.open(async (page) => {
    await source(page).getByText('Drawn for this request.').waitFor();
    await page.reload();
    await source(page).getByText('This browser had it already').waitFor();
    assert.notEqual(await told(page, 'phases', 'trace'), '0 ms', 'the copy keeps the time of its drawing');
  }, { at, panel: 'numbers' });
  await on.open(async (page) => {
    await source(page).getByText('From the server\u2019s cache').waitFor();
    assert.equal(await told(page, 'phases', 'trace'), '0 ms');
    assert.notEqual(await told(page, 'kinds', 'primary'), '0');
  }, { at, panel: 'numbers' });
});

test('while a hand drags, the chart has a bar for every picture, and says how many come a second', () =>
  on.open(async (page, { pictures: begun, whole }) => {
    const box = await page.locator('#hand').boundingBox();
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 3);
    await page.mouse.down();
    for (let i = 0; i < 25; ++i) await page.mouse.move(box.x + box.width / 3 + 4 * i, box.y + box.height / 3 + i);
    await page.getByText(/^[\d.]+ pictures a second$/).waitFor();
    await page.mouse.up();
    await rest(page);
    const pictures = begun.filter((one) => whole.has(one.request()));
    const count = pictures.length;
    assert.ok(count > 3 && count <= 120, String(count));
    assert.equal(await page.locator('.chart rect').count(), count);
    const states = await Promise.all(pictures.map((one) => one.headerValue('cache-status')));
    const cached = states.filter((it) => it.includes('hit')).length;
    await page.getByText(`${count - cached} drawn`).and(page.locator('.legend .drawn')).waitFor();
    await page.getByText(`${cached} from a cache`).waitFor();
    assert.equal(await page.locator('.chart rect.cached').count(), cached);
    await page.getByRole('img', { name: `The last ${count} pictures: ` }).waitFor();
    await page.getByText('at rest', { exact: true }).waitFor();
  }, { panel: 'numbers' }));

test('a failure is a bar of its own', () =>
  on.open(async (page) => {
    await page.route('**/render?*light=*', (route) => route.abort());
    await page.getByLabel('x', { exact: true }).fill('3');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Try again' }).waitFor();
    await page.locator('#tab-numbers').click();
    await page.getByText('1 failed').waitFor();
    assert.equal(await page.locator('.chart rect.failed').count(), 1);
  }, { panel: 'light', failing: true }));

test('nothing is drawn while nobody looks', () =>
  on.open(async (page) => {
    await page.locator('#tab-light').click();
    await page.evaluate(() => {
      globalThis.changes = 0;
      const watcher = new MutationObserver((list) => (globalThis.changes += list.length));
      watcher.observe(document.getElementById('panel-numbers'),
        { subtree: true, childList: true, attributes: true, characterData: true });
    });
    await light(page, 'd');
    assert.equal(await page.evaluate(() => globalThis.changes), 0);
    await page.locator('#tab-numbers').click();
    await page.waitForFunction(() => globalThis.changes > 0);
  }, { panel: 'numbers' }));

test('pictures a second are the gaps of the last second; failures count for none', () => {
  const drawn = (...times) => times.map((at) => ({ at, kind: 'drawn' }));
  assert.equal(rateOf(drawn(0, 100, 200, 300), 300), 10);
  assert.equal(rateOf(drawn(0, 1500, 1550), 1600), 20);
  assert.equal(rateOf([...drawn(0, 500), { at: 510, kind: 'failed' }], 600), 2);
  assert.equal(rateOf(drawn(0), 0), null);
  assert.equal(rateOf(drawn(0, 100), 1200), null);
  assert.equal(median([5, 1, 3]), 3);
  assert.equal(median([4, 1, 3, 2]), 2.5);
});

test('the last 120 pictures are remembered, no more', () => {
  const pace = new Pace();
  for (let i = 0; i < 130; ++i) pace.add({ at: i, ms: i, kind: i % 10 ? 'drawn' : 'cached' });
  assert.deepEqual([pace.last.length, pace.last[0].at, pace.counts], [120, 10, { drawn: 108, cached: 12, failed: 0 }]);
});
