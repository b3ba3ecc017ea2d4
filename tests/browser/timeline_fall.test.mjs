// Bodies in the timeline: a ball that falls and bounces, from nothing, and what is told of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lab, rest, shownPixels } from './lab.mjs';
import { until } from './page.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const THESIS = { at: '/?scene=thesis&key=a&width=160&height=120', panel: 'timeline' };
const G = 9.81;

const button = (page, name) => page.getByRole('button', { name, exact: true });
const time = (page) => page.getByRole('slider', { name: 'Time', exact: true });
const stateOf = (page) => page.evaluate(async () => (await import('/state/address.js')).readAddress(location));
const ballIn = (page) => page.getByRole('button', { name: /^ball, From the right/ });
const contacts = (page) => page.getByRole('img', { name: /contacts: ball and floor at/ });

async function showsItsAddress(page) {
  await rest(page);
  const answer = await fetch(`${on.tia.base}/render`, { method: 'POST', body: JSON.stringify(await stateOf(page)) });
  assert.equal(answer.status, 200, await answer.clone().text());
  assert.deepEqual(await shownPixels(page, '#picture'), pixelsOf(Buffer.from(await answer.arrayBuffer())));
}

/** Waits until the ball has been lifted off its floor; how high it hangs above it then. */
async function lifted(page) {
  let height = 0;
  await until(async () => (height = (await stateOf(page)).scene?.objects?.[0].center?.[1] ?? 0) > 0.5, 'the ball in mid-air');
  return height; // at 0 it touches
}

/** What the page tells of the first fall from a height: it takes sqrt(2 h / g). */
async function tellsBounces(page, height) {
  await contacts(page).waitFor({ state: 'attached' });
  const [, first] = /at ([\d.]+) s/.exec(await contacts(page).getAttribute('aria-label'));
  assert.ok(Math.abs(Number(first) - Math.sqrt((2 * height) / G)) < 0.006, `${first} s from ${height}`);
  assert.equal(await page.getByRole('img', { name: 'Heights of ball' }).count(), 1);
  assert.equal(await page.getByRole('img', { name: /^Energy in all: / }).count(), 1);
  await button(page, 'Play').click();
  const told = page.locator('.timeline .told').filter({ hasText: /^5 of 5 seconds; ball met floor at [\d.]+$/ });
  await told.waitFor();
  await until(async () => (await stateOf(page)).time === 5, 'its end');
  await showsItsAddress(page);
}

test('a ball that falls and bounces, from nothing, by the keyboard alone', () =>
  on.open(async (page) => {
    const key = async (...keys) => {
      for (const one of keys) await page.keyboard.press(one);
    };
    await ballIn(page).focus();
    await key('Shift+ArrowUp');
    const height = await lifted(page);
    await page.getByText('Make it fall', { exact: true }).first().focus();
    await key('Enter');
    await page.getByLabel('What ball does').focus();
    await key('ArrowUp'); // from standing in the way
    await page.getByLabel('Bounce, 0 to 1').focus();
    await key('Control+a');
    await page.keyboard.type('0.5');
    await key('Tab');
    await button(page, 'Make it fall').focus();
    await key('Enter');
    await until(async () => (await stateOf(page)).scene.physics, 'its physics');
    const { bodies, fixed, solver } = (await stateOf(page)).scene.physics;
    assert.deepEqual([bodies, fixed, solver], [[{ mass: 1, restitution: 0.5, friction: 0.5, velocity: [0, 0, 0], object: 'ball' }], [{ object: 'floor' }], 'exact']);
    await page.getByLabel('Speed').focus();
    await key('End');
    await tellsBounces(page, height);
  }, THESIS));

test('a ball that falls and bounces, from nothing, by the mouse alone; its arrow gives it speed', () =>
  on.open(async (page) => {
    const drag = async (locator, [x, y]) => {
      await locator.scrollIntoViewIfNeeded();
      const box = await locator.boundingBox();
      const from = [box.x + box.width / 2, box.y + box.height / 2];
      await page.mouse.move(...from);
      await page.mouse.down();
      await page.mouse.move(from[0] + x, from[1] + y, { steps: 4 });
      await page.mouse.up();
    };
    await drag(ballIn(page), [0, -24]);
    const height = await lifted(page);
    await page.getByText('Make it fall', { exact: true }).first().click();
    await page.getByLabel('What ball does').selectOption('falls');
    await button(page, 'Make it fall').click();
    await page.getByLabel('Speed').selectOption('4');
    await tellsBounces(page, height);
    await drag(page.getByRole('button', { name: /^Velocity of ball, From above/ }), [30, 0]);
    await until(async () => (await stateOf(page)).scene.physics.bodies[0].velocity[0] > 0.5, 'its speed');
    await showsItsAddress(page);
    await button(page, 'Let nothing fall').click();
    await until(async () => !(await stateOf(page)).scene.physics, 'no physics');
    assert.equal((await stateOf(page)).time, undefined);
    await button(page, 'Undo').click();
    await contacts(page).waitFor({ state: 'attached' });
  }, THESIS));

test('without anything that falls there is nothing to make fall, and that is said', () =>
  on.open(async (page) => {
    await page.getByText('Make it fall', { exact: true }).first().click();
    await button(page, 'Make it fall').click();
    await page.getByText('Choose first what falls.').waitFor();
    assert.equal((await stateOf(page)).scene, 'thesis');
    await time(page).waitFor();
  }, THESIS));
