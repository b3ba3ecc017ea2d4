// The lamp in the page: every way to move it, and that the picture is the server's own.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { STATUS, answerTo, pathOf, shows, told } from './page.mjs';
import { stage } from './stage.mjs';

const run = promisify(execFile);
const BUTTONS = {
  a: 'Light to the left',
  d: 'Light to the right',
  s: 'Light above, near the eye',
  w: 'Light above, far from the eye',
  Escape: 'Light off',
};

const on = stage();
const { look } = on;

async function asksAndShows(page, action, path, words) {
  const answer = await answerTo(page, action);
  const { pathname, search } = new URL(answer.url());
  assert.equal(pathname + search, path);
  const direct = await on.tia.get(path);
  assert.ok((await answer.body()).equals(direct), 'the very bytes of the path');
  await told(page, words);
  assert.ok(await shows(page, direct), 'the very pixels on the page');
  assert.ok((await page.locator('#picture').getAttribute('alt')).includes(words));
}

async function type(page, x, y, z) {
  await page.getByLabel('x', { exact: true }).fill(x);
  await page.getByLabel('y', { exact: true }).fill(y);
  await page.getByLabel('z', { exact: true }).fill(z);
}

const fields = (page) => page.locator('#light input').evaluateAll((all) => all.map((it) => it.value));

test('the page opens on the unlit picture, asked for once, with the picture in focus', () =>
  look(async (page, { asked }) => {
    assert.deepEqual(asked, ['/render']);
    assert.ok(await shows(page, await on.tia.get('/render')));
    assert.equal(await page.evaluate(() => document.activeElement.id), 'picture');
    assert.deepEqual(await fields(page), ['', '', '']);
    assert.deepEqual(await page.locator('#picture').evaluate((it) => [it.naturalWidth, it.naturalHeight]), [640, 480]);
  }));

for (const key of ['a', 'd', 's', 'w']) {
  test(`key ${key} asks ${pathOf(key)} and shows its very bytes`, () =>
    look((page) => asksAndShows(page, () => page.keyboard.press(key), pathOf(key), STATUS[key])));

  test(`the button "${BUTTONS[key]}" does what key ${key} does`, () =>
    look(async (page) => {
      const button = page.getByRole('button', { name: BUTTONS[key], exact: true });
      await asksAndShows(page, () => button.click(), pathOf(key), STATUS[key]);
      const pressed = page.getByRole('button', { pressed: true });
      assert.equal(await pressed.count(), 1);
      assert.equal(await pressed.getAttribute('data-key'), key);
    }));
}

test('Escape and its button put the light off again', () =>
  look(async (page) => {
    const off = page.getByRole('button', { name: BUTTONS.Escape, exact: true });
    for (const action of [() => page.keyboard.press('Escape'), () => off.click()]) {
      await page.locator('#picture').focus();
      await asksAndShows(page, () => page.keyboard.press('a'), '/render?key=a', STATUS.a);
      await asksAndShows(page, action, '/render', STATUS.Escape);
      assert.deepEqual(await fields(page), ['', '', '']);
    }
  }));

test('a key fills the position in; a typed position at the same place shows the same picture', () =>
  look(async (page) => {
    await asksAndShows(page, () => page.keyboard.press('d'), '/render?key=d', STATUS.d);
    assert.deepEqual(await fields(page), ['20', '20', '-10']);
    const again = () => page.getByRole('button', { name: 'Move the lamp' }).click();
    await asksAndShows(page, again, '/render?light=20,20,-10', 'Light at 20, 20, -10.');
    assert.ok(await shows(page, await on.tia.get('/render?key=d')));
  }));

test('a typed position is sent once, by Enter as by leaving the field', () =>
  look(async (page, { asked }) => {
    await type(page, '5', '2.5e1', '\u221210');
    const enter = () => page.keyboard.press('Enter');
    await asksAndShows(page, enter, '/render?light=5,25,-10', 'Light at 5, 25, -10.');
    await page.getByLabel('x', { exact: true }).fill('6');
    const leave = () => page.keyboard.press('Tab');
    await asksAndShows(page, leave, '/render?light=6,25,-10', 'Light at 6, 25, -10.');
    assert.equal(asked.length, 3);
  }));

test('arrow keys step a coordinate by 1, with Shift by 10', () =>
  look(async (page) => {
    await asksAndShows(page, () => page.keyboard.press('a'), '/render?key=a', STATUS.a);
    await page.getByLabel('x', { exact: true }).focus();
    const up = () => page.keyboard.press('ArrowUp');
    await asksAndShows(page, up, '/render?light=-19,20,-10', 'Light at -19, 20, -10.');
    const down = () => page.keyboard.press('Shift+ArrowDown');
    await asksAndShows(page, down, '/render?light=-29,20,-10', 'Light at -29, 20, -10.');
  }));

test('a position copies as x,y,z and pastes into any field', () =>
  look(async (page) => {
    await asksAndShows(page, () => page.keyboard.press('w'), '/render?key=w', STATUS.w);
    await page.getByRole('button', { name: 'Copy the position' }).click();
    await page.getByText('Copied: 0,25,-35').waitFor();
    await page.keyboard.press('Escape');
    await page.getByLabel('z', { exact: true }).fill('');
    const paste = () => page.keyboard.press('Control+V');
    await asksAndShows(page, paste, '/render?light=0,25,-35', 'Light at 0, 25, -35.');
  }, { permissions: ['clipboard-read', 'clipboard-write'] }));

test('where the browser offers no clipboard interface, as on plain http, copying works all the same', () =>
  look(async (page) => {
    await asksAndShows(page, () => page.keyboard.press('a'), '/render?key=a', STATUS.a);
    await page.getByRole('button', { name: 'Copy the position' }).click();
    await page.getByText('Copied: -20,20,-10').waitFor();
    await page.locator('#picture').focus();
    await asksAndShows(page, () => page.keyboard.press('d'), '/render?key=d', STATUS.d);
    await page.getByLabel('x', { exact: true }).focus();
    const paste = () => page.keyboard.press('Control+V');
    await asksAndShows(page, paste, '/render?light=-20,20,-10', 'Light at -20, 20, -10.');
  }, { init: () => Object.defineProperty(navigator, 'clipboard', { value: undefined }) }));

test('text that is no number is explained at its field, and nothing is sent', () =>
  look(async (page, { asked }) => {
    const fault = page.locator('#fault');
    await type(page, '1', '1,5', '-10');
    await page.keyboard.press('Enter');
    await fault.filter({ hasText: 'y is \u201c1,5\u201d, which is not a number' }).waitFor();
    assert.equal(await page.getByLabel('y', { exact: true }).getAttribute('aria-invalid'), 'true');
    await type(page, '1', '', '');
    await page.keyboard.press('Enter');
    await fault.filter({ hasText: 'y and z are still empty' }).waitFor();
    await page.locator('#picture').focus();
    await asksAndShows(page, () => page.keyboard.press('s'), '/render?key=s', STATUS.s);
    assert.equal(await fault.textContent(), '');
    assert.deepEqual(asked, ['/render', '/render?key=s']);
  }));

test('Escape in a field takes back what was typed and leaves the light on', () =>
  look(async (page, { asked }) => {
    await asksAndShows(page, () => page.keyboard.press('a'), '/render?key=a', STATUS.a);
    await page.getByLabel('x', { exact: true }).fill('oops');
    await page.keyboard.press('Escape');
    assert.deepEqual(await fields(page), ['-20', '20', '-10']);
    assert.deepEqual(asked, ['/render', '/render?key=a']);
  }));

test('the curl line runs in a shell as it stands and fetches the picture shown', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'tia-curl-'));
  try {
    await look(async (page) => {
      const states = [
        ['tia.png', '/render', () => page.keyboard.press('Escape'), STATUS.Escape],
        ['tia-light.png', '/render?light=1e-7,30,-4', async () => {
          await type(page, '0.0000001', '30', '-4');
          await page.keyboard.press('Enter');
        }, 'Light at 1e-7, 30, -4.'],
        ['tia-a.png', '/render?key=a', () => page.keyboard.press('a'), STATUS.a],
      ];
      for (const [file, path, action, words] of states) {
        await asksAndShows(page, action, path, words);
        const line = await page.locator('#curl').innerText();
        assert.equal(line, `curl -o ${file} '${on.tia.base}${path}'`);
        await page.getByRole('button', { name: 'Copy the curl line' }).click();
        await page.getByText(`Copied: ${line}`).waitFor();
        assert.equal(await page.evaluate(() => navigator.clipboard.readText()), line);
        await run('sh', ['-c', line], { cwd: folder });
        assert.ok((await readFile(join(folder, file))).equals(await on.tia.get(path)), line);
        await page.locator('#picture').focus();
      }
    }, { permissions: ['clipboard-read', 'clipboard-write'] });
  } finally {
    await rm(folder, { recursive: true });
  }
});

test('time and rays on the page are those of the answer', () =>
  look(async (page) => {
    const answer = await answerTo(page, () => page.keyboard.press('a'));
    await told(page, STATUS.a);
    const headers = await answer.allHeaders();
    const phases = [...headers['server-timing'].matchAll(/(\w+)\s*;\s*dur=([\d.e+-]+)/g)];
    const rays = [...headers['tia-rays'].matchAll(/(\w+)=(\d+)/g)].map(([, , count]) => Number(count));
    assert.deepEqual(await page.locator('.phases dt').allTextContents(), phases.map(([, name]) => name));
    const shown = parseFloat((await page.locator('.time').innerText()).replaceAll(',', ''));
    const total = phases.reduce((sum, [, , ms]) => sum + Number(ms), 0);
    assert.ok(Math.abs(shown - total) <= total * 0.005 + 1e-9, `${shown} ms shown, ${total} ms sent`);
    const counted = await page.locator('.rays').innerText();
    assert.equal(counted.replaceAll(',', ''), String(rays.reduce((sum, count) => sum + count)));
  }));
