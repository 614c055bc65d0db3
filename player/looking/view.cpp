// Selects view width and focus point.
#include "player/looking/looking.h"

#include <algorithm>

#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/view_cone.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

using soccer::ViewWidth;

bool needs_wide_view(const WorldModel& world) {
  const PlayMode mode = without_side(world.game.mode);
  const bool waiting_penalty = soccer::is_penalty_mode(mode) && mode != PlayMode::kPenaltyTakenLeft;
  return before_play(mode) || waiting_penalty || (world.goalie && holds_caught_ball(world));
}

bool is_player_near_ball(const WorldModel& world, double radius) {
  for (const PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (const PlayerState& player : *list) {
      if (player.position_valid() && player.dist_from_ball < radius) return true;
    }
  }
  return false;
}

/// A goalie far from play widens its view the more the ball is off its body direction.
bool goalie_far_from_play(const WorldModel& world, Vec2 play, double dist) {
  return world.goalie && !world.self.kickable &&
         (dist > 10.0 || play.x > -soccer::kHalfLength + soccer::kPenaltyAreaLength ||
          distance(play, kOwnGoal) > 20.0);
}

ViewWidth tactical_width(const WorldModel& world) {
  if (needs_wide_view(world) || !world.ball.position_valid()) return ViewWidth::kWide;
  if (without_side(world.game.mode) == PlayMode::kPenaltyTakenLeft) return ViewWidth::kNarrow;

  const Vec2 play = first_reach_point(world);
  const Vec2 here = self_after(world, 1);
  const double dist = distance(play, here);
  const double off_body = (AngleDeg::of(play - here) - world.self.body).abs();

  if (goalie_far_from_play(world, play, dist)) {
    const double reach = world.server().maxneckang;
    const double narrow = view_angle(world.server(), ViewWidth::kNarrow) / 2.0 - 3.0;
    if (off_body > reach + narrow) return ViewWidth::kWide;
    if (off_body > reach) return ViewWidth::kNormal;
  }

  if (dist > 40.0) return ViewWidth::kWide;
  if (dist > 20.0) return ViewWidth::kNormal;
  if (dist > 10.0 && off_body > 120.0) return ViewWidth::kWide;
  if (!world.goalie && world.ball.dist_from_self > 10.0 && !is_player_near_ball(world, 5.0)) {
    return ViewWidth::kNormal;
  }
  return ViewWidth::kNarrow;
}

}  // namespace

bool view_synch(CommandSlots& slots) { return slots.change_view(ViewWidth::kNarrow); }

bool view_tactical(const WorldModel& world, CommandSlots& slots) {
  return slots.change_view(tactical_width(world));
}

bool focus_to_point(const WorldModel& world, CommandSlots& slots, Vec2 point) {
  if (!world.self.position_valid() || !world.self.face_valid()) return false;

  const Vec2 relative = point - slots.next_position();
  const double half = view_angle(world.server(), slots.next_view_width()) / 2.0;
  const double direction = (AngleDeg::of(relative) - slots.next_face()).degrees();
  const double inside = soccer::between(direction, -half, half);

  // Outside the view cone: use the nearest point on its edge.
  const double off = math::to_radians(direction - inside);
  const double reach = relative.length() * std::max(0.0, math::cos(off));
  return slots.change_focus(reach - world.self.focus_distance,
                            inside - world.self.focus_direction.degrees());
}

bool focus_reset(const WorldModel& world, CommandSlots& slots) {
  return slots.change_focus(-world.self.focus_distance, -world.self.focus_direction.degrees());
}

}  // namespace cls::player
