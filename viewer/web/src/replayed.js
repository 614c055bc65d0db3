// Decisions that `cls review` has played again: what else the player could have done, and what came of each.
import {frameOfCycle} from './record.js';
import {slotOfShortName} from './sides.js';

/**
 * @typedef {{text: string, target: number[] | null, worths: number[], mean: number}} Choice `target`: of the ball; null for what the player did.
 *   `worths`: goals, one per playout
 * @typedef {{frame: number, slot: number, cost: number, low: number, high: number, best: number, choices: Choice[]}} Replayed `choices`: first what the
 *   player did; `best`: index of the better one
 */

/** @type {WeakMap<object, Replayed[]>} */
const cache = new WeakMap();

/** Those with a better choice, in order of time. @param {import('./record.js').MatchRecord} record @returns {Replayed[]} */
export function replayedDecisions(record) {
  if (!Array.isArray(record.review)) return [];
  if (!cache.has(record.review)) cache.set(record.review, record.review.flatMap((each) => replayedOf(record, each) ?? []).sort((a, b) => a.frame - b.frame));
  return cache.get(record.review);
}

function replayedOf(record, each) {
  const {cycle, player, cost, better, choices} = Object(each);
  const slot = slotOfShortName(String(player));
  if (slot < 0 || !Number.isInteger(cycle) || !isNumbers(cost, 3) || !Array.isArray(choices)) return null;
  const read = choices.map(choiceOf);
  if (read.length < 2 || read.includes(null) || !(better > 0 && better < read.length)) return null;
  return {frame: Math.max(0, frameOfCycle(record, cycle, 0)), slot, cost: cost[0], low: cost[1], high: cost[2], best: better, choices: read};
}

function choiceOf(choice) {
  if (!choice || typeof choice.text !== 'string' || !isNumbers(choice.worths) || choice.worths.length === 0) return null;
  const mean = choice.worths.reduce((sum, worth) => sum + worth, 0) / choice.worths.length;
  return {text: choice.text, target: isNumbers(choice.target, 2) ? choice.target : null, worths: choice.worths, mean};
}

function isNumbers(list, count = list?.length) {
  return Array.isArray(list) && list.length === count && list.every(Number.isFinite);
}

const kShownFrames = 15;

/** The decision whose choices to show at a frame. @returns {Replayed | undefined} */
export function replayedAt(record, frame) {
  return replayedDecisions(record).findLast((each) => each.frame <= frame && frame < each.frame + kShownFrames);
}
