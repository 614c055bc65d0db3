// Looking with the neck alone.
#include "proxy/looking/neck.h"

#include <algorithm>
#include <cmath>

#include "proxy/looking/neck_search.h"
#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

/// Degrees that an object must lie inside the edge of the view to be surely seen.
constexpr double kEdge = 5.0;

/// From `relative`, degrees off the next body, to the neck slot.
bool aim(const WorldModel& world, CommandSlots& slots, double relative) {
  return slots.turn_neck(relative - world.self.neck.degrees());
}

double half_view(const WorldModel& world, const CommandSlots& slots) {
  return view_angle(world.server(), slots.next_view_width()) / 2.0;
}

/// Direction of a point in the next cycle, degrees off the next body.
double relative_direction(const CommandSlots& slots, Vec2 point) {
  return (AngleDeg::of(point - slots.next_position()) - slots.next_body()).degrees();
}

bool can_see(const WorldModel& world, const CommandSlots& slots, double relative, double edge) {
  const double reach = half_view(world, slots) - edge;
  return relative > world.server().minneckang - reach &&
         relative < world.server().maxneckang + reach;
}

Vec2 next_place(const PlayerState& player) {
  return player.velocity_valid() ? player.position + player.velocity : player.position;
}

/// Best direction among those that keep `relative` at least `edge` degrees inside the view.
bool aim_near(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
              double relative, double edge) {
  const double slack = std::max(0.0, half_view(world, slots) - edge);
  const double low =
      std::clamp(relative - slack, world.server().minneckang, world.server().maxneckang);
  const double high =
      std::clamp(relative + slack, world.server().minneckang, world.server().maxneckang);
  const NeckSearch search(world, sight, slots);
  return aim(world, slots, search.best_field(low, high));
}

}  // namespace

bool neck_scan_field(const WorldModel& world, const SightMemory& sight, CommandSlots& slots) {
  const auto& server = world.server();
  const NeckSearch search(world, sight, slots);
  const Vec2 here = slots.next_position();
  const bool at_edge =
      std::fabs(here.x) > soccer::kHalfLength - 5.0 || std::fabs(here.y) > soccer::kHalfWidth - 5.0;
  if (at_edge && slots.next_view_width() == soccer::ViewWidth::kWide) {
    const double inward = relative_direction(slots, {here.x * 0.3, 0.0});
    return aim(world, slots, std::clamp(inward, server.minneckang, server.maxneckang));
  }
  if (search.knows_all_players()) {
    return aim(world, slots, search.best_players(server.minneckang, server.maxneckang));
  }
  return aim(world, slots, search.best_field(server.minneckang, server.maxneckang));
}

bool neck_scan_players(const WorldModel& world, const SightMemory& sight, CommandSlots& slots) {
  const NeckSearch search(world, sight, slots);
  if (!search.knows_all_players()) return neck_scan_field(world, sight, slots);
  return aim(world, slots,
             search.best_players(world.server().minneckang, world.server().maxneckang));
}

bool neck_turn_to_ball(const WorldModel& world, const SightMemory& sight, CommandSlots& slots) {
  const bool known = world.ball.position_valid() && world.ball.ghost_count == 0;
  if (!known) return neck_scan_field(world, sight, slots);
  const double ball = relative_direction(slots, ball_after(world, 1));
  if (!can_see(world, slots, ball, kEdge)) return neck_scan_field(world, sight, slots);
  if (world.intercept.first_opponent_steps <= 1) return aim(world, slots, ball);
  constexpr double kBallEdge = 10.0;
  constexpr double kDuelEdge = 20.0;
  const bool duel = world.kickable_opponent() || world.intercept.first_opponent_steps <= 3;
  return aim_near(world, sight, slots, ball, duel ? kDuelEdge : kBallEdge);
}

bool neck_turn_to_ball_or_scan(const WorldModel& world, const SightMemory& sight,
                               CommandSlots& slots, int count_threshold) {
  if (world.ball.pos_count <= count_threshold) return neck_scan_field(world, sight, slots);
  const Vec2 ball = ball_after(world, 1);
  const bool sensed = distance(ball, slots.next_position()) < world.server().visible_distance - 0.3;
  if (count_threshold >= 0 && sensed && world.ball.position_valid() &&
      world.intercept.first_opponent_steps > 1) {
    return neck_scan_field(world, sight, slots);
  }
  return neck_turn_to_ball(world, sight, slots);
}

bool neck_turn_to_ball_and_player(const WorldModel& world, const SightMemory& sight,
                                  CommandSlots& slots, const PlayerState* player,
                                  int count_threshold) {
  if (player == nullptr) return false;
  if (player->seen_pos_count <= count_threshold || !world.ball.position_valid()) {
    return neck_turn_to_ball(world, sight, slots);
  }
  const double ball = relative_direction(slots, ball_after(world, 1));
  const double other = relative_direction(slots, next_place(*player));
  const double gap = soccer::math::normalize_degrees(other - ball);
  const double middle = soccer::math::normalize_degrees(ball + gap / 2.0);
  const double width = 2.0 * (half_view(world, slots) - kEdge);
  const double neck = std::clamp(middle, world.server().minneckang, world.server().maxneckang);
  const bool fits = std::fabs(gap) / 2.0 + std::fabs(middle - neck) <= width / 2.0;
  return fits ? aim(world, slots, neck) : neck_turn_to_ball(world, sight, slots);
}

bool neck_turn_to_player_or_scan(const WorldModel& world, const SightMemory& sight,
                                 CommandSlots& slots, const PlayerState* player,
                                 int count_threshold) {
  if (player == nullptr) return false;
  if (player->seen_pos_count <= count_threshold) return neck_scan_field(world, sight, slots);
  const double relative = relative_direction(slots, next_place(*player));
  if (can_see(world, slots, relative, kEdge)) return aim(world, slots, relative);
  return neck_turn_to_ball_or_scan(world, sight, slots, 0);
}

bool neck_turn_to_goalie_or_scan(const WorldModel& world, const SightMemory& sight,
                                 CommandSlots& slots, int count_threshold) {
  const PlayerState* goalie =
      world.their_goalie_unum > 0 ? world.opponent(world.their_goalie_unum) : nullptr;
  if (goalie == nullptr || goalie->seen_pos_count <= count_threshold) {
    return neck_turn_to_ball_or_scan(world, sight, slots, 0);
  }
  const double relative = relative_direction(slots, next_place(*goalie));
  if (!can_see(world, slots, relative, kEdge)) {
    return neck_turn_to_ball_or_scan(world, sight, slots, 0);
  }
  // The goal beside the goalie is worth seeing too: lean toward its middle.
  const double goal = relative_direction(slots, {soccer::kHalfLength, 0.0});
  const double lean = std::clamp(soccer::math::normalize_degrees(goal - relative), -10.0, 10.0);
  return aim(world, slots, relative + lean);
}

bool neck_turn_to_low_conf_teammate(const WorldModel& world, const SightMemory& sight,
                                    CommandSlots& slots) {
  constexpr double kFar = 40.0;
  const PlayerState* stalest = nullptr;
  double direction = 0.0;
  for (const PlayerState& mate : world.teammates) {
    if (mate.ghost() || !mate.position_valid() || mate.dist_from_self > kFar) continue;
    if (mate.position.x < world.self.position.x || mate.unum < 1) continue;
    if (stalest != nullptr && mate.seen_pos_count <= stalest->seen_pos_count) continue;
    const double relative = relative_direction(slots, next_place(mate));
    if (!can_see(world, slots, relative, kEdge)) continue;
    stalest = &mate;
    direction = relative;
  }
  if (stalest == nullptr || stalest->seen_pos_count == 0) {
    return neck_turn_to_ball_or_scan(world, sight, slots, 0);
  }
  return aim_near(world, sight, slots, direction, 2.0 * kEdge);
}

bool neck_turn_to_point(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                        Vec2 point) {
  const double relative = relative_direction(slots, point);
  if (!can_see(world, slots, relative, kEdge)) return neck_scan_field(world, sight, slots);
  return aim(world, slots, relative);
}

bool neck_turn_to_relative(const WorldModel& world, CommandSlots& slots, double angle) {
  return aim(world, slots, soccer::math::normalize_degrees(angle));
}

bool neck_offensive_intercept(const WorldModel& world, const SightMemory& sight,
                              CommandSlots& slots) {
  const InterceptTable& table = world.intercept;
  if (world.kickable_opponent()) {
    return neck_turn_to_ball_and_player(world, sight, slots,
                                        world.player_by_id(world.kickable_opponent_id), 0);
  }
  const Vec2 goal{soccer::kHalfLength, 0.0};
  const bool near_goal = distance(first_reach_point(world), goal) < 20.0;
  if (table.self_steps <= 1 && near_goal) {
    return neck_turn_to_goalie_or_scan(world, sight, slots, 0);
  }
  if (world.ball.pos_count > 0 || table.first_opponent_steps <= table.self_steps + 1) {
    slots.change_view(soccer::ViewWidth::kNarrow);
    return neck_turn_to_ball(world, sight, slots);
  }
  if (table.self_steps > 4) {
    slots.change_view(soccer::ViewWidth::kNormal);
    return neck_turn_to_ball_or_scan(world, sight, slots, 0);
  }
  return neck_turn_to_low_conf_teammate(world, sight, slots);
}

}  // namespace cls::proxy
