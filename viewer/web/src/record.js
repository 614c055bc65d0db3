// The match as the page has it: header, columns, notes, statistics.
import {Column} from './columns.js';

const kMajorVersion = 1;

/** @param {any} header @returns {string} '' or why this page cannot show the match */
export function headerProblem(header) {
  const schema = /^cls\.view\/(\d+)$/.exec(header?.schema ?? '');
  if (!schema) return 'the data is not a cls match';
  if (Number(schema[1]) > kMajorVersion) return `the match has format ${header.schema}; write the page again with the cls that made it`;
  if (!Array.isArray(header.columns)) return 'the header lists no columns';
  return '';
}

/** A column for what a log lacks: one value for all frames. */
function constantColumn(value) {
  return new Proxy([], {get: () => value});
}

const kNoNumbers = constantColumn(0);

/** A match. `column(name)` has one array per series; a compact page lacks some, which read as zero. */
export class MatchRecord {
  /** @param {any} header */
  constructor(header) {
    this.setHeader(header);
    this.frames = 0;
    /** @type {Map<string, Column>} */
    this.columns = new Map(header.columns.map((row) => [row.name, new Column(row)]));
    /** @type {import('./notes.js').Note[]} */
    this.notes = [];
    /** @type {[import('./notes.js').Team, import('./notes.js').Team][]} by value of the column `teams` */
    this.teams = [[emptyTeam(header, 0), emptyTeam(header, 1)]];
    /** cls.stats/1 of the first `statisticsFrames` frames, or null. */
    this.statistics = null;
    this.statisticsFrames = 0;
    /** Missed decisions, as the settings of the page have them: cycle, stopped, player, reason. @type {[number, number, string, string][]} */
    this.missed = [];
    /** Decisions that were played again, as the settings of the page have them (replayed.js). @type {unknown[]} */
    this.review = [];
    /** The sides as `cls match` names them, left and right, or null. @type {[string, string] | null} */
    this.sides = null;
    /** Chunk E, or null while the match runs. */
    this.end = null;
    this.missing = constantColumn(kNoNumbers);
  }

  /** A live match may have several. @param {any} header */
  setHeader(header) {
    this.header = header;
    /** @type {Map<number, any>} */
    this.types = new Map((header.types ?? []).map((type) => [type.id, type]));
  }

  /** @param {string} name @returns {(Float32Array | Int32Array)[]} */
  column(name) {
    const column = this.columns.get(name);
    if (column?.pending) column.complete();
    return column?.series ?? this.missing;
  }

  /** Decodes one column that was left for later. @returns {boolean} false: there is none */
  completeOne() {
    for (const column of this.columns.values()) {
      if (!column.pending) continue;
      column.complete();
      return true;
    }
    this.forgetIntegers();
    return false;
  }

  /** Decodes all columns. */
  complete() {
    while (this.completeOne());
  }

  /** The integers of the last frames have done their work. */
  forgetIntegers() {
    for (const column of this.columns.values()) column.integers = new Int32Array(0);
  }

  /** More frames will come. */
  get isLive() {
    return this.header.live === true && this.end === null;
  }

  has(name) {
    return this.columns.has(name);
  }

  /** @param {import('./notes.js').Note[]} notes */
  addNotes(notes) {
    for (const note of notes) {
      this.notes.push(note);
      if (note.kind === 'teams') this.teams.push(note.teams);
    }
  }

  /** @param {any} statistics of all frames so far */
  setStatistics(statistics) {
    this.statistics = statistics;
    this.statisticsFrames = this.frames;
  }

  time(frame) {
    return this.column('time')[0][frame];
  }

  stopped(frame) {
    return this.column('stopped')[0][frame];
  }

  /** @returns {string} play mode, "play_on" */
  modeName(frame) {
    return this.header.modes[this.column('mode')[0][frame]] ?? '';
  }

  /** @returns {[import('./notes.js').Team, import('./notes.js').Team]} names and scores in force */
  teamsAt(frame) {
    return this.teams[this.column('teams')[0][frame]] ?? this.teams[0];
  }

  /** The number of a server parameter. */
  parameter(name, otherwise) {
    const value = this.header.server?.[name];
    return typeof value === 'number' ? value : otherwise;
  }

  /** The player type of a slot in a frame; types change with substitutions. */
  playerType(slot, frame) {
    const id = this.column('type')[slot][frame];
    return this.types.get(id) ?? this.header.types?.[0] ?? {};
  }
}

function emptyTeam(header, index) {
  return {name: header.names?.[index] ?? '', score: 0, scored: 0, missed: 0};
}

/** The frame of a cycle: that with `stopped` if the clock was stopped, else the first of the nearest cycle.
 * @param {MatchRecord} record @param {number} time @param {number} [stopped] @returns {number} */
export function frameOfCycle(record, time, stopped = 0) {
  const times = record.column('time')[0];
  let low = 0;
  let high = record.frames;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  let frame = Math.min(low, Math.max(0, record.frames - 1));
  while (frame + 1 < record.frames && times[frame + 1] === time && record.stopped(frame) < stopped) ++frame;
  return frame;
}

/** "1234", or "1234+7" while the clock is stopped.
 * @param {MatchRecord} record @param {number} frame @returns {string} */
export function cycleLabel(record, frame) {
  const stopped = record.stopped(frame);
  return stopped > 0 ? `${record.time(frame)}+${stopped}` : String(record.time(frame));
}

/** Minute of a match of ninety minutes, from 1.
 * @param {MatchRecord} record @param {number} frame @returns {number} */
export function minuteOf(record, frame) {
  const half = record.parameter('half_time', 300) * 10;
  const cycles = half > 0 ? half * 2 : 6000;
  return Math.floor((Math.max(0, record.time(frame) - 1) * 90) / cycles) + 1;
}
