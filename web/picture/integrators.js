// The server's integrators, from its schema.

import { fetchJson } from './server.js';

let known = [];

/** Without an answer the page draws as the scene says. */
export async function learnIntegrators() {
  try {
    const { $defs } = await fetchJson('schema/scene.json');
    known = $defs.options.properties.integrator.oneOf.map((one) => (
      { name: one.const, about: one.description, feature: one['x-gathers'] !== 'light',
        usual: { samples: one['x-samples'] ?? 1, max_depth: one['x-max-depth'] ?? 5, seed: 0, exposure: 0 } }));
  } catch (problem) {
    console.warn(problem.message);
  }
}

const names = (feature) => known.filter((one) => one.feature === feature).map(({ name }) => name);

/** Those that gather light, and those that do not. */
export const lightNames = () => names(false);
export const featureNames = () => names(true);
export const isFeature = (name) => featureNames().includes(name);

/** Its samples, max_depth or seed where nothing is said. */
export const usualOf = (name, option) => known.find((one) => one.name === name)?.usual[option];

/** Whether its rays are chance, so that samples are rounds of an estimate. */
export const isChance = (name) => usualOf(name, 'samples') > 1;

/** What counts of a scene's options: rays that are chance have numbers of their own where it means others. */
export function countingOptions({ integrator }, options) {
  if (!isChance(integrator) || integrator === options?.integrator) return options;
  const { samples, threshold, noise, max_depth, ...others } = options ?? {};
  return others;
}

export const aboutOf = (name) => known.find((one) => one.name === name)?.about ?? name;
