// Latest wins: one task at a time; of those asked for meanwhile only the newest follows.

/** Wraps the async `task` so that it runs for the newest input only. */
export function latest(task) {
  let running = false;
  let waiting = null;

  return async function ask(input) {
    waiting = { input };
    if (running) return;
    running = true;
    try {
      while (waiting) {
        const next = waiting.input;
        waiting = null;
        await task(next);
      }
    } finally {
      running = false;
    }
  };
}
