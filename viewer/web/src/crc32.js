// CRC-32 of gzip and zlib, four bytes at a time.

/** Table `k` advances a byte by `k` more bytes. */
const kCrcTables = [Uint32Array.from({length: 256}, (_, index) => {
  let value = index;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value >>> 0;
})];
for (let k = 1; k < 4; ++k) kCrcTables.push(kCrcTables[k - 1].map((value) => (value >>> 8) ^ kCrcTables[0][value & 0xff]));

/** @param {Uint8Array} bytes @param {number} [start] CRC of the bytes before @returns {number} */
export function crc32(bytes, start = 0) {
  const [last, third, second, first] = kCrcTables;
  const words = bytes.length - (bytes.length % 4);
  let crc = ~start;
  let i = 0;
  for (; i < words; i += 4) {
    crc ^= bytes[i] | (bytes[i + 1] << 8) | (bytes[i + 2] << 16) | (bytes[i + 3] << 24);
    crc = first[crc & 0xff] ^ second[(crc >>> 8) & 0xff] ^ third[(crc >>> 16) & 0xff] ^ last[crc >>> 24];
  }
  for (; i < bytes.length; ++i) crc = (crc >>> 8) ^ last[(crc ^ bytes[i]) & 0xff];
  return ~crc >>> 0;
}
