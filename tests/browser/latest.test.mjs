// Latest wins: what the page asks for, and what it shows meanwhile, when pictures come slowly.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { STATUS, shows, told } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
const slowly = on.proxied;

async function press(page, keys) {
  for (const key of keys) await page.keyboard.press(key);
}

test('under a slow server one picture is under way, the newest wish follows, those between are dropped', () =>
  slowly(async (page, proxy) => {
    proxy.hold();
    await press(page, ['a']);
    await proxy.arrived(2);
    await press(page, ['d', 's', 'Escape', 'w']);
    proxy.release();
    await told(page, STATUS.w);
    assert.deepEqual(proxy.asked, ['/render', '/render?key=a', '/render?key=w']);
    assert.equal(proxy.most, 1);
    assert.ok(await shows(page, await on.tia.get('/render?key=w')));
  }));

test('a quick hand over a fast server never has two pictures under way, and ends on its last key', () =>
  slowly(async (page, proxy) => {
    await press(page, [...'adsadsadsadsadsadsadsadsadsadsw']);
    await told(page, STATUS.w);
    assert.equal(proxy.most, 1);
    assert.equal(proxy.asked.at(-1), '/render?key=w');
    assert.ok(await shows(page, await on.tia.get('/render?key=w')));
  }));

test('a key held down asks once', () =>
  slowly(async (page, proxy) => {
    for (let i = 0; i < 30; ++i) await page.keyboard.down('a');
    await page.keyboard.up('a');
    await told(page, STATUS.a);
    await press(page, ['d']);
    await told(page, STATUS.d);
    assert.deepEqual(proxy.asked, ['/render', '/render?key=a', '/render?key=d']);
  }));

test('the old picture stays while the new one is on its way, and the wait is told', () =>
  slowly(async (page, proxy) => {
    await press(page, ['a']);
    await told(page, STATUS.a);
    proxy.hold();
    await press(page, ['d']);
    await proxy.arrived(3);
    await told(page, 'Rendering\u2026');
    assert.equal(await page.locator('#frame').getAttribute('aria-busy'), 'true');
    assert.ok(await shows(page, await on.tia.get('/render?key=a')));
    proxy.release();
    await told(page, STATUS.d);
    assert.equal(await page.locator('#frame').getAttribute('aria-busy'), 'false');
  }));

// Lets the test decide when a picture counts as decoded.
function holdDecoding() {
  const decode = HTMLImageElement.prototype.decode;
  let gate = Promise.resolve();
  globalThis.holdDecoding = () => (gate = new Promise((open) => (globalThis.letDecode = open)));
  HTMLImageElement.prototype.decode = async function () {
    await decode.call(this);
    globalThis.decoding = true;
    await gate;
  };
}

test('the old picture stays until the new one is decoded', () =>
  slowly(async (page) => {
    const unlit = await on.tia.get('/render');
    await page.evaluate(() => {
      globalThis.holdDecoding();
      globalThis.decoding = false;
    });
    await press(page, ['a']);
    await page.waitForFunction(() => globalThis.decoding);
    const source = await page.locator('#picture').getAttribute('src');
    assert.match(await page.locator('#picture').getAttribute('alt'), /Light off/);
    await page.evaluate(() => globalThis.letDecode());
    await told(page, STATUS.a);
    assert.notEqual(await page.locator('#picture').getAttribute('src'), source);
    assert.ok(!(await shows(page, unlit)));
    assert.ok(await shows(page, await on.tia.get('/render?key=a')));
  }, { init: holdDecoding }));

// Looks at the picture in every frame and counts those in which it is not there.
function countBlankFrames() {
  globalThis.blank = 0;
  const look = () => {
    const picture = document.querySelector('#picture');
    if (picture?.src && !(picture.complete && picture.naturalWidth)) ++globalThis.blank;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

test('no frame is without a picture while keys are pressed', () =>
  slowly(async (page) => {
    for (const key of 'adswadsw') {
      await press(page, [key]);
      await told(page, STATUS[key]);
    }
    assert.equal(await page.evaluate(() => globalThis.blank), 0);
  }, { init: countBlankFrames }));

// Keeps the object URLs that are made and not given back.
function watchObjectUrls() {
  const { createObjectURL, revokeObjectURL } = URL;
  globalThis.alive = new Set();
  URL.createObjectURL = (blob) => {
    const url = createObjectURL.call(URL, blob);
    globalThis.alive.add(url);
    return url;
  };
  URL.revokeObjectURL = (url) => (globalThis.alive.delete(url), revokeObjectURL.call(URL, url));
}

test('only the picture shown keeps its object URL', () =>
  slowly(async (page) => {
    for (const key of 'adswadswadsw') {
      await press(page, [key]);
      await told(page, STATUS[key]);
    }
    const alive = await page.evaluate(() => [...globalThis.alive]);
    assert.deepEqual(alive, [await page.locator('#picture').getAttribute('src')]);
  }, { init: watchObjectUrls }));
