// The pages say what the code says: their tables are those that tables.mjs makes, their links lead
// somewhere, and the first page is short.

import assert from 'node:assert/strict';
import { stat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { startTia } from '../browser/tia.mjs';
import { ROOT, pages, tableIn, tablesIn } from './pages.mjs';
import { factsOf, remade } from './tables.mjs';

let tia;
let facts;

before(async () => {
  tia = await startTia(0, [], 'ignore');
  facts = await factsOf(tia);
});
after(() => tia.stop());

for (const { name, text } of pages)
  for (const table of tablesIn(text))
    test(`${name}: the table ${table} is the code's; else node tests/pages/tables.mjs`, () => {
      const [, now] = tableIn(text, table);
      const [, made] = tableIn(remade(text, facts), table);
      assert.ok(made.split('\n').length > 3, 'an empty table');
      assert.equal(now, made);
    });

// As code hosts make them of headings.
const anchorsOf = (text) => [...text.matchAll(/^#+ (.*)$/gm)].map(([, heading]) =>
  heading.toLowerCase().replace(/[^\p{L}\p{N} _-]/gu, '').replaceAll(' ', '-'));

for (const { name, text } of pages)
  test(`${name}: links and pictures lead somewhere`, async () => {
    const prose = text.replaceAll(/^```[^]*?^```/gm, '');
    const links = [...prose.matchAll(/\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"/g)].map(([, a, b]) => a ?? b);
    for (const link of links.filter((each) => !/^https?:/.test(each))) {
      const [path, anchor] = link.split('#');
      const target = path ? join(dirname(name), path) : name;
      await assert.doesNotReject(stat(join(ROOT, target)), link);
      if (anchor) assert.ok(anchorsOf(pages.find((page) => page.name === target).text).includes(anchor), link);
    }
  });

test('the first page has at most 10 kB', () => {
  assert.ok(Buffer.byteLength(pages.find(({ name }) => name === 'README.md').text) <= 10_000);
});
