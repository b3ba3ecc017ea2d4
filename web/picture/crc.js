// CRC-32 of PNG chunks. Source: PNG specification, third edition, annex D.

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
