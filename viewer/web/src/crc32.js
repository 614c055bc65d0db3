// CRC-32 of gzip and zlib.

const kCrcTable = Uint32Array.from({length: 256}, (_, index) => {
  let value = index;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value >>> 0;
});

/** @param {Uint8Array} bytes @param {number} [start] CRC of the bytes before @returns {number} */
export function crc32(bytes, start = 0) {
  let crc = ~start;
  for (let i = 0; i < bytes.length; ++i) crc = (crc >>> 8) ^ kCrcTable[(crc ^ bytes[i]) & 0xff];
  return ~crc >>> 0;
}
