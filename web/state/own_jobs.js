// The jobs that were begun in this browser, newest first: [{ id, width, height }].

import { recall, remember } from './memory.js';

const MOST = 20;

export function ownJobs() {
  try {
    const all = JSON.parse(recall('jobs') ?? '[]');
    return Array.isArray(all) ? all.filter(({ id }) => typeof id === 'string') : [];
  } catch {
    return [];
  }
}

const keep = (jobs) => remember('jobs', JSON.stringify(jobs.slice(0, MOST)));

export const addJob = (job) => keep([job, ...ownJobs()]);
export const forgetJob = (gone) => keep(ownJobs().filter(({ id }) => id !== gone));
