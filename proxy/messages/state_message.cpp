// The world around the objects: match, teams, lines, ways to the ball.
#include "proxy/messages/state_message.h"

#include <string>

#include "proxy/messages/object_messages.h"
#include "soccer/play_mode.h"

namespace cls::proxy {
namespace {

constexpr float f(double value) { return static_cast<float>(value); }
constexpr int wire_unum(int unum) { return unum == 0 ? -1 : unum; }

// By number of the mode. drop_ball has no word of its own; play goes on in the same cycle.
constexpr std::array<protos::GameModeType, soccer::kPlayModeCount> kWireModes = {
    protos::BeforeKickOff,
    protos::BeforeKickOff,
    protos::TimeOver,
    protos::PlayOn,
    protos::KickOff_,
    protos::KickOff_,
    protos::KickIn_,
    protos::KickIn_,
    protos::FreeKick_,
    protos::FreeKick_,
    protos::CornerKick_,
    protos::CornerKick_,
    protos::GoalKick_,
    protos::GoalKick_,
    protos::AfterGoal_,
    protos::AfterGoal_,
    protos::PlayOn,
    protos::OffSide_,
    protos::OffSide_,
    protos::PenaltyKick_,
    protos::PenaltyKick_,
    protos::FirstHalfOver,
    protos::Pause,
    protos::Human,
    protos::FoulCharge_,
    protos::FoulCharge_,
    protos::FoulPush_,
    protos::FoulPush_,
    protos::FoulMultipleAttacker_,
    protos::FoulMultipleAttacker_,
    protos::FoulBallOut_,
    protos::FoulBallOut_,
    protos::BackPass_,
    protos::BackPass_,
    protos::FreeKickFault_,
    protos::FreeKickFault_,
    protos::CatchFault_,
    protos::CatchFault_,
    protos::IndFreeKick_,
    protos::IndFreeKick_,
    protos::PenaltySetup_,
    protos::PenaltySetup_,
    protos::PenaltyReady_,
    protos::PenaltyReady_,
    protos::PenaltyTaken_,
    protos::PenaltyTaken_,
    protos::PenaltyMiss_,
    protos::PenaltyMiss_,
    protos::PenaltyScore_,
    protos::PenaltyScore_,
    protos::IllegalDefense_,
    protos::IllegalDefense_};

protos::GameModeType wire_mode_of(const GameState& game) {
  return game.goalie_catch ? protos::GoalieCatch_ : wire_mode(game.mode);
}

void assign(std::string_view text, std::string* out) {
  if (*out != text) out->assign(text);
}

protos::InterceptActionType wire_plan_kind(InterceptPlan::Kind kind) {
  switch (kind) {
    case InterceptPlan::Kind::kOmniDash:
      return protos::OMNI_DASH;
    case InterceptPlan::Kind::kTurnForwardDash:
      return protos::TURN_FORWARD_DASH;
    case InterceptPlan::Kind::kTurnBackwardDash:
      return protos::TURN_BACKWARD_DASH;
  }
  return protos::UNKNOWN_Intercept_Action_Type;
}

// `value`, an evaluator's slot, stays unset: nothing has evaluated the plan.
void fill_plan(const InterceptPlan& plan, protos::InterceptInfo& out) {
  out.set_action_type(wire_plan_kind(plan.kind));
  out.set_turn_steps(plan.turns);
  out.set_turn_angle(f(plan.turn_angle));
  out.set_dash_steps(plan.dashes);
  out.set_dash_power(f(plan.dash_power));
  out.set_dash_dir(f(plan.dash_direction));
  fill(plan.self_position, *out.mutable_final_self_position());
  out.set_final_ball_dist(f(plan.ball_distance));
  out.set_final_stamina(f(plan.stamina));
}

// The next element to fill: an old one as long as there are any.
template <typename Message>
Message& element(google::protobuf::RepeatedPtrField<Message>& list, int index) {
  return index < list.size() ? *list.Mutable(index) : *list.Add();
}

template <typename Message>
void shrink(google::protobuf::RepeatedPtrField<Message>& list, int size) {
  while (list.size() > size) list.RemoveLast();
}

void fill_intercept(const InterceptTable& table, protos::InterceptTable& out) {
  out.set_self_reach_steps(table.self_steps);
  out.set_first_teammate_reach_steps(table.first_teammate_steps);
  out.set_second_teammate_reach_steps(table.second_teammate_steps);
  out.set_first_opponent_reach_steps(table.first_opponent_steps);
  out.set_second_opponent_reach_steps(table.second_opponent_steps);
  out.set_first_teammate_id(table.first_teammate_id);
  out.set_second_teammate_id(table.second_teammate_id);
  out.set_first_opponent_id(table.first_opponent_id);
  out.set_second_opponent_id(table.second_opponent_id);
  auto& plans = *out.mutable_self_intercept_info();
  int count = 0;
  for (const InterceptPlan& plan : table.plans) fill_plan(plan, element(plans, count++));
  shrink(plans, count);
}

using PlayerMessages = google::protobuf::RepeatedPtrField<protos::Player>;
using PlayerMap = google::protobuf::Map<google::protobuf::int32, protos::Player>;

// Keys that a team's dictionary may have: the numbers, and -1, -2, ... for those without.
constexpr int kLargestKey = 22;

// Removes entries of earlier cycles; `filled` tells which keys (shifted by kLargestKey) are new.
void forget_others(const std::array<bool, 2 * kLargestKey + 1>& filled, PlayerMap& map) {
  for (auto entry = map.begin(); entry != map.end();) {
    const bool keep = filled[static_cast<std::size_t>(entry->first + kLargestKey)];
    entry = keep ? std::next(entry) : map.erase(entry);
  }
}

// Players with a number go into the list and the dictionary, those without only into the latter.
// `self`: the agent's own entry, in the dictionary only.
void fill_team(const WorldModel& world, const PlayerList& players, bool with_self,
               PlayerMessages& list, PlayerMap& map) {
  std::array<bool, 2 * kLargestKey + 1> filled{};
  const auto entry = [&](int key) -> protos::Player& {
    filled[static_cast<std::size_t>(key + kLargestKey)] = true;
    return map[key];
  };
  int numbered = 0;
  int numberless = 0;
  for (const PlayerState& player : players) {
    if (!player.position_valid()) continue;
    const double decay = world.type_of(player).player_decay;
    protos::Player& keyed = entry(player.unum != 0 ? player.unum : --numberless);
    fill_player(player, decay, nullptr, keyed);
    if (player.unum != 0) fill_player(player, decay, &keyed, element(list, numbered++));
  }
  shrink(list, numbered);
  if (with_self) fill_self_as_player(world, entry(world.unum));
  forget_others(filled, map);
}

void fill_unknowns(const WorldModel& world, PlayerMessages& list) {
  int count = 0;
  for (const PlayerState& player : world.unknowns) {
    if (!player.position_valid()) continue;
    fill_player(player, world.type_of(player).player_decay, nullptr, element(list, count++));
  }
  shrink(list, count);
}

void fill_home(const HomePositions& home, protos::WorldModel& out) {
  auto& map = *out.mutable_helios_home_positions();
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const soccer::Vec2 point = home[static_cast<std::size_t>(unum - 1)];
    protos::RpcVector2D& entry = map[unum];
    entry.set_x(f(point.x));
    entry.set_y(f(point.y));
  }
}

void fill_penalty(const WorldModel& world, protos::WorldModel& out) {
  if (!soccer::is_penalty_mode(world.game.mode)) {
    out.clear_penalty_kick_state();
    return;
  }
  const PenaltyState& penalty = world.game.penalty;
  protos::PenaltyKickState& state = *out.mutable_penalty_kick_state();
  state.set_on_field_side(wire_side(penalty.field_side));
  state.set_current_taker_side(wire_side(penalty.taker));
  state.set_our_taker_counter(penalty.our_taken);
  state.set_their_taker_counter(penalty.their_taken);
  state.set_our_score(penalty.our_score);
  state.set_their_score(penalty.their_score);
  state.set_is_kick_taker(penalty.taker == world.our_side &&
                          world.unum == default_penalty_taker(penalty.our_taken));
  state.set_cycle(penalty.cycle);
}

void fill_game(const WorldModel& world, protos::WorldModel& out) {
  const GameState& game = world.game;
  const bool left = world.our_side == soccer::Side::kLeft;
  out.set_cycle(game.time.cycle);
  out.set_time_stopped(game.time.stopped);
  out.set_see_time(game.see_time);
  out.set_game_mode_type(wire_mode_of(game));
  out.set_game_mode_side(wire_side(game.mode_side()));
  out.set_stoped_cycle(game.mode_start.stopped);
  out.set_last_set_play_start_time(game.last_set_play_start);
  out.set_set_play_count(game.set_play_count);
  out.set_is_our_set_play(is_set_play_of(game, world.our_side));
  out.set_is_their_set_play(is_set_play_of(game, world.their_side()));
  out.set_is_penalty_kick_mode(soccer::is_penalty_mode(game.mode));
  out.set_our_team_score(game.our_score);
  out.set_their_team_score(game.their_score);
  out.set_left_team_score(left ? game.our_score : game.their_score);
  out.set_right_team_score(left ? game.their_score : game.our_score);
  out.set_last_kick_side(wire_side(world.last_kick.side));
  out.set_last_kicker_uniform_number(wire_unum(world.last_kick.unum));
  fill_penalty(world, out);
}

void fill_lines(const TeamLines& lines, protos::WorldModel& out) {
  out.set_offside_line_x(f(lines.offside));
  out.set_ofside_line_x_count(lines.offside_count);
  out.set_our_defense_line_x(lines.our_defense);
  out.set_their_defense_line_x(lines.their_defense);
  out.set_our_defense_player_line_x(lines.our_defense_players);
  out.set_their_defense_player_line_x(lines.their_defense_players);
}

void fill_teams(const WorldModel& world, protos::WorldModel& out) {
  assign(world.our_team_name.view(), out.mutable_our_team_name());
  assign(world.their_team_name.view(), out.mutable_their_team_name());
  out.set_our_side(wire_side(world.our_side));
  out.set_our_goalie_uniform_number(wire_unum(world.our_goalie_unum));
  out.set_their_goalie_uniform_number(wire_unum(world.their_goalie_unum));
  out.set_kickable_teammate_id(world.kickable_teammate_id);
  out.set_kickable_opponent_id(world.kickable_opponent_id);
  out.set_kickable_teammate_existance(world.kickable_teammate());
  out.set_kickable_opponent_existance(world.kickable_opponent());
  fill_team(world, world.teammates, !world.sideline, *out.mutable_teammates(),
            *out.mutable_our_players_dict());
  fill_team(world, world.opponents, false, *out.mutable_opponents(),
            *out.mutable_their_players_dict());
  fill_unknowns(world, *out.mutable_unknowns());
}

}  // namespace

protos::GameModeType wire_mode(soccer::PlayMode mode) {
  return kWireModes.at(static_cast<std::size_t>(mode));
}

void fill_coach_state(const WorldModel& world, soccer::CoachRole role, protos::State& out) {
  protos::WorldModel& model = *out.mutable_world_model();
  fill_ball(world.ball, *model.mutable_ball());
  fill_teams(world, model);
  fill_game(world, model);
  fill_lines(world.lines, model);
  if (role == soccer::CoachRole::kTrainer) model.set_our_side(protos::UNKNOWN);
}

void fill_state(const WorldModel& world, const HomePositions& home, bool need_preprocess,
                protos::State& out) {
  out.set_need_preprocess(need_preprocess);
  protos::WorldModel& model = *out.mutable_world_model();
  fill_self(world, *model.mutable_self());
  fill_ball(world.ball, *model.mutable_ball());
  fill_intercept(world.intercept, *model.mutable_intercept_table());
  fill_teams(world, model);
  fill_game(world, model);
  fill_lines(world.lines, model);
  fill_home(home, model);
}

}  // namespace cls::proxy
