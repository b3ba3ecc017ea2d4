// One piece of work at a time, of which only the newest wish counts.

/** Latest: `ask(wish)` begins `work(wish, signal)` once the one under way has ended. */
export class Latest {
  #work;
  #failed;
  #next;
  #going = null;

  constructor(work, failed) {
    [this.#work, this.#failed] = [work, failed];
  }

  ask(wish) {
    this.#next = { wish };
    if (!this.#going) this.#run();
  }

  /** Leaves what is under way, and what was wished. */
  leave() {
    this.#next = null;
    this.#going?.abort();
  }

  async #run() {
    while (this.#next) {
      const { wish } = this.#next;
      this.#next = null;
      this.#going = new AbortController();
      const { signal } = this.#going;
      await this.#work(wish, signal).catch((problem) => signal.aborted || this.#failed(problem));
    }
    this.#going = null;
  }
}
