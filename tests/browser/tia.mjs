// The real server as a child process: TIA, or the release build.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

export const BINARY = process.env.TIA ?? fileURLToPath(new URL('../../build/release/tia', import.meta.url));
const READY = /^Tia \S+ listening on (http:\/\/\S+:(\d+))$/;

/**
 * Starts a server and gives { base, port, get(path), stop() } once it says that it listens;
 * `stop(signal)` gives [exit status, signal]. `log`: where its standard error goes.
 */
export async function startTia(port = 0, options = [], log = 'inherit') {
  const child = spawn(BINARY, ['serve', '--port', String(port), ...options], { stdio: ['ignore', 'pipe', log] });
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
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} answered ${response.status}: ${await response.text()}`);
  return Buffer.from(await response.arrayBuffer());
}
