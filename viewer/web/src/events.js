// Events of the match: what the statistics name, and what frames and notes show (cards, set plays, offenses).
import {PlayerState} from './player_state.js';
import {playModeClass, playModeText, splitPlayMode} from './play_modes.js';
import {frameOfCycle} from './record.js';
import {replayedDecisions} from './replayed.js';
import {kSlots, sideOfSlot, slotOf, slotOfShortName, unumOfSlot} from './sides.js';

/**
 * @typedef {{frame: number, kind: 'goal' | 'shot' | 'card' | 'set_play' | 'offense' | 'turnover' | 'missed' | 'costly', side: string, slot: number,
 *   text: string, expectedGoals?: number, red?: boolean, replayed?: import('./replayed.js').Replayed}} MatchEvent
 */

/** All events in order of time. @param {import('./record.js').MatchRecord} record @returns {MatchEvent[]} */
export function eventsOf(record) {
  const events = [...goals(record), ...shots(record), ...cards(record), ...modeEvents(record), ...turnovers(record), ...missedDecisions(record),
    ...costlyDecisions(record)];
  return events.sort((a, b) => a.frame - b.frame);
}

function teamName(record, side) {
  return record.header.names?.[side === 'right' ? 1 : 0] || side;
}

function playerText(record, side, unum) {
  return unum > 0 ? `${teamName(record, side)} ${unum}` : teamName(record, side);
}

/** The frame of an event of the statistics. */
function eventFrame(record, event) {
  const frame = Number.isInteger(event.frame) ? event.frame : frameOfCycle(record, event.cycle, event.stopped ?? 0);
  return Math.min(Math.max(0, frame), record.frames - 1);
}

/** The expected goals of the shot that became this goal; undefined without one. */
function expectedGoalsOf(record, goal) {
  const own = (record.statistics?.shots ?? []).filter((shot) =>
    shot.outcome === 'goal' && shot.side === goal.side && shot.unum === goal.unum && eventFrame(record, shot) <= eventFrame(record, goal));
  return goal.own_goal ? undefined : own.at(-1)?.expected_goals;
}

function goals(record) {
  const later = goalsOfNotes(record).filter(({frame}) => frame >= record.statisticsFrames);
  return [...(record.statistics?.goals ?? []).map((goal) => ({
    frame: eventFrame(record, goal),
    kind: 'goal',
    side: goal.side,
    slot: goal.own_goal ? -1 : slotOf(goal.side, goal.unum),
    expectedGoals: expectedGoalsOf(record, goal),
    text: `Goal: ${goal.own_goal ? `${teamName(record, goal.side)}, own goal` : playerText(record, goal.side, goal.unum)}`,
  })), ...(record.end && record.statistics ? [] : later)];
}

/** Where statistics are missing, as in a live match: each increase of a score. */
function goalsOfNotes(record) {
  const found = [];
  let before = [0, 0];
  for (const note of record.notes) {
    if (note.kind !== 'teams') continue;
    note.teams.forEach((team, index) => {
      const side = index === 0 ? 'left' : 'right';
      if (team.score > before[index]) found.push({frame: clampFrame(record, note.frame), kind: 'goal', side, slot: -1, text: `Goal: ${team.name || side}`});
    });
    before = note.teams.map((team) => team.score);
  }
  return found;
}

function clampFrame(record, frame) {
  return Math.min(Math.max(0, frame), Math.max(0, record.frames - 1));
}

function shots(record) {
  const list = record.statistics?.shots ?? [];
  return list.filter((shot) => shot.outcome !== 'goal').map((shot) => ({
    frame: eventFrame(record, shot),
    kind: 'shot',
    side: shot.side,
    slot: slotOf(shot.side, shot.unum),
    expectedGoals: shot.expected_goals,
    text: `Shot: ${playerText(record, shot.side, shot.unum)}, ${String(shot.outcome).replaceAll('_', ' ')}`,
  }));
}

function cards(record) {
  const found = [];
  for (let slot = 0; slot < kSlots; ++slot) {
    const states = record.column('state')[slot];
    let shown = 0;
    for (let frame = 0; frame < record.frames; ++frame) {
      const now = states[frame] & (PlayerState.yellowCard | PlayerState.redCard);
      if (now === shown) continue;
      const red = (now & ~shown & PlayerState.redCard) !== 0;
      const side = sideOfSlot(slot);
      if (now & ~shown) found.push({frame, kind: 'card', side, slot, red, text: `${red ? 'Red' : 'Yellow'} card: ${playerText(record, side, unumOfSlot(slot))}`});
      shown = now;
    }
  }
  return found;
}

function modeEvents(record) {
  const found = [];
  const modes = record.column('mode')[0];
  for (let frame = 1; frame < record.frames; ++frame) {
    if (modes[frame] === modes[frame - 1]) continue;
    const name = record.modeName(frame);
    const kind = playModeClass(name);
    if (kind !== 'set_play' && kind !== 'offense') continue;
    const text = playModeText(name, teamName(record, 'left'), teamName(record, 'right'));
    found.push({frame, kind, side: splitPlayMode(name).side, slot: -1, text: text.charAt(0).toUpperCase() + text.slice(1)});
  }
  return found;
}

/** Passes that an opponent intercepted. */
function turnovers(record) {
  const list = record.statistics?.events ?? [];
  return list.filter((event) => event.kind === 'pass' && event.result === 'intercepted').map((event) => ({
    frame: Math.min(record.frames - 1, eventFrame(record, event) + (event.frames ?? 0)),
    kind: 'turnover',
    side: event.side,
    slot: slotOf(event.side, event.unum),
    text: `Ball lost: ${playerText(record, event.side, event.unum)}`,
  }));
}

/** Missed decisions of this many frames in a row, or with this many frames between them, are one event. */
const kMissedGap = 5;

/** Where players got no usable reply in time; one event for neighboring frames of a team. */
function missedDecisions(record) {
  const found = [];
  for (const [cycle, stopped, player, reason] of Array.isArray(record.missed) ? record.missed : []) {
    const slot = slotOfShortName(String(player));
    if (slot < 0 || !Number.isInteger(cycle)) continue;
    const frame = frameOfCycle(record, cycle, stopped);
    const side = sideOfSlot(slot);
    const last = found.findLast((event) => event.side === side);
    if (last && frame - last.end <= kMissedGap) {
      last.end = frame;
      ++last.count;
      last.slots.add(slot);
    } else {
      found.push({frame, end: frame, kind: 'missed', side, slot, count: 1, slots: new Set([slot]), reason: String(reason), text: ''});
    }
  }
  for (const event of found) event.text = missedText(record, event);
  return found;
}

function missedText(record, {side, count, slots, reason}) {
  if (count === 1) return `Missed decision: ${playerText(record, side, unumOfSlot([...slots][0]))}, ${reason}`;
  const who = slots.size === 1 ? playerText(record, side, unumOfSlot([...slots][0])) : `${slots.size} players of ${teamName(record, side)}`;
  return `${count} missed decisions: ${who}, ${reason}`;
}

/** Decisions that `cls review` has played again, where something else was better. */
function costlyDecisions(record) {
  return replayedDecisions(record).map((replayed) => {
    const {frame, slot, cost, best, choices} = replayed;
    const side = sideOfSlot(slot);
    return {frame, kind: 'costly', side, slot, replayed, text: `Cost ${cost.toFixed(2)} goals: ${playerText(record, side, unumOfSlot(slot))}, ${choices[0].text}; better: ${choices[best].text}`};
  });
}

const kHighlightBefore = 60;
const kHighlightAfter = 20;
const kHighlightExpectedGoals = 0.2;

/** Pieces of the match around goals and good shots, merged where they overlap.
 * @param {MatchEvent[]} events @param {number} frames @returns {[number, number][]} */
export function highlightsOf(events, frames) {
  /** @type {[number, number][]} */
  const segments = [];
  for (const event of events) {
    if (event.kind !== 'goal' && !(event.kind === 'shot' && event.expectedGoals >= kHighlightExpectedGoals)) continue;
    const from = Math.max(0, event.frame - kHighlightBefore);
    const to = Math.min(frames - 1, event.frame + kHighlightAfter);
    const last = segments[segments.length - 1];
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else segments.push([from, to]);
  }
  return segments;
}

/** The next event after a frame, or before it. @param {MatchEvent[]} events in order of time
 * @param {number} frame @param {1 | -1} direction @param {string[]} [kinds] all if missing */
export function nextEvent(events, frame, direction, kinds) {
  const wanted = kinds ? events.filter((event) => kinds.includes(event.kind)) : events;
  if (direction > 0) return wanted.find((event) => event.frame > frame);
  return wanted.findLast((event) => event.frame < frame);
}

/** Which team had the ball: by frame the side of the last pass, carry, tackle or shot.
 * @param {import('./record.js').MatchRecord} record @returns {{frame: number, side: string}[]} changes in order of time */
export function possessionChanges(record) {
  const changes = [];
  const list = (record.statistics?.events ?? []).filter((event) => event.kind !== 'foul' && event.kind !== 'goal');
  for (const event of list) {
    const side = event.side;
    if (changes.length > 0 && changes[changes.length - 1].side === side) continue;
    changes.push({frame: eventFrame(record, event), side});
  }
  return changes;
}
