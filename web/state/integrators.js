// The integrators that the server has: their names, and what its schema says of each.

import { fetchJson } from '../picture/server.js';

let known = [];

/** Learns them, before anything is drawn. Without an answer the page draws as the scene says. */
export async function learnIntegrators() {
  try {
    const { $defs } = await fetchJson('schema/scene.json');
    known = $defs.options.properties.integrator.oneOf.map((one) => (
      { name: one.const, about: one.description, feature: one['x-gathers'] === 'features' }));
  } catch (problem) {
    console.warn('no integrators:', problem.message);
  }
}

const names = (feature) => known.filter((one) => one.feature === feature).map(({ name }) => name);

/** Those that gather light. */
export const lightNames = () => names(false);

/** Those that tell numbers of surfaces instead. */
export const featureNames = () => names(true);

export const isFeature = (name) => featureNames().includes(name);

/** What one is, in the server's words. */
export const aboutOf = (name) => known.find((one) => one.name === name)?.about ?? name;
