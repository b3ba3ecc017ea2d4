// A film saved from the timeline: one animated PNG of the server's own frames.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { apngOf } from '../../web/picture/apng.js';
import { lab, saved, shownPixels } from './lab.mjs';
import { chunksOf, crc32, pixelsIn, pixelsOf } from './png.mjs';

const on = lab();
const SCENE = { camera: { location: [0, 1, 6], look_at: [0, 0, 0] }, lights: [{ type: 'point', position: [3, 5, 4] }],
  objects: [{ name: 'ball', type: 'sphere', center: [0, 0, 0], radius: 1 }],
  animation: { duration: 2, fps: 4, tracks: [{ target: '/objects/ball/center', keys: [[0, [-1, 0, 0]], [2, [1, 0, 0]]] }] } };
const SMALL = { at: `/?scene=${encodeURIComponent(JSON.stringify(SCENE))}&width=160&height=120`, panel: 'timeline' };

const openFilm = (page) => page.getByText('Save as a film').click();

test('saved, it is an animated PNG of the server\u2019s own pixels, as they were packed, at the size asked for', () =>
  on.open(async (page) => {
    await openFilm(page);
    await page.getByRole('combobox', { name: 'Size' }).selectOption('80 \u00d7 60');
    const { name, bytes } = await saved(page, 'Save');
    assert.equal(name, 'tia-scene-film.png');
    await page.getByText('Saved: 8 frames.').waitFor();
    const stills = await Promise.all(Array.from({ length: 8 }, (_, k) => drawn({ time: k / 4, width: 80, height: 60 })));
    holdAnimation(bytes, stills, 250);
    const text = ({ type }) => type === 'iTXt';
    assert.deepEqual(chunksOf(bytes).filter(text), chunksOf(stills[0]).filter(text), 'the recipe of the first');
    const told = await page.evaluate(decodeAll, bytes.toString('base64'));
    assert.deepEqual(told, { count: 8, durations: Array(8).fill(250_000), size: '80x60', plays: Infinity });
    assert.deepEqual(await shownPixels(page, '#picture'), pixelsOf(await drawn({ time: 0, width: 160, height: 120 })));
  }, SMALL));

async function drawn(request) {
  const body = JSON.stringify({ scene: SCENE, threshold: 0.02, ...request });
  const answer = await fetch(`${on.tia.base}/render`, { method: 'POST', body });
  assert.equal(answer.status, 200, await answer.clone().text());
  return Buffer.from(await answer.arrayBuffer());
}

test('cancelled, nothing is saved and nothing more is asked for', () =>
  on.open(async (page, { asked }) => {
    let hold = () => {};
    const held = new Promise((resolve) => (hold = resolve));
    await page.route(/\/render/, async (route) => {
      const body = route.request().postDataJSON() ?? {};
      const { searchParams } = new URL(route.request().url());
      if (Number(body.time ?? searchParams.get('time')) >= 0.5) await held;
      await route.continue().catch(() => {}); // it may have been left
    });
    await openFilm(page);
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.getByText('2 of 8 frames are here.').waitFor();
    assert.equal(await page.getByRole('progressbar', { name: 'Save as a film' }).getAttribute('value'), '2');
    const before = asked.length;
    await page.keyboard.press('Enter'); // Cancel has the focus
    await page.getByText('Cancelled: nothing was saved.').waitFor();
    assert.ok(await page.getByRole('button', { name: 'Save', exact: true }).evaluate((it) => it === document.activeElement));
    hold();
    assert.equal(asked.length, before);
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
