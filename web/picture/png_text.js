// What a PNG says of itself. Source: PNG specification, third edition, 11.3.3.4 (iTXt).

/** What every PNG begins with. */
export const SIGNATURE = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);

/** The chunks of a PNG as [{ type, data }], `data` a view; an Error where it is none. */
export function pngChunks(bytes) {
  if (!SIGNATURE.every((byte, i) => bytes[i] === byte)) throw new Error('not a PNG');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const chunks = [];
  for (let at = 8; at + 12 <= bytes.length;) {
    const length = view.getUint32(at);
    if (at + 12 + length > bytes.length) throw new Error('cut off');
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    chunks.push({ type, data: bytes.subarray(at + 8, at + 8 + length) });
    at += 12 + length;
  }
  return chunks;
}

/** What the picture was drawn from, as POST /render takes it, and by which version; null: not told. */
export async function readRecipe(blob) {
  const chunks = pngChunks(new Uint8Array(await blob.arrayBuffer()));
  for (const { type, data } of chunks) {
    const text = type === 'iTXt' ? await readText(data, 'Tia recipe') : null;
    if (text !== null) return JSON.parse(text);
  }
  return null;
}

// Keyword, 0, whether deflated, how, language, 0, translated keyword, 0, text.
async function readText(data, wanted) {
  const end = (from) => data.indexOf(0, from);
  const keyword = end(0);
  const language = end(keyword + 3);
  const translated = end(language + 1);
  if (new TextDecoder('latin1').decode(data.subarray(0, keyword)) !== wanted) return null;
  const text = data.slice(translated + 1);
  if (data[keyword + 1] === 0) return new TextDecoder().decode(text);
  const stream = new Blob([text]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).text();
}
