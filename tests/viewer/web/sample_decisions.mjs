// Recorded decisions of left player 7 in the sample match. Writes docs/formats/decisions.md; independent of viewer/decisions (C++).
import {crc32} from '../../../viewer/web/src/crc32.js';
import {kFrames, sampleColumns} from './sample_match.mjs';
import {ByteWriter, chunk, jsonChunk} from './stream_writer.mjs';

export const kDecisionColumns = [
  ...['cycle', 'stopped'].map((name) => ({name, coding: 'd1', series: 1})),
  ...['maker', 'call'].map((name) => ({name, coding: 'c', series: 1})),
  ...['self_x', 'self_y'].map((name) => ({name, coding: 'd2', series: 1, scale: 100})),
  {name: 'self_age', coding: 'd1', series: 1},
  ...['ball_x', 'ball_y'].map((name) => ({name, coding: 'd2', series: 1, scale: 100})),
  {name: 'ball_age', coding: 'd1', series: 1},
  ...['own_reach', 'teammate_reach', 'opponent_reach'].map((name) => ({name, coding: 'd1', series: 1})),
  {name: 'age', coding: 'd1', series: 22},
  ...['x', 'y'].map((name) => ({name, coding: 'd1', series: 22, scale: 100})),
  ...['other_id', 'other_side', 'other_age'].map((name) => ({name, coding: 'c', series: 22})),
  ...['other_x', 'other_y'].map((name) => ({name, coding: 'c', series: 22, scale: 100})),
];

/** The frame with the worst estimate of the ball: 9 m from it. */
export const kWorstFrame = 40;
/** The frame of the missed decision. */
export const kMissedFrame = 50;

/** The frame of a choice of a policy among ten options. */
export const kPolicyFrame = 60;
const kPlans = {
  [kWorstFrame]: '* pass 9 (12, -4) 45.2\n- dribble 7 (1, 1) 30\n',
  [kPolicyFrame]: '- shoot (52.5, 0) 4%\n- hold 10%\n* dribble -45 deg (20, -20) 60% room 4.5\n- through pass 9 (30, 20) 19% room 3.1\n' +
    Array.from({length: 6}, (_, i) => `- pass ahead ${i + 1} (0, ${i}) 1%\n`).join(''),
};

/** The frame that the Playmaker draws about. */
export const kDrawnFrame = 45;
const kSampleDrawings = '1024 C 10 5 3 #ff0000\n8 l -10 -5.25 0 0 blue\n65536 m 1 -2 (c white) run here\n65536 M plan 7.50, -0, 1234567\n32 r 1 2 3 4 \n';

/** Numbers by column and series, and the texts of a frame. The player sees all but right player 9, whom it never saw, and has a
 * player of unknown number at (1, 2). */
function sampleDecision(columns, frame, text) {
  const at = (name, s = 0) => columns[name][s][frame];
  const missed = frame === kMissedFrame;
  const numbers = {
    cycle: [at('time')], stopped: [at('stopped')], maker: [missed ? 6 : frame === kPolicyFrame ? 7 : 0], call: [missed ? 1 : 0],
    self_x: [at('x', 6) + 0.3], self_y: [at('y', 6) + 0.4], self_age: [0],
    ball_x: [at('ball_x') + (frame === kWorstFrame ? 9 : 1)], ball_y: [at('ball_y')], ball_age: [frame % 4],
    own_reach: [5], teammate_reach: [-1], opponent_reach: [12],
    age: Array.from({length: 22}, (_, slot) => (slot === 6 || slot === 19 ? -1 : slot)),
    x: Array.from({length: 22}, (_, slot) => at('x', slot) + 2), y: Array.from({length: 22}, (_, slot) => at('y', slot)),
    other_id: [77], other_side: [-1], other_age: [3], other_x: [1], other_y: [2],
  };
  return {numbers, reply: missed ? '' : `f body_smart_kick target_point=(1, 2)\ne body_go_to_point target_point=(3, 4)\ns ${text}\n`,
    commands: `(dash 100)(turn_neck ${frame})`, plan: kPlans[frame] ?? '',
    drawings: frame === kDrawnFrame ? kSampleDrawings + `1 M ${text}\n` : '', latency: 1500 + frame};
}

const kUnits = [1000, 100, 10, 1];

/** Writes the texts of one kind; `shapes` keeps what came before. */
function textColumn(writer, texts, shapes) {
  const fresh = [];
  const parts = texts.map((text) => {
    const numbers = [];
    const shape = text.replace(/-?(?:0|[1-9]\d{0,4})(?:\.\d{1,3})?/g, (number) => {
      const sign = /^-[0.]+$/.test(number) ? '-' : '';
      numbers.push(number.slice(sign.length));
      return `${sign}\x01`;
    });
    if (!shapes.has(shape)) {
      shapes.set(shape, {id: shapes.size, last: numbers.map(() => 0)});
      fresh.push(shape);
    }
    return {...shapes.get(shape), numbers};
  });
  writer.varint(fresh.length);
  for (const shape of fresh) writer.string(shape);
  for (const {id} of parts) writer.varint(id);
  for (const {id, last} of shapes.values()) {
    for (let place = 0; place < last.length; ++place) {
      for (const part of parts) if (part.id === id) writeNumber(writer, part.numbers[place], last, place);
    }
  }
}

function writeNumber(writer, text, last, place) {
  const decimals = text.includes('.') ? text.length - text.indexOf('.') - 1 : 0;
  const unit = kUnits[decimals];
  const thousandths = Math.round(Number(text) * 1000);
  const step = thousandths / unit - Math.floor((2 * last[place] + unit) / (2 * unit));
  writer.varint(4 * (step >= 0 ? 2 * step : -2 * step - 1) + decimals);
  last[place] = thousandths;
}

/** The integers of a column: series after series. */
function columnValues(row, decisions) {
  return Array.from({length: row.series}, (_, s) => decisions.map(({numbers}) => Math.round((numbers[row.name][s] ?? 0) * (row.scale ?? 1))));
}

function writeColumn(writer, row, values, states) {
  const changes = [];
  let entry = 0;
  let last = -1;
  values.forEach((series, s) => {
    const state = states[s];
    for (const value of series) {
      const delta = value - state.p;
      if (row.coding === 'd1') writer.zigzag(delta);
      if (row.coding === 'd2') writer.zigzag(delta - state.d);
      if (row.coding === 'c' && delta !== 0) {
        changes.push([entry - last - 1, delta]);
        last = entry;
      }
      state.d = delta;
      state.p = value;
      ++entry;
    }
  });
  if (row.coding !== 'c') return;
  writer.varint(changes.length);
  for (const [gap, delta] of changes) {
    writer.varint(gap);
    writer.zigzag(delta);
  }
}

/** A whole stream; `text` is an action that the Playmaker requested and the proxy skipped. */
export function sampleDecisionStream(text = 'body_turn_to_ball') {
  const columns = sampleColumns();
  const states = new Map(kDecisionColumns.map((row) => [row.name, Array.from({length: row.series}, () => ({p: 0, d: 0}))]));
  const chunks = [jsonChunk('H', {schema: 'cls.decisions/1', cls: '1.0', side: 'left', team: 'Azure', columns: kDecisionColumns})];
  const timing = [];
  const shapes = ['reply', 'commands', 'plan', 'drawings'].map(() => new Map());
  let lastLatency = 0;
  for (let first = 0; first < kFrames; first += 128) {
    const decisions = Array.from({length: Math.min(128, kFrames - first)}, (_, i) => sampleDecision(columns, first + i, text));
    const writer = new ByteWriter();
    writer.varint(7);
    writer.varint(decisions.length);
    for (const row of kDecisionColumns) writeColumn(writer, row, columnValues(row, decisions), states.get(row.name));
    chunks.push(chunk('B', writer.bytes));
    for (const [kind, name] of ['reply', 'commands', 'plan', 'drawings'].entries()) {
      const texts = new ByteWriter();
      for (const number of [7, decisions.length, kind]) texts.varint(number);
      textColumn(texts, decisions.map((decision) => decision[name]), shapes[kind]);
      chunks.push(chunk('W', texts.bytes));
    }
    const latencies = new ByteWriter();
    latencies.varint(7);
    latencies.varint(decisions.length);
    for (const {latency} of decisions) {
      latencies.zigzag(latency - lastLatency);
      lastLatency = latency;
    }
    timing.push(chunk('T', latencies.bytes));
  }
  const crc = crc32(Buffer.concat(chunks)).toString(16).padStart(8, '0');
  return Buffer.concat([...chunks, ...timing, jsonChunk('E', {decisions: kFrames, crc32: crc})]);
}
