// The page for everyone: keyboard alone, keys that keep out of the way, narrow screens, both
// themes, the accessibility rules that a machine can check.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { STATUS, faults, startAgain, told } from './page.mjs';
import { HANG_UP } from './proxy.mjs';
import { stage } from './stage.mjs';

const { look, proxied, shared: sharing } = stage();
const shared = sharing(async (page) => {
  await page.locator('#letters').selectOption('picture');
  await startAgain(page);
});

// Puts the light far by a press on the picture: what was asked before it has been asked by then.
async function settle(page) {
  await page.locator('#hand').focus();
  await page.keyboard.press('w');
  await told(page, STATUS.w);
}

const keysOf = (asked) => [...new Set(asked.map((path) => new URLSearchParams(path.split('?')[1]).get('key')))];

test('letter keys and Escape do nothing while the picture is without focus', () =>
  shared(async (page, { asked }) => {
    await page.getByRole('button', { name: 'Start again' }).focus();
    for (const key of ['d', 's', 'Escape']) await page.keyboard.press(key);
    await settle(page);
    assert.deepEqual(keysOf(asked), ['a', 'w']);
  }));

test('letters can work everywhere, or be switched off, and the wish is remembered', () =>
  look(async (page) => {
    const letters = page.getByLabel('Letters A D S W and Esc');
    await letters.selectOption('everywhere');
    await page.getByRole('button', { name: 'Start again' }).focus();
    await page.keyboard.press('d');
    await told(page, STATUS.d);
    await page.reload();
    await told(page, STATUS.d);
    assert.equal(await letters.inputValue(), 'everywhere');
    await letters.selectOption('off');
    await page.locator('#hand').focus();
    await page.keyboard.press('s');
    await page.getByRole('button', { name: 'left', exact: true }).click();
    await told(page, STATUS.a);
  }));

test('letters typed into a field are text, where they work everywhere too', () =>
  shared(async (page, { asked }) => {
    await page.getByLabel('Letters A D S W and Esc').selectOption('everywhere');
    await page.getByLabel('x', { exact: true }).fill('');
    await page.getByLabel('x', { exact: true }).pressSequentially('adsw');
    assert.equal(await page.getByLabel('x', { exact: true }).inputValue(), 'adsw');
    await settle(page);
    assert.deepEqual(keysOf(asked), ['a', 'w']);
  }));

test('keys with Control, Alt or Meta belong to the browser; capitals act like letters', () =>
  shared(async (page, { asked }) => {
    for (const key of ['Control+s', 'Alt+w', 'Meta+s']) await page.keyboard.press(key);
    await page.keyboard.press('D');
    await told(page, STATUS.d);
    assert.deepEqual(keysOf(asked), ['a', 'd']);
  }));

test('Tab alone reaches every control, the picture among the first', () =>
  shared(async (page) => {
    await page.locator('.skip').focus();
    const reached = [];
    for (let name = ''; !reached.includes(name) || !name; ) {
      if (name) reached.push(name);
      await page.keyboard.press('Tab');
      name = await page.evaluate(() => {
        const it = document.activeElement;
        return it === document.body ? 'end' : it.id || it.dataset.tool || it.dataset.key || it.name || it.getAttribute('aria-label') || it.textContent;
      });
      if (name === 'end' || reached.length > 200) break;
    }
    for (const name of ['lamp', 'start-again', 'hand', 'tab-light', 'a', 'd', 's', 'w', 'Escape', 'x', 'y', 'z',
      'copy-light', 'letters', 'language'])
      assert.ok(reached.includes(name), `${name} of ${reached}`);
    assert.ok(reached.indexOf('hand') < reached.indexOf('tab-light'));
  }));

test('what has focus shows it', () =>
  shared(async (page) => {
    for (const id of ['#hand', '[data-key=a]', '#letters', '[name=x]', '#tab-light']) {
      await page.locator(id).focus();
      await page.keyboard.press('Shift');
      assert.match(await page.locator(id).evaluate((it) => getComputedStyle(it).outline), /solid 3px/, id);
    }
  }));

test('from 320 to 2560 px nothing scrolls sideways, in no panel, nor with a long error', () =>
  proxied(async (page, proxy) => {
    const fits = async (what) => {
      for (const width of [2560, 1280, 768, 360, 320]) {
        await page.setViewportSize({ width, height: 740 });
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${what}, ${width} px`);
      }
    };
    const tabs = await page.getByRole('tab').all();
    assert.ok(tabs.length > 5);
    for (const tab of tabs) {
      await tab.click();
      await fits(await tab.innerText());
    }
    const detail = 'x'.repeat(400);
    const headers = { 'Content-Type': 'application/problem+json' };
    proxy.always = { status: 422, headers, body: JSON.stringify({ title: 'No', detail }) };
    await page.locator('#hand').focus();
    await page.keyboard.press('d');
    await page.getByText(detail).waitFor();
    await fits('a long error');
  }, { failing: true }));

test('at 360 px the picture comes first', () =>
  look(async (page) => {
    const picture = await page.locator('#picture').boundingBox();
    assert.ok(picture.y < 320 && picture.width >= 320, JSON.stringify(picture));
  }, { viewport: { width: 360, height: 740 } }));

for (const width of [1280, 360]) {
  test(`a card of the gallery that is hovered or focused shows all its words and moves nothing, ${width} px`, () =>
    look(async (page) => {
      const cards = page.locator('.thumbs li');
      await cards.first().waitFor();
      const heights = () => cards.evaluateAll((all) => [...all.map((it) => it.offsetHeight), document.documentElement.scrollHeight]);
      const still = await heights();
      // The one with most to say.
      const longest = await cards.evaluateAll((all) => {
        const lengths = all.map((it) => it.querySelector('.note').textContent.length);
        return lengths.indexOf(Math.max(...lengths));
      });
      const card = cards.nth(longest);
      const isWhole = () => card.locator('.note').evaluate((it) => it.scrollHeight <= it.clientHeight);
      assert.ok(!await isWhole());
      await card.hover();
      assert.ok(await isWhole());
      assert.deepEqual(await heights(), still);
      await page.mouse.move(0, 0);
      await card.getByRole('button').focus();
      assert.ok(await isWhole());
      assert.deepEqual(await heights(), still);
    }, { viewport: { width, height: 740 } }));
}

for (const [colorScheme, locale] of [['light', 'en-GB'], ['dark', 'vi-VN']]) {
  test(`axe finds nothing in the ${colorScheme} theme, ${locale}: as it came, and in trouble`, () =>
    proxied(async (page, proxy) => {
      assert.equal(await page.locator('html').getAttribute('lang'), locale.slice(0, 2));
      assert.deepEqual(await faults(page), []);
      proxy.always = HANG_UP;
      await page.locator('#hand').focus();
      await page.keyboard.press('d');
      await page.locator('#retry').waitFor();
      assert.deepEqual(await faults(page), []);
    }, { colorScheme, locale, reducedMotion: 'reduce', failing: true }));
}

test('every sentence of the page is there in every language', () =>
  shared(async (page) => {
    const [english, vietnamese] = await page.evaluate(() => Promise.all(['en', 'vi'].map(async (language) => {
      const later = [...document.querySelectorAll('template[data-panel]')].map(({ dataset }) => `${dataset.panel}_${language}`);
      const parts = await Promise.all([language, ...later].map((name) => import(`/words/${name}.js`)));
      const words = Object.assign({}, ...parts.map((part) => part.default));
      const gaps = (text) => [...text.matchAll(/\{\w+\}/g)].map(String).sort().join();
      return Object.entries(words).flatMap(([section, all]) =>
        Object.entries(all).map(([key, text]) => `${section}.${key} ${gaps(text)}`)).sort();
    })));
    assert.deepEqual(vietnamese, english);
  }));

test('the language can be chosen, and stays chosen', () =>
  look(async (page) => {
    await page.getByLabel('Language').selectOption('vi');
    await told(page, '\u0110\u00e8n b\u00ean tr\u00e1i, t\u1ea1i -20, 20, -10.');
    await page.reload();
    await told(page, '\u0110\u00e8n b\u00ean tr\u00e1i, t\u1ea1i -20, 20, -10.');
    assert.equal(await page.locator('html').getAttribute('lang'), 'vi');
  }));

for (const [reducedMotion, still] of [['reduce', true], ['no-preference', false]]) {
  test(`waiting ${still ? 'does not move' : 'moves'} where the wish about motion is ${reducedMotion}`, () =>
    proxied(async (page, proxy) => {
      proxy.hold();
      await page.keyboard.press('d');
      await page.locator('#frame.waiting').waitFor();
      assert.equal(await page.evaluate(() => document.getAnimations().length === 0), still);
      proxy.release();
      await told(page, STATUS.d);
    }, { reducedMotion }));
}
