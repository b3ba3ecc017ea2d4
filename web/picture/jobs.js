// Jobs: work that may outlast a request and this page; the server draws it part by part.

import { authorization } from '../state/access_key.js';
import { inScene, tidy } from '../state/request.js';
import { Problem } from './problem.js';
import { fetchJson, fetchStillScene, get } from './server.js';

const LAST = ['done', 'failed', 'cancelled'];
const AGAIN_MS = 2000; // until a stream of events that broke off is asked for once more
const MOST_PIXELS = 16_777_216;

/** Whether nothing about a job will change any more. */
export const isLast = (state) => LAST.includes(state);

/** Sizes that a picture may be drawn at: its own, and up to eight times as wide. */
export function largeSizes([width, height]) {
  return [1, 2, 3, 4, 6, 8].map((times) => [width * times, height * times]).filter(([w, h]) => w * h <= MOST_PIXELS);
}

/** Has the server draw a request's picture as a job called `name`; gives its status. */
export async function submitJob(request, name) {
  const { budget_ms, max_rays, pixel, ...asked } = inScene(request, request.model && await fetchStillScene(request));
  const headers = { 'Content-Type': 'application/json', 'Idempotency-Key': crypto.randomUUID?.() ?? String(Math.random()) };
  const body = JSON.stringify({ kind: 'render', name, request: tidy(asked) });
  return (await get('jobs', { method: 'POST', headers, body })).json();
}

/** What the server says of a job; null: it knows none of that name. */
export async function fetchJob(id) {
  try {
    return await fetchJson(`jobs/${id}`);
  } catch (problem) {
    if (problem.status === 404 || problem.status === 410) return null;
    throw problem;
  }
}

/** The windows [x0, y0, x1, y1] of a job's parts that are drawn. */
export async function drawnWindows(id) {
  const windows = [];
  for (let first = 0; ; first += 1000) {
    const { parts } = await fetchJson(`jobs/${id}/parts?state=done&first=${first}`);
    windows.push(...parts.map(({ window }) => window).filter(Boolean));
    if (parts.length < 1000) return windows;
  }
}

/** Cancels a job, or lets go of what came of it. */
export async function dropJob(id) {
  await get(`jobs/${id}`, { method: 'DELETE' });
}

/** The picture. */
export async function jobPicture(id) {
  return (await get(`jobs/${id}/result`)).blob();
}

/**
 * Hears of a job until its end: `heard(event, data)` for each event in turn. What breaks off goes on where
 * it was.
 */
export async function watchJob(id, signal, heard) {
  for (let last = null; ;) {
    try {
      const headers = { Accept: 'text/event-stream', ...authorization(), ...(last && { 'Last-Event-ID': last }) };
      const response = await fetch(`jobs/${id}/events`, { headers, signal });
      if (!response.ok) return;
      for await (const { id: at, event, data } of eventsOf(response.body)) {
        last = at ?? last;
        heard(event, data);
        if (event === 'state' && isLast(data.state)) return;
      }
    } catch (error) {
      if (error.name === 'AbortError') return;
      if (!(error instanceof TypeError)) throw new Problem({ title: error.message });
    }
    await new Promise((wake) => setTimeout(wake, AGAIN_MS));
    if (signal.aborted) return;
  }
}

/** The events of a stream: { id, event, data }, of which `data` is JSON (WHATWG HTML, 9.2.6). */
export async function* eventsOf(body) {
  const reader = body.pipeThrough(new TextDecoderStream()).getReader();
  let text = '';
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    text += value;
    const blocks = text.split(/\r?\n\r?\n/);
    text = blocks.pop();
    for (const block of blocks) {
      const fields = Object.fromEntries(block.split(/\r?\n/).map((line) => line.match(/^(\w+): ?(.*)$/)?.slice(1)).filter(Boolean));
      if (fields.data) yield { id: fields.id, event: fields.event, data: JSON.parse(fields.data) };
    }
  }
}
