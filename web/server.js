// The page's only way to the server. Every failure comes out as a Problem.

import { Problem, readProblem, unanswered } from './problem.js';
import { readRays, readTiming } from './timing.js';

const PATIENCE_MS = 120_000;

/** A rendered picture as { image, timing, rays }; `image` is decoded, its `src` an object URL. */
export async function fetchPicture(path) {
  const response = await get(path);
  const image = await decode(await body(() => response.blob()));
  const timing = readTiming(response.headers.get('Server-Timing'));
  return { image, timing, rays: readRays(response.headers.get('Tia-Rays')) };
}

/** A gallery scene's canonical JSON, where fields at their defaults are left out. */
export async function fetchScene(name) {
  const response = await get(`scenes/${encodeURIComponent(name)}`);
  return body(() => response.json());
}

async function get(path) {
  const response = await body(() => fetch(path, { signal: AbortSignal.timeout(PATIENCE_MS) }));
  if (!response.ok) throw await readProblem(response);
  return response;
}

async function body(read) {
  try {
    return await read();
  } catch (error) {
    throw unanswered(error);
  }
}

async function decode(blob) {
  const image = new Image();
  image.src = URL.createObjectURL(blob);
  try {
    await image.decode();
    return image;
  } catch {
    URL.revokeObjectURL(image.src);
    throw new Problem({ title: 'The answer was not a picture that this browser can show', status: 502 });
  }
}
