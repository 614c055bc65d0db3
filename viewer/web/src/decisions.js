// Recorded decisions of a team (docs/formats/decisions.md): what its players estimated, received and sent.
import {Column, decodePlainColumn} from './columns.js';
import {crc32} from './crc32.js';
import {TextShapes} from './decision_texts.js';
import {kPlayersPerTeam} from './sides.js';
import {chunkAt} from './stream.js';
import {ByteReader} from './varint.js';

const kDecisionsText = new TextDecoder();
const kDecisionsMajorVersion = 1;
/** Replies, commands, plans, drawings. */
const kTextKinds = 4;

/** The age of what a player does not know. */
export const kUnknownAge = -1;

/** The decisions of one player in the order of the match; `value(name, i, series)` is a number of decision `i`. */
export class PlayerDecisions {
  /** @param {any[]} rows columns of the header */
  constructor(rows) {
    this.count = 0;
    this.columns = new Map(rows.map((row) => [row.name, new Column(row)]));
    /** Requested actions, a line each: letter of the outcome, space, text. @type {string[]} */
    this.replies = [];
    /** @type {string[]} */
    this.commands = [];
    /** @type {string[]} */
    this.plans = [];
    /** Texts and shapes that the Playmaker shows, a line each: drawings.js. @type {string[]} */
    this.drawings = [];
    this.shapes = Array.from({length: kTextKinds}, () => new TextShapes());
    /** Microseconds until the reply. @type {number[]} */
    this.latencies = [];
  }

  value(name, i, series = 0) {
    return this.columns.get(name)?.series[series]?.[i] ?? kUnknownAge;
  }

  /** Adds a chunk B; the reader stands behind the number of the player. */
  addBlock(reader) {
    const count = reader.varint();
    for (const column of this.columns.values()) {
      column.reserve(this.count + count, false);
      decodePlainColumn(reader, column, this.count, count);
    }
    this.count += count;
  }

  /** Adds a chunk W. */
  addTexts(reader) {
    const count = reader.varint();
    const kind = reader.varint();
    if (kind >= kTextKinds) return;
    const texts = [this.replies, this.commands, this.plans, this.drawings][kind];
    for (const text of this.shapes[kind].read(reader, count)) texts.push(text);
  }

  /** Adds a chunk T. */
  addLatencies(reader) {
    const count = reader.varint();
    for (let i = 0; i < count; ++i) {
      const last = this.latencies[this.latencies.length - 1] ?? 0;
      this.latencies.push(last + reader.zigzag());
    }
  }
}

/** @param {any} header @returns {string} '' or why this page cannot show the decisions */
function decisionsProblem(header) {
  const schema = /^cls\.decisions\/(\d+)$/.exec(header?.schema ?? '');
  if (!schema || !Array.isArray(header.columns)) return 'the recording of decisions has no header';
  if (Number(schema[1]) > kDecisionsMajorVersion) return `the decisions have format ${header.schema}; write the page again with the cls that made them`;
  return '';
}

/** The decisions of a team. Decodes a player when it is asked for. */
export class TeamDecisions {
  /** @param {Uint8Array} bytes a stream of chunks; throws an error of one sentence */
  constructor(bytes) {
    this.header = null;
    /** Chunks B, W and T by uniform number. @type {Map<number, {kind: string, reader: ByteReader}[]>} */
    this.chunks = new Map();
    /** @type {Map<number, PlayerDecisions>} */
    this.players = new Map();
    this.#index(bytes);
  }

  #index(bytes) {
    let at = 0;
    let crc = 0;
    for (let chunk = chunkAt(bytes, 0); chunk; chunk = chunkAt(bytes, at)) {
      if (chunk.kind === 'E') {
        const end = JSON.parse(kDecisionsText.decode(chunk.contents));
        if (parseInt(end.crc32, 16) !== crc) throw new Error('the decisions in this page are corrupt: their checksum differs');
        return;
      }
      if (chunk.kind === 'H') this.#readHeader(chunk.contents);
      if ('BWT'.includes(chunk.kind)) this.#addChunk(chunk);
      if (chunk.kind !== 'T') crc = crc32(bytes.subarray(at, chunk.end), crc);
      at = chunk.end;
    }
    throw new Error('the decisions in this page are incomplete');
  }

  #readHeader(contents) {
    this.header = JSON.parse(kDecisionsText.decode(contents));
    const problem = decisionsProblem(this.header);
    if (problem) throw new Error(problem);
  }

  #addChunk({kind, contents}) {
    if (!this.header) throw new Error('the recording of decisions has no header');
    const reader = new ByteReader(contents);
    const unum = reader.varint();
    if (!(unum >= 1 && unum <= kPlayersPerTeam)) throw new Error('the decisions in this page are corrupt');
    if (!this.chunks.has(unum)) this.chunks.set(unum, []);
    this.chunks.get(unum).push({kind, reader});
  }

  /** @param {number} unum @returns {PlayerDecisions | null} null: not recorded */
  player(unum) {
    const chunks = this.chunks.get(unum);
    if (!chunks) return this.players.get(unum) ?? null;
    const player = new PlayerDecisions(this.header.columns);
    for (const {kind, reader} of chunks) {
      if (kind === 'B') player.addBlock(reader);
      if (kind === 'W') player.addTexts(reader);
      if (kind === 'T') player.addLatencies(reader);
    }
    this.chunks.delete(unum);
    this.players.set(unum, player);
    return player;
  }
}
