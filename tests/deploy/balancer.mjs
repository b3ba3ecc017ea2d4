// HAProxy with the configuration that is shipped, as a child process; and replicas for it.

import { execFile, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm } from 'node:fs/promises';
import net from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { startTia } from '../browser/tia.mjs';

const CONFIG = fileURLToPath(new URL('../../server/deploy/haproxy.cfg', import.meta.url));
const PATH = `${process.env.PATH}:/usr/sbin`; // where Debian has haproxy

/** Looks again and again until `look()` gives something true, and gives that. */
export async function eventually(look, what, patience = 20_000) {
  for (const end = performance.now() + patience; performance.now() < end;) {
    const seen = await look();
    if (seen) return seen;
    await new Promise((done) => setTimeout(done, 5));
  }
  throw new Error(`waited in vain for ${what}`);
}

/** A replica on an address of its own, where it can be started again: nobody else takes its port. */
export async function startReplica(number, options = []) {
  const host = `127.0.1.${number}`;
  const start = (port) => startTia(port, ['--host', host, ...options]);
  const replica = { name: `tia${number}`, host, tia: await start(0) };
  replica.address = `${host}:${replica.tia.port}`;
  replica.restart = async () => (replica.tia = await start(replica.tia.port));
  return replica;
}

/** Starts HAProxy before replicas, two addresses, and waits until it sees them. */
export async function startBalancer([REPLICA_1, REPLICA_2], variables = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'tia-balancer-'));
  const LISTEN = await freeAddress();
  const ADMIN_SOCKET = join(folder, 'admin');
  const env = { PATH, LISTEN, ADMIN_SOCKET, REPLICA_1, REPLICA_2, ...variables };
  if (process.getuid() !== 0) env.AS_STARTED = '1';
  const child = spawn('haproxy', ['-f', CONFIG], { env, stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = once(child, 'exit');
  let log = '';
  for (const output of [child.stdout, child.stderr]) output.setEncoding('utf8').on('data', (lines) => (log += lines));
  ended.then(([code]) => code && console.error(log));
  const balancer = {
    base: `http://${LISTEN}`,
    log: () => log,
    replicas: () => replicasOf(ADMIN_SOCKET),
    sees: (count) => eventually(async () => (await balancer.replicas()).filter(isUp).length === count,
      `${count} replicas to be seen`),
    stop: async () => {
      child.kill('SIGTERM');
      await ended;
      await rm(folder, { recursive: true });
    },
  };
  await eventually(() => balancer.replicas().catch(() => false), 'haproxy to start');
  await balancer.sees(2);
  return balancer;
}

/** Lets HAProxy read the configuration with these variables. Throws where it refuses it. */
export const checkConfig = (variables) =>
  promisify(execFile)('haproxy', ['-c', '-q', '-f', CONFIG], { env: { PATH, ...variables } });

export const isUp = (replica) => replica.status.startsWith('UP');

async function freeAddress() {
  const server = net.createServer().listen(0, '127.0.1.9');
  await once(server, 'listening');
  const { address, port } = server.address();
  await new Promise((done) => server.close(done));
  return `${address}:${port}`;
}

// What HAProxy knows of its servers (management guide, 9.1): a line of numbers for each.
async function replicasOf(socket) {
  const [head, ...lines] = (await tell(socket, 'show stat replicas 4 -1')).trim().split('\n');
  const names = head.replace('# ', '').split(',');
  return lines.map((line) => line.split(','))
    .map((values) => Object.fromEntries(names.map((name, i) => [name, values[i]])))
    .map(({ svname, status, stot, wretr, wredis }) =>
      ({ name: svname, status, answered: +stot, retries: +wretr, elsewhere: +wredis }));
}

async function tell(path, command) {
  const socket = net.connect(path);
  socket.end(`${command}\n`);
  let text = '';
  for await (const part of socket.setEncoding('utf8')) text += part;
  return text;
}
