// The form: what it changes goes into the text, and only there.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fieldsOf } from '../../web/state/scene_fields.js';
import { asItCame, sceneStage, showsPicture, textOf, type } from './scene_stage.mjs';

const on = sceneStage();
const { open } = on;
const shared = on.shared(async (page) => {
  await asItCame(page);
  await choose(page, '/objects/0');
});
const scene = async (page) => JSON.parse(await textOf(page));
const choose = (page, pointer) => page.locator('#scene-part').selectOption(pointer);
const field = (page, name) => page.locator(`[data-field=${name}]`);

test('a slider changes its value in the text and the picture, and nothing else', () =>
  shared(async (page, tia) => {
    const before = await textOf(page);
    const slider = page.getByRole('slider', { name: 'Radius' });
    assert.equal(await slider.inputValue(), '4');
    await slider.focus();
    for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowLeft');
    const radius = Number(await slider.inputValue());
    assert.ok(radius < 4 && radius > 3, `${radius}`);
    assert.equal(await textOf(page), before.replace('"radius": 4', `"radius": ${radius}`));
    assert.ok(await slider.evaluate((it) => it === document.activeElement), 'the slider keeps focus');
    await showsPicture(page, tia, { scene: await scene(page), key: 'a', threshold: 0.02 });
  }));

test('ranges, defaults and descriptions are the server\u2019s schema\u2019s', () =>
  shared(async (page, tia) => {
    const schema = JSON.parse(await tia.get('/schema/scene.json'));
    const { properties } = schema.$defs.material.oneOf.find((kind) => kind.properties.type.const === 'finish');
    for (const name of ['diffuse', 'reflection', 'transmission']) {
      const slider = field(page, name).locator('[type=range]');
      assert.deepEqual([await slider.getAttribute('min'), await slider.getAttribute('max'), await slider.inputValue()],
        [properties[name].minimum, properties[name].maximum, properties[name].default].map(String), name);
      await slider.focus();
      assert.ok((await page.locator('#scene-about').innerText()).includes(properties[name].description));
    }
    const ior = field(page, 'ior').locator('[type=range]');
    assert.deepEqual([await ior.getAttribute('min'), await ior.getAttribute('max')], ['0.1', '10']);
    const ofPrincipled = (field, value) =>
      fieldsOf(schema, { materials: { it: { type: 'principled', [field]: value } } }, '/materials/it')
        .find(({ name }) => name === field);
    const metal = (value) => ofPrincipled('base_color', value)?.kind;
    assert.deepEqual([metal(0.5), metal([1, 0, 0]), metal('gold')], ['color', 'color', undefined]);
    const { min, max } = ofPrincipled('roughness', 0.5).range;
    assert.deepEqual([min, max], [0, 1]);
    assert.equal(ofPrincipled('roughness', { type: 'noise', range: [0, 1] }), undefined);
  }));

test('a material that an object names is changed where it stands; a missing field is added there', () =>
  shared(async (page, tia) => {
    await field(page, 'reflection').locator('.scene-number').fill('0.5');
    const now = await scene(page);
    assert.deepEqual(now.materials.white, { reflection: 0.5 });
    assert.equal(now.objects[0].material, 'white');
    await choose(page, '/camera');
    await field(page, 'fov_degrees').locator('.scene-number').fill('30');
    assert.deepEqual((await scene(page)).camera, { look_at: [0, 0, -1], fov_degrees: 30 });
    await field(page, 'location').locator('input').nth(1).fill('-1.5');
    assert.deepEqual((await scene(page)).camera.location, [0, -1.5, 0]);
    await showsPicture(page, tia, { scene: await scene(page), key: 'a', threshold: 0.02 });
  }));

test('choices, boxes and texts write what they say', () =>
  shared(async (page) => {
    await choose(page, '/options');
    await field(page, 'integrator').locator('select').selectOption('whitted');
    await field(page, 'transparent_shadows').locator('input').check();
    await choose(page, '');
    await field(page, 'title').locator('input').fill('M\u00ecnh \u201cv\u1ebd\u201d');
    const { options, title } = await scene(page);
    assert.deepEqual([options.integrator, options.transparent_shadows, title], ['whitted', true, 'M\u00ecnh \u201cv\u1ebd\u201d']);
  }));

test('what is no number is marked and changes nothing', () =>
  shared(async (page) => {
    const before = await textOf(page);
    const radius = field(page, 'radius').locator('.scene-number');
    for (const text of ['', '-', '4,5', 'x', '1e999']) {
      await radius.fill(text);
      assert.equal(await radius.getAttribute('aria-invalid'), 'true', text);
    }
    assert.equal(await textOf(page), before);
  }));

test('the form rests while the text is broken and lists objects in groups', () =>
  open(async (page) => {
    const words = await page.locator('#scene-part option').allInnerTexts();
    assert.ok(words.some((it) => it === '\u00a0\u00a0Object 1 (sphere)'), words.join('|'));
    await type(page, '"title"', 'title');
    await page.locator('.fault-place').waitFor();
    assert.ok(await page.locator('#scene-part').isDisabled());
  }, { path: '/?scene=bubbles&width=64&height=48&samples=1&threshold=0' }));

const srgb = (value) => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);

test('a colour is picked as screens show it and stored in linear light; what is not touched stays', () =>
  shared(async (page) => {
    await choose(page, '/objects/1');
    const picker = field(page, 'color').locator('[type=color]');
    const code = Math.round(255 * srgb(0.2)).toString(16);
    assert.equal(await picker.inputValue(), `#${code.repeat(3)}`);
    await picker.fill(`#80${code}ff`);
    const { color } = (await scene(page)).objects[1].material;
    assert.ok(Math.abs(srgb(color[0]) * 255 - 128) < 0.02, `${color}`);
    assert.deepEqual(color.slice(1), [0.2, 1]);
    assert.equal(await picker.inputValue(), `#80${code}ff`);
    await field(page, 'color').locator('.scene-number').nth(2).fill('7.5');
    await picker.fill(`#00${code}ff`);
    assert.deepEqual((await scene(page)).objects[1].material.color, [0, 0.2, 7.5]);
  }));

test('all 256 codes come back from linear light as themselves', () =>
  shared(async (page) => {
    const wrong = await page.evaluate(async () => {
      const { hexOf, linearOf } = await import('/picture/srgb.js');
      const codes = Array.from({ length: 256 }, (_, i) => `#${i.toString(16).padStart(2, '0').repeat(3)}`);
      return codes.filter((code) => hexOf(linearOf(code)) !== code);
    });
    assert.deepEqual(wrong, []);
  }));

test('every part of every kind of scene has its fields', () =>
  shared(async (page, tia) => {
    for (const name of ['shapes', 'stage', 'textures']) {
      const source = JSON.parse(await tia.get(`/scenes/${name}`));
      const told = await page.evaluate(async (json) => {
        const { partsOf, fieldsOf } = await import('/state/scene_fields.js');
        const schema = await (await fetch('/schema/scene.json')).json();
        return partsOf(json).map(({ pointer }) => [pointer, fieldsOf(schema, json, pointer).map((it) => it.name)]);
      }, source);
      for (const [pointer, names] of told) assert.ok(names.length > 0, `${name} ${pointer}`);
      const first = Object.keys(source.objects[0]).includes('radius');
      assert.equal(told[0][1].includes('radius'), first);
    }
  }));
