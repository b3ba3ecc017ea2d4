// The clock that plays: it wants the frame of now, and the studio draws the newest wish, so that what comes
// too late is left out.

/** Clock: `playing`, `loop`, `speed`; `told()` hears when it begins and ends. */
export class Clock {
  playing = false;
  loop = false;
  speed = 1;
  #timeline;
  #told;
  #from = null; // { frame, at }: the frame shown when the count began
  #waits = false; // for a server that is busy

  constructor(timeline, told) {
    [this.#timeline, this.#told] = [timeline, told];
  }

  play() {
    if (this.playing) return;
    const { frame, lastFrame } = this.#timeline;
    this.#from = { frame: frame >= lastFrame ? 0 : frame, at: null };
    [this.playing, this.#waits] = [true, false];
    requestAnimationFrame((now) => this.#tick(now));
    this.#told();
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.#told();
  }

  /** No picture came: the frame stands until one does. */
  wait() {
    this.#waits = this.playing;
  }

  goOn() {
    if (!this.#waits) return;
    this.#waits = false;
    this.#from = { frame: this.#timeline.frame, at: null };
  }

  #tick(now) {
    if (!this.playing) return;
    if (!this.#waits) this.#show(now);
    if (this.playing) requestAnimationFrame((next) => this.#tick(next));
  }

  #show(now) {
    const { animation: { duration, fps }, lastFrame } = this.#timeline;
    this.#from.at ??= now;
    const frame = this.#from.frame + Math.floor(((now - this.#from.at) / 1000) * fps * this.speed);
    const count = Math.ceil(duration * fps); // of a film, whose end is its beginning
    if (this.loop && frame >= count) this.#from = { frame: 0, at: now };
    const shown = this.loop ? frame % count : Math.min(frame, lastFrame);
    this.#timeline.seek(this.#timeline.timeOf(shown));
    if (!this.loop && frame >= lastFrame) this.pause();
  }
}
