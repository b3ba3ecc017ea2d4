// The tables of the pages that say what the program or the tree says already, made from there:
//   node tests/pages/tables.mjs    writes them into the pages, between <!-- table: NAME --> and <!-- end -->
// tables.test.mjs holds the pages to them.

import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { BINARY, startTia } from '../browser/tia.mjs';
import { ROOT, pages, tableIn, tablesIn } from './pages.mjs';

const row = (...cells) => `| ${cells.map((cell) => String(cell).replaceAll('|', '\\|')).join(' | ')} |\n`;
const table = (head, rows) => row(...head) + `|${'---|'.repeat(head.length)}\n` + rows.map((cells) => row(...cells)).join('');
const code = (text) => `\`${text}\``;

// 67108864 bytes as 64 MiB, 30000 ms as 30 000 ms.
function quantity(number, unit) {
  const sizes = { PiB: 2 ** 50, TiB: 2 ** 40, GiB: 2 ** 30, MiB: 2 ** 20, KiB: 2 ** 10 };
  const fitting = unit === 'bytes' && number > 0 && Object.keys(sizes).find((size) => number % sizes[size] === 0);
  if (fitting) return `${number / sizes[fitting]} ${fitting}`;
  const digits = number < 10_000 ? String(number) : String(number).replace(/\B(?=(\d{3})+$)/g, ' ');
  return unit && number > 0 ? `${digits} ${unit}` : digits;
}

// ---- the options -----------------------------------------------------------------------------------

// What the machine says, and not the table.
const OF_THE_MACHINE = { TIA_THREADS: 'the processors', TIA_MEMORY_BYTES: 'three quarters' };

function options() {
  const text = execFileSync(BINARY, ['--print-config'], { env: {}, encoding: 'utf8' });
  return table(['option', 'default', 'meaning'],
    [...text.matchAll(/^# (.*): (?:text|an integer (.*)|a number .*|a list .*)\n(TIA_\w+)=(.*)$/gm)].map(([, about, range, name, value]) => {
      const [, unit] = /\((\w+)\)$/.exec(range) ?? [];
      const told = value === '' ? 'none' : range ? quantity(Number(value), unit) : value;
      return [code(name), OF_THE_MACHINE[name] ?? told, about];
    }));
}

// ---- the scene -------------------------------------------------------------------------------------

const COMMON = { object: ['type', 'name', 'material', 'materials', 'transform'], texture: ['type'],
  display: ['type'], light: ['type', 'color', 'intensity', 'fade_distance', 'fade_power'] };

/** The kinds of a list with their fields: those that must be there, and the others with their defaults. */
function kinds({ schema }, list) {
  const seen = new Map(); // fields -> the kinds that have these
  for (const { properties, required = [] } of schema.$defs[list].oneOf) {
    const own = Object.keys(properties).filter((name) => !COMMON[list].includes(name));
    const text = [
      required.filter((name) => own.includes(name)).map(code).join(' '),
      own.filter((name) => !required.includes(name)).map((name) => standard(name, properties[name])).join(', '),
    ];
    const key = text.join('|');
    seen.set(key, { text, types: [...seen.get(key)?.types ?? [], properties.type.const] });
  }
  return table(['`type`', 'required', 'optional'],
    [...seen.values()].map(({ text, types }) => [types.map(code).join(' '), ...text]));
}

function standard(name, { default: value }) {
  const plain = value === undefined || Array.isArray(value) && value.length === 0 || JSON.stringify(value) === '{}';
  return plain ? code(name) : `${code(name)} ${code(JSON.stringify(value))}`;
}

/** The fields of the options, or of a material of that type, each with its default. */
const fieldsOf = ({ schema }, name, type) => table(['field', 'default', 'field', 'default', 'field', 'default'],
  threes((schema.$defs[name].oneOf ?? [schema.$defs[name]]).filter((kind) => !type || kind.properties.type.const === type)
    .flatMap((kind) => Object.entries(kind.properties)).filter(([field]) => field !== 'type')
    .map(([field, { default: value }]) => [code(field), value === undefined ? '' : code(JSON.stringify(value))])));

function threes(cells) {
  const rows = [];
  for (let i = 0; i < cells.length; i += 3) rows.push([...cells.slice(i, i + 3).flat(), '', '', '', ''].slice(0, 6));
  return rows;
}

// ---- what stands in the tree -----------------------------------------------------------------------

function gallery({ scenes }) {
  const cells = scenes.map(({ name, title }) => {
    const file = { thesis: 'a', shapes: 'shapes' }[name] ?? `gallery/${name}`;
    return `[![${title}](../../tests/golden/${file}.png)](${name}.json)<br>${title}`;
  });
  const rows = [];
  for (let i = 0; i < cells.length; i += 4) rows.push([...cells.slice(i, i + 4), '', '', ''].slice(0, 4));
  return table(['', '', '', ''], rows);
}

function steps() {
  const text = readFileSync(join(ROOT, 'tests/steps.sh'), 'utf8');
  return table(['step', 'when', 'what it protects'],
    [...text.matchAll(/^ {2}'(.*)\|(.*)\|(.*)\|(.*)'$/gm)].map(([, name, when, , what]) =>
      [code(name.trim()), when.trim() === 'full' ? '`--full`' : 'each change', what.trim()]));
}

// ----------------------------------------------------------------------------------------------------

const TABLES = {
  options, gallery, steps,
  shapes: (facts) => kinds(facts, 'object'),
  lights: (facts) => kinds(facts, 'light'),
  textures: (facts) => kinds(facts, 'texture'),
  displays: (facts) => kinds(facts, 'display'),
  finish: (facts) => fieldsOf(facts, 'material', 'finish'),
  principled: (facts) => fieldsOf(facts, 'material', 'principled'),
  'scene-options': (facts) => fieldsOf(facts, 'options'),
};

/** What the running program says of itself. */
export async function factsOf(tia) {
  const json = async (path) => JSON.parse(await tia.get(path));
  return { schema: await json('/schema/scene.json'), scenes: (await json('/scenes')).scenes };
}

/** A page's text with its tables made anew. */
export const remade = (text, facts) => tablesIn(text).reduce((whole, name) => {
  const [before, , after] = tableIn(whole, name);
  return before + TABLES[name](facts) + after;
}, text);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const tia = await startTia(0, [], 'ignore');
  const facts = await factsOf(tia).finally(() => tia.stop());
  for (const { name, text } of pages) writeFileSync(join(ROOT, name), remade(text, facts));
}
