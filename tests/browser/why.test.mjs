// "Why this colour?": the colour is the picture's, the sums add up, the reason is the right one.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { because, clickPixel, explained, pixelShown, random, whyStage } from './why_stage.mjs';

const on = whyStage();
const upward = (page) => page.evaluate(() => scrollTo(0, 0)); // to the picture; each test asks anew
const onBalls = on.shared(upward, '?key=a');
const onWhitted = on.shared(upward, '?scene=whitted&pixel=300,240'); // coarse, while one asks
const SIZE = [320, 240]; // quick to draw
const SIZED = 'width=320&height=240';
const pixels = (seed, count) => {
  const next = random(seed);
  return Array.from({ length: count }, () => SIZE.map((length) => Math.floor(length * next())));
};

// Opens the page at the first of the pixels, clicks the others, and calls body(page, pixel) at each.
const askAbout = (path, [first, ...others], body) =>
  on.ask(`?${path}&${SIZED}&pixel=${first}`, async (page) => {
    await explained(page, first);
    await body(page, first);
    for (const pixel of others) {
      await clickPixel(page, pixel, SIZE);
      await body(page, pixel);
    }
  });

for (const path of ['key=a', 'key=s&transfer=srgb', 'scene=whitted', 'scene=whitted&transfer=linear']) {
  test(`the swatch has the colour of the picture's pixel: ${path}`, async () => {
    const colours = new Set();
    await askAbout(path, pixels(7, 14), async (page, pixel) => {
      const codes = await pixelShown(page, pixel);
      const [r, g, b] = codes;
      assert.equal(await page.locator('.codes').innerText(), `red ${r}, green ${g}, blue ${b} of 255`, String(pixel));
      assert.equal(await page.locator('.swatch.big').evaluate((it) => getComputedStyle(it).backgroundColor), `rgb(${codes.join(', ')})`);
      assert.deepEqual(await page.locator('.stored td').allInnerTexts(), codes.map(String));
      colours.add(String(codes));
    });
    assert.ok(colours.size > 4, 'pixels of many colours');
  });
}

// By the same paths as the interface tells of, whose groups are the page's.
test('a pixel of path is explained by the ways that its light came', () =>
  on.ask(`?scene=room&${SIZED}&pixel=160,200`, async (page) => {
    await explained(page, [160, 200]);
    assert.match(await because(page), /^Of the light of 256 paths \d+ % (came|is seen)/);
    const { groups } = await on.json(`/explain?scene=room&${SIZED}&x=160&y=200&samples=256&threshold=0&paths=0`);
    const shown = await page.locator('.ways li').allInnerTexts();
    const told = groups.slice(0, 8).map(({ share }) => `${Math.round(share * 100)} %`);
    assert.deepEqual(shown.map((line) => /\d+ %/.exec(line)[0]), told);
    assert.match(shown[0], /: matt(.*matt)* \u2190 light$/);
    assert.equal(await page.locator('.ways meter').count(), shown.length);
    assert.equal(await page.locator('.steps').count(), 0, 'no tree of rays');
  }));

// Every ray's table as shown: [{ name, ray, value, weight, adds, running }] and the rows below.
const readTables = (page) => page.locator('.walk').evaluate((walk) => {
  const numbers = (row) => row && [...row.querySelectorAll('td')].map((cell) => Number(cell.innerText));
  return [...walk.querySelectorAll('.steps button')].map((button) => {
    button.click();
    const table = walk.querySelector('.sum');
    const terms = [...table.tBodies].map((body) => ({
      name: body.querySelector('strong').innerText,
      ray: Number(/\d+/.exec(body.querySelector('button')?.innerText)?.[0] ?? 0),
      value: numbers(body.rows[1]),
      weight: Number(/[\d.]+/.exec(body.rows[2].cells[0].innerText)[0]),
      adds: numbers(body.rows[2]),
      running: numbers(body.querySelector('.running')),
    }));
    return { terms, whole: [...table.querySelectorAll('.whole')].map(numbers) };
  });
});
const units = (color) => color.map((value) => Math.round(value * 1e4));

function assertAdds({ terms, whole: [whole] }, where) {
  const sum = [0, 0, 0];
  for (const { name, value, weight, adds, running } of terms) {
    for (const c of [0, 1, 2]) {
      sum[c] += units(adds)[c];
      const slack = 1e-4 + 5e-5 * (value[c] + weight); // what rounding leaves
      assert.ok(Math.abs(value[c] * weight - adds[c]) <= slack, `${where}, ${name}: ${weight} x ${value[c]} is not ${adds[c]}`);
    }
    if (running) assert.deepEqual(units(running), sum, `${where}, ${name}: so far`);
  }
  assert.deepEqual(sum, units(whole), `${where}: the columns do not add up`);
}

for (const scene of ['whitted', 'bubbles', 'soft-shadows', 'mirrors', 'cornell', 'prism']) {
  test(`what is shown adds up, ray by ray, and is what the server tells: ${scene}`, () =>
    askAbout(`scene=${scene}`, pixels(scene.length, 3), async (page, [x, y]) => {
      const { tree } = await on.json(`/explain?scene=${scene}&samples=1&threshold=0&${SIZED}&x=${x}&y=${y}`);
      const brings = new Map([[1, tree.color]]);
      for (const [i, table] of (await readTables(page)).entries()) {
        if (table.whole.length === 0) continue; // a shadow ray's: its lamp alone
        const where = `${scene} ${x},${y}, ray ${i + 1}`;
        assertAdds(table, where);
        for (const { ray, value } of table.terms.filter((each) => each.ray)) brings.set(ray, value);
        assert.deepEqual(units(table.whole.at(-1)), units(brings.get(i + 1)), where);
      }
    }));
}

// ---- the reasons, with the geometry worked out here: a ball of radius 4 at (0, 0, -20) -----------

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const unit = (a) => a.map((value) => value / Math.hypot(...a));

function ballNormal([x, y]) {
  const half = Math.tan((12.5 * Math.PI) / 180);
  const way = unit([((2 * (x + 0.5)) / 480 - 640 / 480) * half, (1 - (2 * (y + 0.5)) / 480) * half, -1]);
  const near = dot(way, [0, 0, -20]);
  const t = near - Math.sqrt(near * near - 400 + 16);
  const point = way.map((value) => value * t);
  return { point, normal: [point[0] / 4, point[1] / 4, (point[2] + 20) / 4] };
}

test('a lit point: how much, and at which angle', () =>
  onBalls(async (page) => {
    const pixel = [250, 150];
    await clickPixel(page, pixel);
    const { point, normal } = ballNormal(pixel);
    const cosine = dot(normal, unit([-20, 20, -10].map((value, i) => value - point[i])));
    const [share, angle] = [100 * cosine, (Math.acos(cosine) * 180) / Math.PI].map(Math.round);
    assert.equal(await because(page), `This point of the ball is lit by the lamp at ${share} %: the light comes in at ${angle} degrees, and 0 degrees would be straight on.`);
    assert.ok((await page.locator('#said').innerText()).startsWith('Pixel 250, 150: This point of the ball is lit'));
  }));

function assertReason(told, reason) {
  if (typeof reason === 'string') assert.equal(told, reason);
  else assert.match(told, reason);
}

const reasons = (look, where, all) => all.forEach(([pixel, reason]) =>
  test(`the reason at ${pixel} of ${where}`, () =>
    look(async (page) => {
      await clickPixel(page, pixel);
      assertReason(await because(page), reason);
    })));

reasons(onBalls, '?key=a', [
  [[480, 450], 'This point of the floor is dark because the ball stands between it and the lamp.'],
  [[460, 300], 'This point of the ball faces away from the lamp: no light of it can fall here.'],
  [[10, 10], 'Nothing is there: the ray flies out of the scene and brings back the colour of the background.'],
]);

test('all that lies along the first ray is told with its distance', () =>
  onBalls(async (page) => {
    await clickPixel(page, [320, 240]);
    await page.getByText('All that lies along the first ray: 2').click();
    const told = await page.locator('.hits li').allInnerTexts();
    assert.deepEqual(told, ['at 16: into the ball', 'at 24: out of the ball']);
  }));

test('a scene of many samples says that one ray is explained, and another does not', async () => {
  const said = /one, through the pixel’s centre/;
  await onBalls(async (page) => {
    await clickPixel(page, [300, 240]);
    assert.doesNotMatch(await page.locator('#panel-why').innerText(), said);
  });
  await onWhitted(async (page) => {
    await explained(page, [300, 240]);
    assert.match(await page.locator('#panel-why').innerText(), said);
  });
});

reasons(onWhitted, '?scene=whitted', [
  [[200, 260], /^The mirror ball is a mirror here: what you see is the (floor|background)\./],
  [[400, 150], /^The glass ball lets light through: what you see through it is the background\./],
]);

for (const [path, pixel, reason] of [
  ['?scene=thesis', [320, 240], 'No lamp shines, so this point of the ball is dark.'],
  ['?scene=stage', [300, 380],
    /^This point of the floor is lit by lamp 2 at 88 %.* 2 of 4 lamps light it\. .*: lamps 94 %, even light 6 %\.$/],
]) {
  test(`the reason at ${pixel} of ${path}`, () =>
    on.ask(`${path}&pixel=${pixel}`, async (page) => {
      await explained(page, pixel);
      assertReason(await because(page), reason);
    }));
}

test('a pixel outside, and a question that the server refuses, are told plainly', async () => {
  await on.ask('?key=a&pixel=900,10', async (page) => {
    await page.getByText('The picture has 640 × 480 pixels, counted from 0. The pixel 900, 10 is not one of them').waitFor();
    await clickPixel(page, [480, 450]);
    assert.match(await because(page), /dark because the ball/);
  });
  await on.ask('?integrator=normal&pixel=10,10', async (page) => {
    await page.locator('#panel-why').getByText('A value is out of range').waitFor();
    await page.getByRole('button', { name: 'Stop asking' }).click();
    await page.getByRole('button', { name: 'Ask about the middle' }).waitFor();
  }, { failing: true });
});
