// Writes streams of docs/formats/view.md, for tests of the page's decoder. Independent of viewer/stream (C++).
import {crc32} from '../../../viewer/web/src/crc32.js';

const kUtf8 = new TextEncoder();

/** The columns of a full page, as `cls watch` writes them. */
export const kColumns = [
  {name: 'time', coding: 'd2', series: 1},
  {name: 'stopped', coding: 'd2', series: 1},
  {name: 'mode', coding: 'c', series: 1},
  {name: 'teams', coding: 'c', series: 1},
  {name: 'ball_x', coding: 'd2', series: 1, scale: 10000},
  {name: 'ball_y', coding: 'd2', series: 1, scale: 10000},
  {name: 'ball_vx', coding: 'dv', series: 1, scale: 10000, of: 'ball_x'},
  {name: 'ball_vy', coding: 'dv', series: 1, scale: 10000, of: 'ball_y'},
  {name: 'state', coding: 'c', series: 22},
  {name: 'type', coding: 'c', series: 22},
  {name: 'x', coding: 'd2', series: 22, scale: 10000},
  {name: 'y', coding: 'd2', series: 22, scale: 10000},
  {name: 'vx', coding: 'dv', series: 22, scale: 10000, of: 'x'},
  {name: 'vy', coding: 'dv', series: 22, scale: 10000, of: 'y'},
  {name: 'body', coding: 'da', series: 22, scale: 1000},
  {name: 'neck', coding: 'da', series: 22, scale: 1000},
  {name: 'point_x', coding: 'c', series: 22, scale: 10000, none: -10000000},
  {name: 'point_y', coding: 'c', series: 22, scale: 10000, none: -10000000},
  {name: 'view_width', coding: 'c', series: 22, scale: 1000},
  {name: 'focus_distance', coding: 'c', series: 22, scale: 10000},
  {name: 'focus_direction', coding: 'c', series: 22, scale: 10000},
  {name: 'stamina', coding: 'd1', series: 22, scale: 100},
  {name: 'effort', coding: 'c', series: 22, scale: 1000000},
  {name: 'recovery', coding: 'c', series: 22, scale: 1000000},
  {name: 'capacity', coding: 'd1', series: 22, scale: 100},
  {name: 'attention', coding: 'c', series: 22},
  ...['kick', 'dash', 'turn', 'catch', 'move', 'turn_neck', 'change_view', 'say', 'tackle', 'pointto', 'attentionto', 'change_focus']
    .map((name) => ({name: `count_${name}`, coding: 'c', series: 22})),
];

export class ByteWriter {
  constructor() {
    this.bytes = [];
  }

  varint(value) {
    while (value >= 128) {
      this.bytes.push((value % 128) + 128);
      value = Math.floor(value / 128);
    }
    this.bytes.push(value);
  }

  zigzag(value) {
    this.varint(value >= 0 ? 2 * value : -2 * value - 1);
  }

  string(text) {
    const bytes = typeof text === 'string' ? kUtf8.encode(text) : text;
    this.varint(bytes.length);
    for (const byte of bytes) this.bytes.push(byte);
  }
}

/** A chunk of any kind. */
export function chunk(kind, contents) {
  const writer = new ByteWriter();
  writer.bytes.push(kind.charCodeAt(0));
  writer.varint(contents.length);
  return Buffer.concat([Buffer.from(writer.bytes), Buffer.from(contents)]);
}

export function jsonChunk(kind, value) {
  return chunk(kind, kUtf8.encode(JSON.stringify(value)));
}

/** Chunk N. */
export function notesChunk(notes) {
  const writer = new ByteWriter();
  writer.varint(notes.length);
  for (const note of notes) {
    writer.varint(note.frame);
    writer.zigzag(note.time ?? 0);
    writer.zigzag(note.stopped ?? 0);
    writer.bytes.push(['mode', 'teams', 'message', 'unknown'].indexOf(note.kind));
    if (note.kind === 'mode') writer.bytes.push(note.mode);
    for (const team of note.teams ?? []) {
      writer.string(team.name);
      for (const key of ['score', 'scored', 'missed']) writer.zigzag(team[key]);
    }
    if (note.kind === 'message') writer.zigzag(note.board);
    if (note.text !== undefined) writer.string(note.text);
  }
  return chunk('N', writer.bytes);
}

/** Encodes frames. Keeps the state of each series between chunks, as a live match does. */
export class FrameEncoder {
  constructor(header) {
    this.header = header;
    this.state = new Map(header.columns.map(({name, series}) => [name, Array.from({length: series}, () => ({p: 0, d: 0}))]));
  }

  /** Chunk F. `columns[name][series][frame]` are real values; those missing are 0. */
  chunk(count, columns) {
    const writer = new ByteWriter();
    writer.varint(count);
    const integers = new Map();
    const before = new Map([...this.state].map(([name, series]) => [name, series.map(({p}) => p)]));
    for (const row of this.header.columns) {
      const real = Array.from({length: row.series}, (_, s) => Array.from({length: count}, (_, i) => columns[row.name]?.[s]?.[i] ?? 0));
      const values = real.map((series) => series.map((value) => (Number.isNaN(value) ? row.none : Math.round(value * (row.scale ?? 1)))));
      integers.set(row.name, values);
      this.#column(writer, row, values, integers, before);
      if (row.scale !== undefined) this.#exceptions(writer, row, real, values);
    }
    return chunk('F', writer.bytes);
  }

  #column(writer, row, values, integers, before) {
    const changes = [];
    let entry = 0;
    let last = -1;
    values.forEach((series, s) => {
      const state = this.state.get(row.name)[s];
      series.forEach((value, i) => {
        const delta = value - state.p;
        if (row.coding === 'd1') writer.zigzag(delta);
        if (row.coding === 'd2') {
          writer.zigzag(delta - state.d);
          state.d = delta;
        }
        if (row.coding === 'da') writer.zigzag(wrapped(delta, row.scale));
        if (row.coding === 'dv') writer.zigzag(value - this.#predicted(row, s, i, integers, before));
        if (row.coding === 'c' && delta !== 0) {
          changes.push([entry - last - 1, delta]);
          last = entry;
        }
        state.p = value;
        ++entry;
      });
    });
    if (row.coding !== 'c') return;
    writer.varint(changes.length);
    for (const [gap, delta] of changes) {
      writer.varint(gap);
      writer.zigzag(delta);
    }
  }

  #predicted(row, s, i, integers, before) {
    const position = integers.get(row.of)[s];
    const moved = position[i] - (i === 0 ? before.get(row.of)[s] : position[i - 1]);
    const decay = row.series === 1 ? this.header.ball_decay : (this.header.type_decay[integers.get('type')[s][i]] ?? 4000);
    return Math.floor((decay * moved + 5000) / 10000);
  }

  #exceptions(writer, row, real, values) {
    const found = [];
    const integers = values.flat();
    real.flat().forEach((value, entry) => {
      const integer = integers[entry];
      if (integer !== row.none && Math.fround(integer / row.scale) !== Math.fround(value)) found.push([entry, value]);
    });
    writer.varint(found.length);
    let last = -1;
    for (const [entry, value] of found) {
      writer.varint(entry - last - 1);
      const bytes = Buffer.alloc(4);
      bytes.writeFloatLE(value);
      writer.bytes.push(...bytes);
      last = entry;
    }
  }
}

function wrapped(delta, scale) {
  if (delta > 180 * scale) return delta - 360 * scale;
  return delta <= -180 * scale ? delta + 360 * scale : delta;
}

/** Joins chunks and adds chunk E with their checksum. */
export function finished(chunks, end = {}) {
  const body = Buffer.concat(chunks);
  const crc = crc32(body).toString(16).padStart(8, '0');
  return Buffer.concat([body, jsonChunk('E', {frames: 0, notes: 0, errors: {count: 0}, ...end, crc32: crc})]);
}
