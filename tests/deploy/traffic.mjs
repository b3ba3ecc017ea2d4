// Many clients at once, who ask for the same things again and again and compare what they get.

import { createHash } from 'node:crypto';
import http from 'node:http';

const SPHERE = { type: 'sphere', center: [0, 0, -9], radius: 2 };
const SCENE = { objects: [SPHERE], lights: [{ type: 'point', position: [4, 6, -3] }] };
const SMALL = { width: 48, height: 36 };

const get = (path, headers = {}) => ({ method: 'GET', path, headers });
const post = (path, json) => ({ method: 'POST', path, headers: {}, body: JSON.stringify(json) });

const PICTURE = '/render?key=a&width=48&height=36';

/** What is asked: small pictures and some that take a while, explanations, scenes, what `base` has. */
export async function wishes(base) {
  const tag = async (path) => (await ask(base, { method: 'HEAD', path })).headers.etag;
  const png = Buffer.from(await (await fetch(base + PICTURE)).arrayBuffer());
  const all = [get('/healthz'), get('/scenes/thesis')];
  for (const path of ['/', PICTURE]) all.push(get(path, { 'If-None-Match': await tag(path) }));
  for (const path of ['/verify', '/render'])
    all.push({ method: 'POST', path, headers: { 'Content-Type': 'image/png' }, body: png });
  for (let seed = 0; seed < 24; ++seed) {
    all.push(get(`/render?key=${'adsw'[seed % 4]}&samples=2&seed=${seed}&width=48&height=36`));
    all.push(post('/render', { ...SMALL, scene: SCENE, seed, samples: 2 }));
  }
  for (let x = 0; x < 8; ++x) {
    all.push(get(`/explain?x=${x}&y=1&key=a`), post('/explain', { x, y: 1, key: 'a' }));
    all.push(post('/scenes', { ...SCENE, objects: [{ ...SPHERE, radius: 1 + x }] }));
    all.push(get(`/render?key=a&samples=4&width=320&height=240&seed=${x}`));
  }
  return all;
}

/** Asks once. Gives { status, sha256, ms, headers }; status 0 where the connection broke. */
export function ask(base, { method, path, headers, body }, agent) {
  const began = performance.now();
  return new Promise((done) => {
    const hash = createHash('sha256');
    const end = (status, answered = {}) =>
      done({ status, headers: answered, sha256: hash.digest('hex'), ms: performance.now() - began });
    const request = http.request(base + path, { method, headers, agent }, (response) => {
      response.on('data', (part) => hash.update(part));
      response.on('end', () => end(response.statusCode, response.headers));
      response.on('error', () => end(0));
    });
    request.on('error', () => end(0));
    request.end(body);
  });
}

/**
 * `clients` ask until told to stop, each wish of `wanted` in turn, which has its { status, sha256 }.
 * `stop()` gives { asked, failures, told, worst (ms) }; `told`: how many POSTs were told that their
 * replica ended over them, by 502 or by the end of their connection: nobody asks them again of another one.
 */
export function startTraffic(base, wanted, clients) {
  const agent = new http.Agent({ keepAlive: true, maxSockets: clients });
  const so = { asked: 0, worst: 0, told: 0, failures: [] };
  let going = true;
  let next = 0;
  const client = async () => {
    while (going) {
      const { wish, answer } = wanted[next++ % wanted.length];
      const got = await ask(base, wish, agent);
      ++so.asked;
      so.worst = Math.max(so.worst, got.ms);
      if ([0, 502].includes(got.status) && wish.method === 'POST') ++so.told;
      else if (got.status !== answer.status || got.sha256 !== answer.sha256)
        so.failures.push(`${wish.method} ${wish.path}: ${got.status}, ${got.ms.toFixed()} ms`);
    }
  };
  const ended = Promise.all(Array.from({ length: clients }, client));
  return {
    asked: () => so.asked,
    stop: async () => {
      going = false;
      await ended;
      agent.destroy();
      return so;
    },
  };
}
