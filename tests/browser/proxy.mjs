// A proxy between page and server. It holds pictures back until told, counts how many are under
// way, answers in the server's stead when told, and sends the strictest content policy that the
// page has to live under.

import { EventEmitter, once } from 'node:events';
import http from 'node:http';
import { isPicture } from './page.mjs';

const POLICY = "default-src 'none'; img-src 'self' blob: data:; script-src 'self'; style-src 'self'; "
  + "connect-src 'self'; base-uri 'none'; frame-ancestors 'none'";

/** Instead of an answer the connection is closed. */
export const HANG_UP = { hangUp: true };

/** Starts a proxy before `target`, an address. */
export async function startProxy(target) {
  const proxy = new Between(target);
  proxy.server.listen(0, '127.0.0.1');
  await once(proxy.server, 'listening');
  proxy.base = `http://127.0.0.1:${proxy.server.address().port}`;
  return proxy;
}

/** Runs `body(proxy)` with a proxy before `target`, an address. */
export async function throughProxy(target, body) {
  const proxy = await startProxy(target);
  try {
    return await body(proxy);
  } finally {
    proxy.stop();
  }
}

class Between extends EventEmitter {
  asked = []; // the paths of the pictures asked for
  most = 0; // pictures under way at one time, at most
  next = []; // answers { status, headers, body } to the next pictures
  always = null; // the answer to every picture
  scene = null; // the answer to every request for a scene
  #underWay = 0;
  #gate = Promise.resolve();
  #open = () => {};

  constructor(target) {
    super();
    this.server = http.createServer(async (request, response) => {
      const stead = isPicture(new URL(request.url, target)) ? await this.#admit(request, response)
        : request.url.startsWith('/scenes/') && this.scene;
      if (stead?.hangUp) response.destroy();
      else if (stead) response.writeHead(stead.status, stead.headers).end(stead.body);
      else forward(request, response, target);
    });
  }

  /** Forgets what it was told and what it has seen. */
  reset() {
    this.release();
    Object.assign(this, { asked: [], most: 0, next: [], always: null, scene: null, holdIf: () => false });
  }

  stop() {
    this.release();
    this.server.closeAllConnections();
    this.server.close();
  }

  /** Holds pictures back from now on. */
  hold() {
    this.#gate = new Promise((open) => (this.#open = open));
  }

  /** Lets them go. */
  release() {
    this.#open();
  }

  holdIf = () => false; // which single pictures are held back for good

  /** Waits until one of them has come. */
  async held() {
    while (!this.asked.some(this.holdIf)) await once(this, 'asked');
  }

  /** Waits until `count` pictures have been asked for. */
  async arrived(count) {
    while (this.asked.length < count) await once(this, 'asked');
  }

  async #admit(request, response) {
    this.asked.push(request.url);
    this.most = Math.max(this.most, ++this.#underWay);
    response.once('close', () => --this.#underWay);
    this.emit('asked');
    await (this.holdIf(request.url) ? new Promise(() => {}) : this.#gate);
    return this.next.shift() ?? this.always;
  }
}

function forward(request, response, target) {
  const { method, url, headers } = request;
  const onward = http.request(target + url, { method, headers }, (answer) => {
    response.writeHead(answer.statusCode, { ...answer.headers, 'content-security-policy': POLICY });
    answer.pipe(response);
  });
  onward.on('error', () => response.destroy());
  request.pipe(onward);
}
