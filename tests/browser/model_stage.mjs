// The studio as the tests of its models need it: files dropped on it, and what it asks of the server.

import { rests, until } from './page.mjs';
import { stage } from './stage.mjs';

/** Few samples of a small picture: what is tested is not their noise, and machines may be slow. */
export const SMALL = '&integrator=path&samples=4&width=96&height=96';

/**
 * The stage, and `open(body, options)`, which opens the page, if nothing else is said at a model of
 * the gallery, and runs `body(page, seen)`; `seen.sent` lists the addresses of models sent,
 * `seen.stills` the queries of pictures of them asked for. `shared(body)` is the same on a page that
 * is as the test before left it. A model that the server has not got yet is an error to the browser.
 */
export function modelStage() {
  const on = stage();
  const { look, shared } = on;
  const onModel = (options) =>
    ({ locale: 'en-US', path: `/?model=part${SMALL}`, ready: (page) => still(page), watch, failing: true, patience: 20_000, ...options });
  return Object.assign(on, {
    open: (body, options) => look(body, onModel(options)),
    shared: shared((page) => still(page), onModel()),
  });
}

function watch(page, seen) {
  Object.assign(seen, { sent: [], stills: [] });
  page.on('request', (request) => {
    const { pathname, search, searchParams: query } = new URL(request.url());
    if (pathname === '/models' && request.method() === 'POST') seen.sent.push(pathname + search);
    if (pathname === '/still' && !query.has('as') && !query.has('format')) seen.stills.push(query);
  });
}

/** Drops files on the picture, { path: bytes }. */
export async function drop(page, files) {
  const list = Object.entries(files).map(([path, bytes]) => [path, Buffer.from(bytes).toString('base64')]);
  const dataTransfer = await page.evaluateHandle((all) => {
    const data = new DataTransfer();
    for (const [path, base64] of all)
      data.items.add(new File([Uint8Array.from(atob(base64), (it) => it.charCodeAt(0))], path));
    return data;
  }, list);
  for (const name of ['dragenter', 'dragover', 'drop']) await page.locator('#picture').dispatchEvent(name, { dataTransfer });
}

/** Waits until the page shows a model as fine as it gets, its address with it; gives its query. */
export async function still(page, holds = (query) => query.has('model')) {
  await until(() => holds(queryOf(page)), 'an address of the model');
  await rests(page);
  return queryOf(page);
}

/** The query of the page's address. */
export const queryOf = (page) => new URL(page.url()).searchParams;
