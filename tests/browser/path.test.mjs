// The lamp on its way: frames from still requests, one animated PNG of them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { apngOf } from '../../web/picture/apng.js';
import { circlePath, curvePath } from '../../web/space/light_path.js';
import { lab, light, rest, saved, shownPixels } from './lab.mjs';
import { chunksOf, crc32, pixelsIn, pixelsOf } from './png.mjs';

const on = lab();
const SIZE = 'width=320&height=240'; // many are drawn and read
const SMALL = { at: `/?scene=thesis&key=a&${SIZE}`, panel: 'path' };
const button = (page, name) => page.getByRole('button', { name, exact: true });
const lightsOf = (requests) => requests.map((one) => new URL(one.url()).searchParams.get('light'))
  .filter(Boolean).map((text) => text.split(',').map(Number));

async function choose(page, frames, seconds) {
  await page.getByLabel('Pictures', { exact: true }).fill(String(frames));
  await page.getByLabel('Seconds', { exact: true }).fill(String(seconds));
  await page.keyboard.press('Tab');
}

test('played, the frames come one after the other along a circle and stay; the address does not move', () =>
  on.open(async (page, { asked }) => {
    const before = asked.length;
    const address = page.url();
    let [under, most] = [0, 0];
    page.on('request', (one) => one.url().includes('light=') && (most = Math.max(most, ++under)));
    page.on('response', (one) => one.url().includes('light=') && --under);
    await choose(page, 8, 1);
    await button(page, 'Play').click();
    await page.getByText('8 of 8 pictures are here.').waitFor();
    await page.locator('#compare img[alt="Picture 3 of 8"]').waitFor();
    await button(page, 'Pause').click();
    assert.equal(most, 1);
    const lights = lightsOf(asked.slice(before));
    assert.equal(lights.length, 8);
    assert.deepEqual(lights[0], [-20, 20, -10]);
    const pivot = [0, 0, -20]; // the middle of the ball, which the middle pixel shows all but exactly
    for (const [x, y, z] of lights) {
      assert.equal(y, 20);
      const radius = Math.hypot(x - pivot[0], z - pivot[2]);
      assert.ok(Math.abs(radius - Math.hypot(20, 10)) < 0.1, `${x} ${z}`);
    }
    const range = page.getByRole('slider', { name: 'Along the path' });
    await range.focus();
    await page.keyboard.press('Home');
    for (let i = 0; i < 8; ++i) {
      await page.locator(`#compare img[alt="Picture ${i + 1} of 8"]`).waitFor();
      const query = `scene=thesis&light=${lights[i].join()}&${SIZE}&threshold=0.02`;
      const still = pixelsOf(await on.tia.get(`/render?${query}`));
      assert.deepEqual(await shownPixels(page, '#compare img'), still);
      await page.keyboard.press('ArrowRight');
    }
    assert.equal(asked.length, before + 8, 'a frame was asked for twice');
    assert.equal(page.url(), address);
  }, SMALL));

test('a light that one likes on the way is used: the page is there, and its address says so', () =>
  on.open(async (page, { asked }) => {
    const before = asked.length;
    await choose(page, 8, 1);
    const range = page.getByRole('slider', { name: 'Along the path' });
    await range.focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    await page.locator('#compare img[alt="Picture 4 of 8"]').waitFor();
    const wanted = lightsOf(asked.slice(before))[3].join();
    await button(page, 'Use this light').click();
    await page.waitForURL((url) => url.searchParams.get('light') === wanted);
    await page.locator('#compare').waitFor({ state: 'hidden' });
    await rest(page);
    const still = pixelsOf(await on.tia.get(`/render?light=${wanted}&${SIZE}&threshold=0.02`));
    assert.deepEqual(await shownPixels(page, '#picture'), still);
  }, SMALL));

test('through places: a curve that meets them; without two there is none, and that is said', () =>
  on.open(async (page, { asked }) => {
    await page.getByLabel('through places of yours').check();
    await button(page, 'Add the lamp\u2019s place').click();
    await button(page, 'Play').click();
    await page.getByText('Add two places at least').waitFor();
    await light(page, 'w');
    await button(page, 'Add the lamp\u2019s place').click();
    await page.getByLabel('and back to the first').uncheck();
    await choose(page, 9, 1);
    const before = asked.length;
    await button(page, 'Play').click();
    await page.getByText('9 of 9 pictures are here.').waitFor();
    const lights = lightsOf(asked.slice(before));
    assert.deepEqual([lights[0], lights[8]], [[-20, 20, -10], [0, 25, -35]]);
    await button(page, 'Pause').click();
    await button(page, 'Remove place 1').click();
    await page.locator('#compare').waitFor({ state: 'hidden' });
    assert.equal(await page.locator('.places li').count(), 1);
  }, SMALL));

test('saved, it is an animated PNG of the server\u2019s own pixels, as they were packed', () =>
  on.open(async (page, { asked }) => {
    const before = asked.length;
    await choose(page, 8, 3);
    const { name, bytes } = await saved(page, 'Save as an animated picture');
    assert.equal(name, 'tia-thesis-a-path.png');
    const lights = lightsOf(asked.slice(before));
    const stills = await Promise.all(lights.map((at) =>
      on.tia.get(`/render?scene=thesis&light=${at.join()}&${SIZE}&threshold=0.02`)));
    assert.equal(stills.length, 8);
    holdAnimation(bytes, stills, 375);
    const text = ({ type }) => type === 'iTXt';
    assert.deepEqual(chunksOf(bytes).filter(text), chunksOf(stills[0]).filter(text), 'the recipe of the first');
    const told = await page.evaluate(decodeAll, bytes.toString('base64'));
    assert.deepEqual(told, { count: 8, durations: Array(8).fill(375_000), size: '320x240', plays: Infinity });
  }, SMALL));

// What the browser's own decoder makes of it.
async function decodeAll(base64) {
  const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const decoder = new ImageDecoder({ data, type: 'image/png' });
  await Promise.all([decoder.tracks.ready, decoder.completed]);
  const { frameCount, repetitionCount } = decoder.tracks.selectedTrack;
  const frames = await Promise.all(Array.from({ length: frameCount }, (_, i) => decoder.decode({ frameIndex: i })));
  const durations = frames.map(({ image }) => image.duration);
  const { codedWidth, codedHeight } = frames[0].image;
  frames.forEach(({ image }) => image.close());
  return { count: frameCount, durations, size: `${codedWidth}x${codedHeight}`, plays: repetitionCount };
}

// The PNG specification's rules for an animation whose first frame is the still picture.
function holdAnimation(apng, stills, ms) {
  const chunks = chunksOf(apng);
  const types = chunks.map(({ type }) => type);
  const numbered = chunks.filter(({ type }) => type === 'fcTL' || type === 'fdAT');
  assert.deepEqual(numbered.map(({ data }) => data.readUInt32BE(0)), numbered.map((_, i) => i), 'sequence numbers');
  assert.equal(types[0], 'IHDR');
  assert.ok(types.indexOf('acTL') < types.indexOf('fcTL') && types.indexOf('fcTL') < types.indexOf('IDAT'));
  assert.equal(types.filter((type) => type === 'acTL').length, 1);
  const control = chunks.find(({ type }) => type === 'acTL').data;
  assert.deepEqual([control.length, control.readUInt32BE(0), control.readUInt32BE(4)], [8, stills.length, 0]);

  const frames = [];
  for (const { type, data } of chunks) {
    if (type === 'fcTL') frames.push({ data, packed: [] });
    if (type === 'IDAT') frames.at(-1).packed.push(data);
    if (type === 'fdAT') frames.at(-1).packed.push(data.subarray(4));
  }
  assert.equal(frames.length, stills.length);
  for (const [i, { data, packed }] of frames.entries()) {
    const fields = [4, 8, 12, 16].map((at) => data.readUInt32BE(at));
    const still = pixelsOf(stills[i]);
    assert.deepEqual([data.length, ...fields], [26, still.width, still.height, 0, 0]);
    assert.equal(data.readUInt16BE(20) / data.readUInt16BE(22), ms / 1000);
    assert.deepEqual([data[24], data[25]], [0, 0], 'dispose and blend');
    assert.deepEqual(pixelsIn(chunks[0], Buffer.concat(packed)), still, `frame ${i}`);
  }
}

test('stills of several data chunks keep them; stills of different sizes make no animation', async () => {
  const [a, b] = await Promise.all(['a', 'd'].map((key) => on.tia.get(`/render?key=${key}&width=40&height=30`)));
  const [small] = [await on.tia.get('/render?width=20&height=30')];
  const made = async (...pngs) => Buffer.from(await apngOf(pngs, 100).arrayBuffer());
  holdAnimation(await made(a, b, a), [a, b, a], 100);
  const split = splitData(b);
  assert.equal(chunksOf(split).filter(({ type }) => type === 'IDAT').length, 2);
  holdAnimation(await made(split, split), [split, split], 100);
  await assert.rejects(() => made(a, small), /different kinds/);
});

// The same PNG with its packed pixels in two chunks.
function splitData(png) {
  const parts = chunksOf(png).flatMap(({ type, data }) => (type !== 'IDAT' ? [{ type, data }]
    : [data.subarray(0, 100), data.subarray(100)].map((piece) => ({ type, data: piece }))));
  return Buffer.concat([png.subarray(0, 8), ...parts.map(({ type, data }) => chunkOf(type, data))]);
}

function chunkOf(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  body.copy(whole, 4);
  whole.writeUInt32BE(crc32(body), body.length + 4);
  return whole;
}

test('another camera makes another film; the frames of the old one are let go', () =>
  on.open(async (page, { asked }) => {
    await choose(page, 8, 1);
    await button(page, 'Play').click();
    await page.getByText('8 of 8 pictures are here.').waitFor();
    await page.getByRole('radio', { name: 'Camera' }).click();
    await page.locator('#hand').focus();
    await page.keyboard.press('ArrowLeft');
    await page.locator('#compare').waitFor({ state: 'hidden' });
    await page.waitForURL(/camera=/);
    const before = asked.length;
    await button(page, 'Play').click();
    await page.getByText('8 of 8 pictures are here.').waitFor();
    const frames = asked.slice(before).filter((one) => one.url().includes('light='));
    assert.ok(frames.length === 8 && frames.every((one) => one.url().includes('camera=')));
  }, SMALL));

test('a circle keeps height and distance; a curve meets its places, evenly in between', () => {
  const circle = circlePath([1, 2, 3], [4, 9, 7], 12);
  for (const [x, y, z] of circle) {
    assert.ok(Math.abs(y - 9) < 1e-3 && Math.abs(Math.hypot(x - 1, z - 3) - 5) < 1e-3);
  }
  assert.equal(new Set(circle.map(String)).size, 12);
  assert.equal(circlePath([0, 0, 0], [0, 5, 0], 12), null);

  const places = [[0, 1, 0], [4, 1, 0], [4, 1, 4], [0, 5, 4]];
  const open = curvePath(places, 10, false);
  assert.deepEqual([open[0], open[3], open[6], open[9]], places);
  const closed = curvePath(places, 8, true);
  assert.deepEqual([closed[0], closed[2], closed[4], closed[6]], places);
  assert.deepEqual(curvePath([[0, 0, 0], [2, 4, 6]], 3, false)[1], [1, 2, 3]);
  assert.deepEqual(curvePath([[0, 0, 0], [2, 4, 6]], 8, true)[2], [1, 2, 3]);
});
