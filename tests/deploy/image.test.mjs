// What the container image holds, laid out as the Dockerfile does it: no more than it needs, it runs
// alone, and its list of parts is true.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { copyFile, mkdtemp, readFile, readdir, rm, stat } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { BINARY } from '../browser/tia.mjs';

const run = promisify(execFile);
const LAY_OUT = fileURLToPath(new URL('../../server/image.sh', import.meta.url));

let folder;
let image;
let files;
let sbom;
let parts; // of other people

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'tia-image-'));
  image = join(folder, 'image');
  await run(LAY_OUT, [dirname(BINARY), image]);
  const entries = await readdir(image, { recursive: true, withFileTypes: true });
  files = entries.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath ?? entry.path, entry.name));
  sbom = JSON.parse(await readFile(join(image, 'sbom.spdx.json'), 'utf8'));
  parts = sbom.packages.filter(({ name }) => name !== 'tia');
});

after(() => rm(folder, { recursive: true }));

const inImage = (path) => path.slice(image.length);
const isLibrary = (path) => /\.so(\.[0-9.]+)?$/.test(path);

// The packages that own a file of this machine, by the path before or after /usr was merged.
async function ownersOf(path) {
  const ask = (file) => run('dpkg', ['-S', file]).then(({ stdout }) => stdout, () => '');
  const told = await ask(path) + await ask(`/usr${path}`);
  return told.trim().split('\n').map((line) => line.split(':')[0]);
}

test('the image is small and holds the program, libraries, licences and the list alone', async () => {
  const sizes = await Promise.all(files.map(async (file) => (await stat(file)).size));
  assert.ok(sizes.reduce((sum, size) => sum + size) <= 60e6);
  for (const file of files.map(inImage))
    assert.match(file, /^\/(tia|LICENSE|sbom\.spdx\.json)$|\/lib[^/]*\/.*\.so|^\/usr\/share\/doc\/[^/]+\/copyright$/);
});

test('the program finds all its libraries there, whoever runs it', { skip: process.getuid() !== 0 }, async () => {
  const { stdout } = await run('chroot', ['--userspec=12345:0', image, '/tia', '--version']);
  assert.equal(stdout, (await run(BINARY, ['--version'])).stdout);
});

test('every library is of a package in the list', async () => {
  const names = parts.map(({ name }) => name);
  const libraries = files.filter(isLibrary).map(inImage);
  assert.ok(libraries.length > 3);
  for (const library of libraries)
    assert.ok((await ownersOf(library)).some((owner) => names.includes(owner)), library);
});

test('a library that no package owns is an error that names it', async () => {
  const foreign = join(folder, 'libz.so.1');
  await copyFile(join(image, files.map(inImage).find((file) => file.endsWith('/libz.so.1'))), foreign);
  const env = { ...process.env, LD_LIBRARY_PATH: folder };
  await assert.rejects(run(LAY_OUT, [dirname(BINARY), join(folder, 'other')], { env }),
    ({ code, stderr }) => code !== 0 && stderr.includes(`no package owns ${foreign}`));
});

test('what is only headers is in the list: it is compiled in', () => {
  const compiled = sbom.relationships.filter(({ relationshipType }) => relationshipType === 'STATIC_LINK')
    .map(({ relatedSpdxElement }) => relatedSpdxElement.replace('SPDXRef-', ''));
  for (const name of ['libasio-dev', 'libcli11-dev', 'libstb-dev', 'libxsimd-dev', 'nlohmann-json3-dev'])
    assert.ok(compiled.includes(name), name);
  assert.ok(!compiled.some((name) => /gtest|benchmark/.test(name)), 'what tests need is not');
});

test('versions, sources and licences are those of the package database', async () => {
  const own = (await run('dpkg', ['--print-architecture'])).stdout.trim();
  for (const { name, versionInfo, sourceInfo, licenseDeclared, externalRefs: [{ referenceLocator }] } of parts) {
    const { stdout } = await run('dpkg-query',
      ['-W', '-f', '${Version} ${source:Package} ${source:Version} ${Architecture}\n', name]);
    const [version, source, sourceVersion, architecture] = stdout.trim().split('\n')
      .map((line) => line.split(' ')).find((each) => ['all', own].includes(each[3]));
    assert.equal(versionInfo, version);
    assert.equal(sourceInfo, `built from ${source} ${sourceVersion}`);
    const { pathname, searchParams } = new URL(referenceLocator);
    assert.match(decodeURIComponent(pathname), /^deb\/[a-z]+\//);
    assert.ok(decodeURIComponent(pathname).endsWith(`/${name}@${version}`));
    assert.equal(searchParams.get('arch'), architecture);
    assert.match(licenseDeclared, /^[A-Za-z][A-Za-z0-9.-]+( (WITH|OR|AND) [A-Za-z0-9.-]+)*$/);
    assert.notEqual(licenseDeclared, 'NOASSERTION', `${name}: state its licence in server/image.sh`);
    assert.ok(files.map(inImage).includes(`/usr/share/doc/${name}/copyright`));
  }
});

test('the list is an SPDX 2.3 document about this program', async () => {
  const { spdxVersion, dataLicense, SPDXID, documentNamespace, creationInfo, packages, relationships } = sbom;
  assert.deepEqual([spdxVersion, dataLicense, SPDXID], ['SPDX-2.3', 'CC0-1.0', 'SPDXRef-DOCUMENT']);
  assert.ok(new URL(documentNamespace));
  assert.match(creationInfo.created, /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$/);
  const ids = [SPDXID, ...packages.map((one) => one.SPDXID)];
  assert.equal(new Set(ids).size, ids.length);
  for (const id of ids) assert.match(id, /^SPDXRef-[A-Za-z0-9.-]+$/);
  for (const { spdxElementId, relatedSpdxElement } of relationships)
    assert.ok(ids.includes(spdxElementId) && ids.includes(relatedSpdxElement));
  assert.equal(relationships.length, packages.length, 'each is there for a reason');
  const [tia] = packages.filter(({ name }) => name === 'tia');
  const { stdout } = await run('sha256sum', [join(image, 'tia')]);
  assert.equal(tia.checksums[0].checksumValue, stdout.split(' ')[0]);
  assert.equal(`Tia ${tia.versionInfo}\n`, (await run(BINARY, ['--version'])).stdout);
});
