// What lies over the picture: one thing at a time, whoever puts it there.

const place = document.getElementById('compare');
let owner = null;

/** Lays nodes over the picture. `leave()` hears when somebody else lays something there. */
export function cover(leave, ...nodes) {
  if (owner && owner !== leave) owner();
  owner = leave;
  place.replaceChildren(...nodes);
  place.hidden = false;
  delete place.dataset.stale;
}

/** Tells that what was laid there with the same `leave` is of a picture that has gone. */
export function stale(leave) {
  if (owner === leave) place.dataset.stale = '';
}

/** Takes away what was laid there with the same `leave`. */
export function uncover(leave) {
  if (owner !== leave) return;
  owner = null;
  place.hidden = true;
  place.replaceChildren();
}
