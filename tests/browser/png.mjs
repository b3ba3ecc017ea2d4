// A reader of PNGs for the tests alone. Source: PNG specification, third edition, 5, 9.2, 11.3.6.

import assert from 'node:assert/strict';
import { inflateSync } from 'node:zlib';

/** The chunks as [{ type, data }]; every length and checksum is held. */
export function chunksOf(png) {
  assert.equal(png.subarray(0, 8).toString('latin1'), '\x89PNG\r\n\x1a\n');
  const chunks = [];
  let at = 8;
  while (at < png.length) {
    const length = png.readUInt32BE(at);
    const whole = png.subarray(at + 4, at + 8 + length);
    assert.equal(whole.length, 4 + length, 'cut off');
    assert.equal(png.readUInt32BE(at + 8 + length), crc32(whole), 'checksum');
    chunks.push({ type: whole.toString('latin1', 0, 4), data: whole.subarray(4) });
    at += 12 + length;
  }
  assert.equal(chunks.at(-1).type, 'IEND');
  return chunks;
}

/** { width, height, data } with three bytes a pixel. */
export function pixelsOf(png) {
  const chunks = chunksOf(png);
  const packed = Buffer.concat(chunks.filter(({ type }) => type === 'IDAT').map(({ data }) => data));
  return pixelsIn(chunks[0], packed);
}

/** The same of an IHDR and packed pixels: 8 bits, red, green and blue, not interlaced. */
export function pixelsIn({ type, data: header }, packed) {
  assert.equal(type, 'IHDR');
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  assert.deepEqual([...header.subarray(8)], [8, 2, 0, 0, 0]);
  const raw = inflateSync(packed);
  const line = 3 * width;
  assert.equal(raw.length, height * (line + 1));
  const data = Buffer.alloc(height * line);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (line + 1)];
    for (let i = 0; i < line; ++i) {
      const a = i >= 3 ? data[y * line + i - 3] : 0;
      const b = y > 0 ? data[(y - 1) * line + i] : 0;
      const c = i >= 3 && y > 0 ? data[(y - 1) * line + i - 3] : 0;
      data[y * line + i] = raw[y * (line + 1) + 1 + i] + predicted(filter, a, b, c);
    }
  }
  return { width, height, data };
}

function predicted(filter, a, b, c) {
  switch (filter) {
    case 0: return 0;
    case 1: return a;
    case 2: return b;
    case 3: return (a + b) >> 1;
    case 4: return paeth(a, b, c);
    default: throw new Error(`no filter: ${filter}`);
  }
}

function paeth(a, b, c) {
  const [pa, pb, pc] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/** A chunk's checksum, bit by bit: annex D. */
export function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}
