// The laboratory's panels for everyone: what a machine can check of accessibility, narrow screens,
// the keyboard.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults, lab } from './lab.mjs';

const on = lab();
const fits = (page) => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

// Each panel with all of it in sight.
const SIGHTS = {
  compare: async (page) => {
    await page.locator('#panel-compare > button').first().click();
    await page.locator('#compare .half img').waitFor();
    await page.locator('input[value=difference]').check();
    await page.locator('#compare canvas').waitFor();
  },
  timeline: async (page) => {
    await page.locator('.add-form .add').click();
    await page.locator('.key-form:not([hidden])').waitFor();
    await page.locator('.fall summary').click();
    await page.locator('.bodies select').first().selectOption('falls');
    await page.locator('.film summary').click();
    await page.locator('.film option[value=zip]').waitFor({ state: 'attached' });
  },
  radio: async (page) => {
    await page.locator('.radio-list tbody tr').first().waitFor();
    await page.locator('.radio-legend .ticks span').first().waitFor();
    await page.locator('.radio-charts summary').click();
  },
  numbers: (page) => page.locator('.chart rect').first().waitFor({ state: 'attached' }),
  take: async (page) => {
    await page.locator('input[name=samples]').fill('0');
    await page.keyboard.press('Tab');
    await page.locator('#take-fault:not(:empty)').waitFor();
  },
};

const VIEWS = [['light', 'en-US', 1280], ['dark', 'vi-VN', 320]];

for (const [colorScheme, locale, width] of VIEWS) {
  test(`axe finds nothing and nothing scrolls sideways: ${colorScheme}, ${locale}, ${width} px`, () =>
    on.open(async (page) => {
      for (const [panel, sight] of Object.entries(SIGHTS)) {
        await page.locator(`#tab-${panel}`).click();
        await sight(page);
        assert.deepEqual(await faults(page), [], panel);
        assert.ok(await fits(page), panel);
      }
    }, { colorScheme, locale, viewport: { width, height: 800 }, reducedMotion: 'reduce' }));
}

test('the keyboard alone keeps a picture, compares it, and takes it along', () =>
  on.open(async (page) => {
    const key = async (...keys) => {
      for (const one of keys) await page.keyboard.press(one);
    };
    await page.locator('#tab-light').focus();
    await key(...Array(6).fill('ArrowRight'));
    await page.getByRole('button', { name: 'Keep this picture as A' }).waitFor();
    await key('Tab', 'Enter');
    await page.locator('#compare .half img').waitFor();
    await page.getByRole('radio', { name: 'A', exact: true }).focus();
    await key('ArrowRight');
    await page.locator('#compare .half img[alt="directions"]').waitFor();
    await key('Tab', 'ArrowRight');
    assert.match(await page.getByRole('slider').getAttribute('aria-valuetext'), /^5[1-9] % from the left$|^60 %/);
    await page.locator('#tab-compare').focus();
    await key('End', 'Tab');
    const coming = page.waitForEvent('download');
    await key('Enter');
    assert.equal((await coming).suggestedFilename(), 'tia-thesis-a.png');
  }));
