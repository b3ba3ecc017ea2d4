// The page as a person meets it, in a real Chromium.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { setTimeout } from 'node:timers/promises';
import axe from 'axe-core';
import { chromium } from 'playwright-core';

// The headless shell is Chromium without windows and what belongs to them: it starts a page in half
// the time.
const EXECUTABLE = process.env.CHROMIUM ??
  ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find(existsSync);
const QUIET = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const PATIENCE_MS = 15_000;
const STILL = { reducedMotion: 'reduce' }; // buttons that fade cost a third of a picture's time

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
 * Opens the page at `path` in a context of its own and waits until it is `ready`. Gives the page,
 * what is `seen` of it - `asked` lists the paths of the pictures asked for -, `holds()`, which asserts
 * what holds of every visit - no console error, no request to anyone but the page's own server -,
 * and `close()`. `watch(page, seen)` sees it before it loads; `failing` lets failed loads be logged.
 */
async function open(browser, base,
  { init, path = '/', ready = rests, watch = () => {}, failing = false, patience = PATIENCE_MS, ...options } = {}) {
  const context = await browser.newContext({ ...STILL, ...options });
  context.setDefaultTimeout(patience);
  const seen = { context, asked: [], outside: [], errors: [] };
  const close = () => context.close();
  try {
    if (init) await context.addInitScript(init);
    const page = await context.newPage();
    listen(page, base, seen);
    await watch(page, seen);
    await page.goto(new URL(path, base).href);
    await ready(page);
    const holds = () => {
      const errors = seen.errors.filter((text) => !(failing && text.startsWith('Failed to load')));
      assert.deepEqual(errors, [], 'console errors');
      assert.deepEqual(seen.outside, [], 'requests to others');
    };
    return { page, seen, holds, close };
  } catch (error) {
    await close();
    throw error;
  }
}

/** Opens the page, runs `body(page, seen)`, and asserts what holds of every visit. */
export async function visit(browser, base, body, options) {
  const { page, seen, holds, close } = await open(browser, base, options);
  try {
    await body(page, seen);
    holds();
  } finally {
    await close();
  }
}

let shared = null; // the page that stays open, one at a time, and whose it is

/**
 * visit(body) for tests that share a page: the first of them opens it, `again(page)` takes it back to
 * where it began for each one that follows. A test that fails leaves it to nobody.
 */
export function sharing(opening, again) {
  const whose = {};
  return async (body) => {
    if (shared?.whose === whose) {
      shared.seen.asked.length = 0;
      await again(shared.page);
    } else {
      await shared?.close();
      shared = null;
      const { browser, base, options } = await opening();
      shared = { whose, ...await open(browser, base, options) };
    }
    const { page, seen, holds, close } = shared;
    try {
      await body(page, seen);
      holds();
    } catch (error) {
      shared = null;
      await close();
      throw error;
    }
  };
}

function listen(page, base, { asked, outside, errors }) {
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error.stack)));
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

/**
 * Waits until `holds()` comes to be true. The browser's own waiting takes a promise for true, so
 * what has to be waited for within is asked for here.
 */
export async function until(holds, what) {
  const end = Date.now() + PATIENCE_MS;
  while (!await holds()) {
    assert.ok(Date.now() < end, `${what}: not within ${PATIENCE_MS} ms`);
    await setTimeout(50);
  }
}

/** Takes a page back to the scene as it was opened, by its own button. */
export async function startAgain(page) {
  await page.locator('#tab-light').click();
  await page.locator('#start-again').click();
  await told(page, STATUS.a);
  await page.locator('#hand').focus();
}

/** What axe finds in `part` of the page, as texts; of what it finds in order it tells nothing. */
export async function faults(page, part) {
  if (!await page.evaluate(() => 'axe' in globalThis)) await page.evaluate(axe.source);
  const { violations } = await page.evaluate((where) =>
    globalThis.axe.run(where ?? document, { resultTypes: ['violations'] }), part);
  return violations.map(({ id, nodes }) =>
    `${id}: ${nodes.map(({ html, any }) => [html, ...any.map(({ message }) => message)].join(' ')).join(' ')}`);
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
