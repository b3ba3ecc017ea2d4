// Below a picture that clears up: how far it is, pausing, leaving, and the line between noisy and not.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, lab, rest, shownPixels } from './lab.mjs';
import { shows, until } from './page.mjs';

const on = lab();
const SMALL = 'scene=cornell-light&width=64&height=48';
const place = (page) => page.locator('#clearing');
const words = (page) => place(page).locator('p').first().innerText();
const aloud = (page) => place(page).locator('[role=status]').textContent();

// Streams whose parts the test sends: `streams` are { left, send(samples, last) }. A part is a picture of a
// few samples that is said to be of `samples`.
const byHand = () => {
  const plain = globalThis.fetch;
  globalThis.streams = [];
  globalThis.fetch = async (url, init) => {
    if (!String(url).includes('stream=multipart')) return plain(url, init);
    const stream = { left: false };
    let sink;
    const body = new ReadableStream({ start: (it) => (sink = it), cancel: () => (stream.left = true) });
    init.signal.addEventListener('abort', () => (stream.left = true, sink.error(init.signal.reason)));
    stream.send = async (samples, last) => {
      const few = String(url).replace(/samples=\d+&stream=multipart/, `samples=${Math.ceil(Math.log2(samples))}`);
      const png = new Uint8Array(await (await plain(few)).arrayBuffer());
      const head = `Content-Type: image/png\r\nContent-Length: ${png.length}\r\nTia-Rays: primary=${samples * 64 * 48}\r\n\r\n`;
      const text = new TextEncoder();
      for (const piece of [text.encode(stream.begun ? head : `--b\r\n${head}`), png, text.encode(`\r\n--b${last ? '--' : ''}\r\n`)])
        sink.enqueue(piece);
      stream.begun = true;
      if (last) sink.close();
    };
    globalThis.streams.push(stream);
    return new Response(body, { headers: { 'Content-Type': 'multipart/x-mixed-replace; boundary=b' } });
  };
};
const send = (page, ...part) => page.evaluate((it) => globalThis.streams.at(-1).send(...it), part);
const streams = (page) => page.evaluate(() => globalThis.streams.map(({ left }) => left));
const comes = (page, text) => until(async () => text.test(await words(page)), String(text));

test('how far it is stands in words, told aloud at a quarter and a half; a pause keeps the picture, a page that is left asks no more', () =>
  on.open(async (page) => {
    await until(async () => (await streams(page)).length === 1, 'a stream');
    for (const [samples, told] of [[64, ''], [128, ''], [1024, '1,024'], [1536, '1,024']]) {
      await send(page, samples);
      await comes(page, new RegExp(`^${samples.toLocaleString('en')} of 4,096 samples a pixel${samples > 64 ? ', noise about [\\d.]+ %' : ''}$`));
      if (told) await until(async () => (await aloud(page)).startsWith(told), `${told} told aloud`);
      else assert.equal(await aloud(page), '');
    }
    assert.deepEqual(await faults(page, '#clearing'), []);
    const before = await shownPixels(page, '#picture');
    await page.getByRole('button', { name: 'Pause' }).press('Enter');
    await rest(page);
    assert.deepEqual(await streams(page), [true]);
    assert.match(await aloud(page), /^1,536 of 4,096 samples a pixel, paused/);
    assert.match(page.url(), /samples=4096/);
    assert.deepEqual(await shownPixels(page, '#picture'), before);

    await page.getByRole('button', { name: 'Go on' }).press('Enter');
    await until(async () => (await streams(page)).length === 2, 'another stream');
    await send(page, 64);
    await send(page, 2048);
    await comes(page, /^2,048 of/); // and nothing coarser than what was there
    await page.evaluate(() => dispatchEvent(new Event('pagehide')));
    assert.deepEqual(await streams(page), [true, true]);
    await page.evaluate(() => dispatchEvent(new Event('pageshow')));
    await until(async () => (await streams(page)).length === 3, 'a stream for who comes back');
    await send(page, 4096, true);
    await rest(page);
    await comes(page, /^4,096 samples a pixel/);
    assert.equal(await page.getByRole('button', { name: 'Pause' }).getAttribute('aria-disabled'), 'true');
  }, { at: `/?${SMALL}&samples=4096`, init: byHand, ready: () => {} }));

test('the noise is taken off by a switch, and a line shows both without asking again', () =>
  on.open(async (page, { asked }) => {
    const noisy = await on.tia.get(`/render?${SMALL}&samples=8`);
    const line = place(page).getByRole('slider');
    assert.ok(await line.isHidden());
    await page.getByRole('switch', { name: 'Take the noise off' }).press('Space');
    await rest(page);
    await comes(page, /^8 samples a pixel, noise taken off$/);
    assert.ok(await shows(page, await on.tia.get(`/render?${SMALL}&samples=8&denoise=true`)));
    await until(() => page.url().includes('denoise=true'), 'the address of that');
    const many = asked.length;
    await line.press('End');
    assert.equal(await line.getAttribute('aria-valuetext'), 'noisy up to 100 % from the left');
    const left = await shownPixels(page, '#compare .half img');
    await line.press('ArrowLeft');
    assert.match(await page.locator('#compare .half').getAttribute('style'), /inset\(0px 1%/);
    assert.deepEqual(await faults(page, '#clearing'), []);
    await line.press('Home');
    assert.ok(await page.locator('#compare').isHidden());
    assert.equal(asked.length, many);
    await page.getByRole('switch').press('Space');
    await rest(page);
    assert.ok(await shows(page, noisy));
    assert.deepEqual(await shownPixels(page, '#picture'), left);
    assert.ok(await line.isHidden());
    await page.getByRole('button', { name: 'Start again' }).click();
    await page.locator('#tab-take').click();
    await page.locator('[name=integrator]').selectOption('whitted');
    await place(page).waitFor({ state: 'hidden' });
  }, { at: `/?${SMALL}&samples=8` }));

test('a link to a picture without noise has the noisy one at hand, too; nothing scrolls sideways', () =>
  on.open(async (page) => {
    await place(page).getByRole('slider').fill('50');
    assert.ok(await page.locator('#compare .half img').isVisible());
    assert.deepEqual(await faults(page), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }, { at: `/?${SMALL}&samples=8&denoise=true`, locale: 'vi-VN', colorScheme: 'dark', viewport: { width: 320, height: 800 } }));
