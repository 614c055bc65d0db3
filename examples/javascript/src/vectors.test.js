// The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py.
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { game, gameMethods, team, teamMethods } from './service.js';

const FOLDER = new URL('../../../fixtures/team/', import.meta.url);
const DECISIONS = { 12: 'GetCoachActions', 13: 'GetTrainerActions' };

/** The reply to one agent as a message. */
function parsed(reply) {
  assert.strictEqual(reply.code, 0, reply.error);
  const rpc = DECISIONS[reply.agent] ?? 'GetPlayerActions';
  return game[rpc].responseDeserialize(reply.message);
}

test('replies to recorded States', () => {
  const rpc = team.GetTeamActions;
  const request = rpc.requestDeserialize(readFileSync(new URL('states.bin', FOLDER)));
  const expected = rpc.responseDeserialize(readFileSync(new URL('replies.bin', FOLDER)));
  const response = teamMethods(gameMethods(true)).GetTeamActions(request);
  const actual = rpc.responseDeserialize(rpc.responseSerialize(response));
  assert.ok(expected.agents.length > 50);
  assert.strictEqual(actual.agents.length, expected.agents.length);
  expected.agents.forEach((reply, index) => {
    assert.deepStrictEqual(parsed(actual.agents[index]), parsed(reply), `State ${index}`);
  });
});
