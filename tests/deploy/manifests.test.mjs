// The manifests, as far as a machine without a cluster can tell: they are well formed, agree with each
// other and with the program, and a restart has the time that it takes.

import assert from 'node:assert/strict';
import { readdir } from 'node:fs/promises';
import { before, test } from 'node:test';
import { startTia } from '../browser/tia.mjs';
import { documentsOf, faultsOf, optionsUnder, textOf } from './manifests.mjs';

const FOLDER = 'server/deploy/kubernetes';

let kustomization;
let all;
let pod;
let container;

const ofKind = (kind) => all.filter((object) => object.kind === kind);

before(async () => {
  [kustomization] = await documentsOf(`${FOLDER}/kustomization.yaml`);
  all = (await Promise.all(kustomization.resources.map((file) => documentsOf(`${FOLDER}/${file}`)))).flat();
  pod = ofKind('Deployment')[0].spec.template;
  [container] = pod.spec.containers;
});

// The environment of a container; a field of its resources is what stands there.
const environment = () => Object.fromEntries(container.env.map(({ name, value, valueFrom }) =>
  [name, value ?? container.resources.limits[valueFrom.resourceFieldRef.resource.replace('limits.', '')]]));

// What a restart takes at most, by the options: at least as long as any request may.
function restartMs(options) {
  assert.ok(+options.TIA_DRAIN_MS >= +options.TIA_DEADLINE_MS, 'requests would be given up');
  return +options.TIA_DRAIN_DELAY_MS + +options.TIA_DRAIN_MS;
}

// How long a replica that drains may still be asked: until HAProxy has looked as often as it does.
async function noticedMs() {
  const [, inter, fall] = /inter (\d+)ms .* fall (\d+)/.exec(await textOf('server/deploy/haproxy.cfg'));
  return inter * fall;
}

test('every file is applied, and Kubernetes knows every field', async () => {
  const files = (await readdir(new URL(`../../${FOLDER}`, import.meta.url))).sort();
  assert.deepEqual([...kustomization.resources, 'kustomization.yaml'].sort(), files);
  assert.deepEqual(all.flatMap(faultsOf), []);
});

test('a misspelt field, a wrong type and an unknown version are found', () => {
  const wrong = structuredClone(ofKind('Deployment')[0]);
  wrong.spec.template.spec.containers[0].readinesProbe = {};
  wrong.spec.minReadySeconds = '5';
  assert.deepEqual(faultsOf(wrong), ['Deployment.spec.minReadySeconds: no number',
    'Deployment.spec.template.spec.containers[0] has no readinesProbe']);
  assert.deepEqual(faultsOf({ ...wrong, apiVersion: 'apps/v1beta1' }), ['apps/v1beta1 has no Deployment']);
});

test('every selector selects the pods, and every reference leads somewhere', () => {
  const { labels } = pod.metadata;
  const selectors = [
    ofKind('Deployment')[0].spec.selector.matchLabels,
    ...ofKind('Service').map(({ spec }) => spec.selector),
    ofKind('PodDisruptionBudget')[0].spec.selector.matchLabels,
    ofKind('NetworkPolicy')[0].spec.podSelector.matchLabels,
    ...pod.spec.topologySpreadConstraints.map(({ labelSelector }) => labelSelector.matchLabels),
  ];
  for (const selector of selectors) assert.deepEqual(selector, labels);
  const { apiVersion, kind, name } = ofKind('HorizontalPodAutoscaler')[0].spec.scaleTargetRef;
  assert.ok(all.some((one) => one.apiVersion === apiVersion && one.kind === kind && one.metadata.name === name));
});

test('ports are those of the image, and each is named where it is used', async () => {
  const [, exposed] = /^EXPOSE (\d+)$/m.exec(await textOf('Dockerfile'));
  const [{ name, containerPort }, ...more] = container.ports;
  assert.equal(containerPort, +exposed);
  assert.deepEqual(more, []);
  const used = [
    ...ofKind('Service').flatMap(({ spec }) => spec.ports.map(({ targetPort }) => targetPort)),
    ...ofKind('NetworkPolicy')[0].spec.ingress.flatMap(({ ports }) => ports.map(({ port }) => port)),
    ...['startupProbe', 'livenessProbe', 'readinessProbe'].map((probe) => container[probe].httpGet.port),
  ];
  assert.deepEqual(new Set(used), new Set([name]));
});

test('what probes and scrapers ask for is there', async () => {
  const tia = await startTia();
  const paths = ['startupProbe', 'livenessProbe', 'readinessProbe'].map((probe) => container[probe].httpGet.path);
  try {
    for (const path of [...paths, pod.metadata.annotations['prometheus.io/path']]) await tia.get(path);
  } finally {
    await tia.stop();
  }
});

test('the image is of this version and its user is not root', async () => {
  const [, version] = /^project\(tia VERSION (\S+)/m.exec(await textOf('CMakeLists.txt'));
  const dockerfile = await textOf('Dockerfile');
  assert.equal(kustomization.images[0].newTag, version);
  assert.ok(dockerfile.includes(`org.opencontainers.image.version="${version}"`));
  assert.match(dockerfile, /^USER [1-9]\d*:[1-9]\d*$/m); // Kubernetes can tell only of a number
});

test('the program takes what the pod sets, and a restart fits into its time', async () => {
  const set = environment();
  const options = await optionsUnder(set);
  for (const [name, value] of Object.entries(set)) assert.equal(options[name], value);
  assert.ok(pod.spec.terminationGracePeriodSeconds * 1_000 > restartMs(options));
  assert.ok(+options.TIA_DRAIN_DELAY_MS > await noticedMs());
});

test('there are two replicas at least, and one may go at a time', () => {
  const { minReplicas, maxReplicas } = ofKind('HorizontalPodAutoscaler')[0].spec;
  assert.ok(minReplicas >= 2 && maxReplicas > minReplicas);
  assert.ok(ofKind('PodDisruptionBudget')[0].spec.maxUnavailable < minReplicas);
  assert.equal(ofKind('Deployment')[0].spec.strategy.rollingUpdate.maxUnavailable, 0);
  assert.equal(ofKind('Deployment')[0].spec.replicas, undefined);
});

test('compose: the programs know every variable, ports meet, and a restart fits into its time', async () => {
  const [{ services: { balancer, tia } }] = await documentsOf('server/deploy/compose.yaml');
  const options = await optionsUnder(tia.environment);
  assert.ok(parseInt(tia.stop_grace_period) * 1_000 > restartMs(options));
  assert.ok(+options.TIA_DRAIN_DELAY_MS > await noticedMs());
  const config = await textOf('server/deploy/haproxy.cfg');
  for (const name of Object.keys(balancer.environment))
    assert.match(config, new RegExp(`\\$\\{${name}\\b|defined\\(${name}\\)`));
  const [, exposed] = /^EXPOSE (\d+)$/m.exec(await textOf('Dockerfile'));
  assert.equal(balancer.environment.REPLICAS, `tia:${exposed}`);
  assert.ok(balancer.ports[0].endsWith(balancer.environment.LISTEN.slice(1)));
});
