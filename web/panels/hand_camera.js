// The hand's camera: orbit around what one looks at, pan, nearer and farther.

import { orbit, pan, zoom } from '../space/eye.js';
import { tidyVector } from '../space/vec.js';

/** A tool of the hand (panels/hand.js). */
export function cameraTool(studio) {
  function begin() {
    const { view, pivot, camera } = studio;
    return pivot && { view, pivot, camera };
  }

  function drag({ view, pivot, camera }, { start, at, shift }) {
    const [x, y] = [(at[0] - start[0]) / view.height, (at[1] - start[1]) / view.height];
    look(shift ? pan(camera, view, pivot, -x, y) : orbit(camera, pivot, -x * Math.PI, -y * Math.PI));
  }

  function turn(at, shift) {
    const grip = begin();
    if (grip) drag(grip, { start: [0, 0], at, shift });
  }

  function nearer(factor) {
    if (studio.pivot) look(zoom(studio.camera, studio.pivot, factor));
  }

  function look(fields) {
    const tidied = Object.fromEntries(Object.entries(fields).map(([name, value]) =>
      [name, ['location', 'look_at'].includes(name) ? tidyVector(value, 5) : value]));
    studio.moveCamera(tidied);
  }

  return { begin, drag, turn, nearer, pan: (by) => turn(by, true) };
}
