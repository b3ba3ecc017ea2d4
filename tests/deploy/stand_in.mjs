// A stand-in for a replica: it answers what the test wants, or hangs up, and keeps what it was asked.

import { once } from 'node:events';
import http from 'node:http';

/** Instead of an answer the connection is closed. */
export const HANG_UP = Symbol('hang up');

/** Instead of an answer there is none. */
export const SILENCE = Symbol('silence');

/** Starts one. `next`: its answers, in order, each a status or one of these; then 200. */
export async function startStandIn(number) {
  const standIn = { name: `tia${number}`, ready: [200, 'ready'], next: [], asked: [] };
  const server = http.createServer(async (request, response) => {
    if (request.url === '/readyz') return say(response, ...standIn.ready);
    let body = '';
    for await (const part of request.setEncoding('utf8')) body += part;
    standIn.asked.push({ method: request.method, url: request.url, headers: request.headers, body });
    const answer = standIn.next.shift() ?? 200;
    if (answer === HANG_UP) response.destroy();
    else if (answer !== SILENCE) say(response, answer, 'as told');
  }).listen(0, `127.0.1.${number}`);
  await once(server, 'listening');
  const { address, port } = server.address();
  standIn.address = `${address}:${port}`;
  standIn.stop = () => {
    server.close();
    server.closeAllConnections();
  };
  return standIn;
}

const say = (response, status, word) =>
  response.writeHead(status, { 'Content-Type': 'application/json' }).end(JSON.stringify({ status: word }));
