// A picture that clears up while it is drawn: the parts of one answer, each a whole picture with fields
// of its own (multipart/x-mixed-replace; RFC 2046, 5.1.1).

/** The parts of such an answer as they come: { headers, blob, last }; whoever leaves ends the answer. */
export async function* partsOf({ headers, body }) {
  const line = `--${/boundary=(.+)/.exec(headers.get('Content-Type'))[1]}`;
  const source = new Source(body.getReader());
  let last = false;
  try {
    for (last = await source.line() !== line; !last;) {
      const part = await source.part();
      last = await source.line() !== line;
      yield { ...part, last };
    }
  } finally {
    await source.leave(last);
  }
}

/** Source: bytes by lines or by number. Throws where they end too early. */
class Source {
  #reader;
  #chunk = new Uint8Array();

  constructor(reader) {
    this.#reader = reader;
  }

  /** Fields, a body of the length that they tell, and its end. */
  async part() {
    const headers = new Headers();
    for (let text = await this.line(); text; text = await this.line()) headers.append(...text.split(/:\s*(.*)/, 2));
    const blob = new Blob(await this.bytes(Number(headers.get('Content-Length'))), { type: headers.get('Content-Type') });
    await this.line();
    return { headers, blob };
  }

  /** Hears the end, or ends it. */
  async leave(atEnd) {
    await (atEnd ? this.#reader.read() : this.#reader.cancel()).catch(() => {});
  }

  /** That many bytes, as they came: [Uint8Array]. */
  async bytes(count) {
    const chunks = [];
    for (let left = count; left > 0; left -= chunks.at(-1).length) {
      if (!this.#chunk.length) await this.#next();
      chunks.push(this.#chunk.subarray(0, left));
      this.#chunk = this.#chunk.subarray(left);
    }
    return chunks;
  }

  /** The text before the next CRLF, which goes with it. */
  async line() {
    let text = '';
    while (!text.endsWith('\r\n')) text += String.fromCharCode((await this.bytes(1))[0][0]);
    return text.slice(0, -2);
  }

  async #next() {
    const { done, value } = await this.#reader.read();
    if (done) throw new TypeError('The stream was cut.');
    this.#chunk = value;
  }
}
