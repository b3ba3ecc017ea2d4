// An animated PNG of still ones: their packed pixels go over as they are, nothing is packed anew. Loaded
// when one is saved.
// Source: PNG specification, third edition, 11.3.6 (acTL, fcTL, fdAT) and 5.3 (chunk layout).

import { pngChunks, SIGNATURE } from './png_text.js';

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

/** The CRC-32 of all bytes of some arrays, one after the other. */
export function crc32(...arrays) {
  let crc = 0xffffffff;
  for (const bytes of arrays)
    for (let i = 0; i < bytes.length; ++i) crc = TABLE[(crc ^ bytes[i]) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

const THOUSAND = 1000; // delays are in ms

/**
 * The animation as a Blob: `pngs`, the bytes of each still, all of one header; `ms`, how long each
 * is shown; it plays for ever. The first still's texts stay: who knows no animation sees it alone.
 */
export function apngOf(pngs, ms) {
  const stills = pngs.map(pngChunks);
  const [first] = stills;
  const header = headerOf(first);
  if (stills.some((still) => !equal(headerOf(still), header))) throw new Error('stills of different kinds');

  const begin = first.findIndex(isData);
  const end = first.findLastIndex(isData) + 1;
  let sequence = 0;
  const parts = [SIGNATURE, ...chunk('IHDR', header), ...chunk('acTL', integers(stills.length, 0))];
  for (const { type, data } of first.slice(1, begin)) parts.push(...chunk(type, data));
  for (const [i, still] of stills.entries()) {
    parts.push(...chunk('fcTL', frameControl(sequence++, header, ms)));
    for (const { data } of still.filter(isData))
      parts.push(...(i === 0 ? chunk('IDAT', data) : chunk('fdAT', integers(sequence++), data)));
  }
  for (const { type, data } of first.slice(end)) parts.push(...chunk(type, data));
  return new Blob(parts, { type: 'image/png' });
}

const isData = ({ type }) => type === 'IDAT';
const headerOf = (chunks) => chunks.find(({ type }) => type === 'IHDR').data;
const equal = (a, b) => a.length === b.length && a.every((byte, i) => byte === b[i]);

// Sequence number, width, height, x and y 0, delay as a fraction, dispose and blend 0: the whole
// picture takes the place of the one before.
function frameControl(sequence, header, ms) {
  const data = new Uint8Array(26);
  const view = new DataView(data.buffer);
  view.setUint32(0, sequence);
  data.set(header.subarray(0, 8), 4);
  view.setUint16(20, Math.round(ms));
  view.setUint16(22, THOUSAND);
  return data;
}

function integers(...values) {
  const view = new DataView(new ArrayBuffer(4 * values.length));
  values.forEach((value, i) => view.setUint32(4 * i, value));
  return new Uint8Array(view.buffer);
}

// Length, type, data, checksum of type and data.
function chunk(type, ...data) {
  const name = new TextEncoder().encode(type);
  const length = data.reduce((sum, bytes) => sum + bytes.length, 0);
  return [integers(length), name, ...data, integers(crc32(name, ...data))];
}
