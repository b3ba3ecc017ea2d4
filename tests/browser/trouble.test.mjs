// When things go wrong: what the page says, and that it goes on.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { STATUS, pathOf, shows, startAgain, told, visit } from './page.mjs';
import { stage } from './stage.mjs';
import { startTia } from './tia.mjs';

const PROBLEM = { 'Content-Type': 'application/problem+json' };

const on = stage();
const look = on.sharedProxied(startAgain, { failing: true });
const problem = (page) => page.locator('#problem');
const retry = (page) => page.getByRole('button', { name: 'Try again' });

async function saidTo(page, ...parts) {
  for (const hasText of parts) await problem(page).filter({ hasText }).waitFor();
}

async function cleared(page) {
  await page.locator('#problem:empty').waitFor({ state: 'attached' });
  assert.ok(await retry(page).isHidden());
}

const refusal = (status, document, headers = {}) =>
  ({ status, headers: { ...PROBLEM, ...headers }, body: JSON.stringify(document) });

test('what the server refuses is told in its words, the picture stays, the next success clears it', () =>
  look(async (page) => {
    await page.getByLabel('x', { exact: true }).fill('1e300');
    const answer = page.waitForResponse((response) => response.url().includes('/render?scene=thesis&light=1e300'));
    await page.keyboard.press('Enter');
    const { title, errors } = await (await answer).json();
    await saidTo(page, title, errors[0].pointer.split('/')[1], 'got 1e+300', 'allowed: ', 'Change the request');
    assert.ok(await retry(page).isHidden());
    assert.ok(await shows(page, await on.tia.get(pathOf('a'))));
    await page.locator('#hand').focus();
    await page.keyboard.press('d');
    await told(page, STATUS.d);
    await cleared(page);
  }));

test('every fault of a problem document is told with its place, what came, what is allowed, what is near', () =>
  look(async (page, proxy) => {
    const errors = [
      { pointer: '/key', got: 'q', allowed: ['a', 'd', 's', 'w'], nearest: 'a' },
      { pointer: '/scene/objects/3/radius', got: -1, allowed: '> 0' },
    ];
    proxy.next.push(refusal(422, { title: 'No such key', status: 422, detail: 'Look here.', errors }));
    await page.keyboard.press('d');
    await saidTo(page, 'No such key', 'Look here.', 'key: got q; allowed: a, d, s, w; nearest: a',
      'scene \u203a objects \u203a 3 \u203a radius: got -1; allowed: > 0');
  }));

test('a detail that only repeats the fault is not told twice', () =>
  look(async (page, proxy) => {
    const errors = [{ pointer: '/light/0', got: 9, allowed: 'less' }];
    proxy.next.push(refusal(422, { title: 'Far', detail: '/light/0: got 9, allowed: less', errors }));
    await page.keyboard.press('d');
    await saidTo(page, 'Far');
    assert.deepEqual(await problem(page).locator('p').allTextContents(), [
      'light \u203a 0: got 9; allowed: less', 'Change the request and send it again. The last picture stays.',
    ]);
  }));

test('what the server says is shown as text, never as markup', () =>
  look(async (page, proxy) => {
    proxy.next.push(refusal(422, { title: '<img src=x id=evil>', detail: '<b>bold</b>' }));
    await page.keyboard.press('d');
    await saidTo(page, '<img src=x id=evil>', '<b>bold</b>');
    assert.equal(await page.locator('#evil').count(), 0);
  }));

test('a busy server is told with the time to wait, and trying again asks for the same picture', () =>
  look(async (page, proxy) => {
    const document = { type: '/problems/busy', title: 'Busy', status: 429, detail: 'The queue is full.' };
    proxy.next.push(refusal(429, document, { 'Retry-After': '7' }));
    await page.keyboard.press('w');
    await saidTo(page, 'Busy', 'The queue is full.', 'Wait 7 s, then try again.');
    await retry(page).click();
    await told(page, STATUS.w);
    await cleared(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'hand');
  }));

test('an error without a problem document is told by its status', () =>
  look(async (page, proxy) => {
    proxy.next.push({ status: 502, headers: { 'Content-Type': 'text/html' }, body: '<h1>Bad</h1>' });
    await page.keyboard.press('d');
    await saidTo(page, 'The server answered 502', 'Try again.');
  }));

test('a problem document that is not as it should be is told as far as it goes', () =>
  look(async (page, proxy) => {
    const errors = [null, { pointer: 3, got: null }, 7];
    proxy.next.push(refusal(400, { title: 'Odd', status: 'x', errors }));
    await page.keyboard.press('d');
    await saidTo(page, 'Odd', 'the request: got null');
  }));

test('an answer that is no picture is told', () =>
  look(async (page, proxy) => {
    proxy.next.push({ status: 200, headers: { 'Content-Type': 'image/png' }, body: 'no picture' });
    await page.keyboard.press('d');
    await saidTo(page, 'not a picture');
    assert.ok(await shows(page, await on.tia.get(pathOf('a'))));
  }));

test('a scene that does not come is told until it comes, whatever picture does', () =>
  look(async (page, proxy) => {
    proxy.scene = refusal(500, { title: 'No scene today', status: 500, detail: 'It is lost.' });
    await page.reload();
    await saidTo(page, 'No scene today');
    await page.keyboard.press('d');
    await page.locator('#status').filter({ hasText: 'Light to the right' }).waitFor();
    await saidTo(page, 'No scene today');
    proxy.scene = null;
    await retry(page).click();
    await told(page, STATUS.d);
    await cleared(page);
  }));

test('a busy server is asked again by itself, when it said so', () =>
  look(async (page, proxy) => {
    const document = { type: '/problems/busy', title: 'Busy', status: 503, detail: 'Later.' };
    proxy.next.push(refusal(503, document, { 'Retry-After': '1' }));
    await page.keyboard.press('w');
    await saidTo(page, 'Busy');
    await told(page, STATUS.w);
    await cleared(page);
  }));

test('a server that is gone is told; back again it goes on where it stood', async () => {
  const first = await startTia();
  let second;
  try {
    await visit(on.browser, first.base, async (page) => {
      await first.stop();
      await page.keyboard.press('d');
      await saidTo(page, 'The server cannot be reached', 'Check that tia is running');
      await told(page, STATUS.a);
      second = await startTia(first.port);
      await retry(page).click();
      await told(page, STATUS.d);
      await cleared(page);
    }, { failing: true });
  } finally {
    await first.stop();
    await second?.stop();
  }
});
