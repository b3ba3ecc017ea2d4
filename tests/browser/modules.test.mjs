// The page's pure modules, called in the browser that runs them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stage } from './stage.mjs';

const on = stage();
const { look } = on;
const inPage = on.shared(() => {}); // what is called leaves no trace

// Calls `name` of `module` with each of the argument lists.
const calls = (page, module, name, lists) =>
  page.evaluate(async ([from, what, all]) => {
    const { [what]: call } = await import(from);
    return Promise.all(all.map((list) => call(...list)));
  }, [`/${module}`, name, lists]);

test('Server-Timing: phases in order, entries without a number left out, none where absent', () =>
  inPage(async (page) => {
    const read = (...headers) => calls(page, 'picture/timing.js', 'readTiming', headers.map((it) => [it]));
    assert.deepEqual(await read('queue;dur=0.1, trace;desc="t";dur=2', 'hit, x;dur=no,y;dur="3"', '', null), [
      [{ name: 'queue', ms: 0.1 }, { name: 'trace', ms: 2 }], [{ name: 'y', ms: 3 }], [], [],
    ]);
    const total = (...timings) => calls(page, 'picture/timing.js', 'totalMs', timings.map((it) => [it]));
    const parts = [{ name: 'a', ms: 1 }, { name: 'b', ms: 2 }];
    assert.deepEqual(await total(parts, [...parts, { name: 'total', ms: 4 }], []), [3, 4, 0]);
  }));

test('Tia-Rays: kinds in order', () =>
  inPage(async (page) => {
    assert.deepEqual(await calls(page, 'picture/timing.js', 'readRays', [['primary=307200, shadow=0'], [null]]), [
      [{ name: 'primary', count: 307200 }, { name: 'shadow', count: 0 }], [],
    ]);
  }));

test('a typed number is a decimal number and nothing else', () =>
  inPage(async (page) => {
    const good = ['1', '-20', '+2.5', ' .5 ', '1e3', '-1.5E-2', '\u22124', '5.'];
    const bad = ['', '-', '1,5', '0x10', '1e', 'NaN', 'Infinity', '1 2', 'a'];
    const check = (texts) => page.evaluate(async (all) => {
      const { readNumber } = await import('/state/request.js');
      return all.map((text) => String(readNumber(text)));
    }, texts);
    assert.deepEqual(await check(good), ['1', '-20', '2.5', '0.5', '1000', '-0.015', '-4', '5']);
    assert.deepEqual(await check(bad), bad.map(() => 'NaN'));
  }));

test('numbers read back from every way they are written', () =>
  inPage(async (page) => {
    const texts = ['1,2,3', ' 1, 2, 3 ', '1 2 3', '[1, 2, 3]', '1,2', '1,2,x', '1,,3', ''];
    const read = await calls(page, 'state/request.js', 'readNumbers', texts.map((it) => [it]));
    assert.deepEqual(read, [[1, 2, 3], [1, 2, 3], [1, 2, 3], [1, 2, 3], [1, 2], null, null, null]);
  }));

test('no plus sign gets into a URL, where it would be a space; what needs no code has none', () =>
  inPage(async (page) => {
    const queries = await calls(page, 'state/request.js', 'queryOf', [
      [{ light: [1e21, -0, 1e-7] }], [{}], [{ scene: 'a b', camera: { location: [1, 2, 3] }, width: 8, pixel: [1, 2] }],
    ]);
    assert.deepEqual(queries, ['light=1e21,0,1e-7', '',
      'scene=a%20b&camera=%7B%22location%22:%5B1,2,3%5D%7D&width=8&pixel=1,2']);
  }));

// A ball over a floor with the lamp above it, moved along x; a pixel of its shadow.
function ballAt(far) {
  const at = (x, y, z) => [far + x, y, z];
  const scene = { camera: { location: at(0, 3, 10), look_at: at(0, 0, 0) },
    objects: [{ type: 'plane', point: at(0, -0.5, 0), normal: [0, 1, 0] }, { type: 'sphere', center: at(0, 1, 0), radius: 1 }],
    lights: [{ type: 'point', position: at(0, 6, 0) }] };
  return [{ scene, width: 64, height: 48 }, [32, 28], at(0, 1, 0)];
}

test('a blocked ray ends on what is in its way, however far from the origin the scene stands', () =>
  inPage(async (page) => {
    const fars = [0, 1e3, -1e6, 1e8];
    const all = await calls(page, 'picture/explain_pixel.js', 'explainPixel', fars.map(ballAt));
    for (const [i, { steps }] of all.entries()) {
      const { from: [, floor], to: [x, y, z], aim } = steps.find(({ blocked }) => blocked);
      assert.ok(Math.abs(floor + 0.5) < 1e-5 && y < 1 && aim, `${fars[i]}: ${[x, y, z]}`);
      assert.ok(Math.abs(Math.hypot(x - fars[i], y - 1, z) - 1) < 1e-5, `${fars[i]}: ${[x, y, z]}`);
    }
  }));

// Requests of every kind, by chance.
function requests() {
  const any = (...all) => all[Math.floor(Math.random() * all.length)];
  const number = () => (Math.random() - 0.5) * 10 ** Math.floor(Math.random() * 8 - 2);
  const text = () => Array.from({ length: Math.random() * 900 }, () => any('a', '\u1ee7', '"', '&', '=', '+', '#', ' ', '\u{1f4a1}', '%')).join('');
  return Array.from({ length: 50 }, () => ({
    scene: any('thesis', { title: text(), objects: [{ type: 'sphere', center: [number(), number(), number()], radius: 1 }] }),
    light: [number(), number(), number()],
    width: Math.floor(Math.random() * 1000) + 1,
    camera: { location: [number(), 0, 0], look_at: null },
    pixel: [3, 4],
    ...(Math.random() < 0.3 && { crop: [0, 0, 9, 9], samples: 4, transfer: 'srgb' }),
  }));
}

test('every module of the page is asked for at once, but for other languages', () =>
  look(async (page) => {
    const preloaded = await page.locator('link[rel=modulepreload]').evaluateAll((all) => all.map((it) => it.getAttribute('href')));
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource')
      .map(({ name }) => new URL(name).pathname.slice(1)).filter((path) => path.endsWith('.js') && path !== 'main.js'));
    assert.deepEqual([...new Set(loaded)].sort(), preloaded.sort());
  }));

test('the page with all its languages is at most 150 KB over the wire', () =>
  look(async (page) => {
    const bytes = await page.evaluate(async () => {
      await import('/words/vi.js');
      return performance.getEntriesByType('resource').filter(({ name }) => /\.(js|css|svg)$/.test(new URL(name).pathname))
        .reduce((sum, { transferSize }) => sum + transferSize, performance.getEntriesByType('navigation')[0].transferSize);
    });
    assert.ok(bytes > 50_000 && bytes <= 150_000, `${bytes} bytes`);
  }));

test('every request comes back from its address, short or long', () =>
  inPage(async (page) => {
    const all = requests();
    const back = await page.evaluate(async (states) => {
      const { readAddress, writeAddress } = await import('/state/address.js');
      return Promise.all(states.map(async (state) => {
        const { search, hash } = new URL(await writeAddress(state), 'http://x/');
        return [await readAddress({ search, hash }), search.length, hash.length];
      }));
    }, all);
    assert.deepEqual(back.map(([state]) => state), all);
    assert.ok(back.some(([, query]) => query > 0) && back.some(([, , hash]) => hash > 0));
  }));
