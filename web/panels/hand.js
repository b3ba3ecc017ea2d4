// The hand in the picture: dragging moves the lamp or the camera, wheel and pinch their distance,
// a click asks a point why. Arrows, plus and minus do the same for the keyboard.

import { atDistance, distanceOf, lampAt, markOf, ringRadius } from '../space/lamp.js';
import { orbit, pan, zoom } from '../space/eye.js';
import { tidyVector } from '../space/vec.js';
import { t } from '../words/words.js';
import { element, svg } from './element.js';
import { bindGestures } from './gestures.js';

const STEP_PX = 12; // of a picture 640 wide, for an arrow key; with Shift four times that
const CLOSER = 0.9;
const part = (id) => document.getElementById(id);

export function mountHand(studio) {
  const { model } = studio;
  const [hand, overlay, hint] = [part('hand'), part('overlay'), part('hint')];
  const radios = [...part('tools').querySelectorAll('[role=radio]')];
  const ring = overlay.appendChild(svg('circle', { class: 'ring' }));
  // Moved as a whole layer by the compositor: nothing is painted anew while the hand moves it.
  const lamp = element('div', { class: 'lamp' }, element('span', { class: 'lamp-mark' }));
  overlay.after(element('div', { class: 'lamp-room' }, lamp));
  let tool = null;
  let grip = null; // what a drag began with

  const tools = {
    lamp: { begin: () => lampGrip(studio), drag: dragLamp, nearer: moveLampNearer, turn: turnLamp },
    camera: { begin: () => cameraGrip(studio), drag: dragCamera, nearer: moveEyeNearer, turn: turnCamera },
    ask: { begin: () => null, drag: () => {}, nearer: moveEyeNearer, turn: moveCrosshair },
  };

  function choose(name) {
    tool = name;
    for (const radio of radios) {
      const on = radio.dataset.tool === name;
      radio.setAttribute('aria-checked', on);
      radio.tabIndex = on ? 0 : -1;
    }
    hand.dataset.tool = name;
    hand.setAttribute('aria-label', t(`tools.${name}Label`));
    hint.textContent = t(`tools.${name}Hint`);
    drawMark();
  }

  // ---- the lamp -----------------------------------------------------------------------------

  function dragLamp({ start, at }) {
    const { view, pivot, distance, mark } = grip;
    const to = mark ? [mark[0] + at[0] - start[0], mark[1] + at[1] - start[1]] : at;
    studio.moveLight(tidyVector(lampAt(view, pivot, distance, to)));
  }

  function moveLampNearer(factor) {
    const { pivot, light } = studio;
    if (pivot && light) studio.moveLight(tidyVector(atDistance(pivot, light, factor)));
  }

  function turnLamp([x, y]) {
    grip = lampGrip(studio);
    if (grip) dragLamp({ start: [0, 0], at: grip.mark ? [x, y] : [grip.view.width / 2 + x, grip.view.height / 2 + y] });
  }

  function drawMark() {
    const { view, pivot, light } = studio;
    const seen = tool === 'lamp' && pivot && view;
    setAttributes(overlay, { viewBox: `0 0 ${view.width} ${view.height}` });
    ring.toggleAttribute('hidden', !seen);
    lamp.hidden = !seen || !light;
    setAttributes(ring, { cx: view.width / 2, cy: view.height / 2, r: ringRadius(view) });
    if (lamp.hidden) return;
    const [x, y] = markOf(view, pivot, light);
    lamp.style.translate = `${((100 * x) / view.width).toFixed(2)}% ${((100 * y) / view.height).toFixed(2)}%`;
  }

  // ---- the camera ---------------------------------------------------------------------------

  function dragCamera({ start, at, shift }) {
    const { view, pivot, camera } = grip;
    const [x, y] = [(at[0] - start[0]) / view.height, (at[1] - start[1]) / view.height];
    const moved = shift ? pan(camera, pivot, -x, y) : orbit(camera, pivot, -x * Math.PI, -y * Math.PI);
    look(moved);
  }

  function moveEyeNearer(factor) {
    if (studio.pivot) look(zoom(studio.camera, studio.pivot, factor));
  }

  function turnCamera([x, y], shift) {
    grip = cameraGrip(studio);
    if (grip) dragCamera({ start: [0, 0], at: [x, y], shift });
  }

  function look(fields) {
    const tidied = Object.fromEntries(Object.entries(fields).map(([name, value]) =>
      [name, ['location', 'look_at'].includes(name) ? tidyVector(value, 5) : value]));
    model.change({ camera: { ...model.request.camera, ...tidied } });
  }

  // ---- asking -------------------------------------------------------------------------------

  function moveCrosshair([x, y]) {
    const { view } = studio;
    const [column, row] = model.asked ?? [view.width / 2, view.height / 2];
    ask([column + x / STEP_PX, row + y / STEP_PX]);
  }

  function ask([x, y]) {
    const { view } = studio;
    const within = (value, size) => Math.min(size - 1, Math.max(0, Math.floor(value)));
    model.ask([within(x, view.width), within(y, view.height)]);
    studio.openTab('tab-why');
  }

  bindGestures(hand, {
    size: () => [studio.view.width, studio.view.height],
    begin: () => (grip = tools[tool].begin()),
    drag: (move) => grip && (tool === 'camera' || tool === 'lamp') && tools[tool].drag(move),
    end: () => (grip = null),
    nearer: (factor) => tools[tool].nearer(factor),
    pan: (by) => tool === 'camera' && (grip = cameraGrip(studio)) && dragCamera({ start: [0, 0], at: by, shift: true }),
    click: ask,
  });

  hand.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const closer = { '+': CLOSER, '=': CLOSER, '-': 1 / CLOSER, PageUp: CLOSER, PageDown: 1 / CLOSER }[event.key];
    if (!step && !closer && event.key !== 'Enter') return;
    event.preventDefault();
    const px = STEP_PX * (event.shiftKey ? 4 : 1) * (studio.view.width / 640);
    if (step) tools[tool].turn(step.map((way) => way * px), event.shiftKey && tool === 'camera');
    else if (closer) tools[tool].nearer(closer);
    else ask(model.asked ?? [studio.view.width / 2, studio.view.height / 2]);
  });

  part('tools').addEventListener('keydown', (event) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    const next = radios.at((radios.findIndex((it) => it.dataset.tool === tool) + by) % radios.length);
    choose(next.dataset.tool);
    next.focus();
  });
  for (const radio of radios) radio.addEventListener('click', () => choose(radio.dataset.tool));
  part('start-again').addEventListener('click', () => {
    model.asked = null;
    const { scene, width, height } = model.request;
    studio.open({ scene, width, height });
  });
  for (const event of ['show', 'world', 'source']) model.onFrame(event, drawMark);
  choose('lamp');
}

// What does not change is not set: nothing is painted anew for it.
function setAttributes(made, values) {
  for (const [name, value] of Object.entries(values))
    if (made.getAttribute(name) !== String(value)) made.setAttribute(name, value);
}

function lampGrip({ view, pivot, light, camera }) {
  if (!pivot) return null;
  const distance = light ? distanceOf(pivot, light) : 1.5 * distanceOf(pivot, camera.location);
  return { view, pivot, distance, mark: light && markOf(view, pivot, light) };
}

function cameraGrip({ view, pivot, camera }) {
  return pivot && { view, pivot, camera };
}
