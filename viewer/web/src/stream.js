// A stream of chunks becomes a match (docs/formats/view.md). File and live match have the same grammar.
import {ByteReader} from './varint.js';
import {crc32} from './crc32.js';
import {decodeColumn, deferColumn} from './columns.js';
import {readNotes} from './notes.js';
import {MatchRecord, headerProblem} from './record.js';

const kUtf8Text = new TextDecoder();

/** Columns of the first picture. */
const kFirstColumns = new Set(['time', 'stopped', 'mode', 'teams', 'ball_x', 'ball_y', 'ball_z', 'state', 'type', 'x', 'y', 'body', 'neck']);

/** Collects bytes and decodes complete chunks. */
export class StreamDecoder {
  /** @param {boolean} [deferring] leaves columns that the first picture does not need for later */
  constructor(deferring = false) {
    this.deferring = deferring;
    /** @type {MatchRecord | null} */
    this.record = null;
    this.rest = new Uint8Array(0);
    this.crc = 0;
    /** Set when the checksum of chunk E differs. */
    this.corrupt = false;
  }

  /** Decodes what is complete of `bytes` and the rest before it. Yields the fraction of this call that is done.
   * @param {Uint8Array} bytes */
  *push(bytes) {
    const data = this.rest.length === 0 ? bytes : joined(this.rest, bytes);
    let done = 0;
    for (;;) {
      const chunk = chunkAt(data, done);
      if (!chunk) break;
      for (const fraction of this.#chunk(chunk.kind, chunk.contents)) {
        yield (done + (chunk.end - done) * fraction) / data.length;
      }
      if (chunk.kind !== 'E') this.crc = crc32(data.subarray(done, chunk.end), this.crc);
      done = chunk.end;
      yield done / data.length;
    }
    this.rest = data.slice(done);
  }

  *#chunk(kind, contents) {
    if (kind === 'H') return this.#header(JSON.parse(kUtf8Text.decode(contents)));
    if (!this.record) throw new Error('the data starts without a header');
    if (kind === 'N') this.record.addNotes(readNotes(new ByteReader(contents)));
    if (kind === 'F') yield* this.#frames(new ByteReader(contents));
    if (kind === 'S') this.record.setStatistics(JSON.parse(kUtf8Text.decode(contents)));
    if (kind === 'E') {
      this.record.end = JSON.parse(kUtf8Text.decode(contents));
      this.corrupt = parseInt(this.record.end.crc32, 16) !== this.crc;
    }
  }

  #header(header) {
    const problem = headerProblem(header);
    if (problem) throw new Error(problem);
    if (this.record) this.record.setHeader(header);
    else this.record = new MatchRecord(header);
  }

  *#frames(reader) {
    const {record} = this;
    const count = reader.varint();
    const {header} = record;
    const decays = {ball: header.ball_decay ?? 0, types: header.type_decay ?? []};
    record.complete();
    const defers = this.deferring && record.frames === 0;
    let column = 0;
    for (const row of header.columns) {
      const target = record.columns.get(row.name);
      target.reserve(record.frames + count, !header.live);
      if (defers && !kFirstColumns.has(row.name) && !header.columns.some(({of}) => of === row.name)) {
        deferColumn(reader, record.columns, target, record.frames, count, decays);
      } else {
        for (const _ of decodeColumn(reader, record.columns, target, record.frames, count, decays)) {
          yield column / header.columns.length;
        }
      }
      ++column;
    }
    if (!defers) record.forgetIntegers();
    record.frames += count;
  }
}

function joined(first, second) {
  const all = new Uint8Array(first.length + second.length);
  all.set(first);
  all.set(second, first.length);
  return all;
}

/** The chunk at `start`, or null if it is not complete. */
export function chunkAt(data, start) {
  if (start >= data.length) return null;
  const reader = new ByteReader(data);
  reader.at = start + 1;
  let length = 0;
  try {
    length = reader.varint();
  } catch {
    return null;
  }
  if (reader.at + length > data.length) return null;
  const end = reader.at + length;
  return {kind: String.fromCharCode(data[start]), contents: data.subarray(reader.at, end), end};
}
