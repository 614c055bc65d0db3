// What Playmakers showed in a match with their actions `log` and `debug_client`, by moment and player.
import {drawingOfEntry, kLevels} from './drawings.js';
import {kPlayersPerTeam, sideOfSlot} from './sides.js';

/** @typedef {{slot: number, drawing: import('./drawings.js').Drawing}} Shown */

export class DrawingStore {
  /** @param {import('./record.js').MatchRecord} record @param {import('./drawings.js').DrawingFilter} filter */
  constructor(record, filter) {
    this.record = record;
    this.filter = filter;
    /** @type {Map<string, {slot: number, entry: any}[]>} by cycle and stopped cycles */
    this.moments = new Map();
    this.omitted = 0;
    this.levelBits = 0;
  }

  get empty() {
    return this.moments.size === 0;
  }

  /** Bits of levels that occur, with their names. @returns {[number, string][]} */
  get levels() {
    return kLevels.map((name, bit) => /** @type {[number, string]} */ ([1 << bit, name])).filter(([bit]) => this.levelBits & bit);
  }

  /** Adds lines of a debug log. Those that it does not understand are left out. @param {string} side @param {string} lines */
  add(side, lines) {
    for (const line of lines.split('\n')) {
      if (line !== '') this.#addLine(side, line);
    }
  }

  #addLine(side, line) {
    let entry = null;
    try {
      entry = JSON.parse(line);
    } catch {
      return;
    }
    if (entry?.kind === 'omitted') this.omitted += Number(entry.count) || 0;
    const drawing = drawingOfEntry(entry, side);
    if (!drawing) return;
    this.levelBits |= drawing.level;
    const key = `${entry.t}+${entry.stopped ?? 0}`;
    const shown = this.moments.get(key) ?? [];
    if (shown.length === 0) this.moments.set(key, shown);
    shown.push({slot: entry.unum - 1 + (side === 'right' ? kPlayersPerTeam : 0), entry});
  }

  #key(frame) {
    return `${this.record.time(frame)}+${this.record.stopped(frame)}`;
  }

  /** What was shown about a frame, by the selected players or by all. @param {number} frame @param {number[]} selected slots @returns {Shown[]} */
  at(frame, selected) {
    const shown = this.moments.get(this.#key(frame)) ?? [];
    return shown.filter(({slot}) => selected.length === 0 || selected.includes(slot))
      .map(({slot, entry}) => ({slot, drawing: drawingOfEntry(entry, sideOfSlot(slot))}));
  }

  /** The next frame that something was shown about; -1: none. @param {number} frame @param {1 | -1} direction @param {number[]} selected slots */
  next(frame, direction, selected) {
    for (let at = frame + direction; at >= 0 && at < this.record.frames; at += direction) {
      const shown = this.moments.get(this.#key(at));
      if (shown?.some(({slot}) => selected.length === 0 || selected.includes(slot))) return at;
    }
    return -1;
  }
}
