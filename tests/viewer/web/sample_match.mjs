// A small match for tests: 300 frames; players run in circles, a goal in cycle 100, 20 stopped frames, a kick-off.
import {kColumns, FrameEncoder, finished, jsonChunk, notesChunk} from './stream_writer.mjs';

export const kFrames = 300;
export const kGoalFrame = 100;
export const kStoppedFrames = 20;
const kModes = ['', 'before_kick_off', 'time_over', 'play_on', 'kick_off_l', 'kick_off_r', 'kick_in_l', 'kick_in_r', 'free_kick_l', 'free_kick_r', 'corner_kick_l', 'corner_kick_r', 'goal_kick_l', 'goal_kick_r', 'goal_l', 'goal_r'];

/** @param {{names?: [any, any], texts?: any[]}} [options] names of the teams, texts of messages and unknown lines */
export function sampleHeader({names = ['Azure', 'Amber'], live = false} = {}) {
  return {
    schema: 'cls.view/1', cls: '1.0', log: '6', names, score: [1, 0], frames: live ? null : kFrames, live,
    server: {half_time: 300, stamina_max: 8000, ball_size: 0.085, ball_speed_max: 3, ball_accel_max: 2.7, goal_width: 14.02, simulator_step: 100},
    types: [{id: 0, player_size: 0.3, kickable_margin: 0.7, player_decay: 0.4, player_speed_max: 1.05}],
    modes: kModes, ball_decay: 9400, type_decay: [4000], columns: kColumns,
  };
}

/** Real values by column, series and frame. */
export function sampleColumns() {
  const columns = Object.fromEntries(kColumns.map(({name, series}) => [name, Array.from({length: series}, () => new Array(kFrames).fill(0))]));
  for (let frame = 0; frame < kFrames; ++frame) sampleFrame(columns, frame);
  return columns;
}

function sampleFrame(columns, frame) {
  const set = (name, value, s = 0) => (columns[name][s][frame] = value);
  const stopped = frame < kGoalFrame ? 0 : Math.min(frame - kGoalFrame, kStoppedFrames);
  const inStop = frame >= kGoalFrame && frame <= kGoalFrame + kStoppedFrames;
  set('time', frame - stopped);
  set('stopped', inStop ? stopped : 0);
  set('mode', frame === 0 ? 4 : inStop ? 14 : 3);
  set('teams', frame < kGoalFrame ? 1 : 2);
  const ballX = frame < kGoalFrame ? 0.53 * frame : frame === kGoalFrame + 10 ? 20 : inStop ? 53 : (frame - kGoalFrame) * -0.1;
  set('ball_x', round4(ballX));
  set('ball_y', round4(inStop ? 0 : 3 * Math.sin(frame / 20)));
  set('ball_vx', 0.4213);
  for (let slot = 0; slot < 22; ++slot) {
    const angle = frame / 40 + slot;
    set('state', 1 + (slot % 11 === 0 ? 8 : 0) + (slot === 9 && frame === 98 ? 2 : 0) + (slot === 15 && frame >= 150 ? 0x40000 : 0), slot);
    const home = {x: (slot < 11 ? -1 : 1) * (6 + 4 * (slot % 11)), y: -25 + 5 * (slot % 11)};
    set('x', round4(home.x + 4 * Math.cos(angle)), slot);
    set('y', round4(home.y + 4 * Math.sin(angle)), slot);
    set('vx', round4(-0.1 * Math.sin(angle)), slot);
    set('body', Math.round(1000 * (((angle * 57.3 + 180) % 360) - 180)) / 1000, slot);
    set('neck', 30, slot);
    set('view_width', 60 + 60 * (slot % 3), slot);
    set('stamina', 8000 - 10 * frame, slot);
    set('effort', 1, slot);
    set('recovery', 1, slot);
    set('capacity', 130600.4375, slot);
    set('point_x', slot === 3 ? 10.5 : NaN, slot);
    set('point_y', slot === 3 ? -4 : NaN, slot);
    set('attention', slot === 2 ? 13 : -1, slot);
    set('count_dash', frame, slot);
  }
}

function round4(value) {
  return Math.round(10000 * value) / 10000;
}

export function sampleStatistics(names) {
  const team = (name, share) => ({
    name, possession: {last_touch: share}, shots: {total: 2, on_target: 1, expected_goals: 0.5}, passes: {attempted: 10, completed: 7, completion: 0.7, through: 1, crosses: 0},
    stoppages: {corners: 1, offsides: 0, fouls: 2, yellow_cards: 0, red_cards: 0}, shape: {formation: '4-3-3'}, distance: 1234.5,
  });
  return {
    doubts: [], left: team(names[0], 0.6), right: team(names[1], 0.4), players: [],
    goals: [{cycle: kGoalFrame, frame: kGoalFrame, side: 'left', unum: 10, own_goal: false}],
    shots: [{cycle: 98, frame: 98, side: 'left', unum: 10, outcome: 'goal', expected_goals: 0.5}, {cycle: 200, stopped: 0, side: 'right', unum: 9, outcome: 'saved', expected_goals: 0.3}],
    events: [{kind: 'pass', cycle: 20, frame: 20, side: 'left', unum: 4, result: 'completed'}, {kind: 'pass', cycle: 60, frame: 60, side: 'right', unum: 5, result: 'intercepted', frames: 5}],
  };
}

/** The same match while it is played: pieces of the stream of `size` frames, the last one with statistics and end.
 * With `early`, the first piece has statistics of a match without goals. */
export function liveSamplePieces(size, early = false) {
  const names = ['Azure', 'Amber'];
  const header = sampleHeader({names, live: true});
  const team = (name, score) => ({name, score, scored: 0, missed: 0});
  const columns = sampleColumns();
  const encoder = new FrameEncoder(header);
  const start = notesChunk([{frame: 0, kind: 'teams', teams: [team(names[0], 0), team(names[1], 0)]}]);
  const goal = notesChunk([{frame: kGoalFrame, time: kGoalFrame, kind: 'teams', teams: [team(names[0], 1), team(names[1], 0)]}]);
  const pieces = [];
  for (let first = 0; first < kFrames; first += size) {
    const count = Math.min(size, kFrames - first);
    const part = Object.fromEntries(Object.entries(columns).map(([name, series]) => [name, series.map((values) => values.slice(first, first + count))]));
    const before = [...(first === 0 ? [jsonChunk('H', header), start] : []), ...(first <= kGoalFrame && kGoalFrame < first + count ? [goal] : [])];
    const statistics = early && first === 0 ? [jsonChunk('S', {...sampleStatistics(names), goals: [], shots: [], events: []})] : [];
    pieces.push(Buffer.concat([...before, encoder.chunk(count, part), ...statistics]));
  }
  const whole = finished([...pieces, jsonChunk('S', sampleStatistics(names))], {frames: kFrames, notes: 2});
  return [...pieces, whole.subarray(Buffer.concat(pieces).length)];
}

/** A whole stream; `size` frames a chunk. */
export function sampleStream({names = ['Azure', 'Amber'], texts = [], size = kFrames, statistics = true} = {}) {
  const header = sampleHeader({names: names.map((name) => (typeof name === 'string' ? name : Buffer.from(name).toString()))});
  const team = (name, score) => ({name, score, scored: 0, missed: 0});
  const notes = [
    {frame: 0, kind: 'teams', teams: [team(names[0], 0), team(names[1], 0)]},
    {frame: kGoalFrame, time: kGoalFrame, kind: 'teams', teams: [team(names[0], 1), team(names[1], 0)]},
    ...texts.map((text) => ({frame: 5, kind: 'message', board: 1, text})),
    ...texts.map((text) => ({frame: 6, kind: 'unknown', text})),
  ];
  const columns = sampleColumns();
  const encoder = new FrameEncoder(header);
  const chunks = [jsonChunk('H', header), notesChunk(notes)];
  for (let first = 0; first < kFrames; first += size) {
    const count = Math.min(size, kFrames - first);
    const part = Object.fromEntries(Object.entries(columns).map(([name, series]) => [name, series.map((values) => values.slice(first, first + count))]));
    chunks.push(encoder.chunk(count, part));
  }
  if (statistics) chunks.push(jsonChunk('S', sampleStatistics(header.names)));
  return finished(chunks, {frames: kFrames, notes: notes.length});
}
