// The key that a server may ask for: kept for this tab alone, in no address and in no link.

import { recall, remember } from './memory.js';

/** The key, ID.SECRET, or null. */
export const accessKey = () => recall('key', 'sessionStorage');

/** Keeps a key, or with null forgets it. */
export const keepAccessKey = (key) => remember('key', key, 'sessionStorage');

/** The fields that a request has because of it. */
export function authorization() {
  const key = accessKey();
  return key ? { Authorization: `Bearer ${key}` } : {};
}
