// The scene's panel for everyone: rules that a machine can check, narrow screens, a text and its
// colours that do not drift apart, long texts.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults } from './page.mjs';
import { sceneStage, showsPicture, textOf, type } from './scene_stage.mjs';

const on = sceneStage();
const { open } = on;

const PANEL = '#panel-scene';

for (const [colorScheme, locale, wrong] of [['light', 'en-US', 'Line 12'], ['dark', 'vi-VN', 'D\u00f2ng 12']]) {
  const shared = on.shared((page) => page.locator('#scene-discard').click(), { colorScheme, locale });

  test(`axe finds nothing in the ${colorScheme} theme, ${locale}: as it came, changed and wrong`, () =>
    shared(async (page) => {
      await page.locator('[data-field=radius]').waitFor();
      assert.deepEqual(await faults(page, PANEL), []);
      await type(page, '"radius": 4', '"radius": -4');
      await page.getByRole('button', { name: wrong }).waitFor();
      assert.deepEqual(await faults(page, PANEL), []);
    }));

  // The coloured layer is behind the text, where axe cannot judge it.
  test(`the colours of the text have a contrast of 4.5 in the ${colorScheme} theme, on faults too`, () =>
    shared(async (page) => {
      const low = await page.evaluate(() => {
        const context = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
        const luminance = (color) => {
          context.fillStyle = color;
          context.fillRect(0, 0, 1, 1);
          const [r, g, b] = [...context.getImageData(0, 0, 1, 1).data].slice(0, 3).map((it) => it / 255)
            .map((it) => (it <= 0.04045 ? it / 12.92 : ((it + 0.055) / 1.055) ** 2.4));
          return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const style = (selector) => getComputedStyle(document.querySelector(selector));
        const bad = document.createElement('span');
        document.querySelector('.code-line').append(Object.assign(bad, { className: 'tok-bad' }));
        const grounds = [style('.code').backgroundColor, getComputedStyle(bad).backgroundColor].map(luminance);
        return ['.tok-name', '.tok-text', '.tok-number', '.tok-word', '.code-layer'].filter((selector) => {
          if (selector === '.tok-word') bad.className = 'tok-word';
          const ink = luminance(style(selector).color);
          return grounds.some((ground) => (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05) < 4.5);
        });
      });
      assert.deepEqual(low, []);
    }));
}

for (const [width, deviceScaleFactor] of [[320, 1], [320, 3], [768, 1.1], [1280, 1]]) {
  test(`at ${width} px and scale ${deviceScaleFactor} the text lies on its colours and nothing scrolls sideways`, () =>
    open(async (page) => {
      const lines = Array.from({ length: 300 }, (_, i) => `  "name ${i} \u1ec7\u00e9": [${i}.5, true, "${'wW'.repeat(60)}"],`);
      await page.locator('#scene-text').fill(`{\n${lines.join('\n')}\n  "end": 1\n}\n`);
      const { wide, drift } = await page.evaluate(() => {
        const area = document.getElementById('scene-text');
        const last = [...document.querySelectorAll('.code-line')].at(-2).getBoundingClientRect();
        const longest = Math.max(...[...document.querySelectorAll('.code-line')].map((it) => it.getBoundingClientRect().width));
        const probe = area.cloneNode(); // as large as its text alone
        Object.assign(probe.style, { position: 'absolute', inset: 'auto', width: '0', height: '0' });
        area.after(probe);
        probe.value = area.value;
        const size = [probe.scrollWidth, probe.scrollHeight];
        probe.remove();
        const layer = document.querySelector('.code-layer').getBoundingClientRect();
        const numbers = document.querySelector('.code-numbers').getBoundingClientRect();
        const [pad, row] = [8, parseFloat(getComputedStyle(area).lineHeight)];
        return {
          wide: document.documentElement.scrollWidth > innerWidth,
          drift: [size[1] - (last.bottom - layer.top + row + pad), size[1] - numbers.height,
            longest + pad - size[0], area.scrollHeight - area.clientHeight, area.scrollWidth - area.clientWidth],
        };
      });
      assert.ok(!wide);
      assert.ok(drift.every((it) => Math.abs(it) < 1.5), drift.join());
    }, { viewport: { width, height: 800 }, deviceScaleFactor }));
}

test('what is typed far down and far right is in view', () =>
  open(async (page) => {
    const inView = () => page.waitForFunction(() => {
      const scroll = document.querySelector('.code-scroll');
      return scroll.scrollTop > 1000 && scroll.scrollLeft > 200;
    });
    await page.locator('#scene-text').fill(`{\n${Array.from({ length: 200 }, (_, i) => `"a${i}": 1,`).join('\n')}\n"z": 2}`);
    await page.locator('#scene-text').press('Control+End');
    await page.keyboard.type(`, "y": "${'x'.repeat(90)}`);
    await inView();
    assert.equal(await page.locator('.code-numbers').evaluate((it) => new DOMMatrix(getComputedStyle(it).transform).f),
      -(await page.locator('.code-scroll').evaluate((it) => it.scrollTop)));
  }));

test('a text of half a megabyte is plain, and a letter typed into it is soon there', () =>
  open(async (page, tia) => {
    assert.equal(await page.locator('.code-line').count(), 0);
    await page.waitForFunction(() => /\d{3}\s*$/.test(document.querySelector('.code-numbers').textContent));
    await type(page, '"fov_degrees": 39', '"fov_degrees": 3');
    const ms = await page.evaluate(() => new Promise((resolve) => {
      const start = performance.now();
      document.execCommand('insertText', false, '5');
      requestAnimationFrame(() => setTimeout(() => resolve(performance.now() - start)));
    }));
    assert.ok(ms < 1500, `${ms} ms`);
    const scene = JSON.parse(await textOf(page));
    assert.equal(scene.camera.fov_degrees, 35);
    await showsPicture(page, tia, { scene, width: 160, height: 120 }); // it says itself how it is sampled
  }, { path: '/?scene=trefoil&width=160&height=120' }));
