// Neck actions, and what completes a body command.
#include "player/looking/looking.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"
#include "player/commands/command_slots.h"
#include "player/looking/neck_search.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

/// Margin in degrees inside the view cone for reliable visibility.
constexpr double kEdge = 5.0;

/// Sets the neck slot to `relative` degrees from the next body.
bool aim(const WorldModel& world, CommandSlots& slots, double relative) {
  return slots.turn_neck(relative - world.self.neck.degrees());
}

double half_view(const WorldModel& world, const CommandSlots& slots) {
  return view_angle(world.server(), slots.next_view_width()) / 2.0;
}

/// The nearest angle that the neck can turn to.
double neck_limited(const WorldModel& world, double angle) {
  return soccer::between(angle, world.server().minneckang, world.server().maxneckang);
}

/// Direction of a point in the next cycle, degrees relative to the next body.
double relative_direction(const CommandSlots& slots, Vec2 point) {
  return (AngleDeg::of(point - slots.next_position()) - slots.next_body()).degrees();
}

bool can_see(const WorldModel& world, const CommandSlots& slots, double relative, double edge) {
  const double reach = half_view(world, slots) - edge;
  return relative > world.server().minneckang - reach &&
         relative < world.server().maxneckang + reach;
}

Vec2 next_position_of(const PlayerState& player) {
  return player.velocity_valid() ? player.position + player.velocity : player.position;
}

/// Best scan direction that keeps `relative` at least `edge` degrees inside the view cone.
bool aim_near(const WorldModel& world, const ViewMemory& view, CommandSlots& slots, double relative,
              double edge) {
  const double slack = std::max(0.0, half_view(world, slots) - edge);
  const NeckSearch search(world, view, slots);
  return aim(world, slots,
             search.best_field(neck_limited(world, relative - slack),
                               neck_limited(world, relative + slack)));
}

}  // namespace

bool neck_scan_field(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  const auto& server = world.server();
  const NeckSearch search(world, view, slots);
  const Vec2 here = slots.next_position();

  constexpr double kNearEdge = 5.0;
  if (outside_pitch(here, kNearEdge) && slots.next_view_width() == soccer::ViewWidth::kWide) {
    const double inward = relative_direction(slots, {here.x * 0.3, 0.0});
    return aim(world, slots, neck_limited(world, inward));
  }

  return aim(world, slots,
             search.knows_all_players() ? search.best_players(server.minneckang, server.maxneckang)
                                        : search.best_field(server.minneckang, server.maxneckang));
}

bool neck_scan_players(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  const NeckSearch search(world, view, slots);
  if (!search.knows_all_players()) return neck_scan_field(world, view, slots);
  return aim(world, slots,
             search.best_players(world.server().minneckang, world.server().maxneckang));
}

bool neck_turn_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  const bool known = world.ball.position_valid() && world.ball.ghost_count == 0;
  if (!known) return neck_scan_field(world, view, slots);

  const double ball = relative_direction(slots, ball_after(world, 1));
  if (!can_see(world, slots, ball, kEdge)) return neck_scan_field(world, view, slots);
  if (world.intercept.first_opponent_steps <= 1) return aim(world, slots, ball);

  constexpr double kBallEdge = 10.0;
  constexpr double kDuelEdge = 20.0;
  const bool duel = world.kickable_opponent() || world.intercept.first_opponent_steps <= 3;
  return aim_near(world, view, slots, ball, duel ? kDuelEdge : kBallEdge);
}

bool neck_turn_to_ball_or_scan(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                               int count_threshold) {
  if (world.ball.pos_count <= count_threshold) return neck_scan_field(world, view, slots);

  const Vec2 ball = ball_after(world, 1);
  const bool sensed = distance(ball, slots.next_position()) < world.server().visible_distance - 0.3;
  if (count_threshold >= 0 && sensed && world.ball.position_valid() &&
      world.intercept.first_opponent_steps > 1) {
    return neck_scan_field(world, view, slots);
  }

  return neck_turn_to_ball(world, view, slots);
}

bool neck_turn_to_ball_and_player(const WorldModel& world, const ViewMemory& view,
                                  CommandSlots& slots, const PlayerState* player,
                                  int count_threshold) {
  if (player == nullptr) return false;
  if (player->seen_pos_count <= count_threshold || !world.ball.position_valid()) {
    return neck_turn_to_ball(world, view, slots);
  }

  const double ball = relative_direction(slots, ball_after(world, 1));
  const double other = relative_direction(slots, next_position_of(*player));
  const double gap = math::normalize_degrees(other - ball);
  const double middle = math::normalize_degrees(ball + gap / 2.0);
  const double width = 2.0 * (half_view(world, slots) - kEdge);
  const double neck = neck_limited(world, middle);

  const bool fits = std::fabs(gap) / 2.0 + std::fabs(middle - neck) <= width / 2.0;
  return fits ? aim(world, slots, neck) : neck_turn_to_ball(world, view, slots);
}

bool neck_turn_to_player_or_scan(const WorldModel& world, const ViewMemory& view,
                                 CommandSlots& slots, const PlayerState* player,
                                 int count_threshold) {
  if (player == nullptr) return false;
  if (player->seen_pos_count <= count_threshold) return neck_scan_field(world, view, slots);
  const double relative = relative_direction(slots, next_position_of(*player));
  if (can_see(world, slots, relative, kEdge)) return aim(world, slots, relative);
  return neck_turn_to_ball_or_scan(world, view, slots, 0);
}

bool neck_turn_to_goalie_or_scan(const WorldModel& world, const ViewMemory& view,
                                 CommandSlots& slots, int count_threshold) {
  const PlayerState* goalie =
      world.their_goalie_unum > 0 ? world.opponent(world.their_goalie_unum) : nullptr;
  const bool stale = goalie != nullptr && goalie->seen_pos_count > count_threshold;
  const double relative = stale ? relative_direction(slots, next_position_of(*goalie)) : 0.0;
  if (!stale || !can_see(world, slots, relative, kEdge)) {
    return neck_turn_to_ball_or_scan(world, view, slots, 0);
  }

  // Include the goal beside the goalie: shift toward the goal center.
  const double goal = relative_direction(slots, kOpponentGoal);
  const double lean = std::clamp(math::normalize_degrees(goal - relative), -10.0, 10.0);
  return aim(world, slots, relative + lean);
}

bool neck_turn_to_low_conf_teammate(const WorldModel& world, const ViewMemory& view,
                                    CommandSlots& slots) {
  constexpr double kFar = 40.0;
  const PlayerState* stalest = nullptr;
  double direction = 0.0;

  for (const PlayerState& teammate : world.teammates) {
    if (teammate.ghost() || !teammate.position_valid() || teammate.dist_from_self > kFar) continue;
    if (teammate.position.x < world.self.position.x || teammate.unum < 1) continue;
    if (stalest != nullptr && teammate.seen_pos_count <= stalest->seen_pos_count) continue;
    const double relative = relative_direction(slots, next_position_of(teammate));
    if (!can_see(world, slots, relative, kEdge)) continue;
    stalest = &teammate;
    direction = relative;
  }

  if (stalest == nullptr || stalest->seen_pos_count == 0) {
    return neck_turn_to_ball_or_scan(world, view, slots, 0);
  }
  return aim_near(world, view, slots, direction, 2.0 * kEdge);
}

bool neck_turn_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        Vec2 point) {
  const double relative = relative_direction(slots, point);
  if (!can_see(world, slots, relative, kEdge)) return neck_scan_field(world, view, slots);
  return aim(world, slots, relative);
}

bool neck_turn_to_relative(const WorldModel& world, CommandSlots& slots, double angle) {
  return aim(world, slots, math::normalize_degrees(angle));
}

bool neck_offensive_intercept(const WorldModel& world, const ViewMemory& view,
                              CommandSlots& slots) {
  const InterceptTable& table = world.intercept;
  if (world.kickable_opponent()) {
    return neck_turn_to_ball_and_player(world, view, slots,
                                        world.player_by_id(world.kickable_opponent_id), 0);
  }

  const bool near_goal = distance(first_reach_point(world), kOpponentGoal) < 20.0;
  if (table.self_steps <= 1 && near_goal) return neck_turn_to_goalie_or_scan(world, view, slots, 0);

  if (world.ball.pos_count > 0 || table.first_opponent_steps <= table.self_steps + 1) {
    slots.change_view(soccer::ViewWidth::kNarrow);
    return neck_turn_to_ball(world, view, slots);
  }
  if (table.self_steps > 4) {
    slots.change_view(soccer::ViewWidth::kNormal);
    return neck_turn_to_ball_or_scan(world, view, slots, 0);
  }

  return neck_turn_to_low_conf_teammate(world, view, slots);
}

bool execute_neck_plan(const NeckPlan& plan, const WorldModel& world, const ViewMemory& view,
                       CommandSlots& slots) {
  switch (plan.kind) {
    case NeckPlan::Kind::kNone:
      return false;
    case NeckPlan::Kind::kBall:
      return neck_turn_to_ball(world, view, slots);
    case NeckPlan::Kind::kBallOrScan:
      return neck_turn_to_ball_or_scan(world, view, slots, 0);
    case NeckPlan::Kind::kScan:
      return neck_scan_field(world, view, slots);
    case NeckPlan::Kind::kPoint:
      return neck_turn_to_point(world, view, slots, plan.point);
    case NeckPlan::Kind::kGoalieOrScan:
      return neck_turn_to_goalie_or_scan(world, view, slots, 0);
    case NeckPlan::Kind::kOffensiveIntercept:
      return neck_offensive_intercept(world, view, slots);
  }
  return false;
}

bool set_body_command(const WorldModel& world, const soccer::PlayerCommand& body,
                      CommandSlots& slots) {
  return std::visit(
      base::Overloaded{
          [&](const soccer::Dash& dash) { return slots.dash(dash.power, dash.direction); },
          [&](const soccer::LegDash& legs) { return slots.dash(legs); },
          // The slot takes the angle that the body turns by; the command has the moment.
          [&](const soccer::Turn& turn) {
            return slots.turn(turn.moment /
                              turn_resistance(world.self_type(), world.self.velocity));
          },
          [&](const soccer::Kick& kick) { return slots.kick(kick.power, kick.direction); },
          [&](const soccer::Tackle& tackle) {
            return slots.tackle(tackle.angle_or_power, tackle.foul);
          },
          [&](const soccer::Catch&) { return slots.catch_ball(); },
          [&](const soccer::Move& move) {
            return slots.move({move.x, move.y});
          },
          [](const auto&) { return false; },
      },
      body);
}

}  // namespace cls::player
