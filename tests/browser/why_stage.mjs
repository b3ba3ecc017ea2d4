// The page with a pixel asked about, as a person meets it.

import { rests } from './page.mjs';
import { stage } from './stage.mjs';

const EMPTY = '<svg xmlns="http://www.w3.org/2000/svg" width="160" height="120"/>';

/**
 * The stage, `ask(path, body, options)`, which opens the page there and runs body(page), and
 * `shared(again, path)` for tests that share a page.
 */
export function whyStage() {
  const on = stage();
  const { look, shared } = on;
  const asking = (path, options) => ({ path: `/${path}`, ready: () => {}, watch: withoutThumbnails,
    patience: 30_000, locale: 'en-US', viewport: { width: 1280, height: 900 }, ...options });
  return Object.assign(on, {
    ask: (path, body, options) => look(body, asking(path, options)),
    shared: (again, path) => shared(again, asking(path, { ready: rests })),
    json: async (path) => JSON.parse(await on.tia.get(path)),
  });
}

// The gallery's 32 thumbnails are no part of this, and drawing them takes the server's time.
function withoutThumbnails(page) {
  return page.route(/render\?.*width=160/, (route) => (route.request().resourceType() === 'image'
    ? route.fulfill({ contentType: 'image/svg+xml', body: EMPTY }) : route.continue()));
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
