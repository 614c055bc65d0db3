// The services of a Playmaker: protos.Game, one call per agent and cycle, and
// cls.playmaker.v1.TeamPlaymaker, one call per team and cycle.
import * as grpc from '@grpc/grpc-js';
import * as loader from '@grpc/proto-loader';
import { decide, decideAsCoach, decideAsTrainer } from './decide';
import { AgentMessage__Output } from './wire/cls/playmaker/v1/AgentMessage';
import { AgentReply } from './wire/cls/playmaker/v1/AgentReply';
import { GetTeamActionsRequest__Output } from './wire/cls/playmaker/v1/GetTeamActionsRequest';
import { RegisterTeamRequest__Output } from './wire/cls/playmaker/v1/RegisterTeamRequest';
import { ProtoGrpcType as GameTypes } from './wire/playmaker';
import { BestPlannerActionRequest__Output } from './wire/protos/BestPlannerActionRequest';
import { RegisterRequest__Output } from './wire/protos/RegisterRequest';
import { RegisterResponse } from './wire/protos/RegisterResponse';
import { State__Output } from './wire/protos/State';
import { ProtoGrpcType as TeamTypes } from './wire/team_playmaker';

const COACH = 12;
const TRAINER = 13;

const definition = loader.loadSync(['playmaker.proto', 'team_playmaker.proto'], {
  includeDirs: [process.env.PROTO!], keepCase: true, longs: Number, enums: String, defaults: true,
  oneofs: true,
});
const packages = grpc.loadPackageDefinition(definition) as unknown as GameTypes & TeamTypes;
export const game = packages.protos.Game.service;
export const team = packages.cls.playmaker.v1.TeamPlaymaker.service;

/** Replies to the calls of protos.Game, by name. An exception is the status of its call. */
export type Methods = Record<string, (request: any) => object>;

export function gameMethods(withCoach: boolean): Methods {
  return {
    Register: (request: RegisterRequest__Output): RegisterResponse => ({
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
    GetPlayerActions: (state: State__Output) => decide(state),
    GetCoachActions: (state: State__Output) => {
      if (!withCoach) {
        throw { code: grpc.status.UNIMPLEMENTED, message: 'started without --coach' };
      }
      return decideAsCoach(state);
    },
    GetTrainerActions: (state: State__Output) => decideAsTrainer(state),
    GetBestPlannerAction: bestPlannerAction,
  };
}

/** The node with the highest value; the lowest index among equal ones. */
function bestPlannerAction(request: BestPlannerActionRequest__Output): object {
  const nodes = Object.entries(request.pairs)
    .map(([index, node]) => ({ index: Number(index), value: node.evaluation }))
    .sort((a, b) => b.value - a.value || a.index - b.index);
  return { index: nodes.length > 0 ? nodes[0].index : -1 };
}

export function teamMethods(methods: Methods): Methods {
  return {
    RegisterTeam: (request: RegisterTeamRequest__Output) => ({
      version: 1,
      agents: request.agents.map((agent) => reply(methods, 'Register', agent)),
    }),
    GetTeamActions: (request: GetTeamActionsRequest__Output) => ({
      agents: request.agents.map((agent) => reply(methods, decisionOf(agent.agent), agent)),
    }),
    GetBestPlannerActions: (request: { agents: AgentMessage__Output[] }) => ({
      agents: request.agents.map((agent) => reply(methods, 'GetBestPlannerAction', agent)),
    }),
    UnregisterTeam: (request: { agents: AgentMessage__Output[] }) => {
      request.agents.forEach((agent) => reply(methods, 'SendByeCommand', agent));
      return {};
    },
  };
}

function decisionOf(agent: number): keyof typeof game & string {
  if (agent === COACH) return 'GetCoachActions';
  return agent === TRAINER ? 'GetTrainerActions' : 'GetPlayerActions';
}

/** One agent's reply. What fails for one agent concerns the reply to that agent alone. */
function reply(methods: Methods, rpc: keyof typeof game & string,
  agent: AgentMessage__Output): AgentReply {
  try {
    const request = game[rpc].requestDeserialize(agent.message);
    const serialize = game[rpc].responseSerialize as (message: object) => Buffer;
    return { agent: agent.agent, message: serialize(methods[rpc](request)) };
  } catch (error) {
    const { code, message } = statusOf(rpc, error);
    return { agent: agent.agent, code, error: message };
  }
}

function statusOf(rpc: string, error: any): { code: number; message: string } {
  if (typeof error.code === 'number') return error;
  console.error(`${rpc}:`, error);
  const place = /([\w.-]+\.ts:\d+)/.exec(error?.stack ?? '');
  return { code: grpc.status.UNKNOWN, message: place ? `${error} (${place[1]})` : `${error}` };
}

/** Handlers for grpc.Server.addService. */
export function handlers(methods: Methods): grpc.UntypedServiceImplementation {
  return Object.fromEntries(Object.entries(methods).map(([rpc, method]) => [
    rpc,
    (call: grpc.ServerUnaryCall<object, object>, done: grpc.sendUnaryData<object>) => {
      try {
        done(null, method(call.request));
      } catch (error) {
        done(statusOf(rpc, error));
      }
    },
  ]));
}
