// The match in the page: base64 of gzip of a stream of chunks, decoded in slices.
import {bytesOfBase64} from './base64.js';
import {StreamDecoder} from './stream.js';

const kSliceMs = 40;

/** Lets the browser draw and handle input. */
function nextTask() {
  return new Promise((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => {
      channel.port1.close();
      resolve(undefined);
    };
    channel.port2.postMessage(0);
  });
}

/** What of `text` is there: 1 if all.
 * @param {string} text base64 @param {number} length how many characters there should be */
export function completeness(text, length) {
  return length > 0 ? Math.min(1, text.length / length) : 1;
}

/** Inflates gzip. `onBytes` receives the bytes in pieces. */
async function inflateGzip(bytes, onBytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return;
    await onBytes(value);
  }
}

function joinedPieces(pieces) {
  const all = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

/** Bytes of base64 of gzip. @param {string} text @returns {Promise<Uint8Array>} rejects with one sentence */
export async function inflatedBytes(text) {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('this browser cannot inflate the match; one from May 2023 or later can');
  }
  const packed = Uint8Array.fromBase64 ? Uint8Array.fromBase64(text.trim()) : bytesOfBase64(text);
  const pieces = [];
  try {
    await inflateGzip(packed, (piece) => pieces.push(piece));
  } catch {
    throw new Error('the data in this page is corrupt: it does not inflate');
  }
  return joinedPieces(pieces);
}

/** Decodes what readEmbedded() left for later, a column at a time. @param {import('./record.js').MatchRecord} record */
export async function completeRecord(record) {
  do await nextTask(); while (record.completeOne());
}

/** Decodes the text of the data element. What the first picture does not need is left to completeRecord(), or decoded when it is read.
 * @param {string} text @param {(fraction: number) => void} onProgress
 * @returns {Promise<import('./record.js').MatchRecord>} rejects with one sentence */
export async function readEmbedded(text, onProgress) {
  const bytes = await inflatedBytes(text);
  onProgress(0.3);
  const decoder = new StreamDecoder(true);
  let sliceStart = performance.now();
  for (const fraction of decoder.push(bytes)) {
    if (performance.now() - sliceStart < kSliceMs) continue;
    onProgress(0.3 + 0.7 * fraction);
    await nextTask();
    sliceStart = performance.now();
  }
  if (!decoder.record) throw new Error('the page holds no match');
  if (decoder.corrupt) throw new Error('the match in this page is corrupt: its checksum differs');
  if (decoder.record.frames === 0) throw new Error('the log of this match has no frames');
  return decoder.record;
}

/** The text of a data element in the page, which it removes. Throws an error of one sentence.
 * @param {string} id @param {string} what "the match" @returns {string} */
export function takeData(id, what) {
  const data = document.getElementById(id);
  if (!data) throw new Error(`the page was truncated before ${what}; get the file again`);
  const text = data.textContent ?? '';
  const share = completeness(text, Number(data.getAttribute('data-length')));
  if (share < 1) throw new Error(`the page was truncated at ${Math.floor(100 * share)} % of ${what}; get the file again`);
  data.remove();
  return text;
}

/** The match of a data element in the page, which it removes.
 * @param {string} id @param {(fraction: number) => void} onProgress
 * @returns {Promise<import('./record.js').MatchRecord>} rejects with one sentence */
export async function readData(id, onProgress) {
  return readEmbedded(takeData(id, 'the match'), onProgress);
}
