// Generates later actions with coarse checks.
#include <algorithm>
#include <array>
#include <cmath>

#include "player/planner/generator_parameters.h"
#include "player/planner/generators.h"
#include "player/world/places.h"
#include "soccer/directions.h"

namespace cls::player {
namespace {

constexpr CoarseParameters kNumbers = kGenerators.coarse;

double coarse_speed(double length) {
  if (length >= 20.0) return 2.5;
  if (length >= 8.0) return 2.0;
  return length >= 5.0 ? 1.8 : 1.5;
}

/// Cycles for a ball with that initial speed; kPlannerHorizon if it does not get there.
int ball_cycles(const PlannerField& field, double length, double speed) {
  for (int n = 1; n < kPlannerHorizon; ++n) {
    if (speed * field.roll(n) >= length) return n;
  }
  return kPlannerHorizon;
}

/// True if no opponent is within `degrees` of the pass lane.
bool lane_open(const PlannerField& field, Vec2 from, Vec2 way, double length, double degrees) {
  const double tangent = math::tan(math::to_radians(degrees));
  for (const FieldOpponent& opponent : field.opponents) {
    const Vec2 relative = opponent.position - from;
    const double along = dot(relative, way) / length;
    if (along <= 0.0 || along > length + 2.0) continue;
    if (std::fabs(cross(way, relative)) / length < along * tangent) return false;
  }

  return true;
}

struct Heading {
  AngleDeg angle;
  Vec2 unit;
};

const std::array<Heading, 8>& eight_headings() {
  static const std::array<Heading, 8> headings = [] {
    std::array<Heading, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const AngleDeg angle(45.0 * static_cast<double>(i));
      all[i] = {angle, soccer::polar(1.0, angle)};
    }
    return all;
  }();

  return headings;
}

}  // namespace

bool CoarseState::had_ball(int unum) const {
  for (int at = node; at >= 0; at = plan.at(at).parent) {
    if (plan.at(at).holder == unum) return true;
  }
  return false;
}

Vec2 CoarseState::position_of(const FieldPlayer& player) const {
  for (int at = node; at > 0; at = plan.at(at).parent) {
    if (plan.at(at).holder == player.unum) return plan.at(at).ball;
  }
  return player.position;
}

void add_simple_passes(const CoarseState& state, std::vector<PlanAction>& out) {
  const PlannerField& field = state.field;
  const PlanNode& now = state.now();
  for (const FieldPlayer& teammate : field.teammates) {
    if (teammate.unum == 0 || teammate.age > kNumbers.pass_age || teammate.ghost ||
        state.had_ball(teammate.unum)) {
      continue;
    }

    const Vec2 to = teammate.position;
    const Vec2 way = to - now.ball;
    const double length = way.length();
    if (length < kNumbers.min_pass || length > kNumbers.max_pass) continue;
    if (to.x > std::max(field.world.lines.offside, now.ball.x)) continue;
    if (to.x < kNumbers.own_x && std::fabs(to.y) < kNumbers.own_y) continue;
    if (nearest_opponent(field, to) < field.parameters.later_pass_room) continue;

    const double speed = coarse_speed(length);
    const bool back = teammate.goalie || way.x < 0.0;
    const double angle =
        (back ? kNumbers.back_lane_angle : kNumbers.lane_angle) * kNumbers.lane_speed / speed;
    if (!lane_open(field, now.ball, way, length, angle)) continue;

    out.push_back({.category = PlanCategory::kPass,
                   .tag = PlanTag::kSimplePass,
                   .sender = now.holder,
                   .target = teammate.unum,
                   .target_point = to,
                   .first_speed = speed,
                   .duration = ball_cycles(field, length, speed) + 2,
                   .kicks = 1});
  }
}

void add_simple_dribbles(const CoarseState& state, std::vector<PlanAction>& out) {
  const PlannerField& field = state.field;
  const PlanNode& now = state.now();
  const FieldPlayer* holder = field.our_player(now.holder);
  if (holder == nullptr || holder->age > kNumbers.dribble_age) return;

  for (const auto& [heading, unit] : eight_headings()) {
    constexpr DribbleSearchParameters kDribbles = kGenerators.dribble;
    if (heading.abs() > kDribbles.back_angle && now.ball.x < kDribbles.back_x) continue;
    for (double far = kNumbers.longest_dribble; far > 1.0; far -= kNumbers.dribble_step) {
      const Vec2 end = now.ball + unit * far;
      if (outside_pitch(end, kDribbles.inset)) continue;

      const int cycles = 2 + holder->reach->cycles(far - 0.5 * holder->control);
      const bool open = std::ranges::none_of(field.opponents, [&](const FieldOpponent& opponent) {
        const double grasp = opponent.control + opponent.reach->run(cycles + 1);
        return squared_distance(opponent.position, end) <= grasp * grasp;
      });
      if (!open) continue;

      out.push_back({.category = PlanCategory::kDribble,
                     .tag = PlanTag::kSimpleDribble,
                     .sender = now.holder,
                     .target = now.holder,
                     .target_point = end,
                     .duration = cycles,
                     .kicks = 1,
                     .dashes = cycles - 1});
    }
  }
}

bool can_shoot_from(const PlannerField& field, Vec2 ball, int holder, int max_age) {
  constexpr double kFar = 20.0;
  constexpr int kDirections = 15;
  const double range = field.parameters.shot_range;

  // A ball at no place, whose distance is not a number, is not in range.
  const bool in_range = squared_distance(ball, kOpponentGoal) <= range * range;
  if (!in_range || ball.x >= soccer::kHalfLength) return false;
  const FieldPlayer* player = field.our_player(holder);
  if (player == nullptr || player->age > max_age) return false;

  const bool self = holder == field.self.unum;
  const double min_gap = self ? field.parameters.shot_gap : field.parameters.shot_gap_teammate;
  const double post = field.world.server().goal_width / 2.0 - 0.5;

  const auto [low, high] = soccer::direction_pair(Vec2{kOpponentGoal.x, -post} - ball,
                                                  Vec2{kOpponentGoal.x, post} - ball);
  struct Shadow {
    double direction;
    double half_width;
  };

  base::FixedList<Shadow, 44> shadows;
  for (const FieldOpponent& opponent : field.opponents) {
    const Vec2 relative = opponent.position - ball;
    const double dist = relative.length();
    if (dist > kFar || relative.x < 0.0) continue;
    const auto [direction, width] =
        soccer::direction_pair(relative, {std::max(0.1, dist), opponent.control});
    shadows.push_back({direction, self ? width : 0.5 * width});
  }

  for (int i = 0; i < kDirections; ++i) {
    const double direction = low + (high - low) * i / (kDirections - 1);
    double gap = 180.0;
    for (const Shadow& shadow : shadows) {
      gap = std::min(gap, std::fabs(direction - shadow.direction) - shadow.half_width);
    }
    if (gap >= min_gap) return true;
  }
  return false;
}

void add_simple_shot(const CoarseState& state, std::vector<PlanAction>& out) {
  const PlanNode& now = state.now();
  if (!can_shoot_from(state.field, now.ball, now.holder, 10)) return;

  const double cycles = distance(now.ball, kOpponentGoal) / kNumbers.shot_speed;
  out.push_back({.category = PlanCategory::kShoot,
                 .tag = PlanTag::kSimpleShoot,
                 .sender = now.holder,
                 .target = now.holder,
                 .target_point = kOpponentGoal,
                 .first_speed = state.field.world.server().ball_speed_max,
                 .duration = std::max(1, static_cast<int>(cycles)),
                 .kicks = 1,
                 .final = true});
}

}  // namespace cls::player
