// "Why this colour?" where light goes along paths: over what it came, and single paths, one by one.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, until } from './page.mjs';
import { because, explained, whyStage } from './why_stage.mjs';

const on = whyStage();
const PIXEL = [16, 40]; // the floor beside the red wall
const WHAT = 'scene=cornell-light&width=64&height=48';
const told = () => on.json(`/explain?${WHAT}&threshold=0&samples=256&paths=16&x=${PIXEL[0]}&y=${PIXEL[1]}`);
const brings = ({ value }) => value.some((part) => part > 0);

test('the sentence names what light came over; paths are stepped through, drawn in the picture and the plans', () =>
  on.ask(`?${WHAT}&samples=2&pixel=${PIXEL}`, async (page) => {
    await explained(page, PIXEL);
    const { over, samples } = await told();
    const names = { left: 'the left (red)', right: 'the right (green)' };
    const nameOf = ({ object }) => names[object] ?? `the ${object} (white)`;
    const share = (part) => `${Math.round(100 * part.share)} %`;
    assert.ok((await because(page)).includes(`${share(over[0])} of this light came over ${nameOf(over[0])}`), await because(page));
    assert.ok(over.some(({ object }) => object === 'left'));
    await page.locator('.over').getByText(`${share(over[0])} over ${nameOf(over[0])}`).waitFor();

    await until(async () => await page.locator('.map .handle').count() > 0, 'the plans');
    const next = page.getByRole('button', { name: 'Next path' });
    await next.focus();
    for (const [key, at] of [['ArrowRight', 1], ['Enter', 2], ['ArrowLeft', 1], ['Home', 0], ['ArrowUp', 0], ['End', 15]]) {
      await page.keyboard.press(key);
      assert.equal(await page.locator('.walk .count').innerText(), `${at + 1} of 16`, key);
      const { vertices } = samples[at];
      const rays = vertices.length + vertices.flatMap(({ lights }) => lights).filter((one) => one.asked && brings(one)).length;
      assert.equal(await page.locator('#overlay .ray').count(), rays);
      await until(async () => await page.locator('.map').first().locator('.ray').count() === rays, 'the plan\u2019s rays');
      assert.equal(await page.locator('.path li').count(), vertices.length);
    }
    assert.match(await page.locator('.walk [role=status]').textContent(), /^Path 16 of 16\. It brings (no )?light/);
    const ends = await page.locator('#overlay [data-kind=primary] .core').evaluate((it) => [it.getAttribute('x2'), it.getAttribute('y2')].map(Number));
    assert.ok(Math.hypot(ends[0] - PIXEL[0] - 0.5, ends[1] - PIXEL[1] - 0.5) < 1, `${ends}`); // within its pixel
    assert.deepEqual(await faults(page, '#panel-why'), []);
  }));

test('at 320 px, in Vietnamese, axe finds nothing and nothing scrolls sideways', () =>
  on.ask(`?${WHAT}&samples=2&pixel=${PIXEL}`, async (page) => {
    await page.locator('.path li').first().waitFor();
    assert.match(await because(page), /ánh sáng này đến qua/);
    assert.deepEqual(await faults(page, '#panel-why'), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }, { colorScheme: 'dark', locale: 'vi-VN', viewport: { width: 320, height: 740 } }));
