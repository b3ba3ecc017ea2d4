// Models dropped on the page: sent once, told of, drawn, turned, and taken along.

import assert from 'node:assert/strict';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { glbOf, MTL, OBJ, zipOf } from './model_files.mjs';
import { drop, modelStage, queryOf, still } from './model_stage.mjs';
import { faults, rests, shows, until } from './page.mjs';

const on = modelStage();
const { open, shared } = on;
const sail = glbOf();

const aboutOf = (page, name) => page.locator(`.model-about div:has(dt:text-is("${name}")) dd`).innerText();
const shellOf = (page) => page.locator('.model-shell pre').innerText();

/** The id of a model that the server keeps now. */
async function kept(bytes) {
  const answer = await fetch(`${on.tia.base}/models`, { method: 'POST', body: bytes });
  assert.ok(answer.ok, await answer.clone().text());
  return (await answer.json()).id;
}

// Drops files and waits until the model of them is shown; gives its query.
async function dropped(page, files) {
  const before = queryOf(page).get('model');
  await drop(page, files);
  return still(page, (query) => query.has('model') && query.get('model') !== before);
}

test('a model dropped on the page is sent, told of and drawn, and its address is the picture\u2019s', () =>
  shared(async (page, { sent }) => {
    sent.length = 0;
    const query = await dropped(page, { 'sail.glb': glbOf({ asset: { version: '2.0', generator: 'One that is dropped' } }) });
    assert.deepEqual(sent, ['/models']);
    assert.equal(await page.locator('#tab-model').getAttribute('aria-selected'), 'true');
    assert.equal(await aboutOf(page, 'Triangles'), '1');
    assert.equal(await aboutOf(page, 'Written by'), 'One that is dropped');
    await page.getByText('Not taken from the file: 1').click();
    await page.getByText('EXT_unheard_of').waitFor();
    assert.equal(query.get('samples'), '64');
    assert.ok(await shows(page, await on.tia.get(`/still?model=${query.get('model')}&width=96&height=96`)), 'the server\u2019s own still');
    assert.match(await shellOf(page), /^curl --data-binary '@sail\.glb' 'http.*\/still\?integrator=path&.*' -o tia-model-\w{8}\.png$/);
  }));

test('what the server keeps already is not sent, by whatever name it comes', () =>
  shared(async (page, { sent }) => {
    const id = await kept(sail);
    sent.length = 0;
    const query = await dropped(page, { 'other.glb': sail });
    assert.equal(query.get('model'), id);
    assert.equal(await aboutOf(page, 'Written by'), 'Tia tests');
    assert.deepEqual(sent, []);
  }));

test('files that belong together become one model of all of them, sent once; a ZIP of them is the same', () =>
  shared(async (page, { sent }) => {
    await kept(sail);
    sent.length = 0;
    const files = { 'sail.obj': OBJ, 'sail.mtl': MTL, 'notes.txt': 'none of it' };
    const query = await dropped(page, files);
    assert.deepEqual(sent, ['/models?main=sail.obj']);
    assert.match(await aboutOf(page, 'Bytes'), / in 2 files$/);
    assert.match(await shellOf(page), /^curl -F 'file=@"sail.obj";filename="sail.obj"' -F 'file=@"sail.mtl".* 'http.*&main=sail.obj' -o tia-/);
    await dropped(page, { 'sail.glb': sail });
    assert.equal((await dropped(page, files)).get('model'), query.get('model'));
    assert.equal(sent.length, 1, String(sent));
    const zip = { 'sail.zip': zipOf({ 'sail.obj': OBJ, 'sail.mtl': MTL }) };
    for (const times of [1, 2]) {
      await dropped(page, { 'sail.glb': sail });
      assert.equal((await dropped(page, zip)).get('model'), query.get('model'));
      assert.equal(sent.length, 2, `${times}: ${sent}`); // what is in a ZIP is known once it was read
    }
  }));

test('of several models the page asks which is meant; a broken one tells its fault and changes nothing', () =>
  shared(async (page) => {
    const before = page.url();
    await drop(page, { 'a.glb': sail, 'b.stl': 'solid b\nfacet normal 0 0 x\n' });
    await page.locator('.model-ask button', { hasText: 'b.stl' }).click();
    await page.locator('#model-said .fault').first().waitFor();
    await drop(page, { 'broken.glb': glbOf({ accessors: [{ bufferView: 9, componentType: 5126, count: 3, type: 'VEC3' }] }) });
    await page.locator('#model-said', { hasText: '/accessors/0/bufferView' }).waitFor();
    await drop(page, { 'a.glb': sail, 'b.ply': '' });
    await page.locator('.model-ask button', { hasText: 'a.glb' }).waitFor();
    assert.equal(page.url(), before);
  }));

test('a folder is chosen by its button; an upload that broke off is tried again', () =>
  shared(async (page) => {
    await page.locator('#tab-model').click();
    const folder = await mkdtemp(join(tmpdir(), 'tia-'));
    try {
      await mkdir(join(folder, 'ship'));
      await writeFile(join(folder, 'ship', 'sail.obj'), `# of a folder\n${OBJ}`);
      await writeFile(join(folder, 'ship', 'sail.mtl'), MTL);
      await page.route('**/models?main=*', (route) => route.abort());
      const choosing = page.waitForEvent('filechooser');
      await page.getByRole('button', { name: 'Open a folder\u2026' }).click();
      await (await choosing).setFiles(folder);
      const again = page.locator('.model-ask button', { hasText: 'Try again' });
      await again.waitFor();
      await page.unroute('**/models?main=*');
      await again.click();
      await until(async () => /^curl -F 'file=@"sail\.(obj|mtl)"/.test(await shellOf(page)), 'the line of its files');
    } finally {
      await rm(folder, { recursive: true });
    }
  }));

test('arrow keys and the hand turn a model, plus and the wheel change its size', () =>
  shared(async (page, { stills }) => {
    const id = (await dropped(page, { 'turned.glb': glbOf({ asset: { version: '2.0', generator: 'Turned' } }) })).get('model');
    stills.length = 0;
    await page.locator('#hand').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('+');
    const turned = await still(page, (query) => query.has('orbit') && query.has('zoom'));
    assert.ok(Number(turned.get('orbit').split(',')[0]) < 30, turned.get('orbit'));
    assert.ok(Number(turned.get('zoom')) > 1, turned.get('zoom'));
    const { x, y, width, height } = await page.locator('#hand').boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2, y + height * 0.75);
    await page.mouse.up();
    await still(page, (query) => query.get('orbit').endsWith(',65')); // a quarter of the height is 45 degrees more than 20
    await page.mouse.wheel(0, 200);
    await still(page, (query) => Number(query.get('zoom')) < Number(turned.get('zoom')));
    assert.ok(stills.every((query) => query.get('model') === id && query.get('integrator') === 'path'));
  }));

test('a point of a model is asked why by the method whose rays can be told; the picture comes back after it', () =>
  shared(async (page, { stills }) => {
    const query = await dropped(page, { 'asked.glb': glbOf({ asset: { version: '2.0', generator: 'Asked' } }) });
    stills.length = 0;
    await page.locator('#hand').click();
    await page.locator('#panel-why [role=treeitem], #panel-why li').first().waitFor();
    await still(page, (now) => now.has('pixel'));
    assert.equal(queryOf(page).get('integrator'), 'path');
    assert.ok(stills.every((asked) => asked.get('integrator') === 'whitted' && asked.get('samples') === '1'), String(stills));
    await page.getByRole('button', { name: 'Stop asking' }).click();
    await still(page, (now) => !now.has('pixel'));
    assert.ok(await shows(page, await on.tia.get(`/still?${query}`)), 'the picture of before');
  }));

test('studio, ground, background, variant, camera, animation, time and what is hidden are chosen, and Start again forgets them', () =>
  shared(async (page) => {
    const id = (await dropped(page, { 'chosen.glb': glbOf({ asset: { version: '2.0', generator: 'Chosen' } }) })).get('model');
    const choose = (name, value) => page.locator(`.model-shown select[name=${name}]`).selectOption(value);
    await choose('studio', 'sun');
    assert.equal(await page.locator('.model-shown select[name=ground]').inputValue(), 'shadow');
    await choose('ground', 'floor');
    assert.ok(await page.locator('.model-shown input[name=color]').isHidden());
    await choose('background', 'color');
    await page.getByLabel('Its colour').fill('#ff8000');
    await choose('variant', { label: 'blue one' });
    await page.getByRole('group', { name: 'Hide' }).getByLabel('red').press('Space');
    await choose('camera', { label: 'Front' });
    await choose('animation', { label: 'Glide' });
    await page.locator('.model-shown input[name=time]').focus();
    await page.keyboard.press('End');
    const query = await still(page, (now) => now.get('time') === '2');
    const said = { studio: 'sun', ground: 'floor', background: '1,0.21586,0', hide: 'red', camera: '0', variant: 'blue one', animation: '0' };
    for (const [name, value] of Object.entries(said)) assert.equal(query.get(name), value, name);
    assert.ok(await shows(page, await on.tia.get(`/still?${query}`)), 'the still of all that was chosen');
    await page.locator('#start-again').click();
    const rest = await still(page, (now) => !now.has('studio'));
    assert.deepEqual([...rest.keys()].sort(), ['height', 'integrator', 'model', 'samples', 'width']);
    assert.equal(rest.get('model'), id);
  }));

test('a model goes on as a scene of the same bytes', () =>
  shared(async (page) => {
    const query = await dropped(page, { 'scene.glb': glbOf({ asset: { version: '2.0', generator: 'Scene' } }) });
    await page.getByRole('button', { name: 'Go on as a scene' }).click();
    await until(() => new URL(page.url()).searchParams.get('scene')?.includes(query.get('model')) || page.url().includes('#z='), 'a scene\u2019s address');
    await rests(page);
    assert.match(await page.locator('#scene-text').inputValue(), new RegExp(`"id":\\s*"${query.get('model')}"`));
    assert.ok(await shows(page, await on.tia.get(`/still?${query}`)), 'the same picture');
    await page.locator('#seen', { hasText: 'model: ' }).waitFor();
    await page.goBack();
    assert.equal((await still(page, (now) => now.has('model'))).get('model'), query.get('model'));
  }));

test('a link with the name of a gallery\u2019s model shows it, and its line fetches by the name', () =>
  open(async (page, { sent }) => {
    await page.locator('#tab-model').click();
    await page.locator('.model-shown').waitFor();
    assert.equal(await aboutOf(page, 'Format'), 'STL');
    assert.match(await shellOf(page), /^curl -o tia-model-part\.png 'http.*\/still\?model=part&/);
    assert.deepEqual(sent, []);
    await page.getByRole('group', { name: 'Models of the gallery' }).getByRole('button', { name: 'scan' }).click();
    await until(async () => await aboutOf(page, 'Format') === 'PLY', 'another model of the gallery');
    const bare = `${on.tia.base}/?model=part&width=64&height=64`;
    await page.goto(bare);
    const query = await still(page, (now) => now.get('width') === '64');
    assert.deepEqual(['integrator', 'samples', 'threshold'].map((name) => query.get(name)), ['path', '64', null]);
  }));

test('a model that is not kept is told of, and Start again leads on', () =>
  open(async (page) => {
    await page.locator('#problem').filter({ hasText: /\S/ }).waitFor();
    await page.locator('#start-again').click();
    await until(() => queryOf(page).get('scene') === 'thesis', 'the first scene');
  }, { path: `/?model=${'0'.repeat(64)}`, ready: () => {} }));

for (const [colorScheme, locale, width] of [['light', 'en-US', 1280], ['dark', 'vi-VN', 320]]) {
  test(`axe finds nothing in a model\u2019s panel and nothing scrolls sideways: ${colorScheme}, ${locale}, ${width} px`, () =>
    open(async (page) => {
      await dropped(page, { 'sail.glb': sail });
      await page.locator('select[name=animation]').selectOption('0');
      await page.locator('details.warnings').evaluate((it) => (it.open = true));
      assert.deepEqual(await faults(page), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }, { colorScheme, locale, viewport: { width, height: 800 } }));
}

test('a turntable of the model as it is seen is drawn on one sheet and saved', () =>
  open(async (page) => {
    await page.locator('#tab-model').click();
    await page.getByRole('spinbutton', { name: 'Views' }).fill('3');
    await page.getByLabel('Columns').fill('4');
    await page.getByRole('button', { name: 'Draw and save the sheet' }).click();
    await page.getByText('Columns: a whole number from 1 to 3').waitFor();
    await page.getByLabel('Columns').fill('2');
    const coming = page.waitForEvent('download');
    await page.keyboard.press('Enter');
    const download = await coming;
    assert.equal(download.suggestedFilename(), 'tia-model-part-turntable.png');
    const sheet = await on.tia.get(`/still?model=part&integrator=path&samples=4&width=96&height=96&turntable=3&columns=2`);
    assert.deepEqual(await readFile(await download.path()), sheet);
    await page.getByText('Saved: 3 views of 96 \u00d7 96 pixels.').waitFor();
    const shown = page.getByRole('img', { name: 'The sheet of 3 views' });
    assert.deepEqual(await shown.evaluate((it) => [it.naturalWidth, it.naturalHeight]), [192, 192]);
    const line = await page.locator('.turn-shell pre').innerText();
    assert.match(line, /^curl -o tia-model-part-turntable\.png 'http.*'$/);
    assert.deepEqual(await on.tia.get(line.match(/'http:\/\/[^/]*(.*)'/)[1]), sheet);
    assert.deepEqual(await faults(page, '#panel-model'), []);
    await page.locator('.model-shown select[name=studio]').selectOption('sun');
    await shown.waitFor({ state: 'detached' });
    await still(page, (query) => query.get('studio') === 'sun');
  }));
