//! The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py.
#![allow(dead_code)]
use prost::Message;

#[path = "../src/actions.rs"]
mod actions;
#[path = "../src/decide.rs"]
mod decide;
#[path = "../src/service.rs"]
mod service;
#[path = "../src/situation.rs"]
mod situation;
#[path = "../src/wire.rs"]
mod wire;
use protos::{CoachActions, PlayerActions, TrainerActions};
use service::Playmaker;
use team::{AgentReply, GetTeamActionsRequest, GetTeamActionsResponse};
use wire::{protos, team};

#[test]
fn replies_to_recorded_states() {
    let read = |name| std::fs::read(format!("../../fixtures/team/{name}")).unwrap();
    let request = GetTeamActionsRequest::decode(read("states.bin").as_slice()).unwrap();
    let expected = GetTeamActionsResponse::decode(read("replies.bin").as_slice()).unwrap();
    let actual = Playmaker { with_coach: true }.team_actions(&request);
    assert!(expected.agents.len() > 50);
    assert_eq!(actual.agents.len(), expected.agents.len());
    for (index, (actual, expected)) in actual.agents.iter().zip(&expected.agents).enumerate() {
        assert_eq!(actual.code, 0, "State {index}: {}", actual.error);
        match expected.agent {
            12 => same::<CoachActions>(index, actual, expected),
            13 => same::<TrainerActions>(index, actual, expected),
            _ => same::<PlayerActions>(index, actual, expected),
        }
    }
}

fn same<T>(index: usize, actual: &AgentReply, expected: &AgentReply)
where
    T: Message + Default + PartialEq + std::fmt::Debug,
{
    let parse = |reply: &AgentReply| T::decode(reply.message.as_slice()).unwrap();
    assert_eq!(parse(actual), parse(expected), "State {index}");
}
