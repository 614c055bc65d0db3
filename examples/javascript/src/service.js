// The services of a Playmaker: protos.Game, one call per agent and cycle, and
// cls.playmaker.v1.TeamPlaymaker, one call per team and cycle.
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import grpc from '@grpc/grpc-js';
import loader from '@grpc/proto-loader';
import * as decisions from './decide.js';

const COACH = 12;
const TRAINER = 13;

// Of a project, or of the source tree of cls.
const PROTO = ['../proto', '../../../proto'].map((path) => fileURLToPath(new URL(path, import.meta.url)))
  .find((folder) => existsSync(folder));
const definition = loader.loadSync(['playmaker.proto', 'team_playmaker.proto'], {
  includeDirs: [PROTO], keepCase: true, longs: Number, enums: String, defaults: true,
  oneofs: true,
});
const packages = grpc.loadPackageDefinition(definition);
export const game = packages.protos.Game.service;
export const team = packages.cls.playmaker.v1.TeamPlaymaker.service;

/** Replies to the calls of protos.Game, by name. An exception is the status of its call. */
export function gameMethods(withCoach) {
  return {
    Register: (request) => ({
      client_id: request.uniform_number,
      agent_type: request.agent_type,
      team_name: request.team_name,
      uniform_number: request.uniform_number,
      rpc_server_language_type: 'JAVE_SCRIPT',
    }),
    SendServerParams: () => ({}),
    SendPlayerParams: () => ({}),
    SendPlayerType: () => ({}),
    SendInitMessage: () => ({}),
    SendByeCommand: () => ({}),
    GetPlayerActions: (state) => decisions.decide(state),
    GetCoachActions: (state) => {
      if (!withCoach || !decisions.decideAsCoach) {
        const message = withCoach ? 'decide.js exports no decideAsCoach' : 'started without --coach';
        throw { code: grpc.status.UNIMPLEMENTED, message };
      }
      return decisions.decideAsCoach(state);
    },
    GetTrainerActions: (state) => decisions.decideAsTrainer(state),
    GetBestPlannerAction: bestPlannerAction,
  };
}

/** The node with the highest value; the lowest index among equal ones. */
function bestPlannerAction(request) {
  const nodes = Object.entries(request.pairs)
    .map(([index, node]) => ({ index: Number(index), value: node.evaluation }))
    .sort((a, b) => b.value - a.value || a.index - b.index);
  return { index: nodes.length > 0 ? nodes[0].index : -1 };
}

export function teamMethods(methods) {
  return {
    RegisterTeam: (request) => ({
      version: 1,
      agents: request.agents.map((agent) => reply(methods, 'Register', agent)),
    }),
    GetTeamActions: (request) => ({
      agents: request.agents.map((agent) => reply(methods, decisionOf(agent.agent), agent)),
    }),
    GetBestPlannerActions: (request) => ({
      agents: request.agents.map((agent) => reply(methods, 'GetBestPlannerAction', agent)),
    }),
    UnregisterTeam: (request) => {
      request.agents.forEach((agent) => reply(methods, 'SendByeCommand', agent));
      return {};
    },
  };
}

function decisionOf(agent) {
  if (agent === COACH) return 'GetCoachActions';
  return agent === TRAINER ? 'GetTrainerActions' : 'GetPlayerActions';
}

/** One agent's reply. What fails for one agent concerns the reply to that agent alone. */
function reply(methods, rpc, agent) {
  try {
    const { requestDeserialize, responseSerialize } = game[rpc];
    const message = responseSerialize(methods[rpc](requestDeserialize(agent.message)));
    return { agent: agent.agent, message };
  } catch (error) {
    const { code, message } = statusOf(rpc, error);
    return { agent: agent.agent, code, error: message };
  }
}

function statusOf(rpc, error) {
  if (typeof error.code === 'number') return error;
  console.error(`${rpc}:`, error);
  const place = /([\w.-]+\.js:\d+)/.exec(error?.stack ?? '');
  return { code: grpc.status.UNKNOWN, message: place ? `${error} (${place[1]})` : `${error}` };
}

/** Handlers for grpc.Server.addService. */
export function handlers(methods) {
  return Object.fromEntries(Object.entries(methods).map(([rpc, method]) => [
    rpc,
    (call, done) => {
      try {
        done(null, method(call.request));
      } catch (error) {
        done(statusOf(rpc, error));
      }
    },
  ]));
}
