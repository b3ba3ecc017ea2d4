// The page for everyone: keyboard alone, keys that keep out of the way, narrow screens, both
// themes, the accessibility rules that a machine can check.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import axe from 'axe-core';
import { STATUS, told } from './page.mjs';
import { HANG_UP } from './proxy.mjs';
import { stage } from './stage.mjs';

const { look, proxied } = stage();
const everywhere = (page) => page.getByRole('checkbox', { name: 'Keys work everywhere on the page' });

// Puts the light far by a press on the picture: what was asked before it has been asked by then.
async function settle(page) {
  await page.locator('#picture').focus();
  await page.keyboard.press('w');
  await told(page, STATUS.w);
}

test('letter keys and Escape do nothing while the picture is without focus', () =>
  look(async (page, { asked }) => {
    await page.getByRole('button', { name: 'Copy the curl line' }).focus();
    for (const key of ['a', 'd', 's', 'Escape']) await page.keyboard.press(key);
    await settle(page);
    assert.deepEqual(asked, ['/render', '/render?key=w']);
  }));

test('with the box ticked keys work everywhere, and the wish is remembered', () =>
  look(async (page, { asked }) => {
    await everywhere(page).check();
    await page.keyboard.press('a');
    await told(page, STATUS.a);
    await page.getByRole('button', { name: 'Copy the curl line' }).focus();
    await page.keyboard.press('d');
    await told(page, STATUS.d);
    await page.reload();
    await told(page, STATUS.Escape);
    assert.ok(await everywhere(page).isChecked());
    await page.locator('#picture').blur();
    await page.keyboard.press('s');
    await told(page, STATUS.s);
    await everywhere(page).uncheck();
    await page.keyboard.press('a');
    await settle(page);
    assert.deepEqual(asked.slice(-2), ['/render?key=s', '/render?key=w']);
  }));

test('letters typed into a field are text, with the box ticked too', () =>
  look(async (page, { asked }) => {
    await everywhere(page).check();
    await page.getByLabel('x', { exact: true }).pressSequentially('adsw');
    assert.equal(await page.getByLabel('x', { exact: true }).inputValue(), 'adsw');
    await settle(page);
    assert.deepEqual(asked, ['/render', '/render?key=w']);
  }));

test('keys with Control, Alt or Meta belong to the browser; capitals act like letters', () =>
  look(async (page, { asked }) => {
    for (const key of ['Control+d', 'Alt+a', 'Meta+s']) await page.keyboard.press(key);
    await page.keyboard.press('D');
    await told(page, STATUS.d);
    assert.deepEqual(asked, ['/render', '/render?key=d']);
  }));

test('Tab alone reaches every control, the picture first, and Enter presses it', () =>
  look(async (page) => {
    const focused = () => page.evaluate(() => {
      const { id, name, dataset, textContent } = document.activeElement;
      return document.activeElement === document.body ? null : id || name || dataset.key || textContent;
    });
    const reached = [];
    for (let name = await focused(); name && !reached.includes(name); name = await focused()) {
      reached.push(name);
      await page.keyboard.press('Tab');
    }
    assert.deepEqual(reached, ['picture', 'w', 'a', 'Escape', 'd', 's', 'everywhere', 'x', 'y', 'z',
      'Move the lamp', 'copy-light', 'copy-curl', 'Documentation']);
    await page.getByRole('button', { name: 'Light to the left' }).focus();
    await page.keyboard.press('Enter');
    await told(page, STATUS.a);
  }));

test('what has focus shows it', () =>
  look(async (page) => {
    for (const id of ['#picture', '[data-key=a]', '#everywhere', '[name=x]', '#copy-curl']) {
      await page.locator(id).focus();
      await page.keyboard.press('Shift');
      assert.match(await page.locator(id).evaluate((it) => getComputedStyle(it).outline), /solid 3px/, id);
    }
  }));

for (const width of [320, 360, 768, 1280]) {
  test(`at ${width} px nothing scrolls sideways, a long error and a long curl line included`, () =>
    proxied(async (page, proxy) => {
      const fits = () => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
      assert.ok(await fits());
      const detail = 'x'.repeat(400);
      const headers = { 'Content-Type': 'application/problem+json' };
      proxy.always = { status: 422, headers, body: JSON.stringify({ title: 'No', detail }) };
      await page.getByLabel('x', { exact: true }).fill('-1.2345678901234567e-100');
      await page.getByLabel('y', { exact: true }).fill('-1.2345678901234567e-100');
      await page.getByLabel('z', { exact: true }).fill('-1.2345678901234567e-100');
      await page.keyboard.press('Enter');
      await page.getByText(detail).waitFor();
      assert.ok(await fits());
    }, { viewport: { width, height: 740 }, failing: true }));
}

test('at 360 px the picture comes first and the keys follow within one screen', () =>
  look(async (page) => {
    const picture = await page.locator('#picture').boundingBox();
    const pad = await page.locator('#pad').boundingBox();
    assert.ok(picture.y < 160 && picture.width >= 320);
    assert.ok(pad.y > picture.y + picture.height && pad.y + pad.height <= 780, JSON.stringify(pad));
  }, { viewport: { width: 360, height: 740 } }));

async function faults(page) {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
}

for (const colorScheme of ['light', 'dark']) {
  for (const width of [360, 1280]) {
    test(`axe finds nothing in the ${colorScheme} theme at ${width} px: unlit, lit, in trouble`, () =>
      proxied(async (page, proxy) => {
        assert.deepEqual(await faults(page), []);
        await page.keyboard.press('a');
        await told(page, STATUS.a);
        assert.deepEqual(await faults(page), []);
        proxy.always = HANG_UP;
        await page.keyboard.press('d');
        await page.getByRole('button', { name: 'Try again' }).waitFor();
        await page.getByLabel('x', { exact: true }).fill('oops');
        await page.keyboard.press('Enter');
        await page.getByText('which is not a number').waitFor();
        assert.deepEqual(await faults(page), []);
      }, { colorScheme, viewport: { width, height: 740 }, reducedMotion: 'reduce', failing: true }));
  }
}

for (const [reducedMotion, still] of [['reduce', true], ['no-preference', false]]) {
  test(`waiting ${still ? 'does not move' : 'moves'} where the wish about motion is ${reducedMotion}`, () =>
    proxied(async (page, proxy) => {
      proxy.hold();
      await page.keyboard.press('a');
      await page.locator('#frame[aria-busy=true]').waitFor();
      assert.equal(await page.evaluate(() => document.getAnimations().length === 0), still);
      proxy.release();
      await told(page, STATUS.a);
    }, { reducedMotion }));
}
