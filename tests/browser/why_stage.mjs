// The page with a pixel asked about, as a person meets it.

import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { startChromium } from './page.mjs';
import { startTia } from './tia.mjs';

const EMPTY = '<svg xmlns="http://www.w3.org/2000/svg" width="160" height="120"/>';

/** A server and a browser; `ask(path, body, options)` opens the page there and runs body(page). */
export function whyStage() {
  const on = {
    async ask(path, body, { failing = false, ...options } = {}) {
      const context = await on.browser.newContext({ locale: 'en-US', viewport: { width: 1280, height: 900 }, ...options });
      context.setDefaultTimeout(30_000);
      // The gallery's 32 thumbnails are no part of this, and drawing them takes the server's time.
      await context.route(/render\?.*width=160/, (route) => (route.request().resourceType() === 'image'
        ? route.fulfill({ contentType: 'image/svg+xml', body: EMPTY }) : route.continue()));
      const [errors, outside] = [[], []];
      try {
        const page = await context.newPage();
        page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
        page.on('pageerror', (error) => errors.push(String(error)));
        page.on('request', (request) => {
          const { protocol, origin } = new URL(request.url());
          if (!['blob:', 'data:'].includes(protocol) && origin !== on.tia.base) outside.push(request.url());
        });
        await page.goto(`${on.tia.base}/${path}`);
        await body(page);
        assert.deepEqual(errors.filter((text) => !(failing && text.startsWith('Failed to load'))), []);
        assert.deepEqual(outside, [], 'requests to others');
      } finally {
        await context.close();
      }
    },
    json: async (path) => JSON.parse(await on.tia.get(path)),
  };
  before(async () => ([on.tia, on.browser] = await Promise.all([startTia(), startChromium()])));
  after(async () => {
    await on.browser?.close();
    await on.tia?.stop();
  });
  return on;
}

/** Waits until the pixel is explained and the picture at rest. */
export async function explained(page, [x, y]) {
  await page.locator('#panel-why').getByText(`Pixel ${x}, ${y}`, { exact: true }).waitFor();
  await page.waitForURL((url) => url.searchParams.get('pixel') === `${x},${y}`);
  await page.locator('#frame[aria-busy=false]').waitFor();
}

/** Clicks the pixel in the picture and waits for its explanation. */
export async function clickPixel(page, [x, y], [width, height] = [640, 480]) {
  const box = await page.locator('#hand').boundingBox();
  const place = [box.x + ((x + 0.5) / width) * box.width, box.y + ((y + 0.5) / height) * box.height];
  await page.mouse.click(...place.map(Math.round)); // as whole pixels of the screen come
  await explained(page, [x, y]);
}

/** The sentence that says why. */
export const because = (page) => page.locator('.because').innerText();

/** Numbers from 0 below 1 that are the same in every run. Source: mulberry32. */
export function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let word = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    word = (word + Math.imul(word ^ (word >>> 7), 61 | word)) ^ word;
    return ((word ^ (word >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A pixel's codes in the picture shown. */
export function pixelShown(page, [x, y]) {
  return page.evaluate(([left, top]) => {
    const image = document.querySelector('#picture');
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return [...context.getImageData(left, top, 1, 1).data].slice(0, 3);
  }, [x, y]);
}
