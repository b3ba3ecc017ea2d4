// The page of documentation: reached from the page, readable on any screen and by anyone.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import axe from 'axe-core';
import { stage } from './stage.mjs';

const on = stage();

// Visits the documentation, at a place of it.
const read = (body, options = {}) =>
  on.look(async (page) => {
    await page.goto(`${on.tia.base}/docs${options.place ?? ''}`);
    await body(page);
  }, options);

test('the page leads to it, and it leads back', () =>
  on.look(async (page) => {
    await page.getByRole('link', { name: 'Documentation' }).click();
    await page.getByRole('heading', { level: 1, name: 'Tia documentation' }).waitFor();
    await page.getByRole('link', { name: 'Tia' }).first().click();
    await page.locator('#picture').waitFor();
  }));

for (const width of [320, 768, 1280]) {
  test(`at ${width} px nothing scrolls sideways and nothing is cut off`, () =>
    read(async (page) => {
      const wide = await page.evaluate(() => [...document.querySelectorAll('body *')]
        .filter((it) => it.getBoundingClientRect().right > innerWidth).map((it) => it.outerHTML.slice(0, 80)));
      assert.deepEqual(wide, []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }, { viewport: { width, height: 740 } }));
}

for (const [colorScheme, width] of [['light', 1280], ['dark', 320]]) {
  test(`axe finds nothing in the ${colorScheme} theme at ${width} px`, () =>
    read(async (page) => {
      await page.evaluate(axe.source);
      const { violations } = await page.evaluate(() => globalThis.axe.run(document));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
    }, { colorScheme, viewport: { width, height: 740 } }));
}

test('the contents list every heading of the second level and lead to it', () =>
  read(async (page) => {
    const contents = page.getByRole('navigation', { name: 'Contents' });
    const headings = await page.locator('main h2').allTextContents();
    assert.ok(headings.length >= 5);
    for (const name of headings) {
      await contents.getByRole('link', { name, exact: true }).click();
      const { y } = await page.getByRole('heading', { level: 2, name, exact: true }).boundingBox();
      assert.ok(y >= 0 && y < 740, `${name} at ${y}`);
    }
  }, { viewport: { width: 1280, height: 740 } }));

test("a problem's type, opened as an address, leads to what it means", () =>
  on.look(async (page) => {
    await page.goto(`${on.tia.base}/problems/busy`);
    const meaning = page.locator(':target');
    assert.match(await meaning.textContent(), /\/problems\/busy.*too much to do.*Retry-After/);
    assert.ok((await meaning.boundingBox()).y < 740);
  }, { viewport: { width: 1280, height: 740 } }));

test('Tab comes to a link that skips the contents first', () =>
  read(async (page) => {
    await page.keyboard.press('Tab');
    const skip = page.getByRole('link', { name: 'Skip the contents' });
    assert.ok(await skip.evaluate((it) => it === document.activeElement));
    assert.ok((await skip.boundingBox()).y >= 0);
    await page.keyboard.press('Enter');
    assert.equal(new URL(page.url()).hash, '#requests');
  }));
