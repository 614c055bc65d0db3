// Counts the kicks of a shoot-out and decides it.
#include "base/index.h"
#include "simulator/rules/penalty.h"

#include "simulator/referee/referee.h"

namespace cls::simulator {
namespace {

std::size_t index_of(Side side) { return side == Side::kRight ? 1 : 0; }

void announce_winner(World& world, Side side, Events& events) {
  announce(world, {"penalty_winner", side}, events);
  world.referee.penalty.decided = true;
}

void end_without_goals(World& world, Events& events) {
  if (!world.params().pen_random_winner) {
    announce(world, {"penalty_draw"}, events);
    world.referee.penalty.decided = true;
    return;
  }
  const Side side = world.random.shoot_out.uniform(0.0, 1.0) < 0.5 ? Side::kLeft : Side::kRight;
  world.team(side).won_coin_toss = true;
  announce_winner(world, side, events);
}

// Ends the shoot-out when a side can no longer catch up with its regular kicks.
void decide_early(World& world, int kicks, Side just_kicked, Events& events) {
  const int remaining = world.params().pen_nr_kicks - kicks / 2;
  const auto best = [&](Side side) {
    const bool has_one_less = kicks % 2 == 1 && side == just_kicked;
    return world.team(side).penalty_goals + remaining - (has_one_less ? 1 : 0);
  };
  if (best(Side::kLeft) < world.team(Side::kRight).penalty_goals) {
    announce_winner(world, Side::kRight, events);
    change_mode(world, PlayMode::kTimeOver, events);
  } else if (best(Side::kRight) < world.team(Side::kLeft).penalty_goals) {
    announce_winner(world, Side::kLeft, events);
  }
}

// For a neutral side, a miss sets the mode of the right side and counts for the left side.
void count(World& world, Side side, bool goal, Events& events) {
  const PlayMode mode = goal ? PlayMode::kPenaltyScoreLeft : PlayMode::kPenaltyMissLeft;
  const bool for_right = side == Side::kRight || (side == Side::kNeutral && !goal);
  change_mode(world, for_side(mode, for_right ? Side::kRight : Side::kLeft), events);
  Team& team = world.team(side == Side::kRight ? Side::kRight : Side::kLeft);
  ++team.penalty_kicks;
  if (goal) ++team.penalty_goals;

  const soccer::ServerParams& server = world.params();
  const int kicks = ++world.referee.penalty.kicks;
  // rcssserver compares with `>`: the draw comes one kick late
  // (docs/spec/simulation-model.md 15.1).
  if (kicks > 2 * (server.pen_nr_kicks + server.pen_max_extra_kicks)) {
    end_without_goals(world, events);
  } else if (kicks > 2 * server.pen_nr_kicks) {
    const int lead = world.team(Side::kLeft).penalty_goals - world.team(Side::kRight).penalty_goals;
    if (kicks % 2 == 0 && lead != 0) {
      announce_winner(world, lead > 0 ? Side::kLeft : Side::kRight, events);
    }
  } else {
    decide_early(world, kicks, world.referee.penalty.taker_side, events);
  }
}

}  // namespace

void count_goal(World& world, Side side, Events& events) { count(world, side, true, events); }

void count_miss(World& world, Side side, Events& events) { count(world, side, false, events); }

void record_kicker(World& world, Side side, const Player& kicker) {
  auto& kicked = world.referee.penalty.has_kicked[index_of(side)];
  kicked.set(base::index(kicker.unum));
  if (kicked.count() >= soccer::kPlayersPerTeam) kicked.reset();
}

bool has_kicked(const World& world, const Player& player) {
  return world.referee.penalty.has_kicked[index_of(player.side)].test(base::index(player.unum));
}

}  // namespace cls::simulator
