// The real server as a child process: TIA, or the release build.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

export const BINARY = process.env.TIA ?? fileURLToPath(new URL('../../build/release/tia', import.meta.url));
const READY = /^Tia \S+ listening on (http:\/\/\S+:(\d+))$/;

/**
 * Starts a server and gives { base, port, get(path), stop() } once it says that it listens;
 * `stop(signal)` gives [exit status, signal]. What it says on standard error is passed on, but for
 * its log of requests.
 */
export async function startTia(port = 0, options = []) {
  const child = spawn(BINARY, ['serve', '--port', String(port), ...options], { stdio: ['ignore', 'pipe', 'pipe'] });
  createInterface(child.stderr).on('line', (line) => line.startsWith('{"time":') || console.error(line));
  const ended = once(child, 'exit');
  const line = await Promise.race([
    once(createInterface(child.stdout), 'line').then(([first]) => first),
    ended.then(([code]) => Promise.reject(new Error(`${BINARY} ended with ${code} before it listened`))),
  ]);
  const listening = READY.exec(line);
  if (!listening) throw new Error(`not the line of a server that listens: ${line}`);

  const base = listening[1];
  return {
    base,
    port: Number(listening[2]),
    get: (path) => bytesOf(base + path),
    stop: (signal = 'SIGTERM') => (child.kill(signal), ended),
  };
}

async function bytesOf(url) {
  // Kept, a connection may have been closed by the time that a process which computes asks again.
  const response = await fetch(url, { headers: { connection: 'close' } });
  if (!response.ok) throw new Error(`${url} answered ${response.status}: ${await response.text()}`);
  return Buffer.from(await response.arrayBuffer());
}
