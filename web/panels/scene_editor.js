// A plain textarea as an editor: over a coloured copy of its text, beside its line numbers. The
// textarea is as large as its text and a box around it scrolls both, so that they cannot drift.

import { History, difference } from '../state/scene_history.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { Highlight } from './scene_highlight.js';

const MOST_COLOURED = 60_000; // longer texts are shown plain, so that typing stays quick

/** Editor: `box` is its element, `area` its textarea. Whoever listens hears of every change. */
export class Editor {
  area = element('textarea', {
    class: 'code-text', id: 'scene-text', wrap: 'off', spellcheck: 'false',
    autocapitalize: 'off', autocomplete: 'off', autocorrect: 'off',
    'aria-label': t('scene.text'), 'aria-describedby': 'scene-state scene-faults',
  });
  history = new History();
  #highlight = new Highlight();
  #numbers = element('pre', { class: 'code-numbers' });
  #sheet = element('div', { class: 'code-sheet' }, this.#highlight.layer, this.area);
  #scroll = element('div', { class: 'code-scroll' }, this.#sheet);
  box = element('div', { class: 'code' },
    element('div', { class: 'code-gutter', 'aria-hidden': 'true' }, this.#numbers), this.#scroll);
  #faults = [];
  #changed;

  constructor(changed) {
    this.#changed = changed;
    this.area.addEventListener('input', (event) => this.#typed(event));
    this.area.addEventListener('keydown', (event) => this.#press(event));
    this.area.addEventListener('beforeinput', (event) => this.#back(event, event.inputType));
    this.#scroll.addEventListener('scroll', () =>
      (this.#numbers.style.transform = `translateY(${-this.#scroll.scrollTop}px)`));
  }

  get text() {
    return this.history.text;
  }

  /** Shows another text, as a step that can be undone; the first of all begins the history. */
  load(text) {
    if (this.text) this.replace(text, null);
    else {
      this.history.begin(oneBreak(text));
      this.area.value = this.text;
      this.#draw();
    }
  }

  /** Changes the text to `text`; changes of one `kind` that follow each other are undone together. */
  replace(text, kind) {
    const plain = oneBreak(text);
    const change = difference(this.text, plain);
    if (!change) return;
    this.history.record(plain, kind);
    this.#apply(change);
  }

  undo() {
    this.#step(this.history.undo());
  }

  redo() {
    this.#step(this.history.redo());
  }

  /** Marks faults { start, end, line } in the text and beside it. */
  mark(faults) {
    this.#faults = faults;
    this.area.setAttribute('aria-invalid', faults.length > 0);
    this.#draw();
  }

  /** Selects a range and brings it into view. */
  jump(start, end) {
    this.area.focus({ preventScroll: true });
    this.area.setSelectionRange(start, end);
    this.box.scrollIntoView({ block: 'nearest' });
    this.#reveal(start);
  }

  #typed({ inputType }) {
    const kind = /^(insertText|deleteContent)/.test(inputType ?? '') ? inputType.slice(0, 6) : null;
    this.history.record(this.area.value, kind);
    this.#faults = [];
    this.#draw();
    this.#reveal(this.area.selectionStart);
    this.#changed();
  }

  // The browser's own history knows nothing of what the page has written.
  #press(event) {
    const { key, shiftKey, altKey, isComposing } = event;
    if (event.ctrlKey || event.metaKey) {
      const letter = altKey ? '' : key.toLowerCase();
      if (letter === 'z') this.#back(event, shiftKey ? 'historyRedo' : 'historyUndo');
      if (letter === 'y') this.#back(event, 'historyRedo');
    } else if (key === 'Enter' && !shiftKey && !altKey && !isComposing) this.#breakLine(event);
  }

  #back(event, inputType) {
    if (!/^history/.test(inputType)) return;
    event.preventDefault();
    if (inputType === 'historyUndo') this.undo();
    else this.redo();
  }

  // A new line begins below the one before.
  #breakLine(event) {
    event.preventDefault();
    const { selectionStart: start, selectionEnd: end, value } = this.area;
    const line = value.slice(value.lastIndexOf('\n', start - 1) + 1, start);
    const words = `\n${/^[ \t]*/.exec(line)[0]}${/[{[]\s*$/.test(line) ? '  ' : ''}`;
    this.area.setRangeText(words, start, end, 'end');
    this.#typed({ inputType: 'insertLineBreak' });
  }

  #step(change) {
    if (!change) return;
    this.#apply(change);
    const at = change.at + change.added.length;
    this.area.setSelectionRange(at, at);
    this.#reveal(at);
    this.#changed();
  }

  #apply({ at, removed, added }) {
    this.area.setRangeText(added, at, at + removed.length, 'preserve');
    this.#faults = [];
    this.#draw();
  }

  #draw() {
    const { text } = this;
    const plain = text.length > MOST_COLOURED;
    const lines = text.split('\n');
    this.box.classList.toggle('plain', plain);
    this.#highlight.show(plain ? null : text, this.#faults);
    const longest = plain ? lines.reduce((most, line) => Math.max(most, line.length), 0) : 0;
    this.#sheet.style.minWidth = plain ? `${longest + 4}ch` : '';
    this.#sheet.style.minHeight = plain ? `calc(var(--row) * ${lines.length + 2})` : '';
    this.#number(lines.length);
  }

  #number(count) {
    const wrong = [...new Set(this.#faults.map(({ line }) => line))];
    if (this.#numbers.dataset.shown !== `${count} ${wrong}`) {
      const numbers = Array.from({ length: count }, (_, i) => i + 1).join('\n');
      this.#numbers.replaceChildren(numbers, ...wrong.map((line) =>
        element('span', { class: 'code-wrong', style: { top: `calc(var(--row) * ${line - 1})` } }, String(line))));
    }
    this.#numbers.dataset.shown = `${count} ${wrong}`;
  }

  #reveal(at) {
    const { text } = this;
    const begin = text.lastIndexOf('\n', at - 1) + 1;
    const row = parseFloat(getComputedStyle(this.area).lineHeight);
    const [y, x] = [countLines(text, begin) * row, (at - begin) * row * 0.4]; // a letter is 0.6 em wide
    const { scrollTop, scrollLeft, clientHeight, clientWidth } = this.#scroll;
    if (y < scrollTop) this.#scroll.scrollTop = y - row;
    if (y + 3 * row > scrollTop + clientHeight) this.#scroll.scrollTop = y + 3 * row - clientHeight;
    if (x < scrollLeft || x > scrollLeft + clientWidth - 2 * row)
      this.#scroll.scrollLeft = Math.max(0, x - clientWidth / 2);
  }
}

// Lines end as a textarea has them, whatever system the text comes from.
function oneBreak(text) {
  return text.replace(/\r\n?/g, '\n');
}

function countLines(text, end) {
  let count = 0;
  for (let at = text.indexOf('\n'); at >= 0 && at < end; at = text.indexOf('\n', at + 1)) count += 1;
  return count;
}
