// Varints: seven bits a byte, low bits first; signed values in zigzag order.

/** Reads numbers from bytes, front to back. Throws a RangeError where the bytes end too early. */
export class ByteReader {
  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  get atEnd() {
    return this.at >= this.bytes.length;
  }

  /** @returns {number} 0 to 255 */
  byte() {
    if (this.at >= this.bytes.length) throw new RangeError('the data ends too early');
    return this.bytes[this.at++];
  }

  /** @returns {number} 0 to 2^53 - 1 */
  varint() {
    const bytes = this.bytes;
    let value = 0;
    let scale = 1;
    for (let count = 0; count < 8; ++count) {
      if (this.at >= bytes.length) throw new RangeError('the data ends too early');
      const byte = bytes[this.at++];
      value += (byte & 0x7f) * scale;
      if (byte < 0x80) return value;
      scale *= 128;
    }
    throw new RangeError('a number has too many bytes');
  }

  /** @returns {number} a signed number */
  zigzag() {
    const value = this.varint();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  /** Reads `count` signed numbers into `to`, most of which have one or two bytes. @param {Int32Array} to @param {number} count */
  zigzags(to, count) {
    const bytes = this.bytes;
    const safe = bytes.length - 1;
    let at = this.at;
    for (let i = 0; i < count; ++i) {
      let value = at < safe ? bytes[at] : 0x80;
      if (value < 0x80) {
        at += 1;
      } else if (at < safe && bytes[at + 1] < 0x80) {
        value += (bytes[at + 1] << 7) - 0x80;
        at += 2;
      } else {
        this.at = at;
        to[i] = this.zigzag();
        at = this.at;
        continue;
      }
      to[i] = (value >>> 1) ^ -(value & 1);
    }
    this.at = at;
  }

  /** Passes over varints. @param {number} count */
  skip(count) {
    const {bytes} = this;
    let at = this.at;
    for (let left = count; left > 0; ++at) {
      if (at >= bytes.length) throw new RangeError('the data ends too early');
      if (bytes[at] < 0x80) --left;
    }
    this.at = at;
  }

  /** @param {number} count @returns {Uint8Array} a view of the next bytes */
  take(count) {
    if (count > this.bytes.length - this.at) throw new RangeError('the data ends too early');
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }
}
