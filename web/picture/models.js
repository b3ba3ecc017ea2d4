// Models on their way to the server, which keeps them by the SHA-256 of what came.

import { authorization } from '../state/access_key.js';
import { bundleText } from '../state/bundle.js';
import { recall, remember } from '../state/memory.js';
import { readProblem, unanswered } from './problem.js';
import { ask, fetchJson } from './server.js';

/** What is in a kept model. */
export function fetchModel(id, signal) {
  return fetchJson(`models/${encodeURIComponent(id)}`, signal);
}

/**
 * Has the server keep a bundle (state/bundle.js) and gives what is in it. What it keeps already is not
 * sent: `told(part)` hears how much of what is sent has gone, from 0 to 1.
 */
export async function keepModel(bundle, told, signal) {
  const hash = await hashOf(bundle);
  const id = hash && (recall(`model.${hash}`) ?? hash); // an archive's is that of the files in it
  if (id && await isKept(id, signal)) return fetchModel(id, signal);
  const description = await send(bundle, told, signal);
  if (hash && description.id !== hash) remember(`model.${hash}`, description.id);
  return description;
}

// Null where the page may not compute one: outside of https and localhost.
async function hashOf({ files, main }) {
  if (!globalThis.crypto?.subtle) return null;
  const hashed = [];
  for (const { path, file } of files) hashed.push({ path, sha256: await sha256(await file.arrayBuffer()) });
  return hashed.length === 1 ? hashed[0].sha256 : sha256(new TextEncoder().encode(bundleText(hashed, main)));
}

async function sha256(bytes) {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

async function isKept(id, signal) {
  try {
    return (await ask(`models/${id}`, { method: 'HEAD', signal })).ok;
  } catch (error) {
    throw error.name === 'AbortError' ? error : unanswered(error);
  }
}

async function send({ files, main }, told, signal) {
  const single = files.length === 1;
  const body = single ? files[0].file : new FormData();
  if (!single) for (const { path, file } of files) body.append('file', file, path);
  const path = single ? 'models' : `models?main=${encodeURIComponent(main)}`;
  const response = await post(path, body, single && 'application/octet-stream', told, signal);
  if (!response.ok) throw await readProblem(response);
  return response.json();
}

// fetch() does not tell how much of a body has gone.
function post(path, body, type, told, signal) {
  return new Promise((resolve, reject) => {
    const sending = new XMLHttpRequest();
    const header = (name) => sending.getResponseHeader(name);
    sending.upload.addEventListener('progress', ({ loaded, total }) => told(total ? loaded / total : 1));
    sending.addEventListener('load', () => {
      const headers = ['Content-Type', 'Retry-After'].filter(header).map((name) => [name, header(name)]);
      const { status, statusText } = sending;
      resolve(new Response(sending.response, { status, statusText, headers }));
    });
    sending.addEventListener('error', () => reject(unanswered(new TypeError(path))));
    sending.addEventListener('abort', () => reject(signal.reason));
    signal.addEventListener('abort', () => sending.abort());
    sending.open('POST', path);
    sending.responseType = 'blob';
    const headers = { ...authorization(), ...(type && { 'Content-Type': type }) };
    for (const [name, value] of Object.entries(headers)) sending.setRequestHeader(name, value);
    sending.send(body);
  });
}
