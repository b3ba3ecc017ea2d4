// Replicas that are killed and restarted under load, behind HAProxy: nobody notices, but who had sent
// a POST to one that was killed.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { eventually, startBalancer, startReplica } from './balancer.mjs';
import { ask, startTraffic, wishes } from './traffic.mjs';

const CLIENTS = 8;
const ENOUGH = 1_000; // requests while something happens
// With room for a part of the pictures, so that there are some to draw.
const OPTIONS = ['--drain-delay-ms', '1500', '--drain-ms', '30000', '--cache-bytes', '100000'];

let replicas = [];
let balancer;
let wanted;

before(async () => {
  replicas = await Promise.all([startReplica(1, OPTIONS), startReplica(2, OPTIONS)]);
  balancer = await startBalancer(replicas.map((replica) => replica.address));
  wanted = [];
  for (const wish of await wishes(replicas[0].tia.base)) wanted.push({ wish, answer: await ask(replicas[0].tia.base, wish) });
});

after(async () => {
  await balancer?.stop();
  for (const { tia } of replicas) await tia.stop('SIGKILL');
});

// Runs `body(traffic)` under load, which goes on until enough has been asked; nothing may fail.
async function underLoad(t, body, mostTold = 0) {
  const traffic = startTraffic(balancer.base, wanted, CLIENTS);
  try {
    await body(traffic);
    await eventually(() => traffic.asked() >= ENOUGH, 'requests');
  } finally {
    await traffic.stop();
  }
  const { asked, worst, told, failures } = await traffic.stop();
  t.diagnostic(`${failures.length} of ${asked} failed, ${told} POSTs told of, ${worst.toFixed()} ms at worst`);
  assert.ok(told <= mostTold, `${told} POSTs were answered 502`);
  assert.deepEqual(failures.slice(0, 9), []);
  return worst;
}

const retries = async () =>
  (await balancer.replicas()).reduce((sum, { retries, elsewhere }) => sum + retries + elsewhere, 0);

test('every replica gives the same bytes', async () => {
  for (const { wish, answer } of wanted) {
    assert.ok([200, 201, 304].includes(answer.status), `${wish.method} ${wish.path}`);
    const { sha256 } = await ask(replicas[1].tia.base, wish);
    assert.equal(sha256, answer.sha256, `${wish.method} ${wish.path}`);
  }
});

test('SIGKILL of each replica in turn fails no GET, only POSTs that it had, and holds none up for a second', async (t) => {
  const calm = await underLoad(t, () => {});
  assert.ok((await balancer.replicas()).every(({ answered }) => answered > ENOUGH / 4), 'both have worked');
  const before = await retries();
  const worst = await underLoad(t, async (traffic) => {
    for (const replica of replicas) {
      const asked = traffic.asked();
      await eventually(() => traffic.asked() > asked + 100, 'load');
      assert.deepEqual(await replica.tia.stop('SIGKILL'), [null, 'SIGKILL']);
      await balancer.sees(1);
      await replica.restart();
      await balancer.sees(2);
    }
  }, 2 * CLIENTS);
  t.diagnostic(`${worst.toFixed()} ms at worst, ${calm.toFixed()} ms in calm; ${await retries() - before} retries`);
  assert.ok(worst - calm <= 1_000 + calm); // calm: what this machine makes of it by chance
  assert.ok(await retries() > before, 'nothing was under way when they died');
});

test('a rolling restart fails no request, and each replica ends with 0', (t) =>
  underLoad(t, async () => {
    for (const replica of replicas) {
      assert.deepEqual(await replica.tia.stop('SIGTERM'), [0, null]);
      await replica.restart();
      await balancer.sees(2);
    }
  }));
