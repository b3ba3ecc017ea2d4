// Undo and redo for a text that people and the page change alike: a browser's own history loses
// its way where the page writes. Keeps what was replaced, not whole texts.

const TOGETHER_MS = 1000; // changes of one kind that follow each other so closely are one step

/** What turns `old` into `text`, as small as can be: { at, removed, added }; null where nothing. */
export function difference(old, text) {
  if (old === text) return null;
  const most = Math.min(old.length, text.length);
  let at = 0;
  while (at < most && old.charCodeAt(at) === text.charCodeAt(at)) at += 1;
  let tail = 0;
  const same = () => old.charCodeAt(old.length - 1 - tail) === text.charCodeAt(text.length - 1 - tail);
  while (tail < most - at && same()) tail += 1;
  return { at, removed: old.slice(at, old.length - tail), added: text.slice(at, text.length - tail) };
}

/** History: of `text`. A step holds texts before and after by what differs between them. */
export class History {
  text = '';
  #done = [];
  #undone = [];
  #kind = null;
  #when = -Infinity;

  /** Begins anew with a text. */
  begin(text) {
    Object.assign(this, { text });
    [this.#done, this.#undone, this.#kind] = [[], [], null];
  }

  /** Takes a change down; one of the same `kind` that follows at once joins it, null never does. */
  record(text, kind, now = performance.now()) {
    const joins = kind !== null && kind === this.#kind && now - this.#when < TOGETHER_MS;
    const before = joins ? this.#replayed(this.#done.pop()) : this.text;
    const step = difference(before, text);
    if (step) this.#done.push(step);
    [this.text, this.#undone, this.#kind, this.#when] = [text, [], step && kind, now];
  }

  get canUndo() {
    return this.#done.length > 0;
  }

  get canRedo() {
    return this.#undone.length > 0;
  }

  /** The step back, as the change of the text that it is: { at, removed, added }, or null. */
  undo() {
    const step = this.#done.pop();
    if (!step) return null;
    this.#undone.push(step);
    return this.#go({ at: step.at, removed: step.added, added: step.removed });
  }

  redo() {
    const step = this.#undone.pop();
    if (!step) return null;
    this.#done.push(step);
    return this.#go(step);
  }

  #go(change) {
    this.#kind = null;
    this.text = applied(this.text, change);
    return change;
  }

  // The text before a step that was the last.
  #replayed({ at, removed, added }) {
    return applied(this.text, { at, removed: added, added: removed });
  }
}

function applied(text, { at, removed, added }) {
  return text.slice(0, at) + added + text.slice(at + removed.length);
}
