// What the tests of the laboratory's panels share: the page at rest with a panel open.

import { readFile } from 'node:fs/promises';
import { rests } from './page.mjs';
import { stage } from './stage.mjs';

/**
 * The stage, and `open(body, { at, panel, ...options })`, which opens the page at an address of this
 * server, waits until it rests, opens a panel and runs `body(page, seen)`; `seen.asked` are the
 * requests of pictures for the page's frame, `seen.pictures` the responses to them, `seen.whole`
 * those that have come to their end. `shared(again, options)` is the same for tests that share a page.
 */
export function lab() {
  const on = stage();
  const { look, shared } = on;
  return Object.assign(on, {
    open: (body, options) => look(body, inLab(options)),
    shared: (again, options) => shared(again, inLab(options)),
  });
}

function inLab({ at = '/?scene=thesis&key=a', panel, ...options } = {}) {
  const ready = async (page) => {
    await rests(page);
    await page.locator('.lamp-mark').waitFor({ state: 'attached' });
    if (panel) await page.locator(`#tab-${panel}`).click();
  };
  return { locale: 'en-US', path: at, ready, watch, patience: 20_000, ...options };
}

function watch(page, seen) {
  Object.assign(seen, { asked: [], pictures: [], whole: new Set() });
  page.on('request', (request) => isPicture(request) && seen.asked.push(request));
  page.on('requestfinished', (request) => seen.whole.add(request));
  page.on('response', (response) => isPicture(response.request()) && seen.pictures.push(response));
}

// No thumbnail, no feature image for words, no background of a map.
function isPicture(request) {
  if (new URL(request.url()).pathname !== '/render' || request.resourceType() !== 'fetch') return false;
  return !/format\W+pfm|orthographic/.test(request.url() + request.postData());
}

export { faults, rests as rest } from './page.mjs';

/** Presses a key of the lamp and waits until the picture rests. */
export async function light(page, key) {
  await page.locator('#hand').focus();
  await page.keyboard.press(key);
  await rests(page);
}

/** The bytes and the name of the file that pressing the button `name` saves. */
export async function saved(page, name) {
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name, exact: true }).click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** The pixels of an element that shows a picture, or of a canvas: { width, height, data } with rgb. */
export async function shownPixels(page, selector) {
  const { width, height, text } = await page.locator(selector).evaluate(async (it) => {
    const [width, height] = [it.naturalWidth ?? it.width, it.naturalHeight ?? it.height];
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    context.drawImage(it, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const lines = Array.from({ length: height }, (_, y) =>
      String.fromCharCode(...data.subarray(4 * width * y, 4 * width * (y + 1)).filter((_, i) => i % 4 < 3)));
    return { width, height, text: btoa(lines.join('')) };
  });
  return { width, height, data: Buffer.from(text, 'base64') };
}
