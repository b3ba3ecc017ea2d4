// The page of documentation: it tells all that the server's OpenAPI document holds, every link
// leads somewhere, and anyone can read it on any screen or on paper.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faults } from './page.mjs';
import { stage } from './stage.mjs';

const on = stage();
let openapi; // the document

// Visits the documentation, and waits until it is drawn.
const read = (body, options) =>
  on.look(async (page) => {
    openapi ??= JSON.parse(await on.tia.get('/openapi.json'));
    await page.locator('#json').waitFor();
    await body(page);
  }, { path: '/docs', ready: () => {}, ...options });

const operations = () => Object.entries(openapi.paths).flatMap(([path, methods]) =>
  Object.entries(methods).map(([method, operation]) => ({ ...operation, path, method: method.toUpperCase() })));

// What the page tells at each id: its words, the names of its fields, and the links in it.
const told = (page) => page.evaluate(() => Object.fromEntries([...document.querySelectorAll('[id]')].map((it) => [it.id, {
  words: it.textContent,
  names: [...it.querySelectorAll('dt')].map((name) => name.textContent),
  links: [...it.querySelectorAll('a')].map((link) => link.getAttribute('href')),
}])));

test('every route is there, in order, with its parameters, bodies, examples and answers', () =>
  read(async (page) => {
    const parts = await told(page);
    const ids = await page.locator('#requests > section').evaluateAll((all) => all.map((it) => it.id));
    assert.deepEqual(ids, operations().map(({ operationId }) => operationId));
    for (const { operationId, method, path, summary, responses, parameters = [], requestBody, 'x-examples': targets = [] } of operations()) {
      const { words, names, links } = parts[operationId];
      assert.ok(words.startsWith(`${method} ${path}${summary}`), words.slice(0, 80));
      const statuses = Object.keys(responses).filter((status) => status !== 'default');
      assert.deepEqual(names, [...parameters.map(({ name }) => name), ...statuses], operationId);
      for (const { description } of parameters) assert.ok(words.includes(description), description);
      for (const type of Object.keys(requestBody?.content ?? {})) assert.ok(words.includes(type), type);
      for (const target of targets) assert.ok(links.includes(target.slice(1)), target);
    }
    assert.ok(parts.get_render.words.includes('an integer from 1 to 16777216; default 640'));
    assert.ok(parts.post_render.words.includes(`curl localhost:8080/render -d '{"key": "a"}'`));
    assert.match(parts.get_render.words, /429busy/);
    assert.deepEqual(parts.get_ready.links.filter((to) => /draining|Retry/.test(to)), ['#header-Retry-After', '#problem-draining']);
  }));

test('every problem, header and option is there with what it means', () =>
  read(async (page) => {
    const parts = await told(page);
    const rows = [
      ...openapi['x-problems'].map(({ type, status, ...row }) => [`problem-${type.split('/')[2]}`, type, row.title, row.description, `status ${status}`]),
      ...Object.entries(openapi.components.headers).map(([name, { description, schema }]) => [`header-${name}`, name, description, schema.pattern]),
      ...openapi['x-options'].map(({ name, ...row }) => [`option-${name}`, row.flag, row.variable, row.description, row.allowed, row.default ?? '']),
    ];
    assert.ok(rows.length > 60);
    for (const [id, ...texts] of rows)
      for (const text of texts) assert.ok(parts[id]?.words.includes(text), `${id}: ${text}`);
  }));

test('every named schema is there with its fields in order, what all kinds share told once', () =>
  read(async (page) => {
    const parts = await told(page);
    const without = (all, some) => all.filter((name) => !some.includes(name)).sort();
    for (const [name, { properties, oneOf }] of Object.entries(openapi.components.schemas)) {
      const { words, names } = parts[`json-${name}`];
      const kinds = oneOf?.every((kind) => kind.properties?.type?.const) && !properties ? oneOf : [];
      if (properties) assert.deepEqual(names, Object.keys(properties), name);
      for (const kind of kinds) {
        assert.ok(parts[`json-${name}-${kind.properties.type.const}`], kind.properties.type.const);
        assert.deepEqual(without(Object.keys(kind.properties), names), []);
        for (const { description } of Object.values(kind.properties)) assert.ok(words.includes(description ?? ''), description);
      }
    }
    const { names } = parts['json-object'];
    assert.equal(names.filter((name) => name === 'material').length, 1);
    assert.equal(names.filter((name) => name === 'minor_radius').length, 1);
    assert.ok(names.indexOf('major_radius') < names.indexOf('minor_radius'));
  }));

test('every id is there once, and every link leads somewhere', () =>
  read(async (page) => {
    const ids = await page.locator('[id]').evaluateAll((all) => all.map((it) => it.id));
    assert.equal(new Set(ids).size, ids.length);
    const hrefs = await page.locator('a[href]').evaluateAll((all) => all.map((it) => it.href));
    const here = hrefs.filter((href) => href.startsWith(`${page.url()}#`));
    assert.ok(here.length > 200);
    for (const href of here) assert.ok(ids.includes(new URL(href).hash.slice(1)), href);
    const others = new Set(hrefs.filter((href) => !here.includes(href)));
    for (const href of others) {
      assert.equal(new URL(href).origin, on.tia.base);
      assert.equal((await fetch(href)).status, 200, href);
    }
  }));

test('what the document says is text, not HTML', () =>
  read(async (page) => {
    const hostile = '<img src="x" onerror="document.title = 1">';
    await page.route('**/openapi.json', (route) => route.fulfill({ json: JSON.parse(
      JSON.stringify(openapi).replaceAll('a picture; no parameter is required', JSON.stringify(hostile).slice(1, -1))) }));
    await page.reload();
    await page.locator('#get_render p', { hasText: hostile }).waitFor();
    assert.equal(await page.locator('main img').count(), 0);
  }));

test('a schema in words says what it allows', () =>
  read(async (page) => {
    const words = {
      '{"type":"number"}': 'a number',
      '{"type":"number","minimum":0,"maximum":1}': 'a number from 0 to 1',
      '{"type":"number","exclusiveMinimum":0,"maximum":1e9}': 'a number above 0 to 1e9',
      '{"type":"integer","minimum":3}': 'an integer, at least 3',
      '{"type":"number","maximum":1500000,"not":{"const":0}}': 'a number, at most 1500000, not 0',
      '{"type":"array","minItems":3,"maxItems":3,"items":{"type":"number"}}': '3 numbers',
      '{"type":"array","items":{"type":"integer","minimum":0}}': 'a list of integers, each at least 0',
      '{"type":"array","minItems":2,"items":{"type":"string"}}': 'a list of at least 2, each text',
      '{"type":"string","maxLength":256}': 'text of at most 256 characters',
      '{"enum":["a","b<"]}': 'one of <code>a</code>, <code>b&lt;</code>',
      '{"anyOf":[{"$ref":"#/components/schemas/thing"},{"type":"null"}]}': '<a href="#json-thing">thing</a> or <code>null</code>',
      '{"type":"object","additionalProperties":{"type":"boolean"}}': 'an object whose members are each <code>true</code> or <code>false</code>',
      '{}': 'any value',
    };
    const said = await page.evaluate(async (schemas) => {
      const [{ schemaWords }, { element }] = await Promise.all([import('/docs/schema.js'), import('/panels/element.js')]);
      return schemas.map((schema) => element('p', {}, schemaWords(JSON.parse(schema))).innerHTML);
    }, Object.keys(words));
    assert.deepEqual(said, Object.values(words));
  }));

test('where the document cannot be had the page says so, and tries again when told', () =>
  read(async (page) => {
    const title = 'The server has too much to do';
    const problem = { status: 429, contentType: 'application/problem+json', json: { title } };
    for (const [answer, said] of [[(route) => route.abort(), 'The server cannot be reached'], [(route) => route.fulfill(problem), title]]) {
      await page.route('**/openapi.json', answer, { times: 1 });
      await page.reload();
      await page.getByRole('alert').getByText(said).waitFor();
      await page.getByRole('button', { name: 'Try again' }).click();
      await page.locator('#json').waitFor();
      assert.equal(await page.getByRole('alert').count(), 0);
    }
  }, { failing: true }));

test('without JavaScript it says what it lacks and leads to the document', async () => {
  const page = await on.browser.newPage({ javaScriptEnabled: false });
  await page.goto(`${on.tia.base}/docs`);
  assert.match(await page.locator('noscript').innerText(), /needs JavaScript/);
  await page.locator('noscript').getByRole('link', { name: 'openapi.json' }).click();
  assert.equal(page.url(), `${on.tia.base}/openapi.json`);
  await page.close();
});

test('every module of it is asked for at once', () =>
  read(async (page) => {
    const preloaded = await page.locator('link[rel=modulepreload]').evaluateAll((all) => all.map((it) => it.getAttribute('href')));
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource')
      .map(({ name }) => new URL(name).pathname.slice(1)).filter((path) => path.endsWith('.js') && path !== 'docs/page.js'));
    assert.deepEqual([...new Set(loaded)].sort(), preloaded.sort());
  }));

test('the page leads to it, and it leads back', () =>
  on.look(async (page) => {
    await page.getByRole('link', { name: 'Documentation' }).click();
    await page.getByRole('heading', { level: 1, name: 'Tia documentation' }).waitFor();
    await page.getByRole('link', { name: 'Tia' }).first().click();
    await page.locator('#picture').waitFor();
  }));

for (const [media, width] of [['screen', 320], ['screen', 768], ['screen', 1280], ['screen', 1920], ['print', 720]]) {
  test(`on a ${media} of ${width} px nothing scrolls sideways and nothing is cut off`, () =>
    read(async (page) => {
      await page.emulateMedia({ media });
      const wide = await page.evaluate(() => [...document.querySelectorAll('body *')]
        .filter((it) => it.getBoundingClientRect().right > innerWidth).map((it) => it.outerHTML.slice(0, 80)));
      assert.deepEqual(wide, []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }, { viewport: { width, height: 740 } }));
}

for (const [colorScheme, width] of [['light', 1280], ['dark', 320]]) {
  test(`axe finds nothing in the ${colorScheme} theme at ${width} px`, () =>
    read(async (page) => {
      assert.deepEqual(await faults(page), []);
    }, { colorScheme, viewport: { width, height: 740 } }));
}

test('the contents list every heading of the second level and lead to it', () =>
  read(async (page) => {
    const contents = page.getByRole('navigation', { name: 'Contents' });
    const headings = await page.locator('main h2').allTextContents();
    assert.ok(headings.length >= 5);
    for (const name of headings) {
      await contents.getByRole('link', { name, exact: true }).click();
      const { y } = await page.getByRole('heading', { level: 2, name, exact: true }).boundingBox();
      assert.ok(y >= 0 && y < 740, `${name} at ${y}`);
    }
  }, { viewport: { width: 1280, height: 740 } }));

test("a problem's type, opened as an address, leads to what it means", () =>
  read(async (page) => {
    const meaning = page.locator(':target');
    assert.match(await meaning.textContent(), /\/problems\/busy.*too much to do.*Retry-After/);
    assert.ok((await meaning.boundingBox()).y < 740);
  }, { path: '/problems/busy', viewport: { width: 1280, height: 740 } }));

test('Tab comes to a link that skips the contents first', () =>
  read(async (page) => {
    await page.keyboard.press('Tab');
    const skip = page.getByRole('link', { name: 'Skip the contents' });
    assert.ok(await skip.evaluate((it) => it === document.activeElement));
    assert.ok((await skip.boundingBox()).y >= 0);
    await page.keyboard.press('Enter');
    assert.equal(new URL(page.url()).hash, '#requests');
  }));
