// The same rays at another wavelength: where transmitters reach, and by which ways a receiver hears them.

import { emptySpaceDb } from '../space/radio.js';
import { length, subtract } from '../space/vec.js';
import { Radio } from '../studio/radio.js';
import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';
import { antennaForm } from './radio_antennas.js';
import { radioCharts } from './radio_charts.js';
import { radioForm } from './radio_form.js';
import { pathList } from './radio_list.js';
import { methodTable } from './radio_methods.js';
import { radioPlans } from './radio_plan.js';
import { radioView } from './radio_view.js';

export const style = 'panels/radio.css';

export default function mountRadio(studio, panel) {
  const { model } = studio;
  const radio = new Radio(studio);
  const told = element('p', { class: 'told', role: 'status' });
  const list = pathList(radio, () => again());
  const [form, charts, methods, antennas] = [radioForm, radioCharts, methodTable, antennaForm].map((make) => make(radio));
  const notes = element('ul', { class: 'note radio-notes' });
  const box = element('div', { class: 'radio-found' }, list.node, charts.node);
  panel.append(element('p', { class: 'note' }, t('radio.about')), form.node, antennas.node, told, box, methods.node, notes);
  const layers = [radioPlans(studio, radio, list), radioView(studio, radio, list)];
  const again = () => layers.forEach((layer) => layer.draw());

  const news = {
    antennas() {
      studio.near = radio.open ? radio.around : undefined;
      for (const part of [form, antennas]) part.draw();
    },
    map: () => {},
    paths() {
      for (const part of [list, charts, methods]) part.draw();
      notes.replaceChildren(...[...radio.found.assumed, ...radio.found.warnings].map((words) => element('li', {}, words)));
      tell();
    },
    methods: methods.draw,
    problem() {
      showProblem(radio.problem);
      box.classList.toggle('stale', radio.problem !== null);
      tell();
    },
    rest: tell,
  };

  // At rest only: a hand that moves would be talked to all the way.
  function tell() {
    if (radio.held || !radio.found) return;
    const words = radio.problem ? '' : foundWords(radio.found);
    if (told.textContent !== words) told.textContent = words;
  }

  model.on('radio', (_, what) => news[what]());
  for (const event of ['radio', 'world', 'show', 'tab']) model.onFrame(event, again);
  model.on('tab', () => model.tell('radio', 'antennas'));
  radio.follow();
}

// How many ways there are, what they bring, and how that is to the same distance in empty space.
function foundWords({ paths, total, counts, asked }) {
  const [sender, taker] = [asked.transmitters[0], asked.receivers[0]];
  const names = { from: sender.name, to: taker.name };
  const empty = emptySpaceDb(length(subtract(sender.position, taker.position)), asked.frequency_hz);
  if (!paths.length) return t('radio.nothing', { ...names, candidates: countWords(counts.candidates), blocked: countWords(counts.blocked) });
  const lost = empty - total.incoherent_db;
  return [t('radio.found', { ...names, count: countWords(paths.length), gain: decibels(total.incoherent_db), spread: numberWords((total.delay_spread_s ?? 0) * 1e9) }),
    t(lost > 0 ? 'radio.lost' : 'radio.won', { empty: decibels(empty), by: numberWords(Math.abs(lost)) })].join(' ');
}

const decibels = (value) => numberWords(Number(value.toFixed(1)), 5);
