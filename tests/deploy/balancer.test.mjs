// What haproxy.cfg promises, each thing alone: which replica is asked, what is asked again, what is not.

import assert from 'node:assert/strict';
import http from 'node:http';
import { test } from 'node:test';
import { setTimeout } from 'node:timers/promises';
import { checkConfig, eventually, isUp, startBalancer, startReplica } from './balancer.mjs';
import { HANG_UP, SILENCE, startStandIn } from './stand_in.mjs';

const SCENE = { objects: [{ type: 'sphere', center: [0, 0, -9], radius: 2 }] };
const SMALL = 'width=16&height=12';

const get = (balancer, path, headers) => fetch(balancer.base + path, { headers });
const post = (balancer, path, body) => fetch(balancer.base + path, { method: 'POST', body });

// Runs `body(balancer, replicas)` with HAProxy before two replicas that `start(number)` starts.
async function balanced(start, body, variables) {
  const replicas = await Promise.all([start(1), start(2)]);
  let balancer;
  try {
    balancer = await startBalancer(replicas.map((replica) => replica.address), variables);
    await body(balancer, replicas);
  } finally {
    await balancer?.stop();
    for (const replica of replicas) await (replica.tia ?? replica).stop();
  }
}

const withReplicas = (body) => () => balanced(startReplica, body);
const withStandIns = (body, variables) => () => balanced(startStandIn, body, variables);

// Asks, and gives the name of the one that answered.
async function answeredBy(balancer, asking) {
  const earlier = await balancer.replicas();
  assert.equal((await asking()).status, 200);
  const later = await balancer.replicas();
  return later.find((replica, i) => replica.answered > earlier[i].answered).name;
}

// Sends `parts`, a while apart, on a connection of its own: on one that has been used before, HAProxy
// says what broke by closing it. Gives { status, type }.
function sent(balancer, method, parts = []) {
  const headers = method === 'POST' ? { 'Content-Length': parts.join('').length } : {};
  const request = http.request(`${balancer.base}/render`, { method, headers, agent: false });
  const answered = new Promise((done, fail) => {
    request.on('error', fail).on('response', (answer) =>
      done({ status: answer.statusCode, type: answer.resume().headers['content-type'] }));
  });
  const send = async () => {
    for (const part of parts) {
      request.write(part);
      await setTimeout(100);
    }
    request.end();
  };
  return send().then(() => answered);
}

test('the same request goes to the same replica, and different ones to both', withReplicas(async (balancer) => {
  for (const asking of [
    (seed) => get(balancer, `/render?${SMALL}&seed=${seed}`),
    (seed) => post(balancer, '/render', JSON.stringify({ width: 16, height: 12, seed })),
  ]) {
    const seen = [];
    for (let seed = 0; seed < 12; ++seed) {
      seen.push(await answeredBy(balancer, () => asking(seed)));
      assert.equal(await answeredBy(balancer, () => asking(seed)), seen.at(-1), `seed ${seed}`);
    }
    assert.equal(new Set(seen).size, 2);
  }
}));

test('a signed URL goes where it goes without its signature, which no log knows', withStandIns(
  async (balancer, replicas) => {
    const askedOf = (url) => replicas.findIndex(({ asked }) => asked.some((one) => one.url === url));
    const seen = new Set();
    for (let seed = 0; seed < 12; ++seed) {
      const plain = `/render?seed=${seed}`;
      const signed = `${plain}&exp=${2_000_000_000 + seed}&kid=k${seed}&sig=Secret-_${seed}`;
      for (const url of [plain, signed]) assert.equal((await get(balancer, url)).status, 200);
      assert.equal(askedOf(signed), askedOf(plain));
      seen.add(askedOf(plain));
    }
    assert.deepEqual([...seen].sort(), [0, 1]);
    await eventually(() => balancer.log().split('GET /render?seed=11 HTTP').length === 3, 'its log');
    assert.doesNotMatch(balancer.log(), /Secret|sig=|kid=/);
  }));

test('what names a kept scene or model goes to the replica that keeps it', withReplicas(async (balancer, replicas) => {
  const kept = await (await post(balancer, '/scenes', JSON.stringify(SCENE))).json();
  const known = await Promise.all(replicas.map(({ tia }) => fetch(tia.base + kept.location)));
  assert.deepEqual(known.map(({ status }) => status).sort(), [200, 404], 'one keeps it');
  assert.equal((await get(balancer, kept.location)).status, 200);
  const model = await post(balancer, '/models', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  assert.equal(model.status, 201);
  for (let i = 0; i < 12; ++i) {
    assert.equal((await get(balancer, `${model.headers.get('location')}?${i}`)).status, 200);
  }
  for (let seed = 0; seed < 12; ++seed) {
    assert.equal((await get(balancer, `/render?scene=${kept.id}&${SMALL}&seed=${seed}`)).status, 200);
    const wish = JSON.stringify({ scene: kept.id, width: 16, height: 12, seed });
    assert.equal((await post(balancer, '/render', wish)).status, 200);
  }
}));

test('a job is asked of who took it', withReplicas(async (balancer) => {
  for (let seed = 0; seed < 4; ++seed) {
    const job = await post(balancer, '/jobs', JSON.stringify(
      { kind: 'render', request: { scene: 'whitted', width: 16, height: 12, seed } }));
    assert.equal(job.status, 202);
    const at = job.headers.get('location');
    for (let i = 0; i < 6; ++i) assert.equal((await get(balancer, `${at}?${i}`, { Prefer: 'wait=1' })).status, 200);
    assert.equal((await get(balancer, `${at}/result`)).status, 200);
  }
}));

test('with a farm any replica is asked for a job', withStandIns(async (balancer, replicas) => {
  for (let i = 0; i < 24; ++i) await get(balancer, `/jobs/abcdefghijklmnopqrstuvwxy2/results/${i}`);
  for (const { asked } of replicas) assert.ok(asked.length > 0);
}, { FARM: '1' }));

test('what a stream shows is asked where the stream is, by GET and by POST', withStandIns(
  async (balancer, replicas) => {
    const streams = new Set();
    const askedOf = (url) => replicas.findIndex(({ asked }) => asked.some((one) => one.url === url));
    for (let seed = 0; seed < 12; ++seed) {
      for (const replica of replicas) replica.asked = [];
      const body = JSON.stringify({ seed, stream: 'multipart' });
      const answer = await (seed % 2
        ? post(balancer, '/render', body) : get(balancer, `/render?seed=${seed}&stream=events`));
      assert.equal(answer.status, 200);
      const stream = replicas.findIndex(({ asked }) => asked.length > 0);
      streams.add(stream);
      for (let i = 0; i < 4; ++i) {
        await get(balancer, `/pictures/${seed}-${i}`);
        assert.equal(askedOf(`/pictures/${seed}-${i}`), stream);
      }
      await post(balancer, `/streams/${seed}`, '{}');
      assert.equal(askedOf(`/streams/${seed}`), stream);
    }
    assert.equal(streams.size, 2);
  }));

// What the replicas have been asked, once `next` was their first answer to each.
async function askedAfter(replicas, next, asking) {
  for (const replica of replicas) Object.assign(replica, { next: [next], asked: [] });
  const answer = await asking();
  return { answer, asked: replicas.flatMap((replica) => replica.asked) };
}

test('a replica that hangs up over GET or HEAD is left for the other one, once', withStandIns(
  async (balancer, replicas) => {
    for (const method of ['GET', 'HEAD']) {
      const asking = () => sent(balancer, method);
      replicas[1].next = replicas[0].next = [];
      const { answer, asked } = await askedAfter(replicas, HANG_UP, asking);
      assert.equal(answer.status, 502, 'both have hung up');
      assert.deepEqual(asked.map((one) => one.method), [method, method]);
      Object.assign(replicas[0], { next: [HANG_UP], asked: [] });
      Object.assign(replicas[1], { next: [], asked: [] });
      assert.equal((await asking()).status, 200);
    }
  }));

test('what ends a replica by POST never reaches the other one', withStandIns(
  async (balancer, replicas) => {
    const text = 'x'.repeat(64 << 10);
    for (const parts of [['{}'], [text], [text.slice(0, 9), text.slice(9)]]) {
      const { answer, asked } = await askedAfter(replicas, HANG_UP, () => sent(balancer, 'POST', parts));
      assert.deepEqual(answer, { status: 502, type: 'application/problem+json' });
      assert.equal(asked.length, 1);
    }
  }));

test('a replica that takes no connection is left for the other one, by POST too', withStandIns(
  async (balancer, replicas) => {
    replicas[0].stop();  // before HAProxy has looked
    for (let i = 0; i < 6; ++i)
      assert.equal((await post(balancer, '/render', JSON.stringify({ seed: i }))).status, 200);
    assert.equal(replicas[1].asked.length, 6);
  }));

test('a replica that does not answer in time is left for the other one by GET, not by POST', withStandIns(
  async (balancer, replicas) => {
    replicas[0].next = [SILENCE];
    assert.equal((await get(balancer, '/render')).status, 200);
    const { answer, asked } = await askedAfter(replicas, SILENCE, () => post(balancer, '/explain', '{}'));
    assert.equal(answer.status, 504);
    assert.equal(asked.length, 1);
  }, { ANSWER_WITHIN: '200ms' }));

test('a body beyond the buffer is sent once: where its replica hangs up, 502 says so', withStandIns(
  async (balancer, replicas) => {
    assert.equal((await post(balancer, '/render', 'x'.repeat(1 << 20))).status, 200);
    for (const replica of replicas) replica.next = [HANG_UP];
    const answer = await post(balancer, '/render', 'x'.repeat(1 << 20));
    assert.equal(answer.status, 502);
    assert.equal(answer.headers.get('Retry-After'), '1');
    assert.equal((await answer.json()).status, 502);
  }));

test('a refusal is the answer: no other replica is asked', withStandIns(async (balancer, replicas) => {
  for (const status of [404, 422, 429, 500, 503]) {
    for (const replica of replicas) Object.assign(replica, { next: [status], asked: [] });
    assert.equal((await get(balancer, '/render')).status, status);
    assert.equal(replicas.flatMap(({ asked }) => asked).length, 1, `asked again after ${status}`);
  }
}));

test('who drains gets nothing new, who has too much to do does', withStandIns(async (balancer, replicas) => {
  replicas[0].ready = [503, 'draining'];
  replicas[1].ready = [503, 'overloaded'];
  await balancer.sees(1);
  assert.deepEqual((await balancer.replicas()).filter(isUp).map(({ name }) => name), ['tia2']);
}));

test('without any replica the answer is a problem document', withStandIns(async (balancer, replicas) => {
  for (const replica of replicas) replica.stop();
  await balancer.sees(0);
  const answer = await get(balancer, '/render');
  assert.equal(answer.headers.get('Content-Type'), 'application/problem+json');
  const { status, instance } = await answer.json();
  assert.equal(status, 503);
  assert.equal(answer.headers.get('X-Request-Id'), instance);
}));

test('every variable is understood', async () => {
  await checkConfig({ REPLICAS: 'tia.example:8080', STATS: '127.0.0.1:8404', AS_STARTED: '1', FARM: '1' });
  await assert.rejects(checkConfig({ ANSWER_WITHIN: 'soon' }));
});

test('replicas hear who asks and under which name; their numbers are their own', withStandIns(
  async (balancer, replicas) => {
    await get(balancer, '/named', { 'X-Request-Id': 'mine', 'X-Forwarded-For': '192.0.2.1' });
    await get(balancer, '/nameless', { 'X-Request-Id': '"' });
    for (const path of ['/metrics', '/%6detrics?a']) assert.equal((await get(balancer, path)).status, 404);
    const asked = replicas.flatMap((replica) => replica.asked);
    assert.deepEqual(asked.map(({ url }) => url).sort(), ['/named', '/nameless']);
    const [named, nameless] = ['/named', '/nameless'].map((path) => asked.find(({ url }) => url === path).headers);
    assert.equal(named['x-request-id'], 'mine');
    assert.match(named['x-forwarded-for'], /^192\.0\.2\.1, 127\./);
    assert.match(nameless['x-request-id'], /^[0-9a-f-]{36}$/);
  }));
