// Radio in the picture: paths over it, and the antennas, which a hand moves at their height.

import { project, rayThrough } from '../space/view.js';
import { windowOf } from '../state/window.js';
import { add, scale } from '../space/vec.js';
import { t } from '../words/words.js';
import { svg } from './element.js';
import { bindHandle } from './handle.js';
import { seen } from './rays.js';
import { antennaNames, drawnWaves } from './radio_waves.js';

const WIDE = 480; // of the layer that handles are in
const FARTHEST = 8; // times as far as it was: a hand that points at the horizon means nothing nearer

/** Draws them from now on; `list` knows which path is the current one. */
export function radioView(studio, radio, list) {
  const waves = document.getElementById('overlay').appendChild(svg('g', { class: 'waves' }));
  const sheet = svg('svg', { class: 'radio-hands', role: 'group', 'aria-label': t('page.picture') });
  document.getElementById('compare').before(sheet);
  const held = new Map(); // handles by antenna

  function draw() {
    const { view, pivot, model } = studio;
    const there = radio.open && pivot;
    const window = windowOf(model.request);
    waves.replaceChildren(...(there && radio.found ? drawnWaves(radio.found.paths, list.current, (from, to) => seen(view, from, to)) : []),
      ...(there ? antennaNames(radio.antennas, (at) => project(view, at), window.height / 30) : []));
    const high = (WIDE * window.height) / window.width;
    sheet.setAttribute('viewBox', `0 0 ${WIDE} ${high}`);
    const all = there ? radio.antennas : [];
    for (const [name, handle] of held) if (!handle.held && !all.some((one) => one.name === name && placeOf(one))) drop(name);
    for (const antenna of all) {
      const at = placeOf(antenna);
      if (!at) continue;
      const label = t('radio.moveSeen', { name: antenna.name });
      const known = held.get(antenna.name);
      if (!known) held.set(antenna.name, bindHandle(sheet, antenna.kind, at, label, moverOf(antenna)));
      else if (!known.held) known.place(at, label);
    }
  }

  function drop(name) {
    held.get(name).remove();
    held.delete(name);
  }

  // Where an antenna is seen, in the layer's units; null where it is not.
  function placeOf({ position }) {
    const window = windowOf(studio.model.request);
    const at = project(studio.view, position);
    if (!at) return null;
    const unit = WIDE / window.width;
    const [x, y] = [(at[0] - window.x) * unit, (at[1] - window.y) * unit];
    return x >= 0 && y >= 0 && x <= WIDE && y <= window.height * unit ? [x, y] : null;
  }

  function moverOf({ name }) {
    let taken = null;
    const now = () => radio.antennas.find((one) => one.name === name);
    return {
      take: () => (taken = { view: studio.view, unit: windowOf(studio.model.request).width / WIDE, at: now().position }),
      move([x, y]) {
        const to = levelAt(taken, [x * taken.unit, y * taken.unit]);
        if (to) radio.move(now(), to, true);
        return Boolean(to);
      },
    };
  }

  return { draw };
}

// Where the ray through a place of the picture meets the level plane of `at`, after a way of pixels; null nowhere near.
function levelAt({ view, at }, [x, y]) {
  const from = project(view, at);
  const { origin, direction } = rayThrough(view, from[0] + x, from[1] + y);
  const far = (at[1] - origin[1]) / direction[1];
  const away = Math.hypot(...at.map((value, i) => value - view.origin[i]));
  return far > 0 && far < FARTHEST * away ? add(origin, scale(direction, far)).with(1, at[1]) : null;
}
