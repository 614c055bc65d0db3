// Changes of player types and goalies.
#include "simulator/referee/substitution.h"

#include <algorithm>

#include "base/index.h"
#include "simulator/referee/modes.h"
#include "simulator/world/roster.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::reply_of;
using soccer::ServerReply;
using soccer::WarningCode;

constexpr std::uint32_t kRetainedState = state::kStand | state::kGoalie | state::kDiscard;

int& used(World& world, Side side, int type) { return world.team(side).used[base::index(type)]; }

// Players have the default type until one is assigned, so it is not counted for them.
int on_field(const World& world, Side side, int type) {
  return static_cast<int>(std::ranges::count_if(world.players, [=](const Player& player) {
    return player.joined && player.side == side && player.substituted && player.type == type;
  }));
}

bool is_unlimited(const World& world, int type) {
  return type == 0 && world.rules->player.allow_mult_default_type;
}

bool is_after_the_match(const World& world) {
  return world.params().half_time >= 0 && world.clock.time >= world.rules->total_time;
}

// Returns no reply if the rules allow the substitution. Same order of checks as in rcssserver.
std::optional<ServerReply> reject_substitution(World& world, Side side, int unum, int type) {
  const soccer::PlayerParams& params = world.rules->player;
  if (world.mode == PlayMode::kPlayOn) return reply_of(WarningCode::kCannotSubstituteWhilePlayOn);
  if (is_after_the_match(world)) {
    return reply_of(WarningCode::kCannotSubstituteWhilePenaltyShootouts);
  }
  if (world.team(side).substitutions >= params.subs_max) {
    return reply_of(WarningCode::kNoSubstitutionsLeft);
  }

  if (type < 0 || type >= params.player_types) return reply_of(ErrorCode::kOutOfRangePlayerType);
  const int uses = used(world, side, type);
  if (uses > 0 && uses >= params.pt_max && !is_unlimited(world, type)) {
    return reply_of(WarningCode::kNoLeftOfThatType);
  }

  if (!find_player(world, side, unum)) return reply_of(WarningCode::kNoSuchPlayer);
  const Player& player = world.player(side, unum);
  const bool has_type = player.substituted && player.type == type;
  if (on_field(world, side, type) >= params.pt_max && !is_unlimited(world, type) && !has_type) {
    return reply_of(WarningCode::kMaxOfThatTypeOnField);
  }
  return std::nullopt;
}

void count_used(World& world, Side side) {
  world.team(side).used = {};
  for (const Player& player : world.players) {
    if (player.joined && player.side == side && player.substituted) {
      ++used(world, side, player.type);
    }
  }
}

void assign_type(World& world, Player& player, Events& events) {
  const int max_uses = world.rules->player.pt_max;
  const Side side = player.side;
  if (player.substituted && used(world, side, player.type) <= max_uses) return;

  for (int type = 0; type < world.rules->player.player_types; ++type) {
    if (used(world, side, type) >= max_uses) continue;
    if (player.substituted) --used(world, side, player.type);
    ++used(world, side, type);
    if (type != player.type) substitute(world, player.slot(), type, events);
    return;
  }
}

}  // namespace

void substitute(World& world, Slot slot, int type, Events& events) {
  Player& player = world.player(slot);
  player.type = type;
  player.substituted = true;
  player.cards = 0;
  player.state &= kRetainedState;
  recover(world, player);

  if (world.clock.time > 0) {
    ++world.team(player.side).substitutions;
    ++used(world, player.side, type);
  }

  report(events, world, TypeChanged{player.side, player.unum, type});
}

ServerReply change_type(World& world, Side side, int unum, int type, Events& events) {
  if (std::optional<ServerReply> refusal = reject_substitution(world, side, unum, type)) {
    return *std::move(refusal);
  }

  substitute(world, soccer::slot_of(side, unum), type, events);
  return soccer::OkChangePlayerType{{}, unum, type};
}

ServerReply change_type(World& world, const soccer::TrainerChangePlayerType& command,
                        Events& events) {
  const Side side = find_side(world, command.team);
  if (side == Side::kNeutral) return reply_of(WarningCode::kNoTeamFound);
  if (command.type < 0 || command.type >= world.rules->player.player_types) {
    return reply_of(ErrorCode::kOutOfRangePlayerType);
  }

  const std::optional<Slot> slot = find_player(world, side, command.unum);
  if (!slot) return reply_of(WarningCode::kNoSuchPlayer);

  substitute(world, *slot, command.type, events);
  return soccer::OkChangePlayerType{soccer::TeamName(command.team), command.unum, command.type};
}

ServerReply change_goalie(World& world, Side side, int unum, Events& events) {
  const PlayMode mode = world.mode;
  if (mode == PlayMode::kPlayOn) return reply_of(WarningCode::kCannotChangeGoalieWhilePlayOn);
  if (is_either(mode, PlayMode::kPenaltyReadyLeft) ||
      is_either(mode, PlayMode::kPenaltyTakenLeft)) {
    return reply_of(WarningCode::kCannotChangeGoalieWhilePenaltyTaken);
  }

  if (has_enabled_goalie(world, side)) return reply_of(ErrorCode::kGoalieAlreadyExists);
  const std::optional<Slot> slot = find_player(world, side, unum);
  if (!slot || !world.player(*slot).enabled) return reply_of(WarningCode::kNoSuchPlayer);

  Player& player = world.player(*slot);
  player.goalie = true;
  player.state = state::kStand | state::kGoalie;
  report(events, world, GoalieAppointed{side, unum});
  return soccer::OkChangePlayerType{{}, unum, std::nullopt};
}

void assign_types(World& world, Side side, Events& events) {
  if (!world.team(side).connected) return;

  count_used(world, side);
  const soccer::ServerParams& server = world.params();
  if (world.rules->player.allow_mult_default_type ||
      (server.nr_normal_halfs == 0 && server.nr_extra_halfs == 0)) {
    return;
  }

  for (const bool goalies : {true, false}) {
    for (Player& player : world.players) {
      if (player.joined && player.side == side && player.goalie == goalies) {
        assign_type(world, player, events);
      }
    }
  }
}

}  // namespace cls::simulator
