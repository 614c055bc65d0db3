// Columns of frames: the codings of docs/formats/view.md, and the arrays that they fill.
import {kSlots} from './sides.js';

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
    /** @type {(Float32Array | Int32Array)[]} */
    this.series = Array.from({length: row.series}, () => this.#array(0));
    /** Integers of the frames that were decoded last, series after series. */
    this.integers = new Int32Array(0);
    /** The state of the coding: previous integer and difference of each series. */
    this.previous = new Float64Array(row.series);
    this.difference = new Float64Array(row.series);
    this.before = new Float64Array(row.series);
  }

  #array(length) {
    return this.real ? new Float32Array(length) : new Int32Array(length);
  }

  /** Grows all series to `length` frames; `exact` reserves no more than that. */
  reserve(length, exact) {
    if (this.series[0].length >= length) return;
    const capacity = exact ? length : Math.max(length, 2 * this.series[0].length);
    for (let s = 0; s < this.series.length; ++s) {
      const grown = this.#array(capacity);
      grown.set(this.series[s]);
      this.series[s] = grown;
    }
  }
}

/** Adds the changes of a change list to `deltas`, zero elsewhere. */
function readChanges(reader, entries) {
  const deltas = new Float64Array(entries);
  const count = reader.varint();
  let entry = -1;
  for (let i = 0; i < count; ++i) {
    entry += reader.varint() + 1;
    if (entry >= entries) throw new RangeError('a change is beyond the last frame');
    deltas[entry] = reader.zigzag();
  }
  return deltas;
}

/** Integers of one series from its coding. `predicted(i)` is what `dv` adds to the stored number. */
function decodeSeries(reader, column, s, count, changes, predicted) {
  const {coding, scale} = column.row;
  const out = column.integers;
  const turn = 360 * (scale ?? 1);
  let p = column.previous[s];
  let d = column.difference[s];
  for (let i = 0, at = s * count; i < count; ++i, ++at) {
    switch (coding) {
      case 'd1': p += reader.zigzag(); break;
      case 'd2': d += reader.zigzag(); p += d; break;
      case 'da':
        p += reader.zigzag();
        if (p > turn / 2) p -= turn;
        else if (p <= -turn / 2) p += turn;
        break;
      case 'dv': p = reader.zigzag() + predicted(i); break;
      case 'c': p += changes[at]; break;
      default: throw new Error(`column ${column.row.name}: unknown coding '${coding}'; the page needs a newer viewer`);
    }
    out[at] = p;
  }
  column.previous[s] = p;
  column.difference[s] = d;
}

/** What `dv` predicts: displacement of the position column times decay. */
function velocityPrediction(columns, column, s, count, decays) {
  const position = columns.get(column.row.of);
  if (!position) throw new Error(`column ${column.row.name}: no column '${column.row.of}'`);
  const types = column.row.series === 1 ? null : columns.get('type')?.integers;
  const q = position.integers;
  const base = s * count;
  return (i) => {
    const before = i === 0 ? position.before[s] : q[base + i - 1];
    const decay = types ? (decays.types[types[base + i]] ?? 4000) : decays.ball;
    return Math.floor((decay * (q[base + i] - before) + 5000) / 10000);
  };
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

/** Decodes a column whose integers depend on no other column, without exceptions, into entries from `first` on.
 * @param {import('./varint.js').ByteReader} reader @param {Column} column @param {number} first @param {number} count */
export function decodePlainColumn(reader, column, first, count) {
  const {row} = column;
  column.integers = new Int32Array(count * row.series);
  const changes = row.coding === 'c' ? readChanges(reader, count * row.series) : null;
  for (let s = 0; s < row.series; ++s) {
    decodeSeries(reader, column, s, count, changes, null);
    for (let i = 0; i < count; ++i) column.series[s][first + i] = column.integers[s * count + i] / (row.scale ?? 1);
  }
  column.integers = new Int32Array(0);
}

/** Decodes one column of an `F` chunk into frames from `first` on. Yields between series, so that the caller can
 * give the browser time.
 * @param {import('./varint.js').ByteReader} reader
 * @param {Map<string, Column>} columns @param {Column} column @param {number} first @param {number} count
 * @param {{ball: number, types: number[]}} decays in 1/10000 */
export function* decodeColumn(reader, columns, column, first, count, decays) {
  const {row} = column;
  column.before.set(column.previous);
  column.integers = new Int32Array(count * row.series);
  const changes = row.coding === 'c' ? readChanges(reader, count * row.series) : null;
  for (let s = 0; s < row.series; ++s) {
    const predicted = row.coding === 'dv' ? velocityPrediction(columns, column, s, count, decays) : null;
    decodeSeries(reader, column, s, count, changes, predicted);
    const out = column.series[s];
    for (let i = 0, at = s * count; i < count; ++i, ++at) {
      const integer = column.integers[at];
      if (!column.real) out[first + i] = integer;
      else out[first + i] = integer === row.none ? NaN : integer / row.scale;
    }
    yield;
  }
  if (column.real) readExceptions(reader, column, first, count);
}
