// Radio in the plans: antennas and a probe that a hand takes, the map from above with its legend, and paths.

import { placeIn, wayIn } from '../space/plan.js';
import { add } from '../space/vec.js';
import { t } from '../words/words.js';
import { svg } from './element.js';
import { radioLegend, valueWords } from './radio_legend.js';
import { antennaNames, drawnWaves } from './radio_waves.js';

const NARROW = 0.6; // times as wide as in the picture
const said = document.getElementById('said');

/** Draws them from now on; `list` knows which path is the current one. */
export function radioPlans(studio, radio, list) {
  const layers = new Map(); // by the plan's name: { plan, map, waves }
  const legend = radioLegend();
  document.getElementById('maps').append(legend.node);
  let probe = null; // [x, z]
  let drawn = null; // the map that is

  studio.placeRadio = (plan) => {
    const layer = layers.get(plan.name) ?? begun(plan);
    layer.plan = plan;
    const level = plan.name === 'top' && plan.into[1] === -1;
    if (radio.open) radio.see(level ? areaOf(plan) : plan.name === 'top' ? null : radio.area);
    placeHandles(plan, level);
  };

  function begun({ name, sheet }) {
    const layer = { map: svg('image', { class: 'radio-map', preserveAspectRatio: 'none' }), waves: svg('g', { class: 'waves' }) };
    sheet.firstChild.after(layer.map);
    sheet.lastChild.before(layer.waves);
    if (name === 'top') {
      sheet.addEventListener('pointermove', (event) => legend.hover(radio.open && valueAt(pointed(layer.plan, event))));
      sheet.addEventListener('pointerleave', () => legend.hover(null));
    }
    layers.set(name, layer);
    return layer;
  }

  function placeHandles(plan, level) {
    const all = radio.open ? radio.antennas : [];
    const names = all.map(({ kind, number }) => `${kind}-${number}`);
    if (level && radio.open && radio.map) names.push('probe');
    for (const name of plan.names) if (/^(transmitter|receiver|probe)/.test(name) && !names.includes(name)) plan.drop(name);
    for (const antenna of all)
      plan.handle(`${antenna.kind}-${antenna.number}`, plan.at(antenna.position), t('radio.move', { name: antenna.name, map: plan.map }), moverOf(antenna));
    if (names.includes('probe')) placeProbe(plan);
  }

  function moverOf({ name }) {
    let taken = null;
    const now = () => radio.antennas.find((one) => one.name === name);
    return { take: () => (taken = now().position), move: (way) => (radio.move(now(), add(taken, way), true), true) };
  }

  function placeProbe(plan) {
    const [x0, z0, x1, z1] = radio.area;
    const inside = probe && probe[0] > x0 && probe[0] < x1 && probe[1] > z0 && probe[1] < z1;
    if (!inside) probe = [(x0 + x1) / 2, (z0 + z1) / 2];
    let taken = null;
    const place = () => [probe[0], radio.settings.height, probe[1]];
    plan.handle('probe', plan.at(place()), t('radio.probe', { map: plan.map }), {
      take: () => (taken = place()),
      move(way) {
        const [x, , z] = add(taken, way);
        if (x < x0 || x > x1 || z < z0 || z > z1) return false;
        probe = [x, z];
        said.textContent = legend.hover(valueAt(probe));
        return true;
      },
    });
  }

  // The map's word for a place [x, z]; null beside the map.
  function valueAt([x, z]) {
    const { map } = radio;
    if (!map) return null;
    const value = map.values[Math.floor((z - map.area[1]) / map.cell)]?.[Math.floor((x - map.area[0]) / map.cell)];
    return value === undefined ? null : { x, z, value, words: value === null ? t('radio.nothingHere') : valueWords(map, value, radio) };
  }

  function drawMap({ plan, map: image }) {
    const { map } = radio;
    const shown = radio.open && map && plan.into[1] === -1;
    legend.node.hidden = !shown;
    image.toggleAttribute('hidden', !shown);
    if (!shown) return;
    if (drawn !== map) {
      drawn = map;
      const scale = legend.draw(map, radio);
      for (const [name, value] of Object.entries({ href: pixelsOf(map, scale), width: map.width, height: map.height })) image.setAttribute(name, value);
    }
    // A cell of the map to the right and one down are ways in the plan.
    const at = (column, row) => placeIn(plan, plan.region, plan.height, [map.area[0] + column * map.cell, map.y, map.area[1] + row * map.cell]);
    const [[e, f], [x1, y1], [x2, y2]] = [at(0, 0), at(1, 0), at(0, 1)];
    image.setAttribute('transform', `matrix(${[x1 - e, y1 - f, x2 - e, y2 - f, e, f].join(' ')})`);
  }

  /** Draws map and paths; antennas follow by themselves. */
  function draw() {
    for (const [name, layer] of layers) {
      const { region, height } = layer.plan;
      const place = (from, to) => ({ a: placeIn(layer.plan, region, height, from), b: placeIn(layer.plan, region, height, to) });
      layer.waves.replaceChildren(...(radio.open && radio.found ? drawnWaves(radio.found.paths, list.current, place, NARROW) : []),
        ...(radio.open ? antennaNames(radio.antennas, (at) => layer.plan.at(at), height / 18) : []));
      if (name === 'top') drawMap(layer);
    }
  }

  return { draw };
}

// The part of a level plane that a plan shows: [x0, z0, x1, z1].
function areaOf({ across, up, region: { center, half } }) {
  const reach = (i) => half * Math.abs(across[i]) * (4 / 3) + half * Math.abs(up[i]);
  return [center[0] - reach(0), center[2] - reach(2), center[0] + reach(0), center[2] + reach(2)];
}

// Where a pointer is in a plan, as [x, z].
function pointed({ region, height, sheet, ...plan }, { clientX, clientY }) {
  const box = sheet.getBoundingClientRect();
  const way = [((clientX - box.left) / box.width - 1 / 2) * height * (4 / 3), ((clientY - box.top) / box.height - 1 / 2) * height];
  const [x, , z] = add(region.center, wayIn(plan, region, height, way));
  return [x, z];
}

// A pixel a cell; where nothing comes there is none.
function pixelsOf({ width, height, values }, scale) {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  for (const [i, value] of values.flat().entries()) if (value !== null) image.data.set([...scale.colorOf(value), 255], 4 * i);
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}
