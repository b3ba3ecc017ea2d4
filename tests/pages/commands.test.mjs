// Every command that a page shows runs, in the page's order, in one shell and an empty folder beside
// a server of its own that is called localhost:8080. A command's status must be 0, the answers of its
// curls below 400, or what its comment says ("# 422"), and files that it names with -o must be there.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, readFile, readdir, rm, stat, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { BINARY, startTia } from '../browser/tia.mjs';
import { ROOT, blocksOf, commandsOf, pages, syntaxFault } from './pages.mjs';

// The word after ```sh of blocks that do not run here, and what runs them instead. Of these blocks the
// syntax is checked, and that the files that they name are there.
const ELSEWHERE = {
  build: 'they build from nothing: tests/run.sh and server/run.sh are what continuous integration calls',
  minutes: 'they measure or test for minutes',
  writes: 'they change files of the repository: tables.test.mjs and the golden tests hold the results',
  docker: 'tests/deploy/image.test.mjs lays the image out as the Dockerfile does',
  root: 'tests/deploy/balancer.test.mjs runs HAProxy with the same file and options',
  cluster: 'tests/deploy/manifests.test.mjs holds the manifests to the fields of Kubernetes',
};

// Says every status that curl gets on standard error.
const CURL = `curl() { command curl -sS --max-time 60 -w '%{stderr}~%{http_code}~' "$@"; }\n`;
const MAGIC = { png: '\x89PNG', pfm: ['PF\n', 'Pf\n'], hdr: '#?RA', tiff: 'II*\0', exr: 'v/1\x01' };

const shellBlocks = (page) => blocksOf(page).filter(({ language }) => language === 'sh');

/** A folder in which the paths of the repository hold, too. */
async function workplace() {
  const folder = await mkdtemp(join(tmpdir(), 'tia-pages-'));
  for (const name of await readdir(ROOT))
    if (name !== '.git' && name !== 'build') await symlink(join(ROOT, name), join(folder, name));
  await symlink(dirname(dirname(BINARY)), join(folder, 'build'));
  return folder;
}

/** Runs commands in one shell and gives { code, said } of each. */
async function runAll(commands, port) {
  const folder = await workplace();
  const script = commands.map(({ text }, i) => `{ ${text.replaceAll('localhost:8080', `localhost:${port}`)}
} < /dev/null > ${i}.out 2>&1\necho $? > ${i}.code\n`).join('');
  await writeFile(join(folder, 'commands.sh'), CURL + script);
  const shell = spawn('bash', ['commands.sh'], { cwd: folder, detached: true, stdio: 'ignore',
    env: { PATH: process.env.PATH, HOME: folder, LANG: 'C.UTF-8' } });
  await once(shell, 'exit');
  try {
    process.kill(-shell.pid); // what still runs in the background
  } catch { /* nothing does */ }
  const read = (name) => readFile(join(folder, name), 'latin1').catch(() => '');
  const results = await Promise.all(commands.map(async ({ text }, i) => ({
    code: await read(`${i}.code`), said: await read(`${i}.out`), files: await filesOf(text, folder) })));
  await rm(folder, { recursive: true });
  return results;
}

// The files that a command names with -o, and how each begins.
const filesOf = (text, folder) => Promise.all([...text.matchAll(/ -o (\S+)/g)].map(async ([, name]) => {
  const bytes = await readFile(join(folder, name), 'latin1').catch(() => '');
  return { name, start: bytes.slice(0, 4) };
}));

function judge({ text, status }, { code, said, files }) {
  const statuses = [...said.matchAll(/~(\d{3})~/g)].map(([, each]) => Number(each));
  const about = `${text}\n${said.slice(0, 2000)}`;
  assert.equal(code.trim(), '0', about);
  if (status) assert.ok(statuses.includes(status), `${status} was to come, not ${statuses}: ${about}`);
  else assert.ok(statuses.every((each) => each < 400), about);
  for (const { name, start } of files) {
    const magic = MAGIC[name.split('.').pop()];
    assert.ok(status >= 300 || (magic ? [magic].flat().some((each) => start.startsWith(each)) : start), `${name} is not there: ${about}`);
  }
}

for (const page of pages) {
  const commands = shellBlocks(page).filter(({ kind }) => !kind).flatMap(commandsOf);
  if (commands.length === 0) continue;
  test(page.name, async (t) => {
    const tia = await startTia(0, [], 'ignore');
    const results = await runAll(commands, tia.port).finally(() => tia.stop());
    for (const [i, command] of commands.entries())
      await t.test(`line ${command.line}`, () => judge(command, results[i]));
  });
}

test('what does not run here is of a known kind, and could run', async () => {
  for (const page of pages)
    for (const { kind, line, text } of shellBlocks(page).filter((block) => block.kind)) {
      const where = `${page.name}:${line}`;
      assert.ok(ELSEWHERE[kind], `${where}: ${kind} is no kind of block`);
      assert.equal(syntaxFault(text), '', where);
      for (const [, path] of text.matchAll(/(?:^|[\s=])((?:server|tests|web|core)\/[\w./-]+)/gm))
        await assert.doesNotReject(stat(join(ROOT, path)), `${where}: ${path}`);
    }
});

test('commands stand in blocks, where they are tested, and not within sentences', () => {
  const command = /^(TIA_\w+=\S+ )?(curl|docker|kubectl|node|npm|npx|python3?|cmake|ninja|ctest|git|tia render|(build|tests|server)\/\S+) \S/;
  for (const page of pages)
    for (const [, text] of page.text.replaceAll(/^```[^]*?^```/gm, '').matchAll(/`([^`\n]+)`/g))
      assert.doesNotMatch(text, command, page.name);
  for (const page of pages)
    for (const { language, line } of blocksOf(page))
      assert.match(language, /^(sh|text|json|cpp|js|html)$/, `${page.name}:${line}`);
});
