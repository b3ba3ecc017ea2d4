// The hand in the picture and on the plans: pointer, wheel, touch and keyboard. What it should
// lead to is computed here, from the lamp's place before and after.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addressOf, rests, shows, startAgain, told } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
const { look } = on;
const shared = on.shared(async (page) => {
  await page.getByRole('radio', { name: 'Lamp' }).click();
  await startAgain(page);
});

const numbers = (text) => text.split(',').map(Number);
const length = (a) => Math.hypot(...a);
const minus = (a, b) => a.map((value, i) => value - b[i]);
const near = (a, b, by, what) => assert.ok(Math.abs(a - b) <= by, `${what ?? 'value'}: ${a}, not ${b}`);
const query = (page) => new URLSearchParams(addressOf(page));
const lightOf = (page) => numbers(query(page).get('light'));
const BALL = [0, 0, -20]; // what the thesis' camera looks at

// The picture on the page is the address' own, byte for byte.
async function isItsAddress(page) {
  await rests(page);
  assert.ok(await shows(page, await on.tia.get(`/render${addressOf(page)}`)), addressOf(page));
}

// Drags over the picture from and to parts of its size, in steps.
async function drag(page, from, to, { button = 'left', steps = 8 } = {}) {
  const box = await page.locator('#hand').boundingBox();
  const at = ([x, y]) => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down({ button });
  await page.mouse.move(...at(to), { steps });
  await page.mouse.up({ button });
}

// Waits for another address, and then for rest: a hand that moves on changes it again.
async function changed(page, before) {
  await page.waitForFunction((old) => location.search !== old, before);
  await rests(page);
}

test('dragging moves the lamp on a sphere around the ball, the way the hand goes', () =>
  shared(async (page) => {
    const before = addressOf(page);
    await drag(page, [0.5, 0.5], [0.7, 0.4]);
    await changed(page, before);
    const light = lightOf(page);
    near(length(minus(light, BALL)), length(minus([-20, 20, -10], BALL)), 0.2, 'distance');
    assert.ok(light[0] > -20 + 5 && light[1] > 0, `${light}`);
    await isItsAddress(page);
  }));

test('the lamp\u2019s mark follows the hand', () =>
  shared(async (page) => {
    const mark = async () => {
      const box = await page.locator('.lamp-mark').boundingBox();
      return [box.x + box.width / 2, box.y + box.height / 2];
    };
    const [before, address] = [await mark(), addressOf(page)];
    const box = await page.locator('#hand').boundingBox();
    await drag(page, [0.3, 0.3], [0.4, 0.45]);
    await changed(page, address);
    const after = await mark();
    near(after[0] - before[0], 0.1 * box.width, 3, 'right');
    near(after[1] - before[1], 0.15 * box.height, 3, 'down');
  }));

test('the wheel takes the lamp nearer and farther, its direction stays', () =>
  shared(async (page) => {
    await page.locator('#hand').hover();
    const before = addressOf(page);
    await page.mouse.wheel(0, -400);
    await changed(page, before);
    const [old, now] = [minus([-20, 20, -10], BALL), minus(lightOf(page), BALL)];
    near(length(now) / length(old), Math.exp(-400 * 0.0015), 0.01, 'distance');
    near(old.reduce((sum, value, i) => sum + value * now[i], 0) / length(old) / length(now), 1, 1e-4, 'cosine');
    await isItsAddress(page);
  }));

async function fingers(page, context, frames) {
  const devtools = await context.newCDPSession(page);
  const send = (type, touchPoints) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', frames[0]);
  for (const frame of frames.slice(1)) await send('touchMove', frame);
  await send('touchEnd', []);
}

test('two fingers that part bring the lamp nearer; one finger moves it', () =>
  look(async (page, { context }) => {
    const box = await page.locator('#hand').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const apart = (by) => [{ x: x - by, y, id: 1 }, { x: x + by, y, id: 2 }];
    let before = addressOf(page);
    await fingers(page, context, [apart(30), apart(40), apart(50), apart(60)]);
    await changed(page, before);
    near(length(minus(lightOf(page), BALL)) / length(minus([-20, 20, -10], BALL)), 0.5, 0.02, 'distance');
    await rests(page);
    before = addressOf(page);
    await fingers(page, context, [[{ x, y, id: 1 }], [{ x: x + 20, y, id: 1 }], [{ x: x + 60, y, id: 1 }]]);
    await changed(page, before);
    await isItsAddress(page);
  }, { hasTouch: true, viewport: { width: 390, height: 800 } }));

test('arrow keys move the lamp, plus and minus its distance', () =>
  shared(async (page) => {
    let before = addressOf(page);
    await page.keyboard.press('ArrowRight');
    await changed(page, before);
    assert.ok(lightOf(page)[0] > -20);
    await rests(page);
    before = addressOf(page);
    const far = length(minus(lightOf(page), BALL));
    await page.keyboard.press('+');
    await changed(page, before);
    near(length(minus(lightOf(page), BALL)) / far, 0.9, 0.01);
    await isItsAddress(page);
  }));

test('with the camera in hand dragging walks around the ball, Shift shifts, the wheel comes nearer', () =>
  shared(async (page) => {
    await page.getByRole('radio', { name: 'Camera' }).click();
    const camera = () => JSON.parse(query(page).get('camera'));
    let before = addressOf(page);
    await drag(page, [0.5, 0.5], [0.75, 0.5]);
    await changed(page, before);
    const turned = camera();
    near(length(minus(turned.location, BALL)), 20, 0.1, 'distance');
    assert.ok(turned.location[0] < -5, 'to the left, as if the ball were turned to the right');
    await isItsAddress(page);
    before = addressOf(page);
    await page.keyboard.down('Shift');
    await drag(page, [0.5, 0.5], [0.5, 0.6]);
    await page.keyboard.up('Shift');
    await changed(page, before);
    const shifted = camera();
    const [eye, target] = [minus(shifted.location, turned.location), minus(shifted.look_at, turned.look_at)];
    near(length(minus(eye, target)), 0, 1e-3, 'eye and target go the same way');
    assert.ok(eye[1] > 0.3, `up: ${eye}`);
    await rests(page);
    before = addressOf(page);
    await page.mouse.wheel(0, -300);
    await changed(page, before);
    assert.ok(length(minus(camera().location, BALL)) < length(minus(shifted.location, BALL)) - 3);
    await isItsAddress(page);
  }));

// The rays of pixels by chance: the server's, the page's, and where the page sees their points.
async function raysOf(query) {
  const { viewOf, rayThrough, project } = await import('/space/view.js');
  const { readRecipe } = await import('/picture/png_text.js');
  const size = 'width=97&height=61&samples=1&threshold=0';
  const { request } = await readRecipe(await (await fetch(`render?${query}&${size}`)).blob());
  if (request.scene.camera?.aperture) return []; // a lens' rays start anywhere on it
  const view = viewOf(request.scene.camera, 97, 61);
  const pixels = Array.from({ length: 8 }, () => [97, 61].map((size) => Math.floor(Math.random() * size)));
  return Promise.all(pixels.map(async ([x, y]) => {
    const { ray } = await (await fetch(`explain?${query}&${size}&x=${x}&y=${y}`)).json();
    const mine = rayThrough(view, x + 0.5, y + 0.5);
    const far = mine.origin.map((value, i) => value + 7 * mine.direction[i]);
    return { server: [...ray.origin, ...ray.direction], page: [...mine.origin, ...mine.direction],
      pixel: [x + 0.5, y + 0.5], seen: project(view, far) };
  }));
}

test('the page\u2019s camera casts the server\u2019s rays, in every spelling, and sees points where they are', () =>
  shared(async (page) => {
    let cast = 0;
    for (const scene of ['cameras', 'cornell', 'shapes', 'whitted', 'stage']) {
      for (const key of ['', '&key=a', '&key=d', '&key=s']) {
        for (const ray of await page.evaluate(raysOf, `scene=${scene}${key}`)) {
          ray.page.forEach((value, i) => near(value, ray.server[i], 1e-9 * (1 + Math.abs(value)), scene + key));
          ray.seen.forEach((value, i) => near(value, ray.pixel[i], 1e-6, scene + key));
          ++cast;
        }
      }
    }
    assert.ok(cast >= 8 * 15, `${cast} rays`);
  }));

test('the lamp\u2019s handle on the plan from above moves it along the floor', () =>
  shared(async (page) => {
    const handle = page.getByRole('button', { name: 'Lamp, From above' });
    await handle.scrollIntoViewIfNeeded();
    const box = await handle.locator('.mark').boundingBox();
    const before = addressOf(page);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 40, box.y + box.height / 2, { steps: 5 });
    await page.mouse.up();
    await changed(page, before);
    const light = lightOf(page);
    assert.ok(light[0] > -18, `${light}`);
    near(light[1], 20, 0.01);
    near(light[2], -10, 0.01);
    await isItsAddress(page);
  }));

test('a ball dragged on the plan from the right is moved in the scene, and what else is written stays', () =>
  look(async (page) => {
    const handle = page.getByRole('button', { name: 'ball, From the right' });
    await handle.scrollIntoViewIfNeeded();
    const box = await handle.locator('.mark').boundingBox();
    const before = addressOf(page);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 - 30, { steps: 4 });
    await page.mouse.up();
    await changed(page, before);
    const scene = JSON.parse(query(page).get('scene'));
    const [x, y, z] = scene.objects[0].center;
    assert.ok(y > 1, `up: ${y}`);
    assert.deepEqual([x, z], [0, -20]);
    const thesis = JSON.parse(await on.tia.get('/scenes/thesis'));
    thesis.objects[0].center = [x, y, z];
    assert.deepEqual(scene, thesis);
    await isItsAddress(page);
    const moved = addressOf(page);
    await handle.focus();
    await page.keyboard.press('ArrowDown');
    await changed(page, moved);
    await isItsAddress(page);
    await page.locator('#seen').filter({ hasText: 'ball' }).waitFor();
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), await handle.getAttribute('aria-label'), 'the focus stays');
  }));

test('the plans\u2019 handles go by the arrow keys, too: lamp, camera and what it looks at', () =>
  shared(async (page) => {
    const step = async (name, key) => {
      const before = addressOf(page);
      await page.getByRole('button', { name }).focus();
      await page.keyboard.press(key);
      await changed(page, before);
      await rests(page);
      return query(page);
    };
    const lamp = numbers((await step('Lamp, From the right', 'ArrowUp')).get('light'));
    assert.ok(lamp[1] > 20 && Math.abs(lamp[0] + 20) < 0.01, `${lamp}`);
    const { location, look_at: target } = JSON.parse((await step('Camera, From above', 'ArrowRight')).get('camera'));
    assert.ok(location[0] > 0 && length(minus(target, BALL)) < 0.2, `${location}, ${target}`);
    const aim = JSON.parse((await step('What the camera looks at, From the right', 'ArrowUp')).get('camera')).look_at;
    assert.ok(aim[1] > 0.1, `${aim}`);
    await isItsAddress(page);
  }));

test('a scene of the gallery opens by its picture, by its name, and the browser goes back', () =>
  shared(async (page) => {
    await page.getByRole('button', { name: 'Every shape' }).click();
    await page.waitForFunction(() => location.search.includes('scene=shapes'));
    await isItsAddress(page);
    await page.getByLabel('A scene by its name or id').fill('heart');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => location.search.includes('scene=heart'));
    await rests(page);
    await page.goBack();
    await page.waitForFunction(() => location.search.includes('scene=shapes'));
    await isItsAddress(page);
    await page.goBack();
    await told(page, 'Light to the left, at -20, 20, -10.');
  }));

test('what is seen is told in words: sides and shadows', () =>
  shared(async (page) => {
    const seen = page.locator('#seen');
    await seen.filter({ hasText: /ball: lit from above and the left, \d+ % in shadow/ }).waitFor();
    await page.keyboard.press('d');
    await seen.filter({ hasText: /ball: lit from above and the right, \d+ % in shadow/ }).waitFor();
    await page.keyboard.press('Escape');
    await seen.filter({ hasText: /^$/ }).waitFor({ state: 'attached' });
  }));
