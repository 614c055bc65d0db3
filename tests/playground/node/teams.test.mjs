// JavaScript teams: the objects of the JavaScript projects, and the match of such a project.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Messages } from '../../../playground/web/messages.js';
import { startMatch } from '../../../playground/web/teams.js';
import { logsOfCls, makeEngine, playOut } from './matches.mjs';

const example = fileURLToPath(new URL('../../../examples/javascript', import.meta.url));
const proto = fileURLToPath(new URL('../../../proto', import.meta.url));
const skip = existsSync(`${example}/node_modules/@grpc/proto-loader`)
  ? false : 'no packages of examples/javascript (examples/javascript/run build)';

/** The options of examples/javascript/src/service.js. */
const LOADER = { includeDirs: [proto], keepCase: true, longs: Number, enums: String, defaults: true,
  oneofs: true };

test('States are the objects that JavaScript projects get, and actions the bytes they send', { skip },
  async () => {
    const loader = createRequire(`${example}/package.json`)('@grpc/proto-loader');
    const service = loader.loadSync('playmaker.proto', LOADER)['protos.Game'];
    const engine = await makeEngine();
    const messages = new Messages(engine.schema());
    const { decide } = await import(`${example}/src/decide.js`);
    let compared = 0;
    const compare = (rpc, bytes) => {
      if (rpc !== 'GetPlayerActions') return undefined;
      const state = messages.decode('protos.State', bytes);
      assert.deepEqual(state, service[rpc].requestDeserialize(Buffer.from(bytes)));
      const reply = decide(state);
      const sent = messages.encode('protos.PlayerActions', reply);
      assert.deepEqual(service[rpc].responseDeserialize(Buffer.from(sent)),
        service[rpc].responseDeserialize(service[rpc].responseSerialize(reply)));
      compared += 1;
      return sent;
    };
    const match = engine.start({ left: 'function', right: 'mock', seed: 5, cycles: 60 }, [compare, null]);
    playOut(match);
    assert.equal(match.status().failure, '');
    assert.ok(compared >= 660, `${compared} States`);
  });

test('the JavaScript example plays the match that it plays under cls match', { skip }, async () => {
  const team = await import(`${example}/src/decide.js`);
  const engine = await makeEngine();
  const match = startMatch(engine, {
    left: team, right: 'mock:simple', leftName: 'Script', seed: 11, cycles: 150,
  });
  const logs = playOut(match);
  const expected = logsOfCls(`run:${example}/run --port {port} --coach`, 'mock:simple',
    ['--left-name', 'Script', '--seed', '11', '--cycles', '150']);
  assert.ok(logs.game.equals(expected.game), 'match.rcg');
  assert.ok(logs.text.equals(expected.text), 'match.rcl');
});

const schema = {
  enums: { Color: { RED: 0, BLUE: 1 } },
  messages: {
    Inner: [{ number: 1, name: 'x', type: 'double' }],
    Entry: [{ number: 1, name: 'key', type: 'int32' }, { number: 2, name: 'value', type: 'message', of: 'Inner' }],
    Outer: [
      { number: 1, name: 'number', type: 'int32' },
      { number: 2, name: 'text', type: 'string' },
      { number: 3, name: 'color', type: 'enum', of: 'Color' },
      { number: 4, name: 'inner', type: 'message', of: 'Inner' },
      { number: 5, name: 'list', type: 'int32', repeated: true },
      { number: 6, name: 'map', type: 'message', of: 'Entry', repeated: true, map: true },
      { number: 7, name: 'one', type: 'bool', oneof: 'choice' },
      { number: 80, name: 'other', type: 'message', of: 'Inner', oneof: 'choice' },
      { number: 9, name: 'float', type: 'float' },
    ],
  },
};

test('messages of all kinds come back as they were', () => {
  const messages = new Messages(schema);
  const roundTrip = (object) => messages.decode('Outer', messages.encode('Outer', object));
  const nothing = { number: 0, text: '', color: 'RED', inner: null, list: [], map: {}, float: 0 };
  assert.deepEqual(roundTrip({}), nothing);
  assert.deepEqual(roundTrip(undefined), nothing);
  const everything = {
    number: -7, text: 'Müller ⚽', color: 'BLUE', inner: { x: -0.1 }, list: [1, -2, 2147483647],
    map: { '-1': { x: 1 }, 11: { x: 0 } }, choice: 'other', other: { x: 2 }, float: 0.5,
  };
  assert.deepEqual(roundTrip(everything), everything);
  assert.deepEqual(roundTrip({ one: false }), { ...nothing, one: false, choice: 'one' });
  const long = { ...nothing, text: 'x'.repeat(20_000), list: Array.from({ length: 5000 }, (_, i) => i) };
  assert.deepEqual(roundTrip(long), long);
  // Enums may be numbers.
  assert.equal(roundTrip({ color: 1 }).color, 'BLUE');
});

test('fields of a newer interface are skipped', () => {
  const older = new Messages({
    enums: schema.enums, messages: { ...schema.messages, Outer: [schema.messages.Outer[1]] },
  });
  const bytes = new Messages(schema).encode('Outer', {
    number: 300, text: 'kept', inner: { x: 1 }, list: [1, 2], float: 2, map: { 1: { x: 1 } },
  });
  assert.deepEqual(older.decode('Outer', bytes), { text: 'kept' });
});

test('what is not an object or a list is named', () => {
  const messages = new Messages(schema);
  const error = (object) => () => messages.encode('Outer', object);
  assert.throws(error({ inner: 5 }), /TypeError: Outer\.inner: object expected/);
  assert.throws(error({ list: {} }), /TypeError: Outer\.list: array expected/);
  assert.throws(error({ map: 'x' }), /TypeError: Outer\.map: object expected/);
});
