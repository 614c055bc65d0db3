// The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py.
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { game, gameMethods, team, teamMethods } from './service';

const FOLDER = join(__dirname, '../../../../fixtures/team');
const DECISIONS = { 12: 'GetCoachActions', 13: 'GetTrainerActions' } as const;

/** The reply to one agent as a message. */
function parsed(reply: any): object {
  assert.strictEqual(reply.code, 0, reply.error);
  const rpc = DECISIONS[reply.agent as 12 | 13] ?? 'GetPlayerActions';
  return game[rpc].responseDeserialize(reply.message);
}

test('replies to recorded States', () => {
  const rpc = team.GetTeamActions;
  const request = rpc.requestDeserialize(readFileSync(join(FOLDER, 'states.bin')));
  const expected = rpc.responseDeserialize(readFileSync(join(FOLDER, 'replies.bin')));
  const response = teamMethods(gameMethods(true)).GetTeamActions(request);
  const serialize = rpc.responseSerialize as (message: object) => Buffer;
  const actual = rpc.responseDeserialize(serialize(response));
  assert.ok(expected.agents.length > 50);
  assert.strictEqual(actual.agents.length, expected.agents.length);
  expected.agents.forEach((reply, index) => {
    assert.deepStrictEqual(parsed(actual.agents[index]), parsed(reply), `State ${index}`);
  });
});
