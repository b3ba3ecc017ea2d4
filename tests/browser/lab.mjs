// What the tests of the laboratory's panels share: a server, a browser, the page at rest.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before } from 'node:test';
import axe from 'axe-core';
import { startChromium } from './page.mjs';
import { startTia } from './tia.mjs';

const PATIENCE_MS = 20_000;

/**
 * A server and a browser for one file's tests. `open(body, { at, panel, ...options })` opens the
 * page at an address of this server, waits until it rests, opens a panel and runs `body(page, seen)`;
 * `seen.pictures` are the responses of pictures for the page's frame, `seen.whole` the requests of
 * those that have come to their end.
 */
export function lab() {
  const on = { open: (body, options) => open(on, body, options) };
  before(async () => ([on.tia, on.browser] = await Promise.all([startTia(0, [], 'ignore'), startChromium()])));
  after(async () => {
    await on.browser?.close();
    await on.tia?.stop();
  });
  return on;
}

async function open({ tia, browser }, body,
  { at = '/?scene=thesis&key=a', panel, init, failing = false, ...options } = {}) {
  const context = await browser.newContext({ locale: 'en-US', ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  const seen = { context, pictures: [], whole: new Set(), asked: [], outside: [], errors: [] };
  try {
    if (init) await context.addInitScript(init);
    const page = await context.newPage();
    listen(page, tia.base, seen);
    await page.goto(new URL(at, tia.base).href);
    await rest(page);
    await page.locator('.lamp-mark').waitFor({ state: 'attached' });
    if (panel) await page.locator(`#tab-${panel}`).click();
    await body(page, seen);
    const errors = seen.errors.filter((text) => !(failing && text.startsWith('Failed to load')));
    assert.deepEqual(errors, [], 'console errors');
    assert.deepEqual(seen.outside, [], 'requests to others');
  } finally {
    await context.close();
  }
}

function listen(page, base, { pictures, whole, asked, outside, errors }) {
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== base) outside.push(url.href);
    if (isPicture(request)) asked.push(request);
  });
  page.on('requestfinished', (request) => whole.add(request));
  page.on('response', (response) => isPicture(response.request()) && pictures.push(response));
}

// No thumbnail, no feature image for words, no background of a map.
function isPicture(request) {
  if (new URL(request.url()).pathname !== '/render' || request.resourceType() !== 'fetch') return false;
  return !/format\W+pfm|orthographic/.test(request.url() + request.postData());
}

/** Waits until nothing finer follows. */
export async function rest(page) {
  await page.locator('#frame[aria-busy=false]').waitFor();
}

/** Presses a key of the lamp and waits until the picture rests. */
export async function light(page, key) {
  await page.locator('#hand').focus();
  await page.keyboard.press(key);
  await rest(page);
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
    let text = '';
    for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
    return { width, height, text: btoa(text) };
  });
  return { width, height, data: Buffer.from(text, 'base64') };
}

/** What axe finds in the page, as texts. */
export async function faults(page) {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
}
