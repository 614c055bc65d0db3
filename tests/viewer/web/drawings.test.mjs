// Texts and drawings of Playmakers without recorded decisions: entries of a debug log, and which frame they belong to.
import assert from 'node:assert/strict';
import test from 'node:test';
import {followDrawings} from '../../../viewer/web/src/drawing_data.js';
import {DrawingStore} from '../../../viewer/web/src/drawing_store.js';
import {DrawingFilter, drawingOfEntry} from '../../../viewer/web/src/drawings.js';
import {StreamDecoder} from '../../../viewer/web/src/stream.js';
import {kShownFrame, sampleDebugLog} from './sample_drawings.mjs';
import {kGoalFrame, sampleStream} from './sample_match.mjs';

function sampleRecord() {
  const decoder = new StreamDecoder();
  for (const _ of decoder.push(sampleStream()));
  return decoder.record;
}

function sampleStore(lines = sampleDebugLog()) {
  const store = new DrawingStore(sampleRecord(), new DrawingFilter());
  store.add('left', lines);
  return store;
}

const texts = (shown) => shown.map(({slot, drawing}) => `${slot} ${drawing.kind} ${drawing.text}`);

test('Entries of a debug log are read as decisions have them', () => {
  const entry = (fields) => ({t: 1, unum: 7, color: 'red', ...fields});
  assert.deepEqual(drawingOfEntry(entry({kind: 'circle', level: 'SHOOT', center: {x: 10, y: 5}, radius: 3, fill: true}), 'left'),
    {kind: 'circle', filled: true, level: 1024, numbers: [10, 5, 3], text: '', color: 'red'});
  assert.deepEqual(drawingOfEntry(entry({kind: 'arc', center: {x: 1, y: 2}, radius: 3, start_angle: 30, span_angel: 60}), 'right').numbers, [-1, -2, 3, 210, 60]);
  assert.deepEqual(drawingOfEntry(entry({kind: 'rectangle', left: 1, top: 2, length: 3, width: 4}), 'right').numbers, [-1, -2, -4, -6]);
  assert.deepEqual(drawingOfEntry(entry({kind: 'line', end: {x: 4}}), 'left').numbers, [0, 0, 4, 0]);
  assert.equal(drawingOfEntry(entry({kind: 'debug_client', message: 'x'}), 'left').kind, 'text');
  assert.equal(drawingOfEntry(entry({kind: 'text', level: 'ACTION_CHAIN'}), 'left').level, 1 << 19);
  for (const wrong of [null, 3, {}, entry({kind: 'toString'}), entry({kind: 'circle', radius: 'NaN'}), entry({kind: 'text', unum: 12}), {unum: 1, kind: 'text'}]) {
    assert.equal(drawingOfEntry(wrong, 'left'), null);
  }
});

test('DrawingStore has what players showed about a frame, stopped clock included', () => {
  const store = sampleStore();
  assert.deepEqual(texts(store.at(kShownFrame, [])), ['6 text pass to 9', '6 circle ', '8 message run here']);
  assert.deepEqual(texts(store.at(kShownFrame, [8])), ['8 message run here']);
  assert.deepEqual(store.at(kShownFrame + 1, []), []);
  assert.deepEqual(texts(store.at(kGoalFrame + 7, [])), ['8 rectangle ']);
  assert.deepEqual(store.at(kGoalFrame, []), []);
  assert.equal(store.omitted, 12);
  assert.deepEqual(store.levels.map(([, name]) => name), ['shoot', 'team', 'action chain']);
  assert.equal(store.next(0, 1, []), kShownFrame);
  assert.equal(store.next(kShownFrame, 1, [6]), -1);
  assert.equal(store.next(kGoalFrame + 7, -1, [6]), kShownFrame);
});

test('DrawingStore reads any lines', () => {
  const store = sampleStore('{"t":\n\nnull\n[]\n"x"\n{"t":1,"unum":1,"kind":"text","message":{}}\n');
  assert.equal(store.at(1, []).length, 1);
  assert.equal(sampleStore('').empty, true);
});

test('followDrawings reads a log that grows, in pieces that cut lines, until the match is over', async () => {
  const record = {isLive: true, frames: 0};
  const store = new DrawingStore(/** @type {any} */ (record), new DrawingFilter());
  const log = Buffer.from(sampleDebugLog('über'));
  let there = 0;
  const asked = [];
  globalThis.fetch = async (url) => {
    asked.push(url);
    const from = Number(/from=(\d+)/.exec(url)[1]);
    if (url.startsWith('drawings-right')) return new Response('', {status: 404});
    there = Math.min(log.length, there + 61);
    if (there === log.length) record.isLive = false;
    return new Response(log.subarray(from, there));
  };
  let changes = 0;
  await followDrawings('drawings', store, () => ++changes);
  assert.equal(store.moments.size, 3);
  assert.equal(store.moments.get(`${kShownFrame}+0`)[0].entry.message, 'über');
  assert.ok(changes > 3 && asked[0] === 'drawings-left?from=0');
});
