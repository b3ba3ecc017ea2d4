// The documents of server/deploy, and what they are held to: Kubernetes' own list of fields, and the
// options that the program takes.

import { execFile } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { promisify } from 'node:util';
import * as k8s from '@kubernetes/client-node';
import { BINARY } from '../browser/tia.mjs';

// Of KEDA 2 (keda.sh, "ScaledObject specification" and "Metrics API"), as Kubernetes' are below.
const KEDA = {
  ScaledObject: { apiVersion: 'string', kind: 'string', metadata: 'V1ObjectMeta', spec: 'ScaledObjectSpec' },
  ScaledObjectSpec: {
    scaleTargetRef: 'ScaleTarget', pollingInterval: 'number', cooldownPeriod: 'number',
    initialCooldownPeriod: 'number', minReplicaCount: 'number', maxReplicaCount: 'number',
    triggers: 'Array<ScaleTrigger>',
  },
  ScaleTarget: { apiVersion: 'string', kind: 'string', name: 'string' },
  ScaleTrigger: { type: 'string', name: 'string', metadata: 'MetricsApi', authenticationRef: 'ScaleTarget' },
  MetricsApi: { url: 'string', valueLocation: 'string', targetValue: 'string', format: 'string' },
};

const API = {
  Deployment: 'apps/v1',
  HorizontalPodAutoscaler: 'autoscaling/v2',
  NetworkPolicy: 'networking.k8s.io/v1',
  PodDisruptionBudget: 'policy/v1',
  Service: 'v1',
};

/** A file of the repository as text. */
export const textOf = (path) => readFile(new URL(`../../${path}`, import.meta.url), 'utf8');

/** A file's YAML documents. */
export const documentsOf = async (path) => k8s.loadAllYaml(await textOf(path));

/** What Kubernetes would not understand of an object, each in a sentence. */
export function faultsOf(object) {
  const { apiVersion, kind } = object;
  if (apiVersion === 'keda.sh/v1alpha1') return faultsIn(object, kind, kind);
  if (API[kind] !== apiVersion) return [`${apiVersion} has no ${kind}`];
  return faultsIn(object, `V${apiVersion.slice(-1)}${kind}`, kind);
}

// `type` as the client's own lists of fields write it.
function faultsIn(value, type, at) {
  const [, many] = /^Array<(.*)>$/.exec(type) ?? [];
  const [, named] = /^\{ \[key: string\]: (.*); \}$/.exec(type) ?? [];
  if (value === null || Array.isArray(value) !== Boolean(many)) return [`${at}: no ${type}`];
  if (many) return value.flatMap((one, i) => faultsIn(one, many, `${at}[${i}]`));
  if (named) return Object.entries(value).flatMap(([name, one]) => faultsIn(one, named, `${at}.${name}`));
  if (type === 'IntOrString') return ['number', 'string'].includes(typeof value) ? [] : [`${at}: no ${type}`];
  const fields = KEDA[type] ? Object.entries(KEDA[type]).map(([baseName, of]) => ({ baseName, type: of }))
    : k8s[type]?.attributeTypeMap;
  if (!fields) return typeof value === type ? [] : [`${at}: no ${type}`];
  return Object.entries(value).flatMap(([name, one]) => {
    const field = fields.find(({ baseName }) => baseName === name);
    return field ? faultsIn(one, field.type, `${at}.${name}`) : [`${at} has no ${name}`];
  });
}

/** What the program makes of these variables: its options by name. Throws where it refuses one. */
export async function optionsUnder(env) {
  const { stdout, stderr } = await promisify(execFile)(BINARY, ['--print-config'], { env });
  if (stderr) throw new Error(stderr);
  return Object.fromEntries(stdout.split('\n').filter((line) => /^TIA_/.test(line)).map((line) => line.split('=')));
}
