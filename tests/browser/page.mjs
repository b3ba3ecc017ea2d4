// The page as a person meets it, in a real Chromium.

import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';

const EXECUTABLE = process.env.CHROMIUM ?? '/usr/bin/chromium';
const QUIET = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const PATIENCE_MS = 15_000;

/** Where each key puts the light, in the page's words. */
export const STATUS = {
  a: 'Light to the left, at -20, 20, -10.',
  d: 'Light to the right, at 20, 20, -10.',
  s: 'Light above, near the eye, at 0, 20, -5.',
  w: 'Light above, far from the eye, at 0, 25, -35.',
  Escape: 'Light off.',
};

/** Where each key's picture lies. */
export const pathOf = (key) => (key === 'Escape' ? '/render' : `/render?key=${key}`);

/** Starts the browser. */
export function startChromium() {
  return chromium.launch({ executablePath: EXECUTABLE, args: QUIET });
}

/**
 * Opens the page, waits for its first picture, runs `body(page, visit)`, and then asserts what holds
 * of every visit: no console error and no request to anyone but the page's own server.
 * `visit.asked` lists the paths of the pictures asked for; `failing` lets failed loads be logged.
 */
export async function visit(browser, base, body, { init, failing = false, ...options } = {}) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE_MS);
  const seen = { context, asked: [], outside: [], errors: [] };
  try {
    if (init) await context.addInitScript(init);
    const page = await context.newPage();
    listen(page, base, seen);
    await page.goto(base);
    await told(page, STATUS.Escape);
    await body(page, seen);
    const errors = seen.errors.filter((text) => !(failing && text.startsWith('Failed to load')));
    assert.deepEqual(errors, [], 'console errors');
    assert.deepEqual(seen.outside, [], 'requests to others');
  } finally {
    await context.close();
  }
}

function listen(page, base, { asked, outside, errors }) {
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== base) outside.push(url.href);
    if (url.pathname === '/render') asked.push(url.pathname + url.search);
  });
}

/** Waits until the status says `words`. */
export async function told(page, words) {
  await page.getByText(words, { exact: true }).and(page.locator('#status')).waitFor();
}

/** Runs `action` and gives the picture's response that it led to. */
export async function answerTo(page, action) {
  const answer = page.waitForResponse((response) => new URL(response.url()).pathname === '/render');
  await action();
  return answer;
}

/** Whether the page shows exactly the pixels of `png`, a Buffer. */
export function shows(page, png) {
  return page.evaluate(async (base64) => {
    const wanted = new Image();
    wanted.src = `data:image/png;base64,${base64}`;
    await wanted.decode();
    const pixels = (image) => {
      const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
      const context = canvas.getContext('2d', { willReadFrequently: true });
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const [left, right] = [wanted, document.querySelector('#picture')].map(pixels);
    return left.length === right.length && left.every((value, i) => value === right[i]);
  }, png.toString('base64'));
}
