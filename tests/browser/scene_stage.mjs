// The studio with its scene's panel open, as the tests of that panel need it.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { STATUS, rests, shows, told, until } from './page.mjs';
import { stage } from './stage.mjs';

const SCENES = new URL('../../web/scenes/', import.meta.url);

/** The gallery's files as { name: text }. */
export const gallery = () => Object.fromEntries(readdirSync(SCENES).filter((file) => file.endsWith('.json')).map((file) =>
  [file.replace('.json', ''), readFileSync(new URL(file, SCENES), 'utf8')]));

/**
 * The stage, and `open(body, { path, tab, ...options })`, which opens the panel at a path and runs
 * `body(page, tia)`; without `tab` the panel stays closed and nothing is waited for. `shared(again,
 * options)` is the same for tests that share a page.
 */
export function sceneStage() {
  const on = stage();
  const { look, shared } = on;
  const onScene = ({ tab = true, ...options } = {}) =>
    ({ ready: tab ? openScene : () => {}, failing: true, patience: 20_000, ...options });
  return Object.assign(on, {
    open: (body, options) => look((page) => body(page, on.tia), onScene(options)),
    shared: (again, options) => {
      const use = shared(again, onScene(options));
      return (body) => use((page) => body(page, on.tia));
    },
  });
}

/** Opens the panel and waits for its text. */
export async function openScene(page) {
  await rests(page);
  await page.locator('#tab-scene').click();
  await page.waitForFunction(() => document.getElementById('scene-text').value !== '');
}

/** Takes a page back to the thesis' scene as it came, by its own buttons. */
export async function asItCame(page) {
  if (await page.locator('#scene-discard').isEnabled()) await page.locator('#scene-discard').click();
  await page.getByText('The scene as it came.', { exact: false }).waitFor();
  await page.locator('#start-again').click();
  await told(page, STATUS.a);
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

/** Waits until the page shows, pixel for pixel, what the server draws of `request`. */
export async function showsPicture(page, { base }, request) {
  const answer = await fetch(`${base}/render`, { method: 'POST', body: JSON.stringify(request) });
  assert.equal(answer.status, 200, await answer.clone().text());
  const wanted = Buffer.from(await answer.arrayBuffer());
  await until(() => shows(page, wanted), `the picture of ${JSON.stringify(request).slice(0, 200)}`);
}

/** The picture shown, as a text. */
export const pictureOf = (page) => page.locator('#picture').evaluate((it) => it.toDataURL());

/** Waits until the panel tells the faults at [[line, column], ...], in their order. */
export async function tellsFaults(page, places) {
  const names = places.map(([line, column]) => `Line ${line}, column ${column}`);
  await page.waitForFunction((wanted) => JSON.stringify(wanted)
    === JSON.stringify([...document.querySelectorAll('.fault-place')].map((it) => it.textContent)), names);
}
