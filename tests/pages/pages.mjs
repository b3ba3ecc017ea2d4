// The pages (README.md and server/OPERATING.md, wherever they stand) and what is fenced in them.

import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = fileURLToPath(new URL('../../', import.meta.url));

/** Every page of the repository: { name, text }. */
export const pages = execFileSync('find', ['.', '-name', '*.md', '-not', '-path', '*/node_modules/*',
  '-not', '-path', './build/*'], { cwd: ROOT, encoding: 'utf8' })
  .trim().split('\n').map((path) => path.slice(2)).sort()
  .map((name) => ({ name, text: readFileSync(join(ROOT, name), 'utf8') }));

/** The fenced blocks of a page: { kind, language, line, text }, `line` that of the first line inside. */
export function blocksOf(page) {
  const blocks = [];
  let open;
  page.text.split('\n').forEach((line, index) => {
    const fence = /^```(\S*) ?(.*)$/.exec(line);
    if (!fence) open?.lines.push(line);
    else if (open) {
      blocks.push({ language: open.language, kind: open.kind, line: open.line, text: open.lines.join('\n') });
      open = undefined;
    } else open = { language: fence[1], kind: fence[2], line: index + 2, lines: [] };
  });
  if (open) throw new Error(`${page.name}:${open.line}: the fence is not closed`);
  return blocks;
}

/** What bash finds wrong with a text, or ''. */
export const syntaxFault = (text) => spawnSync('bash', ['-n'], { input: text, encoding: 'utf8' }).stderr;

/** The commands of a block, each perhaps of several lines: { line, text, status }. */
export function commandsOf(block) {
  const commands = [];
  let lines = [];
  block.text.split('\n').forEach((line, index) => {
    if (lines.length === 0 && /^\s*(#.*)?$/.test(line)) return;
    lines.push(line);
    const text = lines.join('\n');
    if (/\\$/.test(line) || syntaxFault(text)) return;
    commands.push({ line: block.line + index + 1 - lines.length, text, status: statusIn(text) });
    lines = [];
  });
  if (lines.length > 0) commands.push({ line: block.line, text: lines.join('\n') });
  return commands;
}

// "# 422: too small" says which status is to come.
function statusIn(text) {
  const told = /\s#\s+([1-5]\d\d)\b/.exec(text);
  return told && Number(told[1]);
}

/** The part of a page between a table's markers: [before, inside, after]. */
export function tableIn(text, name) {
  const start = `<!-- table: ${name} -->\n`;
  const from = text.indexOf(start);
  const to = text.indexOf('<!-- end -->', from);
  if (from < 0 || to < 0) throw new Error(`no table ${name}`);
  return [text.slice(0, from + start.length), text.slice(from + start.length, to), text.slice(to)];
}

/** The names of the tables that a page holds. */
export const tablesIn = (text) => [...text.matchAll(/^<!-- table: (\S+) -->$/gm)].map(([, name]) => name);
