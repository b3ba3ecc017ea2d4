// The page's address follows what it shows, once the hand rests; another scene is a step of the
// browser's history.

import { readAddress, writeAddress } from '../state/address.js';

const FIRST = { scene: 'thesis', key: 'a' }; // the lamp is on: there is a shadow to ask about

/** What the address wants to be shown: { request, asked }. */
export async function firstState() {
  const { pixel, ...request } = await readAddress(location).catch(() => ({}));
  const asked = Array.isArray(pixel) ? pixel : null;
  return { request: Object.keys(request).length ? request : FIRST, asked };
}

/** Keeps the address in step. */
export function mountAddress(studio) {
  let scene = null;
  studio.model.on('rest', async () => {
    const address = await pageAddress(studio);
    const { scene: now } = studio.model.request;
    const move = scene === null || scene === JSON.stringify(now) ? 'replaceState' : 'pushState';
    scene = JSON.stringify(now);
    if (address !== location.search + location.hash) history[move](null, '', address || location.pathname);
  });
  addEventListener('popstate', async () => {
    const { request, asked } = await firstState();
    scene = JSON.stringify(request.scene);
    studio.begin({ request, asked });
  });
}

/** The page's address for what is shown, relative to the page. */
export function pageAddress({ final, model }) {
  return writeAddress({ ...final, scene: final.scene ?? 'thesis', pixel: model.asked ?? undefined });
}
