// An agent's world model as a State.
#include "proxy/messages/state_message.h"

#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "proxy/agent/player_agent.h"
#include "soccer/memory_channel.h"
#include "tests/proxy/messages/field_paths.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"
#include "tests/support/transcript.h"

namespace cls::proxy {
namespace {

using google::protobuf::util::MessageDifferencer;
using soccer::AngleDeg;
using Paths = std::set<std::string>;

player::PlayerState player(int id, soccer::Side side, int unum) {
  player::PlayerState player;
  player.id = id;
  player.side = side;
  player.unum = unum;
  player.unum_count = player.pos_count = player.seen_pos_count = player.heard_pos_count = 3;
  player.vel_count = player.seen_vel_count = player.body_count = player.face_count = 4;
  player.point_count = player.ghost_count = 1;
  player.goalie = player.kicking = player.tackling = true;
  player.type_id = 7;
  player.position = {10.0 + id, -5.0};
  player.velocity = player.seen_velocity = {0.3, 0.4};
  player.seen_position = player.heard_position = {9.0, -6.0};
  player.body = player.face = player.point_direction = AngleDeg(30.0);
  player.dist_from_self = player.dist_from_ball = 12.0;
  player.angle_from_self = player.angle_from_ball = AngleDeg(-40.0);
  player.ball_reach_steps = 15;
  return player;
}

void fill_everything(player::SelfState& self) {
  self.position = self.seen_position = {-20.0, 15.0};
  self.velocity = self.seen_velocity = {0.2, -0.1};
  self.body = AngleDeg(45.0);
  self.neck = AngleDeg(-30.0);
  self.pos_count = self.seen_pos_count = self.vel_count = self.seen_vel_count = 1;
  self.body_count = self.point_count = 2;
  self.stamina = 5000.0;
  self.capacity = 90000.0;
  self.point_direction = AngleDeg(80.0);
  self.card = soccer::Card::kYellow;
  self.type_id = 5;
  self.kicked = self.kickable = true;
  self.tackle_expires_in = 3;
  self.catch_time = 77;
  self.kick_rate = 0.02;
  self.catch_probability = self.tackle_probability = self.foul_probability = 0.5;
  self.safety_dash_power = 60.0;
}

void fill_everything(player::BallState& ball) {
  ball.position = {1.0, 2.0};
  ball.velocity = ball.seen_velocity = ball.heard_velocity = {-1.0, 0.5};
  ball.relative_position = ball.seen_position = ball.heard_position = {21.0, -13.0};

  ball.pos_count = ball.seen_pos_count = ball.heard_pos_count = 1;
  ball.vel_count = ball.seen_vel_count = ball.heard_vel_count = 2;
  ball.lost_count = ball.ghost_count = 1;
  ball.dist_from_self = 24.7;
  ball.angle_from_self = AngleDeg(-31.8);
}

void fill_everything(player::InterceptTable& table) {
  table.self_steps = 4;
  table.first_teammate_steps = 5;
  table.second_teammate_steps = 6;
  table.first_opponent_steps = 7;
  table.second_opponent_steps = 8;
  table.first_teammate_id = 1;
  table.second_teammate_id = 2;
  table.first_opponent_id = 3;
  table.second_opponent_id = 4;

  player::InterceptPlan plan;
  plan.kind = player::InterceptPlan::Kind::kTurnForwardDash;
  plan.turns = 1;
  plan.dashes = 3;
  plan.turn_angle = plan.dash_direction = 20.0;
  plan.dash_power = 100.0;
  plan.self_position = {3.0, 4.0};
  plan.ball_distance = 0.7;
  plan.stamina = 4800.0;
  table.plans.push_back(plan);
}

void fill_everything(player::GameState& game) {
  game.time = {3012, 4};
  game.see_time = 3012;
  game.mode = soccer::PlayMode::kPenaltySetupRight;
  game.mode_start = {3012, 2};
  game.last_set_play_start = 3000;
  game.set_play_count = 9;
  game.our_score = 2;
  game.their_score = 1;
  game.penalty = {soccer::Side::kLeft, soccer::Side::kRight, 1, 1, 1, 1, 3012};
}

/// The right team's number 10 in its first penalty kick; nothing is zero.
player::WorldModel full_world() {
  player::WorldModel world;
  world.our_side = soccer::Side::kRight;
  world.unum = 10;
  world.goalie = true;
  world.our_team_name = "us";
  world.their_team_name = "them";

  fill_everything(world.self);
  fill_everything(world.ball);
  fill_everything(world.intercept);
  fill_everything(world.game);
  world.teammates.push_back(player(1, soccer::Side::kRight, 4));
  world.opponents.push_back(player(3, soccer::Side::kLeft, 6));
  world.opponents.push_back(player(4, soccer::Side::kLeft, 0));
  world.unknowns.push_back(player(5, soccer::Side::kNeutral, 0));

  world.lines = {-30.0, 31.0, -32.0, 33.0, 34.0, 2};
  world.last_kick = {soccer::Side::kLeft, 8};
  world.kickable_teammate_id = 1;
  world.kickable_opponent_id = 3;
  world.our_goalie_unum = 1;
  world.their_goalie_unum = 12;
  return world;
}

HomePositions some_home() {
  HomePositions home;
  for (std::size_t i = 0; i < home.size(); ++i) home[i] = {-20.0 + static_cast<double>(i), 7.0};
  return home;
}

protos::State state_of(const player::WorldModel& world) {
  protos::State state;
  fill_state(world, some_home(), true, state);
  return state;
}

Paths without(Paths paths, const std::vector<std::string>& prefixes) {
  for (const std::string& prefix : prefixes) {
    std::erase_if(paths, [&](const std::string& path) { return path.starts_with(prefix); });
  }
  return paths;
}

TEST(StateMessage, SetsEveryField) {
  player::WorldModel world = full_world();
  protos::State state = state_of(world);
  Paths set;
  tests::add_field_paths(state, set);
  // Set plays, the left score and sets that exclude each other need a second look.
  world.game.mode = soccer::PlayMode::kKickInRight;
  tests::add_field_paths(state_of(world), set);
  world.game.mode = soccer::PlayMode::kKickInLeft;
  world.game.penalty.taker = soccer::Side::kRight;
  tests::add_field_paths(state_of(world), set);
  world.game.mode = soccer::PlayMode::kPenaltyTakenRight;
  tests::add_field_paths(state_of(world), set);

  Paths missing = without(tests::all_field_paths(*protos::State::descriptor()),
                          {
                              "register_response",  // the agent's own business
                              "full_world_model",   // never known
                              // Unknown by definition of the interface.
                              "world_model.self.heard_position.",
                              "world_model.self.ghost_count",
                              "world_model.self.id",
                              "world_model.self.uniform_number_count",
                              "world_model.intercept_table.self_intercept_info.value",
                              "world_model.helios_home_positions.dist",
                              "world_model.helios_home_positions.angle",
                              "world_model.unknowns.side",
                          });
  std::erase_if(missing, [&](const std::string& path) { return set.contains(path); });
  EXPECT_EQ(missing, Paths{});
}

TEST(StateMessage, WritesUnknownAsZeroWithAge1000) {
  player::WorldModel world;
  world.unum = 4;
  const protos::State state = state_of(world);

  EXPECT_FALSE(tests::has_unreal_number(state));

  const protos::WorldModel& model = state.world_model();
  EXPECT_EQ(model.self().pos_count(), 1000);
  EXPECT_TRUE(model.self().has_position());
  EXPECT_EQ(model.ball().seen_pos_count(), 1000);
  EXPECT_EQ(model.ball().dist_from_self(), 1000.0F);
  EXPECT_EQ(model.intercept_table().self_reach_steps(), 1000);
  EXPECT_EQ(model.our_goalie_uniform_number(), -1);
  EXPECT_EQ(model.last_kicker_uniform_number(), -1);
  EXPECT_EQ(model.helios_home_positions_size(), 11);
  EXPECT_FALSE(model.has_penalty_kick_state());
  EXPECT_EQ(model.our_players_dict_size(), 1);
}

TEST(StateMessage, UsesSidesOfServer) {
  const protos::State state = state_of(full_world());
  const protos::WorldModel& model = state.world_model();
  EXPECT_EQ(model.our_side(), protos::RIGHT);
  EXPECT_EQ(model.our_team_score(), 2);
  EXPECT_EQ(model.left_team_score(), 1);
  EXPECT_EQ(model.right_team_score(), 2);
  EXPECT_EQ(model.game_mode_type(), protos::PenaltySetup_);
  EXPECT_EQ(model.game_mode_side(), protos::RIGHT);
  EXPECT_TRUE(model.penalty_kick_state().is_kick_taker()) << "number 10 takes the first kick";
  EXPECT_EQ(model.last_kick_side(), protos::LEFT);
}

TEST(StateMessage, ListsNumberedPlayersAndUsesNegativeKeysForOthers) {
  const protos::State state = state_of(full_world());
  const protos::WorldModel& model = state.world_model();

  ASSERT_EQ(model.opponents_size(), 1);
  EXPECT_EQ(model.opponents(0).uniform_number(), 6);
  ASSERT_EQ(model.their_players_dict_size(), 2);
  EXPECT_EQ(model.their_players_dict().at(-1).uniform_number(), -1);
  EXPECT_TRUE(MessageDifferencer::Equals(model.their_players_dict().at(6), model.opponents(0)));
  ASSERT_EQ(model.our_players_dict_size(), 2);

  const protos::Player& self = model.our_players_dict().at(10);
  EXPECT_EQ(self.id(), 0);
  EXPECT_EQ(self.dist_from_self(), 0.0F);
  EXPECT_EQ(self.position().x(), model.self().position().x());
  EXPECT_EQ(model.unknowns_size(), 1);
  EXPECT_EQ(model.unknowns(0).side(), protos::UNKNOWN);
}

TEST(StateMessage, ComputesLengthAndDirectionOfVectors) {
  const protos::State state = state_of(full_world());
  const protos::RpcVector2D& velocity = state.world_model().opponents(0).velocity();
  EXPECT_FLOAT_EQ(velocity.dist(), 0.5F);
  EXPECT_NEAR(velocity.angle(), 53.13, 0.01);
  EXPECT_NEAR(state.world_model().self().angle_from_ball(), 148.2, 0.01);
}

TEST(StateMessage, ClearsPreviousCycle) {
  protos::State reused;
  reused.mutable_register_response()->set_client_id(3);
  player::WorldModel crowded = full_world();

  for (int unum = 7; unum <= 11; ++unum) {
    crowded.opponents.push_back(player(unum, soccer::Side::kLeft, unum));
  }

  player::WorldModel lonely = full_world();
  lonely.opponents.clear();
  lonely.unknowns.clear();
  lonely.intercept.plans.clear();
  lonely.game.mode = soccer::PlayMode::kPlayOn;
  fill_state(crowded, some_home(), true, reused);
  fill_state(lonely, some_home(), false, reused);

  EXPECT_EQ(reused.register_response().client_id(), 3);
  reused.clear_register_response();
  protos::State fresh;
  fill_state(lonely, some_home(), false, fresh);
  EXPECT_TRUE(MessageDifferencer::Equals(reused, fresh));
}

TEST(StateMessage, MapsEveryPlayMode) {
  for (int mode = 0; mode < soccer::kPlayModeCount; ++mode) {
    player::WorldModel world;
    world.unum = 1;
    world.game.mode = static_cast<soccer::PlayMode>(mode);
    const protos::WorldModel model = state_of(world).world_model();
    const std::string name = protos::GameModeType_Name(model.game_mode_type());
    const bool sided = model.game_mode_side() != protos::UNKNOWN;
    EXPECT_EQ(name.back() == '_', sided) << mode << " " << name;
  }

  player::WorldModel world;
  world.unum = 1;
  world.game.mode = soccer::PlayMode::kFreeKickLeft;
  world.game.goalie_catch = true;

  EXPECT_EQ(state_of(world).world_model().game_mode_type(), protos::GoalieCatch_);
}

/// Replays the messages to a player of the recorded match and visits every State.
void replay(const std::string& player, const std::function<void(const protos::State&)>& show) {
  auto [ours, servers] = soccer::make_memory_channel();
  AgentOptions options;
  options.team_name = "PROXY";
  options.goalie = player == "l1_goalie";
  PlayerAgent agent(std::move(ours), options);
  const std::string text =
      tests::read_file(*tests::data("aligned/udp/player_" + player + ".txt.gz"));

  for (const tests::Spoken& spoken : tests::read_transcript(text)) {
    if (!spoken.by_server) continue;
    servers->send(spoken.message);
    agent.perceive();
    if (!agent.decision_due()) continue;
    show(agent.state());
    agent.act(protos::PlayerActions());
  }

  EXPECT_EQ(agent.server().errors.unreadable, 0) << agent.server().errors.first_unreadable;
}

/// States of upstream's proxy for the same messages.
std::vector<protos::State> upstream_states(const std::string& agent) {
  std::vector<protos::State> states;
  for (const std::string& message : tests::split_messages(tests::read_file(
           *tests::data("aligned/grpc/" + agent + ".GetPlayerActions.req.pb.gz")))) {
    EXPECT_TRUE(states.emplace_back().ParseFromString(message));
  }
  return states;
}

/// File names of the recorded players: of cls and of upstream.
const std::vector<std::pair<std::string, std::string>>& recorded_players() {
  static const std::vector<std::pair<std::string, std::string>> players = {
      {"l1_goalie", "1"}, {"l4", "4"}, {"l7", "7"}, {"l10", "10"}};
  return players;
}

/// Fields that follow from the messages without any estimate, by name.
std::map<std::string, double> facts_of(const protos::State& state) {
  const protos::WorldModel& model = state.world_model();

  const protos::Self& self = model.self();
  return {
      {"cycle", model.cycle()},
      {"time_stopped", model.time_stopped()},
      {"see_time", model.see_time()},
      {"game_mode_type", model.game_mode_type()},
      {"game_mode_side", model.game_mode_side()},
      {"stoped_cycle", model.stoped_cycle()},
      {"last_set_play_start_time", model.last_set_play_start_time()},
      {"set_play_count", model.set_play_count()},
      {"is_our_set_play", model.is_our_set_play()},
      {"is_their_set_play", model.is_their_set_play()},
      {"is_penalty_kick_mode", model.is_penalty_kick_mode()},
      {"has_penalty_kick_state", model.has_penalty_kick_state()},
      {"our_team_score", model.our_team_score()},
      {"right_team_score", model.right_team_score()},
      {"our_side", model.our_side()},
      {"has_team_name", model.our_team_name() == "PROXY"},
      {"has_their_name", model.their_team_name() == "HELIOS_R"},
      {"uniform_number", self.uniform_number()},
      {"is_goalie", self.is_goalie()},
      {"type_id", self.type_id()},
      {"stamina", self.stamina()},
      {"effort", self.effort()},
      {"recovery", self.recovery()},
      {"stamina_capacity", self.stamina_capacity()},
      {"view_width", self.view_width()},
      {"card", self.card()},
      {"catch_time", self.catch_time()},
      {"is_tackling", self.is_tackling()},
      {"is_kicking", self.is_kicking()},
      {"point_to_direction_count", self.point_to_direction_count()},
      {"get_safety_dash_power", self.get_safety_dash_power()},
  };
}

TEST(StateMessage, MatchesUpstreamWhereNoEstimateIsNeeded) {
  if (!tests::data("aligned/udp")) GTEST_SKIP() << "no data: set CLS_DATA";
  std::map<std::string, int> differing;
  for (const auto& [player, agent] : recorded_players()) {
    const std::vector<protos::State> theirs = upstream_states(agent);
    std::size_t i = 0;
    replay(player, [&, who = player](const protos::State& ours) {
      ASSERT_LT(i, theirs.size());
      // In its last decision, at time_over, upstream still sends the previous play mode.
      const std::size_t at = std::min(i, theirs.size() - 2);
      if (at != i++) return;
      const auto expected = facts_of(theirs[at]);
      for (const auto& [name, value] : facts_of(ours)) {
        if (value == expected.at(name) || ++differing[name] > 3) continue;
        ADD_FAILURE() << who << ", decision " << at << ": " << name << " is " << value
                      << " instead of " << expected.at(name);
      }
    });
    EXPECT_EQ(i, theirs.size());
  }

  EXPECT_EQ(differing, (std::map<std::string, int>{}));
}

TEST(StateMessage, SetsSameFieldsAsUpstream) {
  if (!tests::data("aligned/udp")) GTEST_SKIP() << "no data: set CLS_DATA";
  Paths ours;
  Paths theirs;

  for (const auto& [player, agent] : recorded_players()) {
    replay(player, [&](const protos::State& state) {
      EXPECT_FALSE(tests::has_unreal_number(state));
      tests::add_field_paths(state, ours);
    });
    for (const protos::State& state : upstream_states(agent)) {
      tests::add_field_paths(state, theirs);
    }
  }

  theirs = without(
      theirs, {
                  "register_response",
                  // Never set by definition; upstream has it infinite.
                  "world_model.self.heard_position.",
                  "world_model.intercept_table.self_intercept_info.value",
                  // Sensed in every cycle, so always of age 0; upstream counts from the last see.
                  "world_model.self.vel_count",
                  // Opponents of unknown type count as type 0.
                  "world_model.opponents.type_id",
                  // In this replay the ball was never missing at its expected position.
                  "world_model.ball.ghost_count",
              });

  Paths missing;
  for (const std::string& path : theirs) {
    if (ours.count(path) == 0) missing.insert(path);
  }

  EXPECT_GT(theirs.size(), 250U);
  EXPECT_EQ(missing, Paths{});
}

}  // namespace
}  // namespace cls::proxy
