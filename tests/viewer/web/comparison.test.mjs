// The common time axis of two matches.
import assert from 'node:assert/strict';
import test from 'node:test';
import {commonAxis, distances, frameAtMoment, momentOfFrame} from '../../../viewer/web/src/common_axis.js';

/** A record with one frame per [time, stopped]; player 1 stands at (x, 0). */
function recordOf(moments, x = 0) {
  const columns = {state: [moments.map(() => 1)], x: [moments.map(() => x)], y: [moments.map(() => 0)], ball_x: [moments.map(() => 0)], ball_y: [moments.map(() => 0)]};
  const empty = moments.map(() => 0);
  return {frames: moments.length, time: (frame) => moments[frame][0], stopped: (frame) => moments[frame][1], column: (name) => new Proxy(columns[name], {get: (rows, slot) => rows[slot] ?? empty})};
}

test('Equal clocks have one axis', () => {
  const record = recordOf([[0, 0], [1, 0], [1, 1], [2, 0]]);
  const axis = commonAxis(record, record);
  assert.equal(axis.length, 4);
  assert.deepEqual([...axis.frames[0]], [0, 1, 2, 3]);
  assert.deepEqual([...axis.frames[1]], [0, 1, 2, 3]);
});

test('A stopped clock of one match holds the other one', () => {
  const axis = commonAxis(recordOf([[1, 0], [1, 1], [1, 2], [2, 0]]), recordOf([[1, 0], [2, 0], [3, 0]]));
  assert.deepEqual([...axis.frames[0]], [0, 1, 2, 3, 3]);
  assert.deepEqual([...axis.frames[1]], [0, 0, 0, 1, 2]);
  assert.equal(momentOfFrame(axis, 1, 1), 3);
  assert.equal(momentOfFrame(axis, 0, 9), 4);
});

test('A match that starts late or is empty shows its first frame', () => {
  const axis = commonAxis(recordOf([[1, 0], [2, 0]]), recordOf([[2, 0]]));
  assert.deepEqual([...axis.frames[1]], [0, 0]);
  assert.equal(commonAxis(recordOf([]), recordOf([])).length, 0);
});

test('Between two moments only a match with two frames moves', () => {
  const axis = commonAxis(recordOf([[1, 0], [1, 1], [2, 0]]), recordOf([[1, 0], [2, 0]]));
  assert.equal(frameAtMoment(axis, 0, 0.5), 0.5);
  assert.equal(frameAtMoment(axis, 1, 0.5), 0);
  assert.equal(frameAtMoment(axis, 1, 1.25), 0.25);
  assert.equal(frameAtMoment(axis, 1, 2), 1);
});

test('The distance is the mean over ball and players', () => {
  const moments = [[1, 0], [2, 0]];
  const axis = commonAxis(recordOf(moments), recordOf(moments));
  assert.deepEqual([...distances(axis, recordOf(moments), recordOf(moments))], [0, 0]);
  assert.deepEqual([...distances(axis, recordOf(moments, 4), recordOf(moments))], [2, 2]);
});
