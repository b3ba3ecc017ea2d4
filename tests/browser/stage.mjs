// What the tests of the page share: one server, one browser, and the page in it.

import { after, before } from 'node:test';
import { startChromium, visit } from './page.mjs';
import { throughProxy } from './proxy.mjs';
import { startTia } from './tia.mjs';

/**
 * A server and a browser for the tests of one file. `look(body, options)` visits the page;
 * `proxied(body, options)` does so through a proxy, which `body(page, proxy)` gets too.
 */
export function stage() {
  const on = {
    look: (body, options) => visit(on.browser, on.tia.base, body, options),
    proxied: (body, options) =>
      throughProxy(on.tia.base, (proxy) =>
        visit(on.browser, proxy.base, (page) => body(page, proxy), options)),
  };
  before(async () => ([on.tia, on.browser] = await Promise.all([startTia(), startChromium()])));
  after(async () => {
    await on.browser?.close();
    await on.tia?.stop();
  });
  return on;
}
