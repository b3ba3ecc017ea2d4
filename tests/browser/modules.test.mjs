// The page's pure modules, called in the browser that runs them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stage } from './stage.mjs';

const { look: inPage } = stage();

// Calls `name` of `module` with each of the argument lists.
const calls = (page, module, name, lists) =>
  page.evaluate(async ([from, what, all]) => {
    const { [what]: call } = await import(from);
    return all.map((list) => call(...list));
  }, [`/${module}`, name, lists]);

test('Server-Timing: phases in order, entries without a number left out, none where absent', () =>
  inPage(async (page) => {
    const read = (...headers) => calls(page, 'timing.js', 'readTiming', headers.map((it) => [it]));
    assert.deepEqual(await read('queue;dur=0.1, trace;desc="t";dur=2', 'hit, x;dur=no,y;dur="3"', '', null), [
      [{ name: 'queue', ms: 0.1 }, { name: 'trace', ms: 2 }], [{ name: 'y', ms: 3 }], [], [],
    ]);
    const total = (...timings) => calls(page, 'timing.js', 'totalMs', timings.map((it) => [it]));
    const parts = [{ name: 'a', ms: 1 }, { name: 'b', ms: 2 }];
    assert.deepEqual(await total(parts, [...parts, { name: 'total', ms: 4 }], []), [3, 4, 0]);
  }));

test('Tia-Rays: kinds in order', () =>
  inPage(async (page) => {
    assert.deepEqual(await calls(page, 'timing.js', 'readRays', [['primary=307200, shadow=0'], [null]]), [
      [{ name: 'primary', count: 307200 }, { name: 'shadow', count: 0 }], [],
    ]);
  }));

test('a typed number is a decimal number and nothing else', () =>
  inPage(async (page) => {
    const good = ['1', '-20', '+2.5', ' .5 ', '1e3', '-1.5E-2', '\u22124', '5.'];
    const bad = ['', '-', '1,5', '0x10', '1e', 'NaN', 'Infinity', '1 2', 'a'];
    const check = (texts) => page.evaluate(async (all) => {
      const { readNumber } = await import('/request.js');
      return all.map((text) => String(readNumber(text)));
    }, texts);
    assert.deepEqual(await check(good), ['1', '-20', '2.5', '0.5', '1000', '-0.015', '-4', '5']);
    assert.deepEqual(await check(bad), bad.map(() => 'NaN'));
  }));

test('a position reads back from every way it is written', () =>
  inPage(async (page) => {
    const texts = ['1,2,3', ' 1, 2, 3 ', '1 2 3', '[1, 2, 3]', '1,2', '1,2,3,4', '1,2,x', '1,,3'];
    const read = await calls(page, 'request.js', 'readLight', texts.map((it) => [it]));
    assert.deepEqual(read, [[1, 2, 3], [1, 2, 3], [1, 2, 3], [1, 2, 3], null, null, null, null]);
  }));

test('no plus sign gets into a URL, where it would be a space', () =>
  inPage(async (page) => {
    const paths = await calls(page, 'request.js', 'renderPath', [[{ light: [1e21, -0, 1e-7] }], [{}]]);
    assert.deepEqual(paths, ['render?light=1e21,0,1e-7', 'render']);
  }));

test('the runner starts at once, runs one at a time, keeps the newest, and survives a task that throws', () =>
  inPage(async (page) => {
    const log = await page.evaluate(async () => {
      const { latest } = await import('/latest.js');
      const seen = [];
      let finish;
      const ask = latest((input) => {
        seen.push(`start ${input}`);
        return new Promise((resolve, reject) => (finish = input === 'bad' ? reject : resolve))
          .finally(() => seen.push(`end ${input}`));
      });
      const first = ask(1);
      for (const input of [2, 3, 4]) ask(input);
      finish();
      while (!seen.includes('start 4')) await null;
      finish();
      await first;
      const failed = ask('bad').catch(() => seen.push('caught'));
      finish();
      await failed;
      ask(5);
      return seen;
    });
    assert.deepEqual(log, ['start 1', 'end 1', 'start 4', 'end 4', 'start bad', 'end bad', 'caught', 'start 5']);
  }));
