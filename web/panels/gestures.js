// Pointers of every kind as a few gestures, in the picture's own pixels.

const SLOP_PX = 4; // a press that moves less is a click
const WHEEL = 0.0015; // of distance for a pixel of the wheel

/**
 * Binds gestures to `target`: `begin()` when a drag starts, `drag({ start, at, shift })` while it
 * goes on, `end()`; `nearer(factor)` by wheel or pinch; `pan([dx, dy])` by two fingers; `click([x,
 * y])`. `seen()` gives what the target shows: { x, y, width, height } of the picture.
 */
export function bindGestures(target, { seen, begin, drag, end, nearer, pan, click }) {
  const pointers = new Map();
  let start = null;
  let dragging = false;
  let pinch = null;

  let box = null; // of the target, since the first finger came down

  const place = (event) => {
    const { x, y, width, height } = seen();
    return [x + ((event.clientX - box.left) / box.width) * width, y + ((event.clientY - box.top) / box.height) * height];
  };
  const spread = ([a, b]) => ({
    apart: Math.hypot(a[0] - b[0], a[1] - b[1]),
    middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
  });

  target.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && event.button > 2) return;
    target.setPointerCapture(event.pointerId);
    target.focus({ preventScroll: true });
    box = target.getBoundingClientRect();
    pointers.set(event.pointerId, place(event));
    if (pointers.size === 1) start = { at: place(event), client: [event.clientX, event.clientY], pan: event.button > 0 };
    if (pointers.size === 2) {
      if (dragging) end();
      [start, dragging] = [null, false];
      pinch = spread([...pointers.values()]);
    }
  });

  target.addEventListener('pointermove', (event) => {
    if (!pointers.has(event.pointerId)) return;
    pointers.set(event.pointerId, place(event));
    if (pinch && pointers.size === 2) return movePinch();
    if (!start) return;
    const [x, y] = start.client;
    if (!dragging && Math.hypot(event.clientX - x, event.clientY - y) < SLOP_PX) return;
    if (!dragging) begin();
    dragging = true;
    drag({ start: start.at, at: place(event), shift: event.shiftKey || start.pan });
  });

  function movePinch() {
    const now = spread([...pointers.values()]);
    nearer(pinch.apart / Math.max(now.apart, 1));
    pan([now.middle[0] - pinch.middle[0], now.middle[1] - pinch.middle[1]]);
    pinch = now;
  }

  function lift(event) {
    if (!pointers.delete(event.pointerId)) return;
    if (dragging) end();
    else if (start && event.type === 'pointerup' && !start.pan) click(place(event));
    [start, dragging] = [null, false];
    if (pointers.size < 2) pinch = null;
  }

  target.addEventListener('pointerup', lift);
  target.addEventListener('pointercancel', lift);
  target.addEventListener('lostpointercapture', lift);
  target.addEventListener('contextmenu', (event) => event.preventDefault());
  target.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    nearer(Math.exp(event.deltaY * lines * WHEEL));
  }, { passive: false });
}
