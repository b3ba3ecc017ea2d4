// What the tests of the page share: one server, one browser, and the page in it.

import { after, before } from 'node:test';
import { sharing, startChromium, visit } from './page.mjs';
import { startProxy, throughProxy } from './proxy.mjs';
import { startTia } from './tia.mjs';

let running = null; // the process' own server and browser, whichever of its files asks first

/**
 * A server and a browser for the tests of this process. `look(body, options)` visits the page;
 * `proxied(body, options)` does so through a proxy, which `body(page, proxy)` gets too; `shared(again,
 * options)` and `sharedProxied(again, options)` give them for tests that share a page.
 */
export function stage() {
  const on = {
    look: (body, options) => visit(on.browser, on.tia.base, body, options),
    proxied: (body, options) =>
      throughProxy(on.tia.base, (proxy) =>
        visit(on.browser, proxy.base, (page) => body(page, proxy), options)),
    shared: (again, options) => sharing(() => ({ browser: on.browser, base: on.tia.base, options }), again),
    sharedProxied: (again, options) => sharedProxied(on, again, options),
  };
  before(async () => ([on.tia, on.browser] = await (running ??= Promise.all([startTia(), startChromium()]))));
  after(async () => {
    const [tia, browser] = await (running ?? []);
    running = null;
    await browser?.close();
    await tia?.stop();
  });
  return on;
}

function sharedProxied(on, again, options) {
  let proxy;
  after(() => proxy?.stop());
  const use = sharing(async () => {
    proxy?.stop();
    proxy = await startProxy(on.tia.base);
    return { browser: on.browser, base: proxy.base, options };
  }, (page) => (proxy.reset(), again(page)));
  return (body) => use((page) => body(page, proxy));
}
