// How bodies move, told by the server.

import { unanswered, readProblem } from './problem.js';
import { ask } from './server.js';

/** What /simulate tells of a scene with physics: { scene, contacts, energy, events }. */
export async function fetchMotion(scene, signal) {
  const headers = { 'Content-Type': 'application/json' };
  try {
    const response = await ask('simulate', { method: 'POST', headers, signal, body: JSON.stringify({ scene }) });
    if (!response.ok) throw await readProblem(response);
    return await response.json();
  } catch (error) {
    throw error instanceof TypeError ? unanswered(error) : error;
  }
}
