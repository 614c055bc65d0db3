// Selects the formation and limits positions by offside and kick-off rules.
#include "player/movement/home_positions.h"

#include <algorithm>

#include "base/index.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

FormationKind in_open_play(const WorldModel& world) {
  constexpr int kClearly = 2;
  const int our_cycles = world.intercept.our_steps();
  const int their_cycles = world.intercept.first_opponent_steps;
  if (their_cycles <= our_cycles - kClearly) return FormationKind::kDefense;
  if (our_cycles <= their_cycles - kClearly) return FormationKind::kOffense;
  return FormationKind::kNormal;
}

bool in_a_penalty_area(Vec2 ball) {
  return std::fabs(ball.x) > soccer::kHalfLength - soccer::kPenaltyAreaLength &&
         std::fabs(ball.y) < soccer::kPenaltyAreaWidth / 2.0;
}

Vec2 ball_of_interest(const WorldModel& world) {
  const PlayMode kind = without_side(world.game.mode);
  const bool rolling = kind == PlayMode::kPlayOn || kind == PlayMode::kGoalKickLeft;
  return rolling ? first_reach_point(world) : world.ball.position;
}

/// Meters that field players stand ahead of the formation.
double shift_of(FormationKind kind, const PlannerParameters& parameters) {
  switch (kind) {
    case FormationKind::kNormal:
      return parameters.shift_normal;
    case FormationKind::kDefense:
      return parameters.shift_defense;
    case FormationKind::kOffense:
      return parameters.shift_offense;
    default:
      return 0.0;
  }
}

/// Maximum x that is not offside.
double farthest_x(const WorldModel& world) {
  if (before_play(world.game.mode)) return 0.0;
  const int our_cycles = world.intercept.our_steps();
  double line = world.lines.offside;
  if (our_cycles < 50) line = std::max(line, ball_after(world, our_cycles).x);
  return line - 1.0;
}

}  // namespace

FormationKind formation_kind(const WorldModel& world) {
  const PlayMode mode = world.game.mode;
  const bool our_set_play = is_set_play_of(world.game, world.our_side);
  const auto pick = [our_set_play](FormationKind our, FormationKind their) {
    return our_set_play ? our : their;
  };

  if (before_play(mode)) return FormationKind::kBeforeKickOff;
  if (world.game.goalie_catch) {
    return pick(FormationKind::kGoalieCatchOur, FormationKind::kGoalieCatchTheir);
  }

  switch (without_side(mode)) {
    case PlayMode::kPlayOn:
      return in_open_play(world);
    case PlayMode::kKickInLeft:
    case PlayMode::kCornerKickLeft:
      return pick(FormationKind::kKickInOur, FormationKind::kSetPlayTheir);
    case PlayMode::kGoalKickLeft:
      return pick(FormationKind::kGoalKickOur, FormationKind::kGoalKickTheir);
    case PlayMode::kBackPassLeft:
    case PlayMode::kIndirectFreeKickLeft:
      return pick(FormationKind::kIndirectOur, FormationKind::kIndirectTheir);
    case PlayMode::kFoulChargeLeft:
    case PlayMode::kFoulPushLeft:
      if (in_a_penalty_area(world.ball.position)) {
        return pick(FormationKind::kIndirectOur, FormationKind::kIndirectTheir);
      }
      [[fallthrough]];
    default:
      return pick(FormationKind::kSetPlayOur, FormationKind::kSetPlayTheir);
  }
}

TeamPoints home_positions(const WorldModel& world) {
  const FormationKind kind = formation_kind(world);
  TeamPoints points = world.formations->of(kind).positions(ball_of_interest(world));

  if (const double shift = shift_of(kind, *world.planner); shift != 0.0) {
    for (std::size_t i = 1; i < points.size(); ++i) points[i].x += shift;
  }

  const double max_x = farthest_x(world);
  for (Vec2& point : points) point = clamped_to_pitch({std::min(point.x, max_x), point.y});

  return points;
}

Vec2 own_home_position(const WorldModel& world) {
  return home_positions(world)[base::index(world.unum - 1)];
}

}  // namespace cls::player
