// The rays of "Why this colour?": stepping through them, where they are drawn, and that they follow
// the lamp.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults } from './page.mjs';
import { because, clickPixel, explained, pixelShown, whyStage } from './why_stage.mjs';

const on = whyStage();
const SHADOWED = [480, 450]; // of key a: the ball keeps the lamp's light from the floor
const buttons = (page) => page.locator('.steps button');
const current = (page) => page.locator('.steps [aria-current=step] .number').innerText();

// ---- where they are drawn, worked out here ----------------------------------------------------

const HALF = Math.tan((12.5 * Math.PI) / 180); // of thesis' camera at the origin, towards -z
const LAMP = [-20, 20, -10];
const add = (a, b, s = 1) => a.map((value, i) => value + s * b[i]);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const unit = (a) => a.map((value) => value / Math.hypot(...a));
const inPicture = ([x, y, z]) => [320 + (240 * x) / (-z * HALF), 240 - (240 * y) / (-z * HALF)];

function meetsSphere(from, way, center, radius) {
  const out = add(from, center, -1);
  const half = dot(out, way);
  return -half - Math.sqrt(half * half - dot(out, out) + radius * radius);
}

function shadowOf([x, y]) {
  const way = unit([((2 * x + 1) / 480 - 640 / 480) * HALF, (1 - (2 * y + 1) / 480) * HALF, -1]);
  const floor = add([0, 0, 0], way, meetsSphere([0, 0, 0], way, [0, -10004, -20], 10000));
  const toLamp = unit(add(LAMP, floor, -1));
  const blocked = add(floor, toLamp, meetsSphere(floor, toLamp, [0, 0, -20], 4));
  return { floor: inPicture(floor), blocked: inPicture(blocked) };
}

const drawn = (page, kind) => page.locator(`#overlay [data-kind=${kind}]`).first().evaluate((ray) => {
  const ends = (line) => ['x1', 'y1', 'x2', 'y2'].map((name) => Number(line.getAttribute(name)));
  return { core: ends(ray.querySelector('.core')), rest: ray.querySelector('.rest') && ends(ray.querySelector('.rest')),
    current: ray.classList.contains('current') };
});
const near = (is, wanted) => assert.ok(Math.hypot(is[0] - wanted[0], is[1] - wanted[1]) < 0.1, `${is} is not ${wanted}`);

test('the ray from the eye ends at the pixel, the shadow ray where the ball is in its way', () =>
  on.ask(`?key=a&pixel=${SHADOWED}`, async (page) => {
    await explained(page, SHADOWED);
    const { floor, blocked } = shadowOf(SHADOWED);
    const { core } = await drawn(page, 'primary');
    near(core.slice(2), [480.5, 450.5]);
    const shadow = await drawn(page, 'shadow');
    near(shadow.core.slice(0, 2), floor);
    near(floor, [480.5, 450.5]);
    near(shadow.core.slice(2), blocked);
    near(shadow.rest.slice(0, 2), blocked);
    const [dx, dy] = [shadow.rest[2] - blocked[0], shadow.rest[3] - blocked[1]];
    const lamp = inPicture(LAMP);
    assert.ok(Math.abs(dx * (lamp[1] - blocked[1]) - dy * (lamp[0] - blocked[0])) < 1e-3 * Math.hypot(dx, dy) * Math.hypot(...lamp),
      'the rest goes on towards the lamp');
  }));

test('keys step through the rays, one at a time, and the picture shows which', () =>
  on.ask('?scene=whitted&pixel=300,240', async (page) => {
    await explained(page, [300, 240]);
    const all = await buttons(page).count();
    assert.ok(all > 10);
    await buttons(page).first().focus();
    const steps = [['ArrowDown', 2], ['j', 3], ['ArrowRight', 4], ['k', 3], ['ArrowUp', 2], ['ArrowLeft', 1],
      ['ArrowLeft', 1], ['End', all], ['j', all], ['Home', 1]];
    for (const [key, number] of steps) {
      await page.keyboard.press(key);
      assert.equal(await current(page), String(number), key);
      assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-current')), 'step');
      assert.equal(await page.locator('.walk .count').innerText(), `${number} of ${all}`);
      assert.equal(await page.locator('#overlay .current').count(), 1);
      const kind = await page.locator('.detail .sample').getAttribute('class');
      assert.ok(kind.includes(`ray-${await page.locator('#overlay .current').getAttribute('data-kind')}`));
    }
    await page.getByRole('button', { name: 'Next ray' }).focus();
    await page.keyboard.press('Enter');
    assert.match(await page.locator('.walk [role=status]').innerText(), /^Ray 2 of \d+\. Mirrored by the glass ball/);
  }));

test('a term leads to the ray that brings it', () =>
  on.ask('?scene=whitted&pixel=300,240', async (page) => {
    await explained(page, [300, 240]);
    await page.locator('.sum').getByRole('button', { name: 'Ray 2' }).click();
    assert.equal(await current(page), '2');
    assert.match(await page.locator('.detail').innerText(), /Counts × 0\.0433 in ray 1\./);
  }));

test('the keyboard alone asks, and Escape in the panel ends it', () =>
  on.ask('?key=a', async (page) => {
    await page.locator('#frame[aria-busy=false]').waitFor();
    await page.locator('#hand').focus();
    await page.keyboard.press('Enter');
    await explained(page, [320, 240]);
    await buttons(page).first().focus();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Ask about the middle' }).and(page.locator(':focus')).waitFor();
    assert.equal(await page.locator('#overlay .rays > *').count(), 0);
    await page.waitForURL((url) => !url.search.includes('pixel'));
    assert.match(page.url(), /key=a/, 'the lamp is still on');
    await page.keyboard.press('Enter');
    await explained(page, [320, 240]);
  }));

test('the explanation follows the lamp while it is dragged, and ends where the lamp does', () =>
  on.ask('?key=a', async (page) => {
    await page.locator('#frame[aria-busy=false]').waitFor();
    const pixel = [320, 200];
    await clickPixel(page, pixel);
    const first = await because(page);
    assert.match(first, /lit by the lamp at \d+ %/);
    const box = await page.locator('#hand').boundingBox();
    const move = (x, y) => page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    const changed = (from) => page.waitForFunction((old) => document.querySelector('.because').innerText !== old, from);
    await move(0.35, 0.4);
    await page.mouse.down();
    await move(0.4, 0.4);
    await changed(first);
    const second = await because(page);
    await move(0.5, 0.7);
    await changed(second);
    await move(0.42, 0.38);
    await page.mouse.up();
    await page.waitForURL((url) => url.searchParams.has('light'));
    await page.locator('#frame[aria-busy=false]').waitFor();
    const light = new URL(page.url()).searchParams.get('light');
    const { tree } = await on.json(`/explain?light=${light}&x=320&y=200`);
    const { n_dot_l: cosine, visible } = tree.terms.at(-1);
    assert.ok(cosine > 0 && visible === 1);
    await page.waitForFunction((wanted) => document.querySelector('.sum .formula').innerText.includes(wanted), `= ${cosine.toFixed(4)}.`);
    assert.match(await because(page), new RegExp(`at ${Math.round(100 * cosine)} %`));
    const [r, g, b] = await pixelShown(page, pixel);
    assert.equal(await page.locator('.codes').innerText(), `red ${r}, green ${g}, blue ${b} of 255`);
  }));

// ---- for everyone -----------------------------------------------------------------------------

for (const [colorScheme, locale] of [['light', 'en-US'], ['dark', 'vi-VN']]) {
  test(`axe finds nothing, at 320 px nothing scrolls sideways: ${colorScheme}, ${locale}`, () =>
    on.ask('?scene=whitted&pixel=300,240', async (page) => {
      await page.locator('.because').waitFor();
      await page.locator('.hits summary').click();
      for (const ray of [0, 1, 2]) {
        await buttons(page).nth(ray).click();
        assert.deepEqual(await faults(page, '#panel-why'), []);
      }
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      const small = await page.locator('#panel-why button').evaluateAll((all) =>
        all.filter((it) => Math.min(it.offsetWidth, it.offsetHeight) < 24).map((it) => it.outerHTML));
      assert.deepEqual(small, []);
    }, { colorScheme, locale, viewport: { width: 320, height: 740 } }));
}
