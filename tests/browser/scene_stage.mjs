// The studio with its scene's panel open, as the tests of that panel need it.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before } from 'node:test';
import { startChromium } from './page.mjs';
import { startTia } from './tia.mjs';

const SCENES = new URL('../../web/scenes/', import.meta.url);

/** The gallery's files as { name: text }. */
export const gallery = () => Object.fromEntries(readdirSync(SCENES).map((file) =>
  [file.replace('.json', ''), readFileSync(new URL(file, SCENES), 'utf8')]));

/**
 * A server and a browser; `on.open(body, { path, ...options })` opens the panel at a path, runs
 * `body(page, tia)` and then asserts: no console error but failed loads, no request to others.
 */
export function sceneStage() {
  const on = {
    async open(body, { path = '/', tab = true, ...options } = {}) {
      const context = await on.browser.newContext(options);
      context.setDefaultTimeout(20_000);
      const [errors, outside] = [[], []];
      try {
        const page = await context.newPage();
        page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
        page.on('pageerror', (error) => errors.push(String(error.stack)));
        page.on('request', (request) => {
          const url = new URL(request.url());
          if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== on.tia.base) outside.push(url.href);
        });
        await page.goto(on.tia.base + path);
        if (tab) await openScene(page);
        await body(page, on.tia);
        assert.deepEqual(errors.filter((text) => !text.startsWith('Failed to load')), [], 'console errors');
        assert.deepEqual(outside, [], 'requests to others');
      } finally {
        await context.close();
      }
    },
  };
  before(async () => ([on.tia, on.browser] = await Promise.all([startTia(), startChromium()])));
  after(async () => {
    await on.browser?.close();
    await on.tia?.stop();
  });
  return on;
}

/** Opens the panel and waits for its text. */
export async function openScene(page) {
  await page.locator('#frame[aria-busy=false]').waitFor();
  await page.locator('#tab-scene').click();
  await page.waitForFunction(() => document.getElementById('scene-text').value !== '');
}

export const textOf = (page) => page.locator('#scene-text').inputValue();

/** Replaces the first `from` in the text by `to` as typing does: selected, then written over. */
export async function type(page, from, to) {
  await page.locator('#scene-text').evaluate((area, words) => {
    const at = area.value.indexOf(words);
    if (at < 0) throw new Error(`no ${words} in the text`);
    area.focus();
    area.setSelectionRange(at, at + words.length);
  }, from);
  if (to) await page.keyboard.type(to);
  else await page.keyboard.press('Delete');
}

/** Waits until the page shows, byte for byte, what the server draws of `request`. */
export async function showsPicture(page, { base }, request) {
  const answer = await fetch(`${base}/render`, { method: 'POST', body: JSON.stringify(request) });
  assert.equal(answer.status, 200, await answer.clone().text());
  const wanted = createHash('sha256').update(Buffer.from(await answer.arrayBuffer())).digest('hex');
  await page.waitForFunction(async (digest) => {
    const { src } = document.getElementById('picture');
    const bytes = await fetch(src).then((it) => it.arrayBuffer()).catch(() => new ArrayBuffer(0));
    const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
    return [...hash].map((byte) => byte.toString(16).padStart(2, '0')).join('') === digest;
  }, wanted, { polling: 100 });
}

/** Waits until the panel tells the faults at [[line, column], ...], in their order. */
export async function tellsFaults(page, places) {
  const names = places.map(([line, column]) => `Line ${line}, column ${column}`);
  await page.waitForFunction((wanted) => JSON.stringify(wanted)
    === JSON.stringify([...document.querySelectorAll('.fault-place')].map((it) => it.textContent)), names);
}
