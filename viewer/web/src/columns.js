// Columns of frames: the codings of docs/formats/view.md, and the arrays that they fill.
import {kSlots} from './sides.js';
import {ByteReader} from './varint.js';

/**
 * @typedef {{name: string, coding: string, series: number, scale?: number, none?: number, of?: string}} ColumnRow
 * A row of the header's table of columns.
 */

/** One property of the match: an array per series (1 for the match, 22 for player slots), by frame. */
export class Column {
  /** @param {ColumnRow} row */
  constructor(row) {
    if (row.series !== 1 && row.series !== kSlots) throw new Error(`column ${row.name}: ${row.series} series`);
    this.row = row;
    this.real = row.scale !== undefined;
    this.capacity = 0;
    /** @type {(Float32Array | Int32Array)[]} */
    this.series = this.#allocate(0);
    /** Integers of the frames that were decoded last, series after series. */
    this.integers = new Int32Array(0);
    /** The state of the coding: previous integer and difference of each series. */
    this.previous = new Float64Array(row.series);
    this.difference = new Float64Array(row.series);
    this.before = new Float64Array(row.series);
    /** Decodes what is not decoded yet; null: nothing. @type {(() => void) | null} */
    this.pending = null;
  }

  /** Decodes what is not decoded yet. */
  complete() {
    const {pending} = this;
    this.pending = null;
    pending?.();
  }

  /** Parts of one array. */
  #allocate(capacity) {
    const {series} = this.row;
    const values = this.real ? new Float32Array(series * capacity) : new Int32Array(series * capacity);
    return Array.from({length: series}, (_, s) => values.subarray(s * capacity, (s + 1) * capacity));
  }

  /** Grows all series to `length` frames; `exact` reserves no more than that. */
  reserve(length, exact) {
    if (this.capacity >= length) return;
    this.capacity = exact ? length : Math.max(length, 2 * this.capacity);
    const before = this.series;
    this.series = this.#allocate(this.capacity);
    before.forEach((values, s) => this.series[s].set(values));
  }
}

/** What `dv` predicts for the entries of a series: displacement of the position column times decay. */
class VelocityPrediction {
  /** @param {Map<string, Column>} columns @param {Column} column @param {number} first @param {{ball: number, types: number[]}} decays */
  constructor(columns, column, first, decays) {
    const position = columns.get(column.row.of);
    if (!position) throw new Error(`column ${column.row.name}: no column '${column.row.of}'`);
    this.position = position;
    this.types = column.row.series === 1 ? undefined : columns.get('type');
    this.first = first;
    this.decays = decays;
  }

  /** Adds the predictions of series `s` to the numbers that were stored. @param {Int32Array} values */
  addTo(values, s) {
    const {decays, first} = this;
    const count = values.length;
    const places = this.position.integers.subarray(s * count, (s + 1) * count);
    const types = this.types?.series[s];
    let before = this.position.before[s];
    for (let i = 0; i < count; ++i) {
      const decay = types ? (decays.types[types[first + i]] ?? 4000) : decays.ball;
      values[i] += Math.floor((decay * (places[i] - before) + 5000) / 10000);
      before = places[i];
    }
  }
}

/** Sums of the stored differences: coding d1. @param {Int32Array} values @returns {number} the last one */
function sum(values, start) {
  let p = start;
  for (let i = 0; i < values.length; ++i) values[i] = p = (p + values[i]) | 0;
  return p;
}

/** Angles: sums that stay within half a turn. */
function sumAngles(values, start, half) {
  let p = start;
  for (let i = 0; i < values.length; ++i) {
    p += values[i];
    if (p > half) p -= 2 * half;
    else if (p <= -half) p += 2 * half;
    values[i] = p;
  }
  return p;
}

/** Integers of one series from its coding, all but change lists.
 * @param {Column} column @param {number} s @param {Int32Array} values as stored; become the integers
 * @param {VelocityPrediction | null} prediction of `dv` */
function decodeSeries(column, s, values, prediction) {
  const {coding, scale} = column.row;
  switch (coding) {
    case 'd1': column.previous[s] = sum(values, column.previous[s]); break;
    case 'd2':
      column.difference[s] = sum(values, column.difference[s]);
      column.previous[s] = sum(values, column.previous[s]);
      break;
    case 'da': column.previous[s] = sumAngles(values, column.previous[s], 180 * (scale ?? 1)); break;
    case 'dv':
      prediction?.addTo(values, s);
      column.previous[s] = values[values.length - 1] ?? column.previous[s];
      break;
    default: throw new Error(`column ${column.row.name}: unknown coding '${coding}'; the page needs a newer viewer`);
  }
}

/** The value of an integer. @param {ColumnRow} row */
function valueOf(row, integer) {
  if (row.scale === undefined) return integer;
  return integer === row.none ? NaN : integer / row.scale;
}

/** Values of one series. @param {Column} column @param {Int32Array} values integers @param {number} s @param {number} first */
function storeSeries(column, values, s, first) {
  const out = column.series[s];
  const {scale} = column.row;
  if (scale === undefined) return out.set(values, first);
  for (let i = 0; i < values.length; ++i) out[first + i] = values[i] / scale;
}

/** Runs of at least this length are filled at once. */
const kLongRun = 24;

function fillRun(out, from, to, value) {
  if (to - from >= kLongRun) out.fill(value, from, to);
  else for (let i = from; i < to; ++i) out[i] = value;
}

/** A change list: each value holds until the next change. Gaps count across series.
 * @param {import('./varint.js').ByteReader} reader @param {Column} column @param {number} first @param {number} count */
function decodeChanges(reader, column, first, count) {
  const {row, previous} = column;
  let left = reader.varint();
  let gap = left > 0 ? reader.varint() : Infinity;
  for (let s = 0; s < row.series; ++s) {
    const out = column.series[s];
    const end = first + count;
    let value = valueOf(row, previous[s]);
    let at = first;
    for (; at + gap < end; ++at) {
      fillRun(out, at, at + gap, value);
      at += gap;
      previous[s] += reader.zigzag();
      value = valueOf(row, previous[s]);
      out[at] = value;
      gap = --left > 0 ? reader.varint() : Infinity;
    }
    fillRun(out, at, end, value);
    gap -= end - at;
  }
  if (left > 0) throw new RangeError('a change is beyond the last frame');
}

/** Exceptions: values with more digits than the scale. */
function readExceptions(reader, column, first, count) {
  const exceptions = reader.varint();
  let entry = -1;
  for (let i = 0; i < exceptions; ++i) {
    entry += reader.varint() + 1;
    const bytes = reader.take(4);
    if (entry >= count * column.series.length) throw new RangeError('an exception is beyond the last frame');
    const value = new DataView(bytes.buffer, bytes.byteOffset, 4).getFloat32(0, true);
    column.series[Math.floor(entry / count)][first + (entry % count)] = value;
  }
}

/** Decodes one column into entries from `first` on. Yields between series, so that the caller can give the browser time.
 * @param {import('./varint.js').ByteReader} reader @param {Column} column @param {number} first @param {number} count
 * @param {VelocityPrediction | null} prediction @param {Int32Array} integers of all series; filled unless the coding is `c` */
function* decodeValues(reader, column, first, count, prediction, integers) {
  const {row} = column;
  if (row.coding === 'c') return decodeChanges(reader, column, first, count);
  for (let s = 0; s < row.series; ++s) {
    const values = integers.subarray(s * count, (s + 1) * count);
    reader.zigzags(values, count);
    decodeSeries(column, s, values, prediction);
    storeSeries(column, values, s, first);
    yield;
  }
}

/** Decodes a column whose integers depend on no other column, without exceptions.
 * @param {import('./varint.js').ByteReader} reader @param {Column} column @param {number} first @param {number} count */
export function decodePlainColumn(reader, column, first, count) {
  for (const _ of decodeValues(reader, column, first, count, null, new Int32Array(count * column.row.series)));
}

/** Passes over a column of an `F` chunk; decodes it when it is asked for. The column of positions of `dv` keeps its integers until then.
 * @param {import('./varint.js').ByteReader} reader @param {Map<string, Column>} columns @param {Column} column
 * @param {number} first @param {number} count @param {{ball: number, types: number[]}} decays in 1/10000 */
export function deferColumn(reader, columns, column, first, count, decays) {
  const {row, real} = column;
  const start = reader.at;
  reader.skip(row.coding === 'c' ? 2 * reader.varint() : count * row.series);
  for (let exceptions = real ? reader.varint() : 0; exceptions > 0; --exceptions) {
    reader.varint();
    reader.take(4);
  }
  const own = new ByteReader(reader.bytes.subarray(start, reader.at));
  column.pending = () => {
    for (const _ of decodeColumn(own, columns, column, first, count, decays));
    column.integers = new Int32Array(0);
  };
}

/** Decodes one column of an `F` chunk. Yields between series.
 * @param {import('./varint.js').ByteReader} reader
 * @param {Map<string, Column>} columns @param {Column} column @param {number} first @param {number} count
 * @param {{ball: number, types: number[]}} decays in 1/10000 */
export function* decodeColumn(reader, columns, column, first, count, decays) {
  const {row} = column;
  column.before.set(column.previous);
  column.integers = new Int32Array(row.coding === 'c' ? 0 : count * row.series);
  const prediction = row.coding === 'dv' ? new VelocityPrediction(columns, column, first, decays) : null;
  yield* decodeValues(reader, column, first, count, prediction, column.integers);
  if (column.real) readExceptions(reader, column, first, count);
}
