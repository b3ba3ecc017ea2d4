// The hand in the picture: dragging moves the lamp or the camera, wheel and pinch their distance,
// a click asks a point why. Arrows, plus and minus do the same for the keyboard.
//
// A tool of the hand:
//   begin()          what a drag needs to know of its beginning, or null where there is none
//   drag(grip, move) `move`: { start, at, shift }, pixels of the picture
//   turn([x, y])     a step of the arrow keys, in pixels
//   nearer(factor)   the distance times the factor
//   pan([x, y])      two fingers

import { opened } from '../state/request.js';
import { middleOf, windowOf } from '../state/window.js';
import { t } from '../words/words.js';
import { bindGestures } from './gestures.js';
import { cameraTool } from './hand_camera.js';
import { lampTool } from './hand_lamp.js';
import { orbitTool } from './hand_orbit.js';

const STEP_PX = 12; // of a picture 640 wide, for an arrow key; with Shift four times that
const CLOSER = 0.9;
const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const FACTORS = { '+': CLOSER, '=': CLOSER, '-': 1 / CLOSER, PageUp: CLOSER, PageDown: 1 / CLOSER };
const part = (id) => document.getElementById(id);
const still = () => {};

export function mountHand(studio) {
  const { model } = studio;
  const hand = part('hand');
  const lamp = { pan: still, ...lampTool(studio) };
  const camera = cameraTool(studio);
  const orbit = orbitTool(studio);
  const ask = askTool(studio, (factor) => (model.request.model ? orbit : camera).nearer(factor));
  const tools = { lamp, camera, orbit, ask };
  let chosen = null; // by name
  let tool = null; // of a model the camera is another one
  const drawMark = () => lamp.draw(tool === 'lamp');

  function take(name) {
    chosen = name;
    tool = name === 'camera' && model.request.model ? 'orbit' : name;
    hand.dataset.tool = name;
    hand.setAttribute('aria-label', t(`tools.${tool}Label`));
    part('hint').textContent = t(`tools.${tool}Hint`);
    drawMark();
  }

  const choose = mountChoice(take);
  let turned = false; // who opens a model wants to turn it, and back among scenes to hold the lamp
  model.on('want', () => {
    if (turned === Boolean(model.request.model)) return;
    turned = !turned;
    if (chosen === 'ask') return;
    choose(turned ? 'camera' : 'lamp');
  });

  let grip = null;
  bindGestures(hand, {
    seen: () => windowOf(model.request),
    begin: () => (grip = tools[tool].begin()),
    drag(move) {
      if (!studio.pivot && tool !== 'orbit') grip = null; // another scene has come under the hand
      if (grip) tools[tool].drag(grip, move);
    },
    end: () => (grip = null),
    nearer: (factor) => tools[tool].nearer(factor),
    pan: (by) => tools[tool].pan(by),
    click: ask.at,
  });
  hand.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const [step, factor] = [STEPS[event.key], FACTORS[event.key]];
    if (!step && !factor && event.key !== 'Enter') return;
    event.preventDefault();
    const px = STEP_PX * (event.shiftKey ? 4 : 1) * (windowOf(model.request).width / 640);
    if (step) tools[tool].turn(step.map((way) => way * px), event.shiftKey);
    else if (factor) tools[tool].nearer(factor);
    else ask.at(model.asked ?? middleOf(model.request));
  });
  part('start-again').addEventListener('click', () => {
    model.asked = null;
    const { scene, width, height, model: id } = model.request;
    const there = model.source !== null; // one that is not there is left
    studio.open({ ...(id && there ? { model: id } : opened(there ? scene : undefined)), width, height });
  });
  for (const event of ['show', 'world', 'source']) model.onFrame(event, drawMark);
}

// A click asks with every tool; with this one arrows move the point that is asked about, too.
function askTool(studio, nearer) {
  const { model } = studio;

  function at([x, y]) {
    const seen = windowOf(model.request);
    const within = (value, from, length) => Math.min(from + length - 1, Math.max(from, Math.floor(value)));
    model.ask([within(x, seen.x, seen.width), within(y, seen.y, seen.height)]);
    studio.openTab('tab-why');
  }

  function turn([x, y]) {
    const [column, row] = model.asked ?? middleOf(model.request);
    const steps = (px) => Math.sign(px) * Math.max(1, Math.round(Math.abs(px) / STEP_PX)); // never on the spot
    at([column + steps(x), row + steps(y)]);
  }

  return { begin: () => null, drag: still, turn, nearer, pan: still, at };
}

// The radio group of the tools. Gives what chooses one by its name.
function mountChoice(chosen) {
  const radios = [...part('tools').querySelectorAll('[role=radio]')];
  const choose = (radio) => {
    for (const other of radios) {
      other.setAttribute('aria-checked', other === radio);
      other.tabIndex = other === radio ? 0 : -1;
    }
    chosen(radio.dataset.tool);
  };
  part('tools').addEventListener('keydown', (event) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!by || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const now = radios.findIndex((radio) => radio.getAttribute('aria-checked') === 'true');
    const next = radios.at((now + by) % radios.length);
    choose(next);
    next.focus();
  });
  for (const radio of radios) radio.addEventListener('click', () => choose(radio));
  const chooseNamed = (name) => choose(radios.find((radio) => radio.dataset.tool === name));
  chooseNamed('lamp');
  return chooseNamed;
}
