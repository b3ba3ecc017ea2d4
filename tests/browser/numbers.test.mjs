// Numbers: what the page tells of a picture is what the server's headers say, and how far rounds are from
// what they come to.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { errorsOf, slopeOf } from '../../web/picture/errors.js';
import { roundAfter, roundsBefore } from '../../web/picture/rounds.js';
import { Pace, median, rateOf } from '../../web/picture/timing.js';
import { faults, lab, light, rest } from './lab.mjs';
import { addressOf, shows } from './page.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const shared = on.shared((page) => page.locator('#tab-numbers').click(), { panel: 'numbers' });
const AT = '/?scene=cornell-light&width=32&height=24&samples=64';
const words = (number) => number.toLocaleString('en', { maximumSignificantDigits: number < 1000 ? 3 : 4 });
const told = (page, list, name) => page.locator(`#panel-numbers .${list} .${name} dd`).textContent();

// "a;dur=1, b;dur=2" and "a=1, b=2" as [name, number].
const entries = (header) => header.split(', ').map((entry) => /^(\w+).*=([\d.]+)$/.exec(entry))
  .map(([, name, value]) => [name, Number(value)]);

test('time, rays, bytes and size are those of the last answer', () =>
  shared(async (page, { pictures }) => {
    await light(page, 's');
    const last = pictures.at(-1);
    const headers = await last.allHeaders();
    const bytes = await last.body();
    await page.locator('.whole .bytes dd').getByText(bytes.length.toLocaleString('en'), { exact: true }).waitFor();
    const phases = entries(headers['server-timing']);
    assert.deepEqual(phases.map(([name]) => name), ['queue', 'wait', 'parse', 'build', 'trace', 'encode']);
    for (const [name, ms] of phases) assert.equal(await told(page, 'phases', name), `${words(ms)} ms`);
    const sum = phases.reduce((total, [, ms]) => total + ms, 0);
    assert.equal(await page.locator('#panel-numbers .figure').first().textContent(), `${words(sum)} ms`);
    const rays = entries(headers['tia-rays']);
    for (const [name, count] of rays) assert.equal(await told(page, 'kinds', name), count.toLocaleString('en'));
    assert.equal(rays.find(([name]) => name === 'refraction')[1], 0);
    const all = rays.reduce((total, [, count]) => total + count, 0);
    assert.equal(await page.locator('#panel-numbers .figure').nth(1).textContent(), all.toLocaleString('en'));
    assert.equal(await told(page, 'whole', 'size'), '640 \u00d7 480');
    assert.equal(await told(page, 'whole', 'each'), words(all / (640 * 480)));
  }));

test('what the integrator leaves out of the scene is told', () =>
  on.open(async (page) => {
    assert.equal(await told(page, 'whole', 'ignored'), '/fog');
    assert.equal(await page.locator('#panel-numbers .whole .biased').count(), 0);
  }, { at: '/?scene=street-lamp&integrator=whitted&width=32&height=24', panel: 'numbers' }));

test('nothing is drawn while nobody looks', () =>
  shared(async (page) => {
    await page.locator('#tab-light').click();
    await page.evaluate(() => {
      globalThis.changes = 0;
      const watcher = new MutationObserver((list) => (globalThis.changes += list.length));
      watcher.observe(document.getElementById('panel-numbers'),
        { subtree: true, childList: true, attributes: true, characterData: true });
    });
    await light(page, 'd');
    assert.equal(await page.evaluate(() => globalThis.changes), 0);
    await page.locator('#tab-numbers').click();
    await page.waitForFunction(() => globalThis.changes > 0);
  }));

test('whose time it is is said: drawn now, from the server\u2019s cache, or this browser\u2019s own copy', async () => {
  const at = `/?scene=thesis&light=${Date.now() % 100_000},20,-10&threshold=0.02`;
  const source = (page) => page.locator('#panel-numbers .from');
  await on.open(async (page) => {
    await source(page).getByText('Drawn for this request.').waitFor();
    await page.reload();
    await source(page).getByText('This browser had it already').waitFor();
    assert.notEqual(await told(page, 'phases', 'trace'), '0 ms', 'the copy keeps the time of its drawing');
  }, { at, panel: 'numbers' });
  await on.open(async (page) => {
    await source(page).getByText('From the server\u2019s cache').waitFor();
    assert.equal(await told(page, 'phases', 'trace'), '0 ms');
    assert.notEqual(await told(page, 'kinds', 'primary'), '0');
  }, { at, panel: 'numbers' });
});

test('while a hand drags, the chart has a bar for every picture, and says how many come a second', () =>
  on.open(async (page, { pictures: begun, whole }) => {
    const box = await page.locator('#hand').boundingBox();
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 3);
    await page.mouse.down();
    for (let i = 0; i < 25; ++i) await page.mouse.move(box.x + box.width / 3 + 4 * i, box.y + box.height / 3 + i);
    await page.getByText(/^[\d.]+ pictures a second$/).waitFor();
    await page.mouse.up();
    await rest(page);
    const pictures = begun.filter((one) => whole.has(one.request()));
    const count = pictures.length;
    assert.ok(count > 3 && count <= 120, String(count));
    assert.equal(await page.locator('.chart rect').count(), count);
    const states = await Promise.all(pictures.map((one) => one.headerValue('cache-status')));
    const cached = states.filter((it) => it.includes('hit')).length;
    await page.getByText(`${count - cached} drawn`).and(page.locator('.legend .drawn')).waitFor();
    await page.getByText(`${cached} from a cache`).waitFor();
    assert.equal(await page.locator('.chart rect.cached').count(), cached);
    await page.getByRole('img', { name: `The last ${count} pictures: ` }).waitFor();
    await page.getByText('at rest', { exact: true }).waitFor();
  }, { panel: 'numbers' }));

test('a failure is a bar of its own', () =>
  on.open(async (page) => {
    await page.route('**/render?*light=*', (route) => route.abort());
    await page.getByLabel('x', { exact: true }).fill('3');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Try again' }).waitFor();
    await page.locator('#tab-numbers').click();
    await page.getByText('1 failed').waitFor();
    assert.equal(await page.locator('.chart rect.failed').count(), 1);
  }, { panel: 'light', failing: true }));

// Root mean square of what two pictures show.
function apart(a, b) {
  const [left, right] = [a, b].map((bytes) => pixelsOf(bytes).data);
  return Math.sqrt(left.reduce((sum, code, i) => sum + (code - right[i]) ** 2, 0) / left.length) / 255;
}

test('what is drawn by chance comes in rounds, the last the picture itself; their errors are beside their times', () =>
  on.open(async (page, { asked, pictures, whole }) => {
    const samplesOf = (url) => new URL(url).searchParams.get('samples');
    assert.deepEqual([...new Set(asked.map((request) => samplesOf(request.url())))], ['1', '4', '16', '64']);
    assert.equal(addressOf(page), AT.slice(1));
    const [four, sixteen, all] = await Promise.all([4, 16, 64].map((samples) =>
      on.tia.get(`/render${addressOf(page)}`.replace('samples=64', `samples=${samples}`))));
    assert.ok(await shows(page, all));
    const percent = (error) => `${(100 * error).toLocaleString('en', { maximumSignificantDigits: 2 })} %`;
    const errors = [[four, 4], [sixteen, 16]].map(([round, n]) => apart(round, all) / Math.sqrt(1 - n / 64));
    const times = await Promise.all(['4', '16', '64'].map((samples) => pictures
      .find((one) => samplesOf(one.url()) === samples && whole.has(one.request())).headerValue('server-timing')));
    const rows = [...errors, errors[1] / 2].map((error, i) => [`${4 ** (i + 1)}`,
      `${words(entries(times[i]).find(([name]) => name === 'trace')[1])} ms`, `${i === 2 ? '\u2248 ' : ''}${percent(error)}`]);
    await page.locator('#panel-numbers tr').nth(3).waitFor();
    assert.deepEqual(await page.locator('#panel-numbers tr').evaluateAll((all) =>
      all.slice(1).map((row) => [...row.cells].map((cell) => cell.textContent))), rows);
    assert.equal(await page.getByRole('img', { name: 'Error against time' }).locator('circle').count(), 3);
    assert.equal(await page.locator('.errors .expected').count(), 1);
    assert.deepEqual(await faults(page, '#panel-numbers'), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));

    // What a budget comes to is named by its samples: so is the picture that the address is to give again.
    await page.goto(`${on.tia.base}${AT.replace('samples=64', 'max_rays=90000')}`);
    await page.waitForURL(/samples=16$/);
    assert.ok(await shows(page, sixteen));
  }, { at: AT, panel: 'numbers', viewport: { width: 320, height: 800 } }));

test('rounds take a third of the time of the last, and are none of a budget', () => {
  for (const samples of [1, 2, 3, 4, 7, 32, 48, 64, 1000, 65536]) {
    const before = roundsBefore(samples);
    assert.ok(before.reduce((sum, each) => sum + each, 0) <= samples / 3, `${samples}: ${before}`);
    assert.ok([...before, samples].every((each, i, all) => i === 0 || each <= 8 * all[i - 1]));
  }
  const wish = { integrator: 'path', noise: 0.1, width: 64, height: 48 };
  const round = (samples) =>
    ({ ...wish, samples, threshold: 0, noise: null, denoise: null, budget_ms: null, max_rays: null });
  assert.deepEqual(roundAfter({ ...round(1), width: 32, height: 24 }, wish, 4096, 0.1), round(2));
  assert.deepEqual(roundAfter(round(2), wish, 4096, 0.1), round(8));
  assert.equal(roundAfter(round(8), wish, 4096, 0.1), null);
  assert.equal(roundAfter(round(1), { ...wish, budget_ms: 100 }, 32), null);
});

// Values around 0 of variance 1 by a seed: the sums of twelve even ones (G. Marsaglia, 1964, has better).
function chance(seed) {
  const even = () => {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    return seed / 2 ** 32;
  };
  return () => Array.from({ length: 12 }, even).reduce((sum, each) => sum + each, -6);
}

test('the error told of a round of independent samples is theirs, though what it is held against has noise too', async () => {
  const [deviation, pixels, value] = [20, 30_000, chance(7)];
  const counts = [4, 16, 64];
  const means = Array.from({ length: 4 * pixels }, () => {
    let [sum, before] = [0, 0];
    return counts.map((count) => {
      sum += Math.sqrt(count - before) * value();
      before = count;
      return 128 + (deviation * sum) / count;
    });
  });
  const rounds = counts.map((samples, i) => ({ samples, ms: 3 * samples, blob: i }));
  const errors = await errorsOf(rounds, async (i) => means.map((each) => each[i]));
  for (const { samples, error } of errors) {
    const right = deviation / 255 / Math.sqrt(samples);
    assert.ok(Math.abs(error / right - 1) < 4 / Math.sqrt(2 * 3 * pixels), `${samples}: ${error}, ${right}`);
  }
  assert.ok(Math.abs(slopeOf(errors.map(({ ms, error }) => [ms, error])) + 0.5) < 0.01);
  assert.ok(Math.abs(slopeOf([1, 3, 7].map((x) => [x, 5 * x ** -0.7])) + 0.7) < 1e-12);
});

test('pictures a second are the gaps of the last second; failures count for none', () => {
  const drawn = (...times) => times.map((at) => ({ at, kind: 'drawn' }));
  assert.equal(rateOf(drawn(0, 100, 200, 300), 300), 10);
  assert.equal(rateOf(drawn(0, 1500, 1550), 1600), 20);
  assert.equal(rateOf([...drawn(0, 500), { at: 510, kind: 'failed' }], 600), 2);
  assert.equal(rateOf(drawn(0), 0), null);
  assert.equal(rateOf(drawn(0, 100), 1200), null);
  assert.equal(median([5, 1, 3]), 3);
  assert.equal(median([4, 1, 3, 2]), 2.5);
});

test('the last 120 pictures are remembered, no more', () => {
  const pace = new Pace();
  for (let i = 0; i < 130; ++i) pace.add({ at: i, ms: i, kind: i % 10 ? 'drawn' : 'cached' });
  assert.deepEqual([pace.last.length, pace.last[0].at, pace.counts], [120, 10, { drawn: 108, cached: 12, failed: 0 }]);
});
