// Radio waves between antennas in a scene, told by the server.

import { sequenceOf } from '../space/radio.js';
import { readProblem, unanswered } from './problem.js';
import { ask } from './server.js';

/** The ways between a transmitter and a receiver: { paths, total, channel, counts, assumed, warnings }. */
export async function fetchPaths(asked, signal) {
  const { pairs: [pair], counts, assumed, warnings } = await post('radio/paths', asked, signal);
  return { ...pair, counts, assumed, warnings };
}

/** What reaches each cell of a level plane: { width, height, area, cell, y, quantity, unit, values }. */
export function fetchMap(asked, signal) {
  return post('radio/map', { ...asked, format: 'json' }, signal);
}

/**
 * What each of `methods` finds of a pair: [{ method, ms, paths, counts, missed, extra }]; `missed` of the ways that are
 * exact, `extra` none of them. One that cannot be asked there has its `problem` instead.
 */
export async function fetchMethods(asked, methods, signal) {
  const told = [];
  for (const method of methods) {
    const start = performance.now();
    const one = await fetchPaths({ ...asked, method }, signal).catch(refused);
    told.push({ method, ms: performance.now() - start, ...one, ways: new Set((one.paths ?? []).map(sequenceOf)) });
  }
  // Rays alone may tell of ways that are none: what passes near a receiver counts.
  const exact = new Set(told.flatMap(({ method, ways }) => (method === 'sbr' ? [] : [...ways])));
  const lacks = (all, some) => [...all].filter((way) => !some.has(way)).length;
  return told.map((one) => ({ ...one, missed: lacks(exact, one.ways), extra: lacks(one.ways, exact) }));
}

function refused(problem) {
  if (!(problem.status >= 400 && problem.status < 500)) throw problem;
  return { problem };
}

async function post(path, asked, signal) {
  const headers = { 'Content-Type': 'application/json' };
  try {
    const response = await ask(path, { method: 'POST', headers, signal, body: JSON.stringify(asked) });
    if (!response.ok) throw await readProblem(response);
    return await response.json();
  } catch (error) {
    throw error instanceof TypeError ? unanswered(error) : error;
  }
}
