// Pictures that clear up: the parts of an answer, and a page that shows them while the last is drawn.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { partsOf } from '../../web/picture/stream.js';
import { lab, rest, shownPixels } from './lab.mjs';
import { shows, until } from './page.mjs';

const on = lab();

// An answer of two parts in pieces of `size` bytes; `left` tells whether its reader has gone.
function answer(size, bytes, seen = {}) {
  const text = `--b\r\nContent-Type: image/png\r\nContent-Length: 9\r\nTia-Rays: a=1, b=2\r\n\r\n--b\r\n\r\n\0\xff\r\n--b\r\n`
    + 'Content-Type: image/png\r\nContent-Length: 0\r\nETag: "a:b"\r\n\r\n\r\n--b--\r\n';
  const all = Buffer.from(text, 'latin1').subarray(0, bytes);
  let at = 0;
  const body = new ReadableStream({
    pull: (to) => (at < all.length ? to.enqueue(new Uint8Array(all.subarray(at, at += size))) : to.close()),
    cancel: () => (seen.left = true),
  });
  return { headers: new Headers({ 'Content-Type': 'multipart/x-mixed-replace; boundary=b' }), body, length: text.length };
}

test('an answer in parts is the same parts however its bytes come, and none where it is cut', async () => {
  const { length } = answer(1);
  for (const size of [1, 2, 3, 7, 50, length]) {
    const parts = [];
    for await (const part of partsOf(answer(size))) parts.push(part);
    assert.deepEqual(parts.map(({ last }) => last), [false, true]);
    assert.equal(parts[0].headers.get('Tia-Rays'), 'a=1, b=2');
    assert.equal(parts[1].headers.get('ETag'), '"a:b"');
    assert.equal(Buffer.from(await parts[0].blob.arrayBuffer()).toString('latin1'), '--b\r\n\r\n\0\xff');
    assert.equal(parts[1].blob.size, 0);
    assert.equal(parts[1].blob.type, 'image/png');
  }
  for (let bytes = 0; bytes < length; ++bytes) {
    let last = false;
    const read = async () => {
      for await (const part of partsOf(answer(5, bytes))) last ||= part.last;
    };
    await assert.rejects(read, TypeError);
    assert.equal(last, false);
  }
});

test('who reads no further part ends the answer', async () => {
  const seen = {};
  for await (const part of partsOf(answer(100, undefined, seen))) if (part) break;
  assert.equal(seen.left, true);
});

test('what clears up is drawn by chance, takes long, and has no end of its own', () =>
  on.open(async (page) => {
    const told = await page.evaluate(async () => {
      const { clearsUp, finerOf } = await import('/picture/passes.js');
      const wish = { integrator: 'path', width: 100, height: 100, samples: 100 };
      const pace = { perPixel: 0.0011, way: 0 }; // 1.1 s
      const others = [{}, { samples: 90 }, { integrator: 'whitted' }, { budget_ms: 1e4 }, { max_rays: 1e9 }];
      const next = (perPixel) => finerOf({ ...wish, samples: 1 }, wish, {}, true, { perPixel, way: 0 }).samples;
      return [...others.map((other) => clearsUp({ ...wish, ...other }, {}, pace)), next(0.0011), next(1e-6)];
    });
    assert.deepEqual(told, [true, false, false, false, false, 100, 6]);
  }));

const LONG = '/?scene=cornell-light&width=64&height=48&samples=1024';

test('a picture that takes long is seen to clear up, and ends as the plain one', () =>
  on.open(async (page, { asked }) => {
    const streams = () => asked.filter((request) => request.url().includes('stream=multipart'));
    await until(() => streams().length, 'a stream');
    const seen = new Set();
    await until(async () => {
      seen.add((await shownPixels(page, '#picture')).data.toString('base64'));
      return seen.size >= 3;
    }, 'three pictures');
    assert.equal(await page.locator('#frame').getAttribute('aria-busy'), 'true');
    await rest(page);
    assert.equal(streams().length, 1);
    assert.ok(await shows(page, await on.tia.get(LONG.replace('/', '/render'))));
    assert.ok(await page.locator('#panel-numbers .errors circle').count() > 2);

    // A new wish does not wait for it.
    await page.locator('#hand').focus();
    await page.keyboard.press('a');
    await until(() => streams().length === 2, 'another stream');
    const given = page.waitForEvent('requestfailed', (request) => request === streams()[1]);
    await page.keyboard.press('d');
    await given;
    await until(() => streams().length === 3, 'a third stream');
  }, { at: LONG, patience: 60_000, panel: 'numbers', ready: (page) => page.locator('#tab-numbers').click() }));

test('a hand that has rested sees it clear up at once, and may act meanwhile; one that goes on has quick pictures', () =>
  on.open(async (page, { asked }) => {
    const kinds = () => asked.map((request) => request.url())
      .map((url) => (url.includes('stream=') ? 'stream' : url.includes('width=8&height=6&') ? 'small' : 'quick'))
      .filter((kind) => kind !== 'small'); // tells the scene
    await page.locator('.lamp-mark').waitFor({ state: 'attached' });
    assert.equal(await page.locator('#frame').getAttribute('aria-busy'), 'true');
    assert.deepEqual(kinds(), ['stream']);
    await page.evaluate(() => ['d', 's'].forEach((key) =>
      document.getElementById('hand').dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }))));
    await until(() => kinds().length === 3, 'the picture of the last key');
    assert.deepEqual(kinds(), ['stream', 'quick', 'stream']);
    assert.ok(asked.filter((request) => !request.url().includes('key=a')).every((request) => request.url().includes('key=s')));
  }, { at: '/?scene=thesis&key=a&integrator=path&width=64&height=48&samples=16384', ready: () => {} }));
