// The film that README.md's line asks for, played in a real Chromium.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { startChromium } from './page.mjs';
import { startTia } from './tia.mjs';

let tia, browser;
before(async () => {
  [tia, browser] = await Promise.all([startTia(), startChromium()]);
});
after(() => Promise.all([browser?.close(), tia?.stop()]));

/** The address of the film in README.md, below the server's. */
async function address() {
  const readme = await readFile(new URL('../../README.md', import.meta.url), 'utf8');
  const [, path] = /^curl -o \S+\.webm '?localhost:8080(\/film\S+?)'? /m.exec(readme);
  return path;
}

/** Plays what the page's video shows for a while; what it tells of itself, then the frame at half a second. */
function play(source) {
  const video = document.createElement('video');
  Object.assign(video, { src: source, muted: true });
  document.body.append(video);
  const comes = (name) => new Promise((resolve, reject) => {
    video.addEventListener(name, resolve, { once: true });
    video.addEventListener('error', () => reject(new Error(video.error.message)), { once: true });
  });
  const codes = () => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
    const context = canvas.getContext('2d');
    context.drawImage(video, 0, 0);
    return [...context.getImageData(0, 0, canvas.width, canvas.height).data];
  };
  return comes('loadeddata').then(async () => {
    const { duration, videoWidth: width, videoHeight: height } = video;
    video.play();
    while (video.currentTime < 0.3) await comes('timeupdate');
    const advanced = video.currentTime;
    const at = await new Promise((resolve) => {
      video.requestVideoFrameCallback((now, { mediaTime }) => resolve(mediaTime));
      video.currentTime = 0.5;
    });
    return { at, codes: codes(), duration, width, height, advanced };
  });
}

test('README.md’s film plays: its size, its duration, its pictures, and time passes', async () => {
  const path = (await address()).replace(/$/, '&to=1');
  const film = await tia.get(path);
  const page = await browser.newPage();
  const shown = await page.evaluate(play, `data:video/webm;base64,${film.toString('base64')}`);
  assert.equal(shown.width, 320);
  assert.equal(shown.height, 240);
  assert.equal(shown.duration, 1);
  assert.ok(shown.advanced >= 0.3);
  const still = await tia.get(path.replace('/film', '/render').replace(/&(format|to)=[^&]*/g, '') + `&frame=${Math.round(shown.at * 24)}`);
  const codes = await page.evaluate(async (source) => {
    const picture = new Image();
    picture.src = source;
    await picture.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [picture.width, picture.height];
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    return [...context.getImageData(0, 0, canvas.width, canvas.height).data];
  }, `data:image/png;base64,${still.toString('base64')}`);
  const off = codes.reduce((sum, code, i) => sum + Math.abs(code - shown.codes[i]), 0) / codes.length;
  assert.ok(off <= 1.5, `a mean of ${off} of 255`);
});
