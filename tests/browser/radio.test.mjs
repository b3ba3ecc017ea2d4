// The Radio panel: antennas that a hand moves, the server's map under them, and its paths in words and lines.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, lab } from './lab.mjs';
import { until } from './page.mjs';

const on = lab();

// A room whose wall leaves a gap: what is behind it is told by ways around and off other walls.
const box = (name, min, max) => ({ type: 'box', name, min, max });
const ROOM = { camera: { location: [0, 9, 6], look_at: [0, 0, 0], fov_degrees: 40 }, lights: [{ type: 'point', position: [0, 8, 0] }],
  objects: [box('floor', [-4, -0.2, -3], [4, 0, 3]), box('north', [-4, 0, -3.2], [4, 2.6, -3]), box('wall', [-0.1, 0, -3], [0.1, 2.6, 1])] };
const AT = { at: `/?${new URLSearchParams({ scene: JSON.stringify(ROOM), width: 160, height: 120 })}`, panel: 'radio' };

const tell = async (path, asked) => (await fetch(new URL(path, on.tia.base), { method: 'POST', body: JSON.stringify(asked) })).json();
const numbers = (page) => page.locator('.radio-antenna input').evaluateAll((all) => all.map((it) => it.valueAsNumber));

// Opens the panel; `asked` are the bodies of all requests of radio, by path, and `settled()` waits for the newest answers.
const open = (body, options) => on.open(async (page) => {
  const asked = { paths: [], map: [] };
  let under = 0;
  const radio = (request) => /\/radio\/(paths|map)$/.exec(request.url())?.[1];
  page.on('request', (request) => radio(request) && ((under += 1), asked[radio(request)].push(request.postDataJSON())));
  for (const end of ['requestfinished', 'requestfailed']) page.on(end, (request) => radio(request) && (under -= 1));
  const settled = async (wanted) => {
    await until(() => asked.paths.some(wanted) && asked.map.some((one) => wanted(one) && one.cell < 0.2), 'the newest paths and map');
    await until(() => under === 0, 'an answer');
    await page.waitForTimeout(100); // a frame, in which they are drawn
  };
  await page.locator('#tab-light').click(); // what was asked before somebody listened is asked again, with another height
  await page.locator('#tab-radio').click();
  await page.locator('input[name=height]').fill('1.25');
  await page.locator('input[name=height]').press('Tab');
  await page.locator('input[name=max_reflections]').fill('1');
  await page.locator('input[name=max_reflections]').press('Tab');
  await settled((one) => one.max_reflections === 1);
  await body(page, { asked, settled });
}, { ...AT, ...options });

test('the transmitter is dragged: coarse cells first, then the map of its new place, and the server\u2019s paths in the table', () =>
  open(async (page, { asked, settled }) => {
    const mark = page.locator('.map .handle-transmitter').first();
    await mark.scrollIntoViewIfNeeded();
    const image = () => page.locator('.radio-map').first().getAttribute('href');
    const [{ x, y, width, height }, before, there] = [await mark.boundingBox(), await numbers(page), await image()];
    const [maps, sheet] = [asked.map.length, await page.locator('.map svg').first().boundingBox()];
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    for (let step = 1; step <= 5; ++step) await page.mouse.move(x + width / 2, y + height / 2 + 6 * step);
    await page.mouse.up();
    const now = await numbers(page);
    await settled(({ transmitters: [{ position }] }) => String(position) === String(now.slice(0, 3)));
    // As far in the room as the pointer has gone in the plan.
    const { area, cell } = asked.map.at(-1);
    assert.ok(Math.abs(now[2] - before[2] - (30 * (area[3] - area[1])) / sheet.height) < 0.02, `${before} ${now}`);
    assert.ok(Math.abs(before[0] - now[0]) < 0.02);
    assert.ok(asked.map.at(maps).cell > 5 * cell, 'the first is coarse');
    assert.notEqual(await image(), there);

    const { pairs: [{ paths, total }] } = await tell('/radio/paths', asked.paths.at(-1));
    const rows = await page.locator('.radio-list tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].slice(1).map((cell) => Number(cell.textContent.replaceAll(',', '')))));
    assert.equal(rows.length, paths.length);
    for (const [i, { delay_s, length_m, gain_db }] of paths.entries())
      for (const [k, value] of [delay_s * 1e9, length_m, gain_db].entries()) assert.ok(Math.abs(rows[i][k] / value - 1) < 1e-3, `${rows[i]}`);
    assert.match(await page.locator('#panel-radio .told').textContent(), new RegExp(`: ${paths.length}\\. Together ${Number(total.incoherent_db.toFixed(1))} dB`));
    // In the plan as in the picture, each with all its points.
    for (const place of ['.map .waves', '#overlay .waves'])
      assert.equal(await page.locator(place).first().locator('.core').count(), paths.reduce((sum, { points }) => sum + points.length - 1, 0));
  }));

test('keys move antennas and the probe, whose value is told; the legend has the colours and numbers of the map', () =>
  open(async (page, { asked, settled }) => {
    const before = await numbers(page);
    await page.getByRole('button', { name: 'Rx 1, in the picture' }).press('Shift+ArrowRight');
    const now = await numbers(page);
    assert.ok(now[3] > before[3] && now[4] === before[4] && Math.abs(now[5] - before[5]) < 0.05, `${before} ${now}`);
    await settled(({ receivers }) => !receivers || receivers[0].position[0] === now[3]);

    const map = await tell('/radio/map', { ...asked.map.at(-1), format: 'json' });
    const probe = page.getByRole('button', { name: /^Probe of the map/ });
    for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp']) await probe.press(key);
    const [, x, z, value] = /^At (\S+), (\S+): (\S+) dB$/.exec(await page.locator('#said').textContent()).map(Number);
    const near = [-0.01, 0.01].flatMap((by) => map.values[Math.floor((z + by - map.area[1]) / map.cell)][Math.floor((x + by - map.area[0]) / map.cell)]);
    assert.ok(near.some((one) => Math.abs(one - value) < 0.06), `${near} ${value}`);

    const all = map.values.flat().filter((one) => one !== null).sort((a, b) => a - b);
    const [low, high] = [3 * Math.floor(all[Math.floor(all.length / 50)] / 3), 3 * Math.floor(all.at(-1) / 3) + 3];
    const { colours, ticks, pixels } = await page.evaluate(async () => {
      const bar = document.querySelector('.radio-legend .bar');
      const image = new Image();
      image.src = document.querySelector('.radio-map').getAttribute('href');
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      return { colours: getComputedStyle(bar).backgroundImage.match(/rgb\([^)]*\)/g).filter((_, i) => i % 2), pixels: [...context.getImageData(0, 0, image.width, image.height).data],
        ticks: [...document.querySelectorAll('.radio-legend .ticks span')].map((it) => [it.textContent, parseFloat(it.style.left)]) };
    });
    assert.equal(colours.length, (high - low) / 3);
    assert.ok(ticks.length > 2);
    for (const [words, left] of ticks) assert.ok(Math.abs(low + (left / 100) * (high - low) - parseFloat(words)) < 1e-3, words);
    for (const [i, one] of map.values.flat().entries()) {
      const band = Math.max(0, Math.floor((one - low) / 3));
      assert.equal(`rgb(${pixels.slice(4 * i, 4 * i + 3).join(', ')}) ${pixels[4 * i + 3]}`, one === null ? 'rgb(0, 0, 0) 0' : `${colours[band]} 255`);
    }
  }));

test('an antenna in the floor is told as a problem, until it is in the air again; methods are held side by side', () =>
  open(async (page) => {
    const height = page.getByLabel('Tx 1, y');
    await height.fill('-0.1');
    await height.press('Tab');
    await page.locator('#problem').getByText('a place in the air; this one is in, behind or on floor').waitFor();
    await height.fill('1.75');
    await height.press('Tab');
    await page.locator('#problem:empty').waitFor({ state: 'attached' });
    await page.getByText('What each method finds and misses').click();
    await page.locator('.radio-scroll tbody tr').nth(2).waitFor();
    const rows = await page.locator('.radio-scroll tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
    const ways = await page.locator('.radio-list tbody tr').count();
    assert.deepEqual(rows.slice(0, 2).map(([, found, missed]) => [found, missed]), [[`${ways}`, '0'], [`${ways}`, '0']]);
    assert.deepEqual(await faults(page, '#panel-radio'), []);
  }, { failing: true }));
