// Texts and shapes that a Playmaker shows, its actions `log` and `debug_client` (docs/formats/decisions.md).
import {kPlayersPerTeam} from './sides.js';

/**
 * @typedef {{kind: string, filled: boolean, level: number, numbers: number[], text: string, color: string}} Drawing
 * `kind`: 'text', 'point', 'line', 'arc', 'circle', 'triangle', 'rectangle', 'sector', 'message'. `numbers` in meters and degrees as
 * the log sees the pitch; a rectangle is two corners.
 */

/** By letter: kind, pairs of numbers that are points, distances, directions. A sweep has no side. */
const kShapes = {
  M: ['text', ''], p: ['point', 'xx'], l: ['line', 'xxxx'], a: ['arc', 'xxrds'], c: ['circle', 'xxr'], t: ['triangle', 'xxxxxx'],
  r: ['rectangle', 'xxrr'], s: ['sector', 'xxrrds'], m: ['message', 'xx'],
};

/** Names of levels, by bit (protos::LoggerLevel). */
export const kLevels = ['system', 'sensor', 'world', 'action', 'intercept', 'kick', 'hold', 'dribble', 'pass', 'cross', 'shoot', 'clear', 'block', 'mark', 'positioning', 'role', 'team', 'communication', 'analyzer', 'action chain', 'plan'];

/** @param {number} level a bit, or several @returns {string} */
export function levelName(level) {
  const names = kLevels.filter((_, bit) => level & (1 << bit));
  return names.join(', ') || 'no level';
}

/** The fields of an entry in a debug log, in the order of the numbers; a dot before those that are points. */
const kFields = {
  point: '.point', line: '.start .end', arc: '.center radius start_angle span_angel', circle: '.center radius', triangle: '.point1 .point2 .point3',
  rectangle: 'left top length width', sector: '.center min_radius max_radius start_angle span_angel', message: '.position',
};
const kForms = Object.fromEntries(Object.values(kShapes));

function levelOf(level) {
  if (typeof level === 'number') return level;
  const bit = kLevels.indexOf(String(level ?? '').toLowerCase().replaceAll('_', ' '));
  return bit < 0 ? 0 : 1 << bit;
}

/** A drawing of a line in a debug log (docs/actions.md); null: not understood. @param {any} entry @param {string} side @returns {Drawing | null} */
export function drawingOfEntry(entry, side) {
  if (!Number.isInteger(entry?.t) || !(entry.unum >= 1 && entry.unum <= kPlayersPerTeam)) return null;
  const kind = entry.kind === 'debug_client' ? 'text' : entry.kind;
  if (kind !== 'text' && !Object.hasOwn(kFields, kind)) return null;
  const numbers = (kFields[kind] ?? '').split(' ').filter((field) => field !== '')
    .flatMap((field) => (field.startsWith('.') ? [entry[field.slice(1)]?.x ?? 0, entry[field.slice(1)]?.y ?? 0] : [entry[field] ?? 0])).map(Number);
  if (!numbers.every(Number.isFinite)) return null;
  const drawing = {kind, filled: entry.fill === true, level: levelOf(entry.level), numbers, text: String(entry.message ?? ''), color: String(entry.color ?? '')};
  if (kind === 'rectangle') numbers.splice(2, 2, numbers[0] + numbers[2], numbers[1] + numbers[3]);
  if (side === 'right') mirror(drawing, kind === 'rectangle' ? 'xxxx' : kForms[kind]);
  return drawing;
}

/** A drawing of a line; null: not understood. @param {string} line */
function drawingOf(line, slot) {
  const match = /^(\d+) ([a-zA-Z])(.*)$/.exec(line);
  const shape = match && (kShapes[match[2]] ?? kShapes[match[2].toLowerCase()]);
  if (!shape) return null;
  const [kind, form] = shape;
  const words = match[3].trimStart().split(' ');
  const numbers = words.splice(0, form.length).map(Number);
  if (form.length > 0 && (numbers.length < form.length || numbers.some(Number.isNaN))) return null;
  const rest = words.join(' ');
  const colored = /^\(c ([^)]*)\) ?(.*)$/.exec(rest);
  const isText = kind === 'text' || kind === 'message';
  /** @type {Drawing} */
  const drawing = {kind, filled: match[2] !== match[2].toLowerCase() && kind !== 'text', level: Number(match[1]), numbers,
    text: isText ? (colored?.[2] ?? rest) : '', color: isText ? (colored?.[1] ?? '') : rest};
  if (kind === 'rectangle') numbers.splice(2, 2, numbers[0] + numbers[2], numbers[1] + numbers[3]);
  if (slot >= kPlayersPerTeam) mirror(drawing, kind === 'rectangle' ? 'xxxx' : form);
  return drawing;
}

/** The right team sees the pitch from the other end. */
function mirror(drawing, form) {
  [...form].forEach((letter, i) => {
    if (letter === 'x') drawing.numbers[i] = -drawing.numbers[i];
    if (letter === 'd') drawing.numbers[i] += 180;
  });
}

/** @param {string} text of a decision @param {number} slot of the player @returns {Drawing[]} */
export function drawingsOf(text, slot) {
  return (text ?? '').split('\n').filter((line) => line !== '').map((line) => drawingOf(line, slot)).filter((drawing) => drawing !== null);
}

/** What of the drawings to show. */
export class DrawingFilter {
  constructor() {
    /** A bit of LoggerLevel; 0: all. */
    this.level = 0;
    /** Part of the text, the kind or the color, in any case. */
    this.text = '';
  }

  /** @param {Drawing} drawing */
  shows(drawing) {
    if (this.level !== 0 && (drawing.level & this.level) === 0) return false;
    const words = `${drawing.filled ? 'filled ' : ''}${drawing.kind} ${drawing.color} ${drawing.text} ${levelName(drawing.level)}`.toLowerCase();
    return words.includes(this.text.trim().toLowerCase());
  }
}

/** Bits of levels that occur, with their names. @param {string[]} texts of decisions @returns {[number, string][]} */
export function levelsIn(texts) {
  let all = 0;
  for (const text of texts) {
    if (!text) continue;
    for (const line of text.split('\n')) all |= Number.parseInt(line, 10) || 0;
  }
  return kLevels.map((name, bit) => /** @type {[number, string]} */ ([1 << bit, name])).filter(([bit]) => all & bit);
}
