// Base64 to bytes.

const kBase64Codes = new Uint8Array(128).fill(255);
for (const [value, letter] of [...'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/'].entries()) {
  kBase64Codes[letter.charCodeAt(0)] = value;
}

/** Ignores whitespace and padding; an incomplete last group gives the bytes that it still holds.
 * @param {string} text @returns {Uint8Array} */
export function bytesOfBase64(text) {
  const bytes = new Uint8Array(Math.ceil((text.length * 3) / 4));
  let length = 0;
  let bits = 0;
  let count = 0;
  for (let i = 0; i < text.length; ++i) {
    const code = text.charCodeAt(i);
    const value = code < 128 ? kBase64Codes[code] : 255;
    if (value === 255) continue;
    bits = (bits << 6) | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes[length++] = (bits >>> count) & 0xff;
    }
  }
  return bytes.subarray(0, length);
}
