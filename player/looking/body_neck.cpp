// Turns body and neck to a point, to the ball, or around to scan the field.
#include "player/looking/looking.h"

#include <algorithm>

#include "base/index.h"
#include "player/looking/neck_search.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

/// Turns the neck so that the face points in a global direction, relative to the next body.
void face(const WorldModel& world, CommandSlots& slots, AngleDeg direction) {
  slots.turn_neck((direction - slots.next_body()).degrees() - world.self.neck.degrees());
}

bool is_localized(const WorldModel& world) {
  return world.self.position_valid() && world.self.face_valid();
}

}  // namespace

bool body_neck_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        Vec2 point) {
  if (!is_localized(world)) return scan_field(world, view, slots);
  const AngleDeg direction = AngleDeg::of(point - self_after(world, 1));
  if (!slots.turn((direction - world.self.body).degrees())) return false;
  face(world, slots, direction);
  return true;
}

bool body_neck_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  if (!world.ball.position_valid()) return scan_field(world, view, slots);
  return body_neck_to_point(world, view, slots, ball_after(world, 1));
}

bool neck_body_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        Vec2 point, double angle_buf) {
  if (!is_localized(world)) return scan_field(world, view, slots);

  const auto& server = world.server();
  const AngleDeg direction = AngleDeg::of(point - self_after(world, 1));
  const double relative = (direction - world.self.body).degrees();
  const double buffer = std::clamp(angle_buf, 0.0, 90.0);
  const bool neck_enough =
      relative > server.minneckang + buffer && relative < server.maxneckang - buffer;

  const bool set = slots.turn(neck_enough ? 0.0 : relative);
  face(world, slots, direction);
  return set;
}

bool neck_body_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                       double angle_buf) {
  if (!world.ball.position_valid()) return scan_field(world, view, slots);
  return neck_body_to_point(world, view, slots, ball_after(world, 1), angle_buf);
}

bool scan_field(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  // Directions seen within this many cycles do not contain a lost ball.
  constexpr int kRecentlySeen = 8;

  if (!is_localized(world)) {
    // Steps of the view width show all landmarks fastest.
    slots.change_view(soccer::ViewWidth::kWide);
    return slots.turn(60.0);
  }

  const auto& server = world.server();
  const double width_now = view_angle(server, world.self.view_width);
  slots.change_view(soccer::ViewWidth::kWide);
  if (world.ball.position_valid() && world.ball.ghost_count == 0) {
    return slots.turn((width_now + view_angle(server, slots.next_view_width())) / 2.0);
  }

  const Vec2 last = world.ball.seen_pos_count < kNever ? world.ball.seen_position : Vec2{};
  const AngleDeg direction = AngleDeg::of(last - self_after(world, 1));
  if (view.ages[base::index(ViewMemory::sector_of(direction))] < kRecentlySeen) {
    return look_around(world, view, slots);
  }

  if (!slots.turn((direction - world.self.body).degrees())) return false;
  face(world, slots, direction);
  return true;
}

bool emergency(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  // View quality is always high: no cls command lowers it.
  return scan_field(world, view, slots);
}

bool look_around(const WorldModel& world, const ViewMemory& view, CommandSlots& slots) {
  constexpr double kStep = 5.0;
  const double half = view_angle(world.server(), slots.next_view_width()) / 2.0;
  const SectorSums ages = sector_sums(view.ages);
  Highest<AngleDeg> best{-1.0, world.self.body};

  for (double offset = -180.0; offset < 180.0; offset += kStep) {
    const AngleDeg direction = world.self.body + offset;
    best.offer(sum_of(ages, sectors_around(direction, half)), direction);
  }

  const double relative = (best.value - world.self.body).degrees();
  const double neck =
      soccer::between(relative, world.server().minneckang, world.server().maxneckang);
  const bool set = slots.turn(relative - neck);
  face(world, slots, best.value);
  return set;
}

}  // namespace cls::player
