//! The services of a Playmaker: protos.Game, one call per agent and cycle, and
//! cls.playmaker.v1.TeamPlaymaker, one call per team and cycle.
use std::cell::Cell;
use std::panic::AssertUnwindSafe;

use prost::Message;
use tonic::{Request, Response, Status};

use crate::decide::{decide, decide_as_coach, decide_as_trainer};
use crate::protos::game_server::Game;
use crate::protos::*;
use crate::team::team_playmaker_server::TeamPlaymaker;
use crate::team::*;

type Reply<T> = Result<Response<T>, Status>;

const COACH: i32 = 12;
const TRAINER: i32 = 13;

#[derive(Clone, Copy)]
pub struct Playmaker {
    pub with_coach: bool,
}

fn register(request: RegisterRequest) -> RegisterResponse {
    RegisterResponse {
        client_id: request.uniform_number,
        agent_type: request.agent_type,
        team_name: request.team_name,
        uniform_number: request.uniform_number,
        rpc_server_language_type: RpcServerLanguageType::UnknownLanguage.into(),
    }
}

/// The node with the highest value; the lowest index among equal ones.
fn best_planner_action(request: &BestPlannerActionRequest) -> BestPlannerActionResponse {
    let mut nodes: Vec<_> = request.pairs.iter().map(|(&i, node)| (i, node.evaluation)).collect();
    nodes.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    BestPlannerActionResponse { index: nodes.first().map_or(-1, |node| node.0) }
}

#[tonic::async_trait]
impl Game for Playmaker {
    async fn register(&self, request: Request<RegisterRequest>) -> Reply<RegisterResponse> {
        Ok(Response::new(register(request.into_inner())))
    }

    async fn send_server_params(&self, _: Request<ServerParam>) -> Reply<Empty> {
        Ok(Response::new(Empty {}))
    }

    async fn send_player_params(&self, _: Request<PlayerParam>) -> Reply<Empty> {
        Ok(Response::new(Empty {}))
    }

    async fn send_player_type(&self, _: Request<PlayerType>) -> Reply<Empty> {
        Ok(Response::new(Empty {}))
    }

    async fn send_init_message(&self, _: Request<InitMessage>) -> Reply<Empty> {
        Ok(Response::new(Empty {}))
    }

    async fn send_bye_command(&self, _: Request<RegisterResponse>) -> Reply<Empty> {
        Ok(Response::new(Empty {}))
    }

    async fn get_player_actions(&self, state: Request<State>) -> Reply<PlayerActions> {
        caught(|| decide(state.get_ref())).map(Response::new)
    }

    async fn get_coach_actions(&self, state: Request<State>) -> Reply<CoachActions> {
        if !self.with_coach {
            return Err(Status::unimplemented("started without --coach"));
        }
        caught(|| decide_as_coach(state.get_ref())).map(Response::new)
    }

    async fn get_trainer_actions(&self, state: Request<State>) -> Reply<TrainerActions> {
        caught(|| decide_as_trainer(state.get_ref())).map(Response::new)
    }

    async fn get_best_planner_action(
        &self,
        request: Request<BestPlannerActionRequest>,
    ) -> Reply<BestPlannerActionResponse> {
        Ok(Response::new(best_planner_action(request.get_ref())))
    }
}

thread_local! {
    /// Of the last panic: "panicked at src/decide.rs:83:5: no plan".
    static PANIC: Cell<String> = const { Cell::new(String::new()) };
}

/// Prints panics as usual, and keeps message and place for the status of the call.
pub fn remember_panics() {
    let print = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        print(panic);
        PANIC.set(panic.to_string().replace('\n', " "));
    }));
}

/// A panic of a decision is the status of its call: one player's mistake costs one decision.
fn caught<R>(decide: impl FnOnce() -> R) -> Result<R, Status> {
    std::panic::catch_unwind(AssertUnwindSafe(decide))
        .map_err(|_| Status::unknown(PANIC.take()))
}

/// One agent's reply. What fails for one agent concerns the reply to that agent alone.
fn one<Q: Message + Default, R: Message>(
    agent: &AgentMessage,
    method: impl Fn(Q) -> Result<R, Status>,
) -> AgentReply {
    let request = Q::decode(agent.message.as_slice());
    let reply = request
        .map_err(|error| Status::invalid_argument(error.to_string()))
        .and_then(method);
    match reply {
        Ok(reply) => {
            AgentReply { agent: agent.agent, message: reply.encode_to_vec(), ..Default::default() }
        }
        Err(status) => AgentReply {
            agent: agent.agent,
            code: status.code() as i32,
            error: status.message().to_string(),
            ..Default::default()
        },
    }
}

impl Playmaker {
    pub fn team_actions(&self, request: &GetTeamActionsRequest) -> GetTeamActionsResponse {
        let decision = |agent: &AgentMessage| match agent.agent {
            COACH if !self.with_coach => one(agent, |_: State| -> Result<CoachActions, Status> {
                Err(Status::unimplemented("started without --coach"))
            }),
            COACH => one(agent, |state: State| caught(|| decide_as_coach(&state))),
            TRAINER => one(agent, |state: State| caught(|| decide_as_trainer(&state))),
            _ => one(agent, |state: State| caught(|| decide(&state))),
        };
        GetTeamActionsResponse {
            agents: request.agents.iter().map(decision).collect(),
            ..Default::default()
        }
    }
}

#[tonic::async_trait]
impl TeamPlaymaker for Playmaker {
    async fn register_team(
        &self,
        request: Request<RegisterTeamRequest>,
    ) -> Reply<RegisterTeamResponse> {
        let identity = |agent| one(agent, |registration| Ok(register(registration)));
        let agents = request.get_ref().agents.iter().map(identity).collect();
        Ok(Response::new(RegisterTeamResponse { version: 1, agents, ..Default::default() }))
    }

    async fn get_team_actions(
        &self,
        request: Request<GetTeamActionsRequest>,
    ) -> Reply<GetTeamActionsResponse> {
        Ok(Response::new(self.team_actions(request.get_ref())))
    }

    async fn get_best_planner_actions(
        &self,
        request: Request<GetBestPlannerActionsRequest>,
    ) -> Reply<GetBestPlannerActionsResponse> {
        let choice = |agent| one(agent, |tree| Ok(best_planner_action(&tree)));
        let agents = request.get_ref().agents.iter().map(choice).collect();
        Ok(Response::new(GetBestPlannerActionsResponse { agents }))
    }

    async fn unregister_team(
        &self,
        _: Request<UnregisterTeamRequest>,
    ) -> Reply<UnregisterTeamResponse> {
        Ok(Response::new(UnregisterTeamResponse {}))
    }
}
