// A match that is played now: its stream over HTTP, decoded as it comes.
import {StreamDecoder} from './stream.js';

const kRetryMs = [500, 1000, 2000, 5000];

/** Retrying does not help. */
class StreamError extends Error {}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function decode(decoder, bytes) {
  try {
    for (const _ of decoder.push(bytes));
  } catch (error) {
    throw new StreamError(error instanceof Error ? error.message : String(error));
  }
  if (decoder.corrupt) throw new StreamError('the match arrived corrupt: its checksum differs');
}

/** Reads until the stream ends or the connection breaks. @returns {Promise<number>} bytes in all */
async function readOnce(path, received, decoder, listener) {
  const response = await fetch(`${path}?from=${received}`, {cache: 'no-store'});
  if (!response.ok || !response.body) throw new Error(`status ${response.status}`);
  listener.onConnection(true);
  const reader = response.body.getReader();
  for (;;) {
    const {done, value} = await reader.read().catch(() => ({done: true, value: undefined}));
    if (done) return received;
    received += value.length;
    decode(decoder, value);
    if (decoder.record) listener.onRecord(decoder.record);
  }
}

/** Reads a live match to its end. When the connection breaks, it connects again and continues where it was.
 * @param {string} path of the stream
 * @param {{onConnection: (connected: boolean) => void, onRecord: (record: import('./record.js').MatchRecord) => void}} listener
 * @returns {Promise<void>} rejects with one sentence if the stream cannot be decoded */
export async function readLive(path, listener) {
  const decoder = new StreamDecoder();
  let received = 0;
  for (let failures = 0; ; ++failures) {
    try {
      const before = received;
      received = await readOnce(path, received, decoder, listener);
      if (received > before) failures = 0;
    } catch (error) {
      if (error instanceof StreamError) throw error;
    }
    if (decoder.record?.end) return;
    listener.onConnection(false);
    await pause(kRetryMs[Math.min(failures, kRetryMs.length - 1)]);
  }
}
