// The lamp by keys, buttons and numbers, and that the picture is the server's own.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { STATUS, addressOf, pathOf, rests, shows, startAgain, told } from './page.mjs';
import { stage } from './stage.mjs';

const BUTTONS = {
  a: 'left',
  d: 'right',
  s: 'Light above, near',
  w: 'Light above, far',
  Escape: 'off',
};

const on = stage();
const { look } = on;
const shared = on.shared(startAgain);

// Does `action`; then the page says `words`, asked for `path` and shows its very pixels.
async function endsOn(page, asked, action, path, words) {
  await action();
  await told(page, words);
  assert.equal(asked.at(-1), path);
  assert.equal(`/render${addressOf(page)}`, path, 'the address is the picture');
  assert.ok(await shows(page, await on.tia.get(path)), 'the very pixels');
  assert.ok((await page.locator('#picture').getAttribute('aria-label')).includes(words));
}

const lightPath = (light) => `/render?scene=thesis&light=${light}&threshold=0.02`;

async function type(page, x, y, z) {
  await page.getByLabel('x', { exact: true }).fill(x);
  await page.getByLabel('y', { exact: true }).fill(y);
  await page.getByLabel('z', { exact: true }).fill(z);
}

const fields = (page) => page.locator('#light input').evaluateAll((all) => all.map((it) => it.value));
const fieldsAre = (page, wanted) => page.waitForFunction((all) =>
  JSON.stringify([...document.querySelectorAll('#light input')].map((it) => it.value)) === all, JSON.stringify(wanted));

test('the page opens lit from the left, with the picture in focus', () =>
  shared(async (page, { asked }) => {
    await told(page, STATUS.a);
    assert.equal(asked.at(-1), pathOf('a'));
    assert.ok(await shows(page, await on.tia.get(pathOf('a'))));
    assert.equal(await page.evaluate(() => document.activeElement.id), 'hand');
    await fieldsAre(page, ['-20', '20', '-10']);
    assert.deepEqual(await page.locator('#picture').evaluate((it) => [it.width, it.height]), [640, 480]);
  }));

test('each key ends on its picture', () =>
  shared(async (page, { asked }) => {
    for (const key of ['d', 's', 'w', 'Escape', 'a'])
      await endsOn(page, asked, () => page.keyboard.press(key), pathOf(key), STATUS[key]);
  }));

test('each button does what its key does', () =>
  shared(async (page, { asked }) => {
    for (const key of ['d', 's', 'w', 'Escape', 'a']) {
      const button = page.getByRole('button', { name: BUTTONS[key], exact: true });
      await endsOn(page, asked, () => button.click(), pathOf(key), STATUS[key]);
      const pressed = page.locator('#pad').getByRole('button', { pressed: true });
      assert.equal(await pressed.count(), 1);
      assert.equal(await pressed.getAttribute('data-key'), key);
      if (key === 'Escape') await fieldsAre(page, ['', '', '']);
    }
  }));

test('a key fills the position in; typed at the same place it is the same picture', () =>
  shared(async (page, { asked }) => {
    await endsOn(page, asked, () => page.keyboard.press('d'), pathOf('d'), STATUS.d);
    await fieldsAre(page, ['20', '20', '-10']);
    const again = () => page.getByRole('button', { name: 'Move the lamp' }).click();
    await endsOn(page, asked, again, lightPath('20,20,-10'), 'Light at 20, 20, -10.');
    assert.ok(await shows(page, await on.tia.get(pathOf('d'))));
  }));

test('a typed position is sent by Enter as by leaving the field', () =>
  shared(async (page, { asked }) => {
    await type(page, '5', '2.5e1', '\u221210');
    await endsOn(page, asked, () => page.keyboard.press('Enter'), lightPath('5,25,-10'), 'Light at 5, 25, -10.');
    await page.getByLabel('x', { exact: true }).fill('6');
    await endsOn(page, asked, () => page.keyboard.press('Tab'), lightPath('6,25,-10'), 'Light at 6, 25, -10.');
  }));

test('arrow keys step a coordinate by 1, with Shift by 10', () =>
  shared(async (page, { asked }) => {
    await page.getByLabel('x', { exact: true }).focus();
    await endsOn(page, asked, () => page.keyboard.press('ArrowUp'), lightPath('-19,20,-10'), 'Light at -19, 20, -10.');
    const down = () => page.keyboard.press('Shift+ArrowDown');
    await endsOn(page, asked, down, lightPath('-29,20,-10'), 'Light at -29, 20, -10.');
  }));

test('a position copies as x,y,z and pastes into any field', () =>
  look(async (page, { asked }) => {
    await endsOn(page, asked, () => page.keyboard.press('w'), pathOf('w'), STATUS.w);
    await page.getByRole('button', { name: 'Copy the position' }).click();
    await page.getByText('Copied: 0,25,-35').waitFor();
    await page.keyboard.press('Escape');
    await page.getByLabel('z', { exact: true }).fill('');
    await endsOn(page, asked, () => page.keyboard.press('Control+V'), lightPath('0,25,-35'), 'Light at 0, 25, -35.');
  }, { permissions: ['clipboard-read', 'clipboard-write'] }));

test('where the browser offers no clipboard interface, as on plain http, copying works all the same', () =>
  look(async (page, { asked }) => {
    await page.getByRole('button', { name: 'Copy the position' }).click();
    await page.getByText('Copied: -20,20,-10').waitFor();
    await page.locator('#hand').focus();
    await endsOn(page, asked, () => page.keyboard.press('d'), pathOf('d'), STATUS.d);
    await page.getByLabel('x', { exact: true }).focus();
    await endsOn(page, asked, () => page.keyboard.press('Control+V'), lightPath('-20,20,-10'), 'Light at -20, 20, -10.');
  }, { init: () => Object.defineProperty(navigator, 'clipboard', { value: undefined }) }));

test('what is no number stays, is told at its field, and is not sent', () =>
  shared(async (page, { asked }) => {
    await endsOn(page, asked, () => page.keyboard.press('Escape'), pathOf('Escape'), STATUS.Escape);
    const before = asked.length;
    await type(page, '5', 'x1', '-4');
    await page.keyboard.press('Enter');
    await page.getByText('y is \u201cx1\u201d, which is not a number').waitFor();
    assert.equal(await page.getByLabel('y', { exact: true }).getAttribute('aria-invalid'), 'true');
    await type(page, '5', '', '-4');
    await page.keyboard.press('Enter');
    await page.getByText('The light needs three numbers: y is still empty.').waitFor();
    assert.deepEqual(await fields(page), ['5', '', '-4']);
    assert.equal(asked.length, before);
  }));

test('Escape in a field brings back the position shown', () =>
  shared(async (page) => {
    await page.getByLabel('x', { exact: true }).fill('oops');
    await page.keyboard.press('Escape');
    assert.deepEqual(await fields(page), ['-20', '20', '-10']);
    await rests(page);
    assert.equal(addressOf(page), '?scene=thesis&key=a&threshold=0.02');
  }));

test('start again takes the scene as it was opened', () =>
  shared(async (page, { asked }) => {
    await page.keyboard.press('w');
    await told(page, STATUS.w);
    await page.getByRole('button', { name: 'Start again' }).click();
    await told(page, STATUS.a);
    assert.equal(asked.at(-1), pathOf('a'));
  }));
