// The page's address follows what it shows, once the hand rests; another scene is a step of the
// browser's history.

import { Problem } from '../picture/problem.js';
import { readAddress, writeAddress } from '../state/address.js';
import { FIRST, PARAMETERS } from '../state/request.js';
import { t } from '../words/words.js';

/** What the address wants to be shown: { request, asked }, and the `problem` with it, or null. */
export async function firstState() {
  const state = await readAddress(location).catch(() => null);
  const { pixel, ...rest } = state ?? {};
  const asked = Array.isArray(pixel) && pixel.length === 2 ? pixel : null;
  const others = Object.keys(rest).filter((name) => !PARAMETERS.includes(name));
  const request = Object.fromEntries(Object.entries(rest).filter(([name]) => PARAMETERS.includes(name)));
  const title = !state ? t('trouble.damaged') : others.length ? t('trouble.otherParts', { names: others.join(', ') }) : '';
  const problem = title ? new Problem({ status: 400, title }) : null;
  return { request: Object.keys(request).length ? request : FIRST, asked, problem };
}

// What is shown, however it is seen.
const whatOf = ({ scene, model }) => JSON.stringify([scene, model]);

/** Keeps the address in step. */
export function mountAddress(studio) {
  let scene = null;
  let newest = 0;
  for (const event of ['rest', 'pause']) studio.model.on(event, follow);
  async function follow() {
    const mine = ++newest;
    const now = whatOf(studio.model.request);
    const address = await pageAddress(studio);
    if (mine !== newest) return;
    const move = scene === null || scene === now ? 'replaceState' : 'pushState';
    scene = now;
    // With the path before it: a fragment alone would keep the query that was there.
    if (address !== location.search + location.hash) history[move](null, '', location.pathname + address);
  }
  addEventListener('popstate', async () => {
    newest += 1;
    const state = await firstState();
    scene = whatOf(state.request);
    studio.begin(state);
  });
  document.addEventListener('click', goWithin);
}

// Links to a part of this page lead there and leave the address alone, which says what is shown.
function goWithin(event) {
  const link = event.target.closest?.('a[href^="#"]');
  const part = link && document.getElementById(link.hash.slice(1));
  if (!part || event.ctrlKey || event.metaKey || event.shiftKey) return;
  event.preventDefault();
  part.scrollIntoView();
  if (!part.matches('a, button, input, [tabindex]')) part.tabIndex = -1;
  part.focus({ preventScroll: true });
}

/** The page's address for what is shown, relative to the page. */
export function pageAddress({ unasked, model }) {
  const scene = unasked.scene ?? (unasked.model ? undefined : 'thesis');
  return writeAddress({ ...unasked, scene, pixel: model.asked ?? undefined });
}
