// The page as a person meets it, in a real Chromium.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

// The headless shell is Chromium without windows and what belongs to them: it starts a page in half
// the time.
const EXECUTABLE = process.env.CHROMIUM ??
  ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find(existsSync);
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

/** The request whose picture the page ends on for a key: smooth, where the scene says nothing. */
export const pathOf = (key) =>
  `/render?scene=thesis${key === 'Escape' ? '' : `&key=${key}`}&threshold=0.02`;

/** Starts the browser. */
export function startChromium() {
  return chromium.launch({ executablePath: EXECUTABLE, args: QUIET });
}

/**
 * Opens the page at `path`, waits until its picture is as fine as it gets, runs `body(page,
 * visit)`, and then asserts what holds of every visit: no console error and no request to anyone
 * but the page's own server. `visit.asked` lists the paths of the pictures asked for; `failing`
 * lets failed loads be logged.
 */
export async function visit(browser, base, body, { init, path = '/', failing = false, ...options } = {}) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE_MS);
  const seen = { context, asked: [], outside: [], errors: [] };
  try {
    if (init) await context.addInitScript(init);
    const page = await context.newPage();
    listen(page, base, seen);
    await page.goto(base + path);
    await rests(page);
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
    if (isPicture(url)) asked.push(url.pathname + url.search);
  });
}

/** Whether a URL is one of the picture's own: no feature, no plan, no thumbnail. */
export function isPicture({ pathname, searchParams: query }) {
  const thumbnail = query.get('width') === '160' && query.get('samples') === '1';
  return pathname === '/render' && !query.has('integrator') && !query.has('format') && !thumbnail;
}

/** Waits until the picture wanted is shown, as fine as it gets. */
export async function rests(page) {
  await page.locator('#frame[aria-busy=false]').waitFor();
}

/** Waits until the status says `words` and the picture rests. */
export async function told(page, words) {
  await page.getByText(words, { exact: true }).and(page.locator('#status')).waitFor();
  await rests(page);
}

/** Whether the page shows exactly the pixels of `png`, a Buffer. */
export function shows(page, png) {
  return page.evaluate(async (base64) => {
    const wanted = new Image();
    wanted.src = `data:image/png;base64,${base64}`;
    await wanted.decode();
    const picture = document.querySelector('#picture');
    const canvas = new OffscreenCanvas(wanted.naturalWidth, wanted.naturalHeight);
    const context = canvas.getContext('2d', { willReadFrequently: true });
    context.drawImage(wanted, 0, 0);
    const pixels = (of) => of.getImageData(0, 0, canvas.width, canvas.height).data;
    if (picture.width !== canvas.width || picture.height !== canvas.height) return false;
    const [left, right] = [pixels(context), pixels(picture.getContext('2d'))];
    return left.every((value, i) => value === right[i]);
  }, png.toString('base64'));
}

/** The query of the page's address: the request of the picture that it shows. */
export function addressOf(page) {
  return new URL(page.url()).search;
}
