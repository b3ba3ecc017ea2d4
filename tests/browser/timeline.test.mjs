// The timeline: motion made from nothing, played, scrubbed and edited; a moment is a link.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { circle, trackValue } from '../../web/space/track.js';
import { lab, rest, saved, shownPixels } from './lab.mjs';
import { until } from './page.mjs';
import { pixelsOf } from './png.mjs';

const on = lab();
const SIZE = 'width=160&height=120';
const THESIS = { at: `/?scene=thesis&key=a&${SIZE}`, panel: 'timeline' };
const ROUND = { at: `/?scene=lamp-round&${SIZE}`, panel: 'timeline' };
const LAMP = '/key_light/position';
const [LEFT, RIGHT] = [[-20, 20, -10], [20, 20, -10]];

const button = (page, name) => page.getByRole('button', { name, exact: true });
const slider = (page, name) => page.getByRole('slider', { name, exact: true });
const time = (page) => slider(page, 'Time');
const keysOf = (page, name = 'Lamp') => page.getByRole('slider', { name: new RegExp(`^${name}: key `) });

/** What the address says. */
const stateOf = (page) => page.evaluate(async () => (await import('/state/address.js')).readAddress(location));
const tracksOf = async (page) => (await stateOf(page)).scene?.animation?.tracks;

/** Waits until the address says that the scene's tracks are these. */
async function hasTracks(page, wanted) {
  let now;
  await until(async () => isDeepStrictEqual(now = await tracksOf(page), wanted), JSON.stringify(wanted))
    .catch((error) => assert.deepEqual(now, wanted, error.message));
}

const hasTime = (page, wanted) => until(async () => (await stateOf(page)).time === wanted, `the time ${wanted}`);

/** Waits until the picture is what the server draws of the page's own address. */
async function showsItsAddress(page) {
  await rest(page);
  const answer = await fetch(`${on.tia.base}/render`, { method: 'POST', body: JSON.stringify(await stateOf(page)) });
  assert.equal(answer.status, 200, await answer.clone().text());
  assert.deepEqual(await shownPixels(page, '#picture'), pixelsOf(Buffer.from(await answer.arrayBuffer())));
}

const leftToRight = [{ target: LAMP, keys: [[0, LEFT], [5, RIGHT]], interpolation: 'smooth' }];

test('a lamp from left to right, from nothing, by the keyboard alone', () =>
  on.open(async (page) => {
    const key = async (...keys) => {
      for (const one of keys) await page.keyboard.press(one);
    };
    await button(page, 'Add a key at 0 s').focus();
    await key('Enter');
    await keysOf(page).first().waitFor();
    await time(page).focus();
    await key('End');
    await hasTime(page, 5);
    await page.locator('#hand').focus();
    await key('d');
    await page.getByText('Lamp: moved by the timeline. At 5 s it stands elsewhere now', { exact: false }).waitFor();
    await page.locator('#held').getByRole('button').first().focus();
    await key('Enter');
    await hasTracks(page, leftToRight);
    assert.equal((await stateOf(page)).key, undefined);
    await page.locator('#held').waitFor({ state: 'hidden' });
    await showsItsAddress(page);
    await page.locator('#hand:focus').waitFor();
    await time(page).focus();
    await key('Home');
    await page.getByLabel('Speed').focus();
    await key('ArrowDown', 'ArrowDown');
    await button(page, 'Play').focus();
    await key('Enter');
    await page.getByText('5 of 5 seconds', { exact: true }).waitFor();
    await hasTime(page, 5);
    await showsItsAddress(page);
  }, THESIS));

test('a lamp from left to right, from nothing, by the mouse alone', () =>
  on.open(async (page) => {
    await button(page, 'Add a key at 0 s').click();
    await keysOf(page).first().waitFor();
    await dragBy(page, page.locator('.lane'), [0.5, 0.5], [1, 0.5]);
    await hasTime(page, 5);
    await rest(page);
    const hand = await page.locator('#hand').boundingBox();
    const mark = await page.locator('.lamp-mark').boundingBox();
    const [x, y] = [mark.x + mark.width / 2, mark.y + mark.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(2 * hand.x + hand.width - x, y, { steps: 4 }); // as far right as it stood left
    await page.mouse.up();
    await page.locator('#held').getByRole('button', { name: 'Add a key at 5 s' }).click();
    await until(async () => (await tracksOf(page))?.[0].keys.length === 2, 'the second key');
    const [{ keys: [[, from], [at, to]] }] = await tracksOf(page);
    assert.equal(at, 5);
    assert.deepEqual(from, LEFT);
    assert.ok(to[0] > 15 && Math.abs(to[1] - 20) < 1, `${to}`);
    await showsItsAddress(page);
    await page.getByLabel('Speed').selectOption('4');
    await button(page, 'Play').click();
    await page.getByText('5 of 5 seconds', { exact: true }).waitFor();
    await hasTime(page, 5);
    await showsItsAddress(page);
  }, THESIS));

// Presses at a share of an element's box and lets go at another.
async function dragBy(page, locator, from, to) {
  const box = await locator.boundingBox();
  const at = ([x, y]) => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at(to), { steps: 5 });
  await page.mouse.up();
}

test('nothing plays by itself; opened, the timeline shows what moves at its beginning', () =>
  on.open(async (page, { asked }) => {
    await hasTime(page, 0);
    await showsItsAddress(page);
    await page.getByText('0.00 of 8 s').waitFor();
    const times = () => new Set(asked.map((one) => new URL(one.url()).searchParams.get('time')).filter(Boolean));
    assert.deepEqual([...times()], ['0']);
    assert.ok(await button(page, 'Play').isVisible());
  }, ROUND));

test('played, later frames follow; in a loop the first comes again; the pause shows the picture of its time', () =>
  on.open(async (page, { asked }) => {
    const before = asked.length;
    await button(page, 'Play').waitFor();
    await page.evaluate(() => {
      globalThis.told = [];
      for (const place of document.querySelectorAll('.timeline [role=status]'))
        new MutationObserver(() => globalThis.told.push(place.textContent)).observe(place, { childList: true, characterData: true, subtree: true });
    });
    await page.getByLabel('Loop').check();
    await page.getByLabel('Speed').selectOption('4');
    await button(page, 'Play').click();
    const times = () => asked.slice(before).map((one) => Number(new URL(one.url()).searchParams.get('time')));
    await until(() => times().some((now, i) => i > 0 && now < times()[i - 1]), 'the beginning again');
    await button(page, 'Pause').click();
    for (const one of times()) assert.ok(Number.isInteger(one * 24) && one < 8, `${one}`);
    const at = (await page.locator('.transport .time').textContent()).replace(' of 8 s', '');
    await until(async () => (await stateOf(page)).time?.toFixed(2) === at, at);
    await showsItsAddress(page);
    const told = await page.evaluate(() => globalThis.told);
    assert.equal(told.length, 1, `${told}`); // at the end, not with each frame
    assert.match(told[0], / of 8 seconds$/);
  }, ROUND));

test('a server that is busy is waited for, and the play goes on', () =>
  on.open(async (page) => {
    let refused = 0;
    const problem = { type: '/problems/busy', title: 'Busy', status: 429 };
    await page.route(/\/render\?time=[1-7]/, (route) => (++refused > 3 ? route.continue()
      : route.fulfill({ status: 429, contentType: 'application/problem+json', headers: { 'Retry-After': '1' }, json: problem })));
    await page.getByLabel('Speed').selectOption('4');
    await button(page, 'Play').click();
    await page.getByText('Busy').waitFor();
    assert.ok(await button(page, 'Pause').isVisible());
    await page.getByText('8 of 8 seconds', { exact: true }).waitFor();
    assert.ok(refused > 3);
    await showsItsAddress(page);
    assert.equal(await page.locator('#problem').textContent(), '');
  }, { ...ROUND, failing: true }));

test('a link with a time opens at it, and says so; steps and scrubbing go by frames', () =>
  on.open(async (page) => {
    await showsItsAddress(page);
    assert.equal((await stateOf(page)).time, 2.5);
    assert.equal(await time(page).getAttribute('aria-valuetext'), '2.5 of 8 seconds');
    await button(page, 'One frame on').click();
    await hasTime(page, 61 / 24);
    await button(page, 'One frame back').click();
    await hasTime(page, 2.5);
    await time(page).focus();
    await page.keyboard.press('ArrowRight');
    await hasTime(page, 61 / 24);
    await page.keyboard.press('Home');
    await hasTime(page, 0);
    await page.keyboard.press('End');
    await hasTime(page, 8);
    await showsItsAddress(page);
    await page.locator('#tab-take').click();
    assert.match(await page.locator('pre', { hasText: 'curl' }).textContent(), /tia-lamp-round-8s\.png .*\/render\?time=8&scene=lamp-round/);
    const { animation } = JSON.parse((await saved(page, 'Save the scene')).bytes);
    assert.equal(animation.duration, 8);
  }, { ...ROUND, at: `${ROUND.at}&time=2.5` }));

test('keys are dragged, moved by arrows, eased, given values, deleted, and all of it is undone', () =>
  on.open(async (page) => {
    const keysNow = async () => (await tracksOf(page))[0].keys;
    const moved = (wanted) => until(async () => JSON.stringify((await tracksOf(page))?.[0].keys.map(([t]) => t)) === JSON.stringify(wanted), `keys at ${wanted}`);
    const second = keysOf(page).nth(1);
    assert.equal(await second.getAttribute('aria-valuetext'), '2 seconds');
    const lane = await page.locator('.lane').boundingBox();
    const box = await second.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(lane.x + 8 + (lane.width - 16) * (3 / 8), box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    await moved([0, 3, 4, 6, 8]);
    await second.focus();
    await page.keyboard.press('ArrowLeft');
    await moved([0, 2.958333, 4, 6, 8]);
    await page.getByLabel('Time in seconds').fill('1');
    await page.keyboard.press('Tab');
    await moved([0, 1, 4, 6, 8]);
    await page.getByLabel('Value').fill('1, 30, -5');
    await page.keyboard.press('Tab');
    await until(async () => String((await keysNow())[1][1]) === '1,30,-5', 'its value');
    await page.getByLabel('Value').fill('1, 30');
    await page.keyboard.press('Tab');
    assert.equal(await page.getByLabel('Value').getAttribute('aria-invalid'), 'true');
    await page.getByLabel('On the way to the next').selectOption('in_out');
    await until(async () => (await keysNow())[1][2] === 'in_out', 'its ease');
    await page.getByLabel('From key to key').selectOption('linear');
    await until(async () => (await tracksOf(page))[0].interpolation === 'linear', 'the way');
    await showsItsAddress(page);
    await second.focus();
    await page.keyboard.press('Delete');
    await moved([0, 4, 6, 8]);
    await page.locator('.key[data-key="1"]:focus').waitFor();
    await page.keyboard.press('Control+z');
    await moved([0, 1, 4, 6, 8]);
    for (let i = 0; i < 6; ++i) await button(page, 'Undo').click();
    await page.waitForURL(/scene=lamp-round/);
    assert.equal((await stateOf(page)).time, 0);
    await button(page, 'Redo').click();
    await until(async () => (await tracksOf(page)) !== undefined, 'the first step again');
  }, ROUND));

test('the last key takes its track along; undone to nothing, the picture stands still again', () =>
  on.open(async (page) => {
    await button(page, 'Add a key at 0 s').click();
    await keysOf(page).first().focus();
    await hasTime(page, 0);
    await page.keyboard.press('Delete');
    await hasTracks(page, []);
    await page.locator('.lanes > input:focus').waitFor();
    await button(page, 'Undo').click();
    await keysOf(page).first().waitFor();
    await button(page, 'Undo').click();
    await until(async () => (await stateOf(page)).time === undefined, 'no time');
    await showsItsAddress(page);
    assert.ok(await button(page, 'Undo').isDisabled());
    await button(page, 'Redo').click();
    await hasTracks(page, [{ target: LAMP, keys: [[0, LEFT]], interpolation: 'smooth' }]);
    await hasTime(page, 0);
  }, THESIS));

test('what was just moved is what gets a key: an object in a plan, the camera', () =>
  on.open(async (page) => {
    const what = page.getByLabel('What moves');
    await what.waitFor();
    const ball = page.getByRole('button', { name: /^ball, From above/ });
    await ball.focus();
    await page.keyboard.press('ArrowRight');
    await until(async () => await what.inputValue() === 'object-0', 'the ball is chosen');
    await button(page, 'Add a key at 0 s').click();
    await until(async () => (await tracksOf(page))?.[0].target === '/objects/ball/center', 'its track');
    await time(page).focus();
    await page.keyboard.press('End');
    await hasTime(page, 5);
    await ball.focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    await page.getByText('ball: place: moved by the timeline', { exact: false }).waitFor();
    await button(page, 'Put it back').click();
    await page.locator('#held').waitFor({ state: 'hidden' });
    await showsItsAddress(page);
    await ball.focus();
    await page.keyboard.press('ArrowRight');
    await page.locator('#held').getByRole('button', { name: 'Add a key at 5 s' }).click();
    await until(async () => (await tracksOf(page))[0].keys.length === 2, 'its second key');
    const [{ keys: [[, from], [, to]] }] = await tracksOf(page);
    assert.ok(to[0] > from[0] && to[1] === from[1], `${from} to ${to}`);

    await page.getByRole('radio', { name: 'Camera' }).click();
    await page.locator('#hand').focus();
    await page.keyboard.press('ArrowLeft');
    await until(async () => await what.inputValue() === 'camera', 'the camera is chosen');
    await page.locator('.add-form .add').click();
    await until(async () => (await tracksOf(page)).length === 3, 'its tracks');
    const targets = (await tracksOf(page)).map(({ target }) => target);
    assert.deepEqual(targets, ['/objects/ball/center', '/camera/location', '/camera/look_at']);
    assert.equal((await stateOf(page)).camera, undefined);
    await showsItsAddress(page);
  }, { ...THESIS, at: `/?scene=thesis&key=a&${SIZE}` }));

test('the lamp once around what one looks at; a moment of it is kept without motion', () =>
  on.open(async (page) => {
    await button(page, 'Lamp once around').click();
    await until(async () => (await tracksOf(page))?.length === 1, 'its track');
    const [{ target, keys, repeat }] = await tracksOf(page);
    assert.deepEqual([target, keys.length, repeat, keys[0][1], keys[8]], [LAMP, 9, 'loop', LEFT, [5, LEFT]]);
    for (const [, [x, y, z]] of keys) {
      assert.equal(y, 20);
      assert.ok(Math.abs(Math.hypot(x, z + 20) - Math.hypot(20, 10)) < 0.1, `${x} ${z}`);
    }
    await time(page).focus();
    await page.keyboard.press('PageUp');
    await rest(page);
    await showsItsAddress(page);
    const before = await shownPixels(page, '#picture');
    await button(page, 'Keep this moment, without motion').click();
    await until(async () => (await stateOf(page)).time === undefined, 'no time');
    await showsItsAddress(page);
    assert.deepEqual(await shownPixels(page, '#picture'), before);
    assert.equal(await tracksOf(page), undefined);
  }, THESIS));

test('a scene of one\u2019s own goes to the server once while it plays', () =>
  on.open(async (page, { asked }) => {
    await page.getByRole('button', { name: /to \u201cLamp\u201d now/ }).click();
    await until(async () => (await tracksOf(page)) !== undefined, 'a scene of one\u2019s own');
    await rest(page);
    const stored = [];
    page.on('request', (one) => one.method() !== 'GET' && /\/scenes/.test(one.url()) && stored.push(one.method()));
    const before = asked.length;
    await button(page, 'Play').click();
    await until(() => asked.length > before + 4, 'frames');
    const frames = asked.slice(before + 1).map((one) => one.url());
    await button(page, 'Pause').click();
    for (const url of frames) assert.match(url, /time=[\d.]+&scene=[\da-f]{64}&/);
    await showsItsAddress(page);
    await until(() => stored.length === 2, 'the scene is let go');
    assert.deepEqual(stored, ['POST', 'DELETE']);
  }, { ...ROUND, at: `${ROUND.at}&time=1` }));

test('where the server has let that scene go, it plays on', () =>
  on.open(async (page) => {
    await page.getByRole('button', { name: /to \u201cLamp\u201d now/ }).click();
    await until(async () => (await tracksOf(page)) !== undefined, 'a scene of one\u2019s own');
    await rest(page);
    let refused = 0;
    await page.route(/\/render\?.*scene=[\da-f]{64}&/, (route) => (++refused,
      route.fulfill({ status: 404, contentType: 'application/problem+json', json: { title: 'Gone', status: 404 } })));
    await page.getByLabel('Speed').selectOption('4');
    await button(page, 'Play').click();
    await page.getByText('8 of 8 seconds', { exact: true }).waitFor();
    assert.equal(refused, 1);
    await showsItsAddress(page);
  }, { ...ROUND, at: `${ROUND.at}&time=1`, failing: true }));

test('the page draws ways as the server does: keys of every kind, eased and repeated', async () => {
  const any = (least, most) => least + Math.random() * (most - least);
  const point = () => [any(-9, 9), any(-9, 9), any(-9, 9)];
  const eases = [[], ['in'], ['out'], ['in_out']];
  for (const interpolation of ['linear', 'smooth', 'step', 'bezier'])
    for (const repeat of ['once', 'loop', 'pingpong']) {
      const made = (value) => [0.5, 1.1, 2, 2.6].map((t, i) => [t, value(), ...(interpolation === 'bezier' ? [value(), value()] : eases[i])]);
      const [places, sizes] = [made(point), made(() => any(1, 2))];
      if (repeat === 'loop') places[3][1] = places[0][1];
      const tracks = [{ target: LAMP, keys: places, interpolation, repeat },
        { target: '/key_light/intensity', keys: interpolation === 'bezier' ? sizes.map(([t]) => [t, 5, 0, 0]) : sizes, interpolation, repeat }];
      const scene = { objects: [{ type: 'sphere', center: [0, 0, 0], radius: 1 }], key_light: { type: 'sphere', radius: 1 },
        animation: { duration: 4, tracks } };
      const answer = await fetch(`${on.tia.base}/scenes`, { method: 'POST', body: JSON.stringify(scene) });
      const { id } = await answer.json();
      assert.ok(id, JSON.stringify(scene.animation));
      for (const at of [0, 0.5, any(0.6, 2.5), any(0, 4), 2, 4]) {
        const { key_light: { position, intensity = 1 } } = JSON.parse(await on.tia.get(`/scenes/${id}?time=${at}`));
        const [p, i] = tracks.map((track) => trackValue(track, at));
        const near = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b));
        assert.ok(p.every((x, n) => near(x, position[n])), `${interpolation} ${repeat} at ${at}: ${p}, not ${position}`);
        assert.ok(near(i, Array.isArray(intensity) ? intensity[0] : intensity), `${interpolation} ${repeat} at ${at}: ${i}, not ${intensity}`);
      }
    }
});

test('a formula comes to what the server says, and where it is none to nothing', async () => {
  const formulas = ['2^-t^2*3 - -t', '-(t-1)^2/4+max(t,1)', 'a*sin(pi*t/2)+min(cos(t),.5e0)', 'sqrt(t+1)-abs(floor(-t))',
    'exp(-t)*log(2+t)-atan2(t,1+t)', 'tan(t/4)+asin(t/9)+acos(t/9)+atan(t)', 'sinh(t/2)-cosh(t/3)*tanh(t)', '2^3^(t/4)'];
  const track = (target, formula) => ({ target, formula, parameters: { a: 1.5 } });
  const tracks = formulas.map((one, i) => track(`/objects/${i}/center/0`, one));
  const objects = formulas.map(() => ({ type: 'sphere', center: [0, 0, 0], radius: 1 }));
  const scene = { objects, animation: { duration: 4, tracks } };
  const answer = await fetch(`${on.tia.base}/scenes`, { method: 'POST', body: JSON.stringify(scene) });
  const { id } = await answer.json();
  for (const at of [0, 0.7, 2.3, 4]) {
    const now = JSON.parse(await on.tia.get(`/scenes/${id}?time=${at}`));
    tracks.forEach((one, i) => {
      const [x] = now.objects[i].center;
      assert.ok(Math.abs(trackValue(one, at) - x) <= 1e-12 * Math.max(1, Math.abs(x)), `${formulas[i]} at ${at}: ${x}`);
    });
  }
  for (const none of ['', 't t', '2**3', 'sin', 'sin(t', 't)', 'b', 'sqrt(-1-t)', 'max(t)'])
    assert.equal(trackValue(track('', none), 1), null, none);
  assert.deepEqual(trackValue(track('', ['t', '0', 'a*t']), 2), [2, 0, 3]);
});

const BALL = { camera: { location: [0, 1, 9], look_at: [0, 0, 0] }, lights: [{ type: 'point', position: [3, 5, 4] }],
  objects: [{ name: 'ball', type: 'sphere', center: [0, 0, 0], radius: 1 }] };
const sceneAt = (scene) => `/?scene=${encodeURIComponent(JSON.stringify(scene))}&${SIZE}`;

test('what the form has changed just now is given keys: a radius that grows, a light that fades', () =>
  on.open(async (page) => {
    const change = async (part, name, value) => {
      await page.locator('#tab-scene').click();
      await page.locator('#scene-part').selectOption(part);
      await page.locator(`[data-field=${name}] .scene-number`).fill(value);
      await page.locator('#tab-timeline').click();
    };
    const keyNow = async (name, at) => {
      await until(() => page.locator('.add-form option:checked').evaluate((it) => it.textContent).then((it) => it === name), name);
      await button(page, `Add a key at ${at} s`).click();
    };
    await change('/objects/0', 'radius', '1.5');
    await keyNow('ball: radius', 0);
    await time(page).focus();
    await page.keyboard.press('End');
    await hasTime(page, 5);
    await change('/objects/0', 'radius', '3');
    await keyNow('ball: radius', 5);
    await change('/lights/0', 'intensity', '0.5');
    await page.locator('.add-form option:checked').evaluate((it) => it.value).then((it) => assert.equal(it, '/lights/0/intensity'));
    await button(page, 'Add a key at 5 s').click();
    await hasTracks(page, [
      { target: '/objects/ball/radius', keys: [[0, 1.5], [5, 3]], interpolation: 'smooth' },
      { target: '/lights/0/intensity', keys: [[5, 0.5]], interpolation: 'smooth' }]);
    await showsItsAddress(page);
  }, { at: sceneAt(BALL), panel: 'timeline' }));

test('the way of a formula is drawn like that of keys', () =>
  on.open(async (page) => {
    const way = page.locator('#overlay .way-object .core');
    await way.waitFor({ state: 'attached' });
    const points = (await way.getAttribute('d')).match(/-?[\d.]+ -?[\d.]+/g).map((one) => one.split(' ').map(Number));
    assert.equal(points.length, 97);
    const middle = points.slice(1).reduce(([x, y], [a, b]) => [x + a / 96, y + b / 96], [0, 0]);
    const far = points.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1]));
    assert.ok(Math.max(...far) / Math.min(...far) < 1.05, 'a circle that faces the eye');
  }, { at: sceneAt({ ...BALL, camera: { location: [0, 0, 30], look_at: [0, 0, 0] }, animation: { duration: 4, tracks: [
    { target: '/objects/ball/center', formula: ['2*cos(pi*t/2)', '2*sin(pi*t/2)', '0'] }] } }), panel: 'timeline' }));

test('a circle keeps height and distance; straight above there is none', () => {
  for (const [x, y, z] of circle([1, 2, 3], [4, 9, 7], 12))
    assert.ok(Math.abs(y - 9) < 1e-3 && Math.abs(Math.hypot(x - 1, z - 3) - 5) < 1e-3);
  assert.equal(circle([0, 0, 0], [0, 5, 0], 12), null);
});
