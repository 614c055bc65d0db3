// The decisions of a player beside the frames of the match: which belongs to which, and how wrong the estimates were.
import {consideredActions} from './decision_plan.js';
import {kUnknownAge} from './decisions.js';
import {drawingsOf, levelsIn} from './drawings.js';
import {PlayerState} from './player_state.js';
import {kSlots, shortNameOfSlot} from './sides.js';

/**
 * @typedef {{name: string, slot: number, estimated: [number, number] | null, actual: [number, number], error: number, age: number}} EstimateRow
 * `slot` -1: the ball. `error` is NaN where nothing is estimated.
 * @typedef {{decision: number, frame: number, ballError: number}} WorstMoment
 */

const kNone = -1;
const kNearestRows = 5;
const kWorstMoments = 8;
const kWorstDistance = 40;
/** At this distance an error counts half as much as at the ball. */
const kHalfDistance = 10;

/** A key for each (time, stopped, how often it occurred before). */
function clockKeys(count, time, stopped) {
  const seen = new Map();
  return Array.from({length: count}, (_, i) => {
    const key = `${time(i)}+${stopped(i)}`;
    const before = seen.get(key) ?? 0;
    seen.set(key, before + 1);
    return `${key} ${before}`;
  });
}

export class DecisionTrack {
  /** @param {import('./record.js').MatchRecord} record @param {number} slot @param {import('./decisions.js').PlayerDecisions} decisions */
  constructor(record, slot, decisions) {
    this.record = record;
    this.slot = slot;
    this.decisions = decisions;
    this.levels = levelsIn(decisions.drawings);
    /** @type {{decision: number, actions: import('./decision_plan.js').Considered[]}} */
    this.latestPlan = {decision: kNone, actions: []};
    this.#align();
    this.ballErrors = Float32Array.from({length: decisions.count}, (_, i) => this.ballRow(i)?.error ?? NaN);
    this.selfErrors = Float32Array.from({length: decisions.count}, (_, i) => this.selfRow(i)?.error ?? NaN);
  }

  #align() {
    const {record, decisions} = this;
    const frames = new Map(clockKeys(record.frames, (i) => record.time(i), (i) => record.stopped(i)).map((key, frame) => [key, frame]));
    this.frames = new Int32Array(decisions.count).fill(kNone);
    this.decisionOfFrame = new Int32Array(record.frames).fill(kNone);
    clockKeys(decisions.count, (i) => decisions.value('cycle', i), (i) => decisions.value('stopped', i)).forEach((key, i) => {
      const frame = frames.get(key);
      if (frame === undefined) return;
      this.frames[i] = frame;
      this.decisionOfFrame[frame] = i;
    });
  }

  /** Texts and shapes of the decision about a frame. @returns {import('./drawing_store.js').Shown[]} */
  drawings(frame) {
    const decision = this.at(frame);
    if (decision < 0) return [];
    return drawingsOf(this.decisions.drawings[decision], this.slot).map((drawing) => ({slot: this.slot, drawing}));
  }

  /** The decision about a frame; -1: none. */
  at(frame) {
    return this.decisionOfFrame[frame] ?? kNone;
  }

  /** What the player considered, best first. @returns {import('./decision_plan.js').Considered[]} */
  considered(decision) {
    if (this.latestPlan.decision !== decision) this.latestPlan = {decision, actions: consideredActions(this.decisions.plans[decision] ?? '')};
    return this.latestPlan.actions;
  }

  /** @returns {EstimateRow | null} null: the frame of the decision is not in the log */
  #row(i, name, slot, age, x, y) {
    const frame = this.frames[i];
    if (frame === kNone) return null;
    const {record} = this;
    /** @type {[number, number]} */
    const actual = slot < 0 ? [record.column('ball_x')[0][frame], record.column('ball_y')[0][frame]] : [record.column('x')[slot][frame], record.column('y')[slot][frame]];
    if (age === kUnknownAge) return {name, slot, estimated: null, actual, error: NaN, age};
    return {name, slot, estimated: [x, y], actual, error: Math.hypot(x - actual[0], y - actual[1]), age};
  }

  selfRow(i) {
    const {decisions} = this;
    return this.#row(i, 'self', this.slot, decisions.value('self_age', i), decisions.value('self_x', i), decisions.value('self_y', i));
  }

  ballRow(i) {
    const {decisions} = this;
    return this.#row(i, 'ball', -1, decisions.value('ball_age', i), decisions.value('ball_x', i), decisions.value('ball_y', i));
  }

  playerRow(i, slot) {
    const {decisions} = this;
    return this.#row(i, shortNameOfSlot(slot), slot, decisions.value('age', i, slot), decisions.value('x', i, slot), decisions.value('y', i, slot));
  }

  /** Self, ball, and the players that are nearest in the full state. @returns {EstimateRow[]} */
  rows(i) {
    const self = this.selfRow(i);
    if (!self) return [];
    const [x, y] = self.actual;
    const players = this.#othersOnPitch(this.frames[i]).map((slot) => this.playerRow(i, slot));
    const distance = (row) => Math.hypot(row.actual[0] - x, row.actual[1] - y);
    players.sort((a, b) => distance(a) - distance(b));
    return [self, this.ballRow(i), ...players.slice(0, kNearestRows)];
  }

  #othersOnPitch(frame) {
    const states = this.record.column('state');
    return Array.from({length: kSlots}, (_, slot) => slot).filter((slot) => slot !== this.slot && states[slot][frame] & PlayerState.enabled);
  }

  /** Players of unknown number. @returns {{side: number, x: number, y: number, age: number}[]} side -1: right, 0: unknown, 1: left */
  unnumbered(i) {
    const {decisions} = this;
    return Array.from({length: kSlots}, (_, s) => s).filter((s) => decisions.value('other_id', i, s) > 0).map((s) => ({
      side: decisions.value('other_side', i, s), x: decisions.value('other_x', i, s), y: decisions.value('other_y', i, s), age: decisions.value('other_age', i, s),
    }));
  }

  /** Decisions with the largest errors of the ball that mattered: near the ball. @returns {WorstMoment[]} by weight */
  worstMoments() {
    const weights = Array.from(this.ballErrors, (error, i) => {
      const row = Number.isNaN(error) ? null : this.selfRow(i);
      if (!row) return 0;
      const frame = this.frames[i];
      const distance = Math.hypot(row.actual[0] - this.record.column('ball_x')[0][frame], row.actual[1] - this.record.column('ball_y')[0][frame]);
      return (error * kHalfDistance) / (kHalfDistance + distance);
    });
    const order = weights.map((_, i) => i).filter((i) => weights[i] > 0).sort((a, b) => weights[b] - weights[a]);
    /** @type {WorstMoment[]} */
    const worst = [];
    for (const i of order) {
      if (worst.length === kWorstMoments) break;
      if (worst.some(({decision}) => Math.abs(decision - i) < kWorstDistance)) continue;
      worst.push({decision: i, frame: this.frames[i], ballError: this.ballErrors[i]});
    }
    return worst;
  }
}

const kOutcomes = {e: 'executed', f: 'not possible', s: 'not tried: an earlier action succeeded', i: 'invalid number', u: 'unknown to this cls', '-': 'not tried'};

/** The requested actions. @param {string} reply @returns {{outcome: string, letter: string, text: string}[]} */
export function requestedActions(reply) {
  return reply.split('\n').filter((line) => line !== '').map((line) => ({letter: line[0], outcome: kOutcomes[line[0]] ?? 'unknown', text: line.slice(2)}));
}

const kMakers = [
  'The first action of the list that was possible decided.',
  'The proxy decided before the list was tried: the player cannot act, the game is stopped, or its own position or the ball is unknown.',
  'The proxy decided before the list was tried: a shot that no opponent can reach.',
  'The proxy decided before the list was tried: it continued what it had begun.',
  'The proxy decided before the list was tried: a forced kick.',
  'The proxy decided before the list was tried: a pass that a teammate announced.',
  'The proxy decided without a reply.',
  'The player decided by its policy; no Playmaker was asked.',
];

/** @param {number} maker @returns {string} who chose the command */
export function makerText(maker) {
  return kMakers[maker] ?? '';
}

const kCallProblems = ['', 'no reply before the deadline', 'the Playmaker could not be reached', 'the Playmaker does not implement the call', 'the reply does not parse', 'the call was cancelled', 'the Playmaker answered with an error'];

/** @param {number} call @returns {string} '' or why the decision was missed */
export function missText(call) {
  return call > 0 ? (kCallProblems[call] ?? 'unknown error') : '';
}

/** Commands that the server executed between a frame and the next one, from its counters.
 * @param {import('./record.js').MatchRecord} record @param {number} slot @param {number} frame @returns {string[]} */
export function executedCommands(record, slot, frame) {
  if (frame + 1 >= record.frames) return [];
  const counters = [...record.columns.keys()].filter((name) => name.startsWith('count_'));
  return counters.filter((name) => record.column(name)[slot][frame + 1] > record.column(name)[slot][frame]).map((name) => name.slice('count_'.length));
}
