// The page's only way to the server. Every failure comes out as a Problem, but an abort.

import { authorization } from '../state/access_key.js';
import { fetchable, inScene, queryOf, routeOf } from '../state/request.js';
import { t } from '../words/words.js';
import { Problem, readProblem, unanswered } from './problem.js';
import { partsOf } from './stream.js';
import { readRays, readTiming } from './timing.js';

const PATIENCE_MS = 120_000;

/**
 * A drawn picture as { blob, timing, rays, cached, copied, ms, path }; `ms` from the request to the
 * last byte, `cached` whether the server had it already, `copied` whether the browser itself had it
 * and the server only said that it still holds; `timing` is then that of the copy. Where there is
 * `shown`, it gets what comes before the picture while that is drawn: the same, of fewer samples.
 */
export async function fetchPicture(request, signal, shown) {
  const start = performance.now();
  const route = routeOf(request);
  const { path } = fetchable(route, request);
  const { path: from, init } = fetchable(route, shown ? { ...request, stream: 'multipart' } : request);
  const response = await get(from, init, signal);
  const told = (headers, blob) => ({ path, blob, ms: performance.now() - start, ...readHeaders(headers, response.headers) });
  if (!shown) return told(response.headers, await body(() => response.blob()));
  return body(async () => {
    for await (const { headers, blob, last } of partsOf(response)) {
      if (blob.type === 'application/problem+json') throw await toldProblem(blob);
      if (last) return told(headers, blob);
      await shown(told(headers, blob));
    }
  });
}

// The problem that ends a stream.
async function toldProblem(blob) {
  const { status } = JSON.parse(await blob.text());
  return readProblem(new Response(blob, { status, headers: { 'Content-Type': blob.type } }));
}

// What is told of a picture; `all` are the headers of all parts.
function readHeaders(headers, all) {
  const header = (name) => headers.get(name);
  return {
    timing: readTiming(header('Server-Timing')),
    rays: readRays(header('Tia-Rays')),
    noise: header('Tia-Noise'),
    gaze: header('Tia-Gaze'),
    biased: all.get('Tia-Biased'),
    ignored: all.get('Tia-Ignored'),
    reached: Number(/&samples=(\d+)$/.exec(header('Content-Location'))?.[1]), // NaN: had no budget
    resumed: /fwd=partial/.test(header('Cache-Status') ?? ''), // goes on from what was drawn before
    cached: /;\s*hit/.test(header('Cache-Status') ?? ''),
    copied: /detail=not-modified/.test(header('Cache-Status') ?? ''),
  };
}

/** A feature image or picture in linear light: the bytes of its PFM file. */
export async function fetchPfm(request, signal) {
  const opaque = request.model ? { background: [0, 0, 0] } : request.scene?.backdrop // such a file has no alpha
    && { scene: { ...request.scene, backdrop: undefined, shadow_ground: undefined } };
  const { path, init } = fetchable(routeOf(request), { ...request, ...opaque, format: 'pfm' });
  const response = await get(path, init, signal);
  return body(() => response.arrayBuffer());
}

/** What /explain tells of the pixel `x`, `y` of a request, or of its `ray`: of light, not of files. */
export async function fetchExplanation(asked, signal) {
  const drawn = asked.model ? inScene(asked, await fetchStillScene(asked, signal)) : asked;
  const { transfer, exposure, white_balance_kelvin, crop, ...request } = drawn;
  const { path, init } = fetchable('explain', request);
  const response = await get(path, init, signal);
  return body(() => response.json());
}

/** A scene's canonical JSON, where fields at their defaults are left out. */
export function fetchScene(name, signal) {
  return fetchJson(`scenes/${encodeURIComponent(name)}`, signal);
}

/** The scene that a still is of, of which /render draws the same bytes. */
export function fetchStillScene({ x, y, ray, ...request }, signal) {
  return fetchJson(`still?${queryOf({ ...request, as: 'scene' })}`, signal);
}

/** The gallery: [{ name, title, description }]. */
export async function fetchGallery() {
  return (await fetchJson('scenes')).scenes;
}

/** JSON of any path of this server, such as its schema. */
export async function fetchJson(path, signal) {
  const response = await get(path, {}, signal);
  return body(() => response.json());
}

/** fetch() with the key that this tab has, where it has one. */
export const ask = (path, init = {}) => fetch(path, { ...init, headers: { ...init.headers, ...authorization() } });

/** The good answer of any path. */
export async function get(path, init, signal) {
  const patience = AbortSignal.timeout(PATIENCE_MS);
  const either = signal ? AbortSignal.any([signal, patience]) : patience;
  const response = await body(() => ask(path, { ...init, signal: either }));
  if (!response.ok) throw await readProblem(response);
  return response;
}

async function body(read) {
  try {
    return await read();
  } catch (error) {
    throw error.name === 'AbortError' || error instanceof Problem ? error : unanswered(error);
  }
}

/** A decoded picture, its bytes as they are in the file. Whoever is done with it closes it. */
export async function decode(blob) {
  try {
    return await createImageBitmap(blob, { colorSpaceConversion: 'none' });
  } catch {
    throw new Problem({ title: t('trouble.unreadable'), status: 502 });
  }
}
