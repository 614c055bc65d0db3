// The engine in WebAssembly plays the matches of the native program, byte by byte.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { logsOfCls, makeEngine, playOut } from './matches.mjs';

// Whole matches with CLS_FULL; else long enough for a choice among plans of equal rank (cycle 526).
const WHOLE = process.env.CLS_FULL === '1';
const LENGTH = WHOLE ? {} : { cycles: 600 };
const OPTIONS = WHOLE ? [] : ['--cycles', '600'];

function assertSame(actual, expected, what) {
  assert.ok(actual.length > 100_000, `${what}: ${actual.length} bytes`);
  const size = Math.min(actual.length, expected.length);
  const same = actual.equals(expected);
  const at = same ? 0 : actual.subarray(0, size).findIndex((byte, i) => byte !== expected[i]);
  const near = expected.subarray(Math.max(0, at - 200), at + 100).toString();
  assert.ok(same, `${what} differs at byte ${at} of ${expected.length}, near ${near}`);
}

test('the engine can reach nothing but decisions, clock and the text of a failed assertion', () => {
  const module = new WebAssembly.Module(readFileSync(process.env.CLS_ENGINE));
  const imports = WebAssembly.Module.imports(module).map(({ module: from, name }) => `${from}.${name}`);
  assert.deepEqual(imports.sort(), [
    'cls.decide',
    'env.__syscall_getuid32', // fails: for the home folder of a user
    'env.emscripten_notify_memory_growth',
    'wasi_snapshot_preview1.clock_time_get',
    'wasi_snapshot_preview1.environ_get', // empty
    'wasi_snapshot_preview1.environ_sizes_get',
    'wasi_snapshot_preview1.fd_close', // fail but for text of an assertion
    'wasi_snapshot_preview1.fd_read',
    'wasi_snapshot_preview1.fd_seek',
    'wasi_snapshot_preview1.fd_write',
    'wasi_snapshot_preview1.proc_exit',
  ]);
});

for (const side of ['mock:planner', 'mock:simple']) {
  test(`a match of ${side} has the bytes of cls match`, async () => {
    const engine = await makeEngine();
    const match = engine.start({ left: side, right: side, seed: 7, ...LENGTH });
    const logs = playOut(match);
    const expected = logsOfCls(side, side, ['--seed', '7', ...OPTIONS]);
    assertSame(logs.game, expected.game, 'match.rcg');
    assertSame(logs.text, expected.text, 'match.rcl');

    const status = match.status();
    assert.equal(status.over, true);
    assert.equal(status.failure, '');
    assert.equal(status.left.name, `${side.slice(5)}_l`);
  });
}

test('names, seed and settings have the bytes of cls match', async () => {
  const engine = await makeEngine();
  const match = engine.start({
    left: 'mock', right: 'mock:simple', leftName: 'Blue', rightName: 'Red', seed: 123456789,
    cycles: 200, set: ['server::game_log_version=5', 'player::pt_max=2'],
  });
  const expected = logsOfCls('mock', 'mock:simple', ['--left-name', 'Blue', '--right-name', 'Red',
    '--seed', '123456789', '--cycles', '200', '--set', 'server::game_log_version=5',
    '--set', 'player::pt_max=2']);
  const logs = playOut(match);
  assertSame(logs.game, expected.game, 'match.rcg');
  assert.deepEqual(logs.text, expected.text);
});

test('matches of one engine take turns and do not disturb each other', async () => {
  const engine = await makeEngine();
  const setup = { left: 'mock:planner', right: 'mock:simple', seed: 3, cycles: 60 };
  const alone = playOut(engine.start(setup));
  const [one, other] = [engine.start(setup), engine.start({ ...setup, seed: 4 })];
  const first = [];
  while (one.play(5)) {
    other.play(3);
    first.push(one.takeGameLog());
  }
  first.push(one.takeGameLog());
  assert.ok(Buffer.concat(first).equals(alone.game));
  assert.ok(!playOut(other).game.equals(alone.game));
  one.close();
  other.close();
});

test('the stream of the viewer grows with the match and ends with it', async () => {
  const engine = await makeEngine();
  const match = engine.start({ left: 'mock', right: 'mock', cycles: 50, view: true });
  match.play(110); // the first frame is that of the kick-off
  const first = Buffer.from(match.takeView());
  assert.equal(first[0], 'H'.charCodeAt(0));
  assert.match(first.toString('latin1'), /cls\.view\/1/);
  const rest = playOut(match).view;
  assert.match(rest.subarray(-60).toString('latin1'), /"crc32":"[0-9a-f]{8}"/);
});

test('what is wrong with a setup is an error of one line', async () => {
  const engine = await makeEngine();
  assert.throws(() => engine.start({ left: 'mock:plannr', right: 'mock' }), /planner/);
  assert.throws(() => engine.start({ left: 'mock' }), /'right' is missing/);
  assert.throws(() => engine.start({ left: 'mock', right: 'mock', set: ['server::half_tim=1'] }),
    /half_time/);
  // An engine goes on after an error.
  assert.equal(engine.start({ left: 'mock', right: 'mock', cycles: 1 }).play(10_000), false);
});

test('a function decides, and one that fails ends the match with its line', async () => {
  const engine = await makeEngine();
  let states = 0;
  const empty = () => new Uint8Array();
  const counts = (rpc, state) => {
    if (rpc !== 'GetPlayerActions') return undefined;
    states += 1;
    assert.ok(state.length > 1000);
    return empty();
  };
  const match = engine.start({ left: 'function', right: 'mock', cycles: 10 }, [counts, null]);
  playOut(match);
  assert.ok(states >= 110, `${states} decisions`);
  assert.equal(match.status().failure, '');

  const fails = (rpc) => {
    if (rpc !== 'GetPlayerActions') return undefined;
    return null.place;
  };
  const failing = engine.start({ left: 'mock', right: 'function' }, [null, fails]);
  playOut(failing);
  const { failure, warnings, cycle } = failing.status();
  assert.match(failure, /function: player \d+ had no usable reply to 21 calls in a row/);
  assert.match(failure, /TypeError.*\(engine\.test\.mjs:\d+\)/);
  assert.ok(warnings.some((line) => line.includes('TypeError')));
  assert.ok(cycle < 50);
});

test('a reply that is not a message is the fault of its team', async () => {
  const engine = await makeEngine();
  const garbage = (rpc) => (rpc === 'GetPlayerActions' ? new Uint8Array([255, 255, 255]) : undefined);
  const match = engine.start({ left: 'function', right: 'mock' }, [garbage, null]);
  playOut(match);
  assert.match(match.status().failure, /GetPlayerActions: the reply does not parse/);
});

test('decisions are a stream for each side, if the setup asks for them', async () => {
  const engine = await makeEngine();
  const setup = { left: 'mock:simple', right: 'mock:hold', cycles: 5 };
  const match = engine.start({ ...setup, decisions: true });
  playOut(match);
  for (const side of [0, 1]) {
    const stream = Buffer.from(match.takeDecisions(side)).toString('latin1');
    assert.match(stream, new RegExp(`cls\\.decisions/1.*"side":"${['left', 'right'][side]}"`));
    assert.match(stream.slice(-60), /"crc32":"[0-9a-f]{8}"/);
    assert.equal(match.takeDecisions(side).length, 0);
  }
  const without = engine.start(setup);
  playOut(without);
  assert.equal(without.takeDecisions(0).length, 0);
});

test('pairs have the seeds and the verdict of cls compare', async () => {
  const engine = await makeEngine();
  const seeds = [1, 2, 3].map((pair) => engine.pairSeed(7, pair));
  assert.equal(new Set(seeds).size, 3);
  assert.ok(seeds.every((seed) => Number.isInteger(seed) && seed >= 0 && seed < 2 ** 31), `${seeds}`);
  assert.equal(engine.verdict([]).decision, 'open');
  const verdict = engine.verdict([4, 4, 4, 4, 4, 4, 4, 4]);
  assert.equal(verdict.decision, 'H1');
  assert.equal(verdict.pairs, 6);
  assert.deepEqual(verdict.outcomes, [0, 0, 0, 0, 6]);
  assert.throws(() => engine.verdict([5]), /\/0/);
});
