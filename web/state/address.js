// The page's address holds all that the page shows: in the query while that is short, where it
// reads as the query of /render does, else deflated in the fragment, which no server gets to see.

import { queryOf, readQuery } from './request.js';

const LONGEST_QUERY = 1500; // chat programs and mail cut longer links

/** What follows the page's path in its address, for a request and the page's own parameters. */
export async function writeAddress(state) {
  const query = queryOf(state);
  if (query.length <= LONGEST_QUERY) return query ? `?${query}` : '';
  return `#z=${base64url(await through(new CompressionStream('deflate-raw'), query))}`;
}

/** The state that `search` and `hash` of an address write; an Error where a fragment is damaged. */
export async function readAddress({ search, hash }) {
  if (!hash.startsWith('#z=')) return readQuery(search.slice(1));
  const bytes = Uint8Array.from(atob(hash.slice(3).replaceAll('-', '+').replaceAll('_', '/')),
    (letter) => letter.charCodeAt(0));
  return readQuery(new TextDecoder().decode(await through(new DecompressionStream('deflate-raw'), bytes)));
}

async function through(transform, data) {
  const stream = new Blob([data]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function base64url(bytes) {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}
