// The decoder of the page: streams, columns, notes, corrupt data.
import assert from 'node:assert/strict';
import test from 'node:test';
import zlib from 'node:zlib';
import {bytesOfBase64} from '../../../viewer/web/src/base64.js';
import {completeRecord, completeness, readEmbedded} from '../../../viewer/web/src/embedded.js';
import {cycleLabel, frameOfCycle} from '../../../viewer/web/src/record.js';
import {StreamDecoder} from '../../../viewer/web/src/stream.js';
import {ByteReader} from '../../../viewer/web/src/varint.js';
import {kFrames, kGoalFrame, sampleColumns, sampleStream} from './sample_match.mjs';
import {chunk, jsonChunk, kColumns} from './stream_writer.mjs';

/** Decodes a stream in pieces of `size` bytes. */
function decoded(stream, size = stream.length) {
  const decoder = new StreamDecoder();
  for (let at = 0; at < stream.length; at += size) Array.from(decoder.push(stream.subarray(at, at + size)));
  return decoder;
}

function assertEqualsSample(record) {
  const expected = sampleColumns();
  for (const {name, series, scale} of kColumns) {
    for (let s = 0; s < series; ++s) {
      for (let frame = 0; frame < kFrames; ++frame) {
        const value = scale === undefined ? expected[name][s][frame] : Math.fround(expected[name][s][frame]);
        const actual = record.column(name)[s][frame];
        if (actual !== value && !(Number.isNaN(actual) && Number.isNaN(value))) assert.fail(`${name}[${s}][${frame}]: ${actual}, not ${value}`);
      }
    }
  }
}

test('ByteReader reads varints and signed numbers', () => {
  const reader = new ByteReader(Uint8Array.of(0x05, 0xac, 0x02, 0x03, 0x04));
  assert.equal(reader.varint(), 5);
  assert.equal(reader.varint(), 300);
  assert.equal(reader.zigzag(), -2);
  assert.equal(reader.zigzag(), 2);
  assert.throws(() => reader.varint(), RangeError);
});

test('bytesOfBase64 equals the encoding of node', () => {
  for (const length of [0, 1, 2, 3, 100, 1001]) {
    const bytes = Buffer.from(Array.from({length}, (_, i) => (i * 37) & 255));
    assert.deepEqual(Buffer.from(bytesOfBase64(bytes.toString('base64'))), bytes);
  }
});

test('StreamDecoder restores every value of every column', () => {
  const decoder = decoded(sampleStream());
  assert.equal(decoder.record.frames, kFrames);
  assert.equal(decoder.corrupt, false);
  assertEqualsSample(decoder.record);
});

test('StreamDecoder restores the same from chunks of 1, 7 and 50 frames', () => {
  for (const size of [1, 7, 50]) assertEqualsSample(decoded(sampleStream({size})).record);
});

test('StreamDecoder leaves columns for later, whatever asks for them first', async () => {
  const deferred = (stream) => {
    const decoder = new StreamDecoder(true);
    Array.from(decoder.push(stream));
    return decoder.record;
  };
  assertEqualsSample(deferred(sampleStream()));
  assertEqualsSample(deferred(sampleStream({size: 50})));
  const backwards = deferred(sampleStream());
  for (const {name} of [...kColumns].reverse()) backwards.column(name);
  assertEqualsSample(backwards);
  const record = deferred(sampleStream());
  const waiting = () => [...record.columns.values()].filter(({pending}) => pending).length;
  assert.ok(waiting() > 20);
  await completeRecord(record);
  assert.equal(waiting(), 0);
  assert.ok([...record.columns.values()].every(({integers}) => integers.length === 0));
  assertEqualsSample(record);
});

test('StreamDecoder accepts bytes in any pieces', () => {
  assertEqualsSample(decoded(sampleStream({size: 50}), 1013).record);
});

test('StreamDecoder reads names, scores and statistics', () => {
  const {record} = decoded(sampleStream());
  assert.deepEqual(record.teamsAt(0).map(({name, score}) => [name, score]), [['Azure', 0], ['Amber', 0]]);
  assert.equal(record.teamsAt(kGoalFrame)[0].score, 1);
  assert.equal(record.statistics.goals.length, 1);
  assert.equal(record.end.frames, kFrames);
});

test('StreamDecoder skips chunks of unknown kinds', () => {
  const stream = sampleStream();
  assert.equal(decoded(Buffer.concat([stream, chunk('Z', [1, 2, 3])])).record.frames, kFrames);
});

test('StreamDecoder refuses a newer major version', () => {
  assert.throws(() => decoded(jsonChunk('H', {schema: 'cls.view/2', columns: []})), /format cls\.view\/2/);
});

test('StreamDecoder notices a changed byte', () => {
  const stream = Buffer.from(sampleStream());
  stream[stream.indexOf('Azure')] ^= 1;
  assert.equal(decoded(stream).corrupt, true);
});

test('StreamDecoder rejects corrupt streams without a hang', () => {
  const stream = sampleStream();
  let seed = 1;
  for (let round = 0; round < 60; ++round) {
    const bytes = Buffer.from(stream);
    for (let i = 0; i < 4; ++i) {
      seed = (seed * 1103515245 + 12345) % 2147483648;
      bytes[seed % bytes.length] = seed & 255;
    }
    try {
      const decoder = decoded(bytes);
      assert.ok(decoder.record === null || decoder.record.frames <= kFrames);
    } catch (error) {
      assert.ok(error instanceof Error);
    }
  }
});

test('readEmbedded reads the text of a page and reports progress', async () => {
  const fractions = [];
  const record = await readEmbedded(zlib.gzipSync(sampleStream()).toString('base64'), (fraction) => fractions.push(fraction));
  assert.equal(record.frames, kFrames);
  assert.ok(fractions.length >= 1);
});

test('readEmbedded says what is wrong with the data', async () => {
  await assert.rejects(readEmbedded('AAAA', () => {}), /does not inflate/);
  await assert.rejects(readEmbedded(zlib.gzipSync(Buffer.alloc(0)).toString('base64'), () => {}), /no match/);
});

test('completeness is the share of the data element', () => {
  assert.equal(completeness('AAAA', 8), 0.5);
  assert.equal(completeness('AAAA', 4), 1);
});

test('frameOfCycle finds cycles and stopped cycles', () => {
  const {record} = decoded(sampleStream());
  assert.equal(frameOfCycle(record, 50), 50);
  assert.equal(frameOfCycle(record, kGoalFrame), kGoalFrame);
  assert.equal(frameOfCycle(record, kGoalFrame, 7), kGoalFrame + 7);
  assert.equal(cycleLabel(record, kGoalFrame + 7), `${kGoalFrame}+7`);
  assert.equal(frameOfCycle(record, 99999), kFrames - 1);
});
