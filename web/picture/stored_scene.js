// A scene kept by the server while its moments are asked for one after the other: its text goes there once.

import { tidy } from '../state/request.js';
import { ask } from './server.js';

/** Storing: `carry(request)` gives the request with its scene's id, where the server has taken it. */
export class StoredScene {
  #scene = null; // the object that is kept, or was refused
  #kept = Promise.resolve(null); // { id, key }, or null

  async carry(request) {
    const { scene } = request;
    if (typeof scene !== 'object') return request;
    if (this.#scene !== scene) this.#keep(scene);
    const kept = await this.#kept;
    return kept ? { ...request, scene: kept.id } : request;
  }

  /** The server has it no more: it goes along with each request from now on. */
  giveUp() {
    this.#kept = Promise.resolve(null);
  }

  /** Lets the scene go, here and there. */
  async drop() {
    const kept = this.#kept;
    [this.#scene, this.#kept] = [null, Promise.resolve(null)];
    const { id, key } = (await kept) ?? {};
    if (key) ask(`scenes/${id}`, { method: 'DELETE', headers: { 'Tia-Delete-Key': key }, keepalive: true }).catch(() => {});
  }

  #keep(scene) {
    this.drop();
    this.#scene = scene;
    this.#kept = keptAs(scene).catch(() => null); // it goes along with each request, then
  }
}

async function keptAs(scene) {
  const headers = { 'Content-Type': 'application/json' };
  const response = await ask('scenes', { method: 'POST', headers, body: JSON.stringify(tidy(scene)) });
  if (!response.ok) return null;
  return { id: (await response.json()).id, key: response.headers.get('Tia-Delete-Key') };
}
