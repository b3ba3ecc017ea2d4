// What server/deploy has for a farm, with the real programs: the Redis of compose lets Tia do what it
// does and nobody else anything, in the clear and by TLS; the manifests of Kubernetes agree with it.

import assert from 'node:assert/strict';
import { execFile, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import net from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { after, before, test } from 'node:test';
import { BINARY, startTia } from '../browser/tia.mjs';
import { eventually } from './balancer.mjs';
import { documentsOf, faultsOf, optionsUnder, textOf } from './manifests.mjs';

const DEPLOY = fileURLToPath(new URL('../../server/deploy/', import.meta.url));
const FOLDER = 'server/deploy/kubernetes-farm';
const MISSING = ['/usr/bin/redis-server', '/usr/sbin/haproxy'].find((path) => !existsSync(path));
const run = promisify(execFile);

const children = [];
let folder;

// A program that is ended with the tests; what it says is passed on where it ends by itself.
function start(program, args, env) {
  const child = spawn(program, args, { env: { PATH: `${process.env.PATH}:/usr/sbin`, ...env } });
  let said = '';
  for (const output of [child.stdout, child.stderr]) output.setEncoding('utf8').on('data', (text) => (said += text));
  child.on('exit', (code) => code && console.error(said));
  children.push(child);
  return child;
}

async function freePort() {
  const server = net.createServer().listen(0, '127.0.0.1');
  await new Promise((done) => server.on('listening', done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

// What a Redis says to these lines, until it has nothing to say for a while.
const said = (port, lines) => new Promise((done, fail) => {
  const socket = net.connect(port, '127.0.0.1', () => socket.write(lines.join('\r\n') + '\r\n'));
  let text = '';
  socket.setEncoding('utf8').setTimeout(300, () => done((socket.destroy(), text)));
  socket.on('data', (part) => (text += part)).on('error', fail);
});

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'tia-farm-'));
});
after(async () => {
  await Promise.all(children.map((child) => child.exitCode ?? new Promise((done) => {
    child.on('exit', done);
    child.kill('SIGTERM');
  })));
  await rm(folder, { recursive: true });
});

test("compose's Redis is for Tia alone, and workers elsewhere reach it by TLS", { skip: MISSING }, async () => {
  const [port, tls, health] = [await freePort(), await freePort(), await freePort()];
  const password = join(folder, 'password'), pem = join(folder, 'tls.pem'), certificate = join(folder, 'ca.pem');
  await writeFile(password, 'a secret\n');
  await run('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256', '-nodes', '-days', '1',
    '-subj', '/CN=localhost', '-addext', 'subjectAltName=DNS:localhost', '-keyout', pem, '-out', certificate]);
  await writeFile(pem, await run('cat', [certificate, pem]).then(({ stdout }) => stdout));
  start('sh', [join(DEPLOY, 'farm-redis.sh'), '--port', port, '--bind', '127.0.0.1', '--dir', folder],
    { FARM_PASSWORD_FILE: password, FARM_ACL_FILE: join(folder, 'users.acl'), FARM_MEMORY: '64mb' });
  start('haproxy', ['-f', join(DEPLOY, 'farm-tls.cfg')],
    { LISTEN: `127.0.0.1:${tls}`, REDIS: `127.0.0.1:${port}`, TLS_FILE: pem });
  await eventually(() => said(port, ['PING']).catch(() => false), 'Redis to start');

  assert.match(await said(port, ['PING']), /^-NOAUTH/);
  const answers = await said(port, ['AUTH tia wrong', 'AUTH tia "a secret"', 'GET other', 'KEYS *', 'CONFIG GET *',
    'FLUSHALL', 'GET {tia}:1:x']);
  assert.deepEqual(answers.split('\r\n').filter(Boolean).map((line) => line.split(' ')[0]),
    ['-WRONGPASS', '+OK', '-NOPERM', '-NOPERM', '-NOPERM', '-NOPERM', '$-1']);

  const server = await startTia(0, ['--farm', `redis://tia@127.0.0.1:${port}/0`, '--farm-password-file', password]);
  start(BINARY, ['worker', '--port', health, '--farm', `rediss://tia@localhost:${tls}/0`, '--farm-ca-file', certificate,
    '--farm-password-file', password], {});
  try {
    const job = await fetch(`${server.base}/jobs`, { method: 'POST',
      body: JSON.stringify({ kind: 'render', request: { scene: 'whitted', width: 64, height: 48 } }) });
    assert.equal(job.status, 202);
    const at = job.headers.get('location');
    const state = async () => JSON.parse(await server.get(at)).state;
    await eventually(async () => (await state()) === 'done', 'the job to be drawn');
    assert.deepEqual(await server.get(`${at}/result`), await server.get('/render?scene=whitted&width=64&height=48'));
    for (const path of await probes()) assert.equal((await fetch(`http://127.0.0.1:${health}${path}`)).status, 200);
    const load = JSON.parse(await server.get('/jobs/load'));
    for (const { metadata } of (await manifest('ScaledObject')).spec.triggers)
      assert.equal(typeof load[metadata.valueLocation], 'number', metadata.valueLocation);
  } finally {
    await server.stop();
  }
});

async function manifests() {
  const [{ resources }] = await documentsOf(`${FOLDER}/kustomization.yaml`);
  const files = resources.filter((file) => !file.includes('/'));
  return (await Promise.all(files.map((file) => documentsOf(`${FOLDER}/${file}`)))).flat();
}
const manifest = async (kind) => (await manifests()).find((each) => each.kind === kind);
async function probes() {
  const [container] = (await manifest('Deployment')).spec.template.spec.containers;
  return ['startupProbe', 'livenessProbe', 'readinessProbe'].map((probe) => container[probe].httpGet.path);
}

test('every file is applied, and Kubernetes and KEDA know every field', async () => {
  const [{ resources, patches, configMapGenerator: [{ envs }], images: [{ newTag }] }] =
    await documentsOf(`${FOLDER}/kustomization.yaml`);
  const files = (await readdir(new URL(`../../${FOLDER}`, import.meta.url))).sort();
  const applied = [...resources, ...patches.map(({ path }) => path), ...envs, 'kustomization.yaml'];
  assert.deepEqual(applied.filter((file) => !file.includes('/')).sort(), files);
  const all = [...await manifests(), ...await documentsOf(`${FOLDER}/server.yaml`)];
  assert.deepEqual(all.flatMap(faultsOf), []);
  const wrong = structuredClone(all.find(({ kind }) => kind === 'ScaledObject'));
  wrong.spec.triggers[0].metadata.valueLocaton = 'x';
  assert.deepEqual(faultsOf(wrong), ['ScaledObject.spec.triggers[0].metadata has no valueLocaton']);
  const [{ images: [base] }] = await documentsOf('server/deploy/kubernetes/kustomization.yaml');
  assert.equal(newTag, base.newTag);
});

test('selectors select the workers, and the program takes what their pods set', async () => {
  const { metadata, spec: { selector, template } } = await manifest('Deployment');
  const { labels } = template.metadata;
  assert.deepEqual(selector.matchLabels, labels);
  assert.deepEqual((await manifest('PodDisruptionBudget')).spec.selector.matchLabels, labels);
  assert.equal((await manifest('ScaledObject')).spec.scaleTargetRef.name, metadata.name);
  const policies = (await manifests()).filter(({ kind }) => kind === 'NetworkPolicy');
  assert.ok(policies.every(({ spec: { podSelector: { matchLabels, matchExpressions } } }) =>
    Object.values(matchLabels ?? { of: matchExpressions?.[0].values }).flat().includes('tia-worker')));
  const env = Object.fromEntries((await textOf(`${FOLDER}/farm.env`)).trim().split('\n').map((line) => line.split('=')));
  const [{ env: own, resources, volumeMounts: [{ mountPath }] }] = template.spec.containers;
  for (const { name, value } of own) env[name] = value ?? resources.limits.cpu;
  const options = await optionsUnder(env);
  for (const [name, value] of Object.entries(env)) assert.equal(options[name], value);
  assert.ok(env.TIA_FARM_PASSWORD_FILE.startsWith(`${mountPath}/`));
  assert.ok(template.spec.terminationGracePeriodSeconds * 1_000 > +options.TIA_DRAIN_MS);
});

test('compose: the programs know every variable, and a file stands for every one that is mounted', async () => {
  const [{ services }] = await documentsOf('server/deploy/farm.yaml');
  for (const name of ['tia', 'worker']) {
    const options = await optionsUnder(services[name].environment);
    assert.ok(parseInt(services[name].stop_grace_period) * 1_000 > +options.TIA_DRAIN_MS);
  }
  const config = await textOf('server/deploy/farm-tls.cfg');
  for (const name of Object.keys(services.tls.environment)) assert.match(config, new RegExp(`\\$\\{${name}\\b`));
  for (const { volumes = [] } of Object.values(services))
    for (const volume of volumes.filter((each) => each.startsWith('./')))
      assert.ok(existsSync(DEPLOY + volume.split(':')[0]), volume);
});
