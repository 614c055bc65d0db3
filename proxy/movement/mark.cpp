// Who looks after whom, and from where.
#include "proxy/movement/mark.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

const Vec2 kOurGoal{-soccer::kHalfLength, 0.0};
constexpr int kStale = 12;

bool their_attack(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  const int ours = std::min(table.best_self_steps(), table.first_teammate_steps);
  const bool theirs = world.kickable_opponent() || table.first_opponent_steps < ours;
  const bool dead_ball = is_set_play_of(world.game, world.their_side());
  return (theirs || dead_ball) && first_reach_point(world).x < 5.0;
}

/// How far a player of ours has to the opponent, seen from where he is and from his place.
double way_to(const WorldModel& world, int unum, Vec2 home, Vec2 opponent) {
  constexpr double kHomeShare = 0.4;
  const PlayerState* mate = unum == world.unum ? nullptr : world.teammate(unum);
  Vec2 here = unum == world.unum ? world.self.position : home;
  if (mate != nullptr && mate->pos_count <= kStale) here = mate->position;
  return (1.0 - kHomeShare) * distance(here, opponent) + kHomeShare * distance(home, opponent);
}

}  // namespace

std::optional<Vec2> mark_point(const WorldModel& world, const TeamPoints& home,
                               const MarkRules& rules) {
  if (!their_attack(world) || world.goalie) return std::nullopt;
  const Vec2 ball = first_reach_point(world);
  FixedList<const PlayerState*, 22> attackers;
  for (const PlayerState& opponent : world.opponents) {
    constexpr double kHasBall = 2.5;
    if (opponent.goalie || opponent.ghost() || opponent.pos_count > kStale) continue;
    if (distance(opponent.position, kOurGoal) > rules.near_goal) continue;
    if (distance(opponent.position, ball) < kHasBall) continue;
    attackers.push_back(&opponent);
  }
  std::sort(attackers.begin(), attackers.end(), [](const PlayerState* a, const PlayerState* b) {
    return distance(a->position, kOurGoal) < distance(b->position, kOurGoal);
  });
  std::array<bool, soccer::kPlayersPerTeam> taken{};
  for (const PlayerState* attacker : attackers) {
    int marker = 0;
    double least = rules.from_home;
    for (int unum = 2; unum <= soccer::kPlayersPerTeam; ++unum) {
      const auto i = static_cast<std::size_t>(unum - 1);
      const double away = way_to(world, unum, home[i], attacker->position);
      if (taken[i] || unum == world.our_goalie_unum || away >= least) continue;
      least = away;
      marker = unum;
    }
    if (marker == 0) continue;
    taken[static_cast<std::size_t>(marker - 1)] = true;
    if (marker != world.unum) continue;
    const Vec2 there =
        attacker->position + (attacker->velocity_valid() ? attacker->velocity * 2.0 : Vec2{});
    return there + soccer::with_length(kOurGoal - there, rules.step);
  }
  return std::nullopt;
}

}  // namespace cls::proxy
