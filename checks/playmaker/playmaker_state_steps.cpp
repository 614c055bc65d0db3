// Steps: edge-case States.
#include <fmt/format.h>

#include <limits>

#include "checks/playmaker/playmaker_subject.h"
#include "checks/playmaker/sample_states.h"

namespace cls::checks {
namespace {

Finding answered(PlaymakerSubject& subject, const protos::State& state, int agent = kAgent) {
  const Answer answer = ask(subject, agent, state);
  return finding(answer.status, fmt::format("{} actions", answer.actions.actions_size()));
}

// A Playmaker may refuse the State, but must survive it.
Finding refusable(PlaymakerSubject& subject, const protos::State& state) {
  const Answer answer = ask(subject, kAgent, state);
  return survives(subject, answer.status.ok() ? "accepted" : "refused");
}

// Requires an answer to an ordinary State after a change.
template <void (*kChange)(protos::State&)>
Finding with(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  kChange(state);
  return answered(subject, state);
}
template <void (*kChange)(protos::WorldModel&)>
Finding with(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  kChange(*state.mutable_world_model());
  return answered(subject, state);
}

void before_kick_off(protos::State& state) {
  forget_everything(state, 0.0f);
  protos::WorldModel& world = *state.mutable_world_model();
  world.set_cycle(0);
  world.set_game_mode_type(protos::BeforeKickOff);
  world.clear_their_team_name();
}

Finding every_mode(PlaymakerSubject& subject) {
  int asked = 0;
  for (int mode = 0; mode < protos::MODE_MAX; ++mode) {
    for (const protos::Side side : {protos::UNKNOWN, protos::LEFT, protos::RIGHT}) {
      protos::State state = subject.next_state(kAgent);
      protos::WorldModel& world = *state.mutable_world_model();
      world.set_game_mode_type(static_cast<protos::GameModeType>(mode));
      world.set_game_mode_side(side);
      world.set_is_our_set_play(side == protos::LEFT);
      world.set_is_their_set_play(side == protos::RIGHT);

      const Answer answer = ask(subject, kAgent, state);
      if (!answer.status.ok()) {
        return fail("{} of side {}: {}", protos::GameModeType_Name(world.game_mode_type()),
                    protos::Side_Name(side), to_text(answer.status));
      }
      ++asked;
    }
  }

  return pass("{} combinations of play mode and side", asked);
}

void right_side(protos::WorldModel& world) {
  world.set_our_side(protos::RIGHT);
  world.mutable_self()->set_side(protos::RIGHT);
}

Finding goalie(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(1);
  protos::WorldModel& world = *state.mutable_world_model();
  world.mutable_ball()->mutable_position()->set_x(-49.0f);
  world.mutable_self()->set_catch_probability(1.0f);
  return answered(subject, state, 1);
}

void kickable(protos::WorldModel& world) {
  *world.mutable_ball()->mutable_position() = world.self().position();
  world.mutable_self()->set_is_kickable(true);
  world.mutable_self()->set_dist_from_ball(0.0f);
  world.mutable_intercept_table()->set_self_reach_steps(0);
}

void tackling(protos::WorldModel& world) { world.mutable_self()->set_is_tackling(true); }

void exhausted(protos::WorldModel& world) {
  protos::Self& self = *world.mutable_self();
  self.set_stamina(0.0f);
  self.set_stamina_capacity(0.0f);
  self.set_effort(0.3f);
  self.set_recovery(0.5f);
  self.set_get_safety_dash_power(0.0f);
}

void penalties(protos::WorldModel& world) {
  world.set_is_penalty_kick_mode(true);
  world.set_game_mode_type(protos::PenaltyReady_);
  world.set_game_mode_side(protos::LEFT);
  protos::PenaltyKickState& penalty = *world.mutable_penalty_kick_state();
  penalty.set_current_taker_side(protos::LEFT);
  penalty.set_is_kick_taker(true);
}

void no_ball(protos::WorldModel& world) { world.clear_ball(); }
void nothing_seen(protos::State& state) { forget_everything(state, 0.0f); }
void infinite(protos::State& state) {
  forget_everything(state, std::numeric_limits<float>::infinity());
}

Finding not_a_number(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  forget_everything(state, std::numeric_limits<float>::quiet_NaN());
  return refusable(subject, state);
}

void alone(protos::WorldModel& world) {
  world.clear_teammates();
  world.clear_opponents();
  world.clear_our_players_dict();
  world.clear_their_players_dict();
  world.clear_helios_home_positions();
  world.mutable_intercept_table()->clear_self_intercept_info();
}

void nameless_players(protos::WorldModel& world) {
  auto& players = *world.mutable_their_players_dict();
  for (int i = 1; i <= 4; ++i) {
    players[-i] = players[i];
    players[-i].set_uniform_number(-1);
    players.erase(i);
    *world.add_unknowns() = players[-i];
  }
}

void crowded(protos::WorldModel& world) {
  for (int i = 0; i < 200; ++i) {
    *world.add_unknowns() = world.opponents(0);
    *world.mutable_intercept_table()->add_self_intercept_info() =
        world.intercept_table().self_intercept_info(0);
  }
}

void late_in_the_match(protos::WorldModel& world) {
  world.set_cycle(123456);
  world.set_left_team_score(99);
  world.set_right_team_score(100);
}

void back_in_time(protos::WorldModel& world) { world.set_cycle(1); }

Finding empty_world(PlaymakerSubject& subject) {
  protos::State state;
  *state.mutable_register_response() = subject.identity(kAgent);
  state.mutable_world_model();
  return refusable(subject, state);
}

Finding no_world(PlaymakerSubject& subject) {
  protos::State state;
  *state.mutable_register_response() = subject.identity(kAgent);
  return refusable(subject, state);
}

Finding no_identity(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  state.clear_register_response();
  return refusable(subject, state);
}

Finding unknown_client(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  state.mutable_register_response()->set_client_id(987654);
  return refusable(subject, state);
}

}  // namespace

std::vector<PlaymakerStep> state_steps() {
  return {
      {"before_kick_off", "The first States of a match contain no observations.",
       with<before_kick_off>},
      {"every_mode", "An unexpected play mode must not end the match.", every_mode},
      {"right_side", "Half of all matches are played on the right.", with<right_side>},
      {"goalie", "The goalie may catch, and has separate code in most teams.", goalie},
      {"kickable", "The code with the ball differs from the code without.", with<kickable>},
      {"tackling", "Decisions are requested for a tackling player too.", with<tackling>},
      {"exhausted", "Stamina and capacity can be 0: a possible division by zero.", with<exhausted>},
      {"penalties", "Shoot-outs decide knockout matches.", with<penalties>},
      {"no_ball", "The ball is an optional part of the State.", with<no_ball>},
      {"nothing_seen", "An age of 1000 means: never seen.", with<nothing_seen>},
      {"infinite_places", "Upstream's proxy sends infinity where something was never seen.",
       with<infinite>},
      {"not_a_number", "Invalid: an error is allowed, a crash ends the match.", not_a_number},
      {"nobody_else", "Teams may be incomplete; a single player in training sees no other.",
       with<alone>},
      {"nameless_players", "Players without uniform number are in the maps as -1, -2, ...",
       with<nameless_players>},
      {"200_unknown_players", "Repeated fields have no size limit.", with<crowded>},
      {"late_in_the_match", "Extra time and shoot-outs go beyond cycle 10000.",
       with<late_in_the_match>},
      {"back_in_time", "Every match starts again at cycle 1.", with<back_in_time>},
      {"older_interface", "Proxies of IDL 1.7 lack the newer fields.", with<remove_newer_fields>},
      {"later_interface", "Later proxies send unknown fields.", with<add_unknown_fields>},
      {"empty_world", "Every field of the world model is optional: a crash ends the match.",
       empty_world},
      {"no_world", "A State without a world model may be refused, but must not crash.", no_world},
      {"no_identity", "Other clients may call: a crash ends the match.", no_identity},
      {"unknown_client", "After a restart of the Playmaker every client id is unknown.",
       unknown_client},
  };
}

}  // namespace cls::checks
