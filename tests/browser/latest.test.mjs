// Latest wins: what the page asks for, and what it shows meanwhile, when pictures come slowly.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { STATUS, pathOf, rests, shows, startAgain, told } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
const slowly = on.proxied;
const slowlyShared = on.sharedProxied(startAgain);

async function press(page, keys) {
  for (const key of keys) await page.keyboard.press(key);
}

const isSmooth = (path) => path.includes('threshold=0.02');
const keyOf = (path) => /key=(.)/.exec(path)?.[1] ?? '';

test('under a slow server one picture is under way, the newest wish follows, those between are dropped', () =>
  slowlyShared(async (page, proxy) => {
    const before = proxy.asked.length;
    proxy.hold();
    await press(page, ['d']);
    await proxy.arrived(before + 1);
    await press(page, ['s', 'Escape', 'a', 'w']);
    proxy.release();
    await told(page, STATUS.w);
    const keys = proxy.asked.slice(before).map(keyOf);
    assert.deepEqual([...new Set(keys)], ['d', 'w']);
    assert.equal(proxy.most, 1);
    assert.ok(await shows(page, await on.tia.get(pathOf('w'))));
  }));

test('a finer picture of what is wanted no more is not waited for', () =>
  slowlyShared(async (page, proxy) => {
    proxy.holdIf = (path) => isSmooth(path) && keyOf(path) === 'd';
    await press(page, ['d']);
    await proxy.held();
    await press(page, ['s']);
    await told(page, STATUS.s);
    assert.ok(await shows(page, await on.tia.get(pathOf('s'))));
  }));

// A finer picture that was given up may not have hung up yet when the next one is asked for.
test('a quick hand over a fast server has no pictures pile up, and ends on its last key', () =>
  slowlyShared(async (page, proxy) => {
    await press(page, [...'adsadsadsadsadsadsadsadsadsadsw']);
    await told(page, STATUS.w);
    assert.ok(proxy.most <= 2, `${proxy.most} under way`);
    assert.equal(proxy.asked.at(-1), pathOf('w'));
    assert.ok(await shows(page, await on.tia.get(pathOf('w'))));
  }));

test('a key held down is one wish', () =>
  slowlyShared(async (page, proxy) => {
    const before = proxy.asked.length;
    for (let i = 0; i < 30; ++i) await page.keyboard.down('d');
    await page.keyboard.up('d');
    await told(page, STATUS.d);
    const passes = proxy.asked.slice(before).length;
    assert.ok(passes >= 1 && passes <= 3, `${passes} passes`);
  }));

test('the old picture stays while the new one is on its way, and the wait is told', () =>
  slowlyShared(async (page, proxy) => {
    const before = proxy.asked.length;
    proxy.hold();
    await press(page, ['d']);
    await proxy.arrived(before + 1);
    await page.getByText('Rendering\u2026', { exact: true }).waitFor();
    assert.equal(await page.locator('#frame').getAttribute('aria-busy'), 'true');
    assert.ok(await shows(page, await on.tia.get(pathOf('a'))));
    proxy.release();
    await told(page, STATUS.d);
  }));

// Lets the test decide when a picture counts as decoded.
function holdDecoding() {
  const decode = globalThis.createImageBitmap;
  let gate = Promise.resolve();
  globalThis.holdDecoding = () => (gate = new Promise((open) => (globalThis.letDecode = open)));
  globalThis.createImageBitmap = async (...all) => {
    const image = await decode(...all);
    globalThis.decoding = true;
    await gate;
    return image;
  };
}

test('the old picture stays until the new one is decoded', () =>
  slowly(async (page) => {
    await page.evaluate(() => {
      globalThis.holdDecoding();
      globalThis.decoding = false;
    });
    await press(page, ['d']);
    await page.waitForFunction(() => globalThis.decoding);
    assert.ok(await shows(page, await on.tia.get(pathOf('a'))));
    await page.evaluate(() => globalThis.letDecode());
    await told(page, STATUS.d);
    assert.ok(await shows(page, await on.tia.get(pathOf('d'))));
  }, { init: holdDecoding }));

// Looks at the middle of the picture in every frame and counts those in which nothing is there.
function countBlankFrames() {
  globalThis.blank = 0;
  const look = () => {
    const picture = document.querySelector('#picture[aria-label]');
    const context = globalThis.started && picture?.getContext('2d');
    if (context && context.getImageData(picture.width / 2, picture.height / 2, 1, 1).data[3] !== 255) ++globalThis.blank;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

test('no frame is without a picture while keys are pressed', () =>
  slowly(async (page) => {
    await page.evaluate(() => (globalThis.started = true));
    for (const key of 'dsadws') {
      await press(page, [key]);
      await told(page, STATUS[key]);
    }
    assert.equal(await page.evaluate(() => globalThis.blank), 0);
  }, { init: countBlankFrames }));

// Keeps the object URLs and bitmaps that are made and not given back.
function watchMemory() {
  const { createObjectURL, revokeObjectURL } = URL;
  globalThis.alive = new Set();
  URL.createObjectURL = (blob) => {
    const url = createObjectURL.call(URL, blob);
    globalThis.alive.add(url);
    return url;
  };
  URL.revokeObjectURL = (url) => (globalThis.alive.delete(url), revokeObjectURL.call(URL, url));
  const { createImageBitmap } = globalThis;
  const { close } = ImageBitmap.prototype;
  globalThis.open = 0;
  globalThis.createImageBitmap = async (...all) => (++globalThis.open, createImageBitmap(...all));
  ImageBitmap.prototype.close = function () {
    --globalThis.open;
    close.call(this);
  };
}

// By the keyboard, over small pictures: they come faster, and each leaves as much behind as a large one.
test('a thousand moves of the lamp leave no object URL, no bitmap and no heap behind', async () =>
  on.look(async (page, { context }) => {
    const devtools = await context.newCDPSession(page);
    const heap = async () => {
      await devtools.send('HeapProfiler.collectGarbage');
      return (await devtools.send('Runtime.getHeapUsage')).usedSize;
    };
    const move = async (times) => {
      for (let i = 0; i < times; ++i)
        await page.keyboard.press(['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown'][Math.floor(i / 5) % 4]);
      await rests(page);
    };
    await move(100);
    const [before, urls] = [await heap(), await page.evaluate(() => globalThis.alive.size)];
    await move(1000);
    await page.locator('#frame[aria-busy=false]').waitFor();
    let grown;  // what is left behind stays; what V8 keeps of a load for a while does not
    for (let looks = 0; looks < 20 && (grown = (await heap()) - before) >= 1 << 20; ++looks)
      await page.waitForTimeout(500);
    assert.ok(grown < 1 << 20, `${grown} bytes more`);
    assert.equal(await page.evaluate(() => globalThis.alive.size), urls);
    await page.waitForFunction(() => globalThis.open === 0);
  }, { init: watchMemory, path: '/?scene=thesis&key=a&width=160&height=120' }));
