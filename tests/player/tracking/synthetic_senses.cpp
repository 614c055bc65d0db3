// Formulas from the specification, independent of the proxy's inverse.
#include "tests/player/tracking/synthetic_senses.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::tests {
namespace {

namespace math = soccer::math;

using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;

double log_rounded(double value, double step) {
  return math::exp(math::quantize(math::log(value + math::kEps), step));
}

int rounded(double degrees) {
  return static_cast<int>(std::rint(math::normalize_degrees(degrees)));
}

struct Eye {
  const TrueWorld& world;
  Vec2 focus;
  double face = 0.0;

  explicit Eye(const TrueWorld& w) : world(w), face(w.self.body + w.self.neck) {
    focus = w.self.position + soccer::polar_degrees(w.focus_distance, face + w.focus_direction);
  }

  double half_view() const {
    return world.width == soccer::ViewWidth::kNarrow   ? 30.0
           : world.width == soccer::ViewWidth::kNormal ? 60.0
                                                       : 90.0;
  }

  double printed_distance(Vec2 object, double step) const {
    const double d = soccer::distance(object, world.self.position);
    const double f = soccer::distance(object, focus);
    if (world.gaussian != nullptr) {
      const double rate = step < 0.05 ? 0.00125 : 0.0125;
      return std::max(0.0, world.gaussian->normal(d, rate * d + rate * f));
    }
    const double correction = (f - log_rounded(f, step)) + (d - log_rounded(d, step));
    return math::quantize(std::max(0.0, d - correction / 2.0), 0.1);
  }

  /// False if the object is neither in the view cone nor close.
  bool place(Vec2 object, double step, ObservedKind in_view, ObservedKind close,
             Observation& out) const {
    const Vec2 offset = object - world.self.position;
    const double angle = math::normalize_degrees(soccer::direction_degrees(offset) - face);
    const bool in_cone = std::fabs(angle) < half_view();
    if (!in_cone && offset.length() > 3.0) return false;
    out.kind = in_cone ? in_view : close;
    out.detail = ObservedDetail::kPosition;
    out.direction = static_cast<std::int16_t>(rounded(angle));
    out.distance = printed_distance(object, step);
    return true;
  }

  void add_changes(Vec2 object, Vec2 velocity, Observation& out) const {
    const Vec2 offset = object - world.self.position;
    const double d = offset.length();
    const Vec2 e = offset / d;
    const Vec2 u = velocity - world.self.velocity;
    out.detail = ObservedDetail::kMotion;
    const double radial = soccer::dot(u, e);
    out.distance_change = world.gaussian != nullptr
                              ? math::quantize(radial * out.distance / d, 0.01)
                              : out.distance * math::quantize(radial / d, 0.02);
    out.direction_change = math::quantize(math::to_degrees(soccer::cross(e, u) / d), 0.1);
  }
};

void add_landmarks(const Eye& eye, soccer::See& see) {
  for (std::size_t i = 0; i < soccer::kLandmarks.size(); ++i) {
    Observation seen;
    const Vec2 place = soccer::kLandmarks[i].position;
    if (!eye.place(place, 0.01, ObservedKind::kLandmark, ObservedKind::kCloseFlag, seen)) continue;
    seen.index = static_cast<std::uint8_t>(i);
    if (seen.kind == ObservedKind::kLandmark && seen.distance <= 20.0) {
      eye.add_changes(place, {}, seen);
    }
    see.objects.push_back(seen);
  }
}

void add_ball(const Eye& eye, soccer::See& see) {
  Observation seen;
  if (!eye.place(eye.world.ball, 0.1, ObservedKind::kBall, ObservedKind::kCloseBall, seen)) return;
  if (seen.kind == ObservedKind::kBall && seen.distance <= 20.0) {
    eye.add_changes(eye.world.ball, eye.world.ball_velocity, seen);
  }
  see.objects.push_back(seen);
}

void add_player(const Eye& eye, const TruePlayer& player, soccer::See& see) {
  Observation seen;
  if (!eye.place(player.position, 0.1, ObservedKind::kPlayer, ObservedKind::kClosePlayer, seen)) {
    return;
  }

  if (seen.kind == ObservedKind::kPlayer) {
    seen.team = player.side == Side::kLeft ? kLeftTeam : kRightTeam;
    if (player.tackling) seen.mark = soccer::ActionMark::kTackling;
    if (player.kicked) seen.mark = soccer::ActionMark::kKicked;
    if (seen.distance <= eye.world.unum_far) {
      eye.add_changes(player.position, player.velocity, seen);
      seen.detail = ObservedDetail::kPose;
      seen.unum = static_cast<std::uint8_t>(player.unum);
      seen.goalie = player.goalie;
      seen.body = static_cast<std::int16_t>(rounded(player.body - eye.face));
      seen.head = static_cast<std::int16_t>(rounded(player.body + player.neck - eye.face));
    }
  }

  see.objects.push_back(seen);
}

/// Border lines that the line of sight crosses; at most one from inside the pitch.
void add_lines(const Eye& eye, soccer::See& see) {
  const Vec2 p = eye.world.self.position;
  const bool inside = std::fabs(p.x) < soccer::kHalfLength && std::fabs(p.y) < soccer::kHalfWidth;
  int left = inside ? 1 : 2;

  for (int line = 0; line < soccer::kPitchLineCount && left > 0; ++line) {
    const bool vertical = line < 2;
    const double sign = line % 2 == 0 ? -1.0 : 1.0;
    const double at = vertical ? sign * soccer::kHalfLength : sign * soccer::kHalfWidth;
    const double offset = at - (vertical ? p.x : p.y);
    const bool beyond = offset * sign < 0.0;
    double normal = vertical ? (sign < 0 ? 180.0 : 0.0) : sign * 90.0;
    if (beyond) normal += 180.0;
    const double s = math::normalize_degrees(normal - eye.face);
    if (std::fabs(s) >= 90.0) continue;
    const double t = offset * math::tan(math::to_radians(s));
    const double along = vertical ? p.y - t : p.x + t;
    if (std::fabs(along) > (vertical ? soccer::kHalfWidth : soccer::kHalfLength)) continue;
    Observation seen;
    seen.kind = ObservedKind::kLine;
    seen.index = static_cast<std::uint8_t>(line);
    seen.distance = math::quantize(
        log_rounded(std::fabs(offset / math::sincos(math::to_radians(s)).cos), 0.01), 0.1);
    seen.direction = static_cast<std::int16_t>(rounded(s > 0.0 ? s - 90.0 : s + 90.0));
    see.objects.push_back(seen);
    --left;
  }
}

}  // namespace

soccer::See see_of(const TrueWorld& world) {
  const Eye eye(world);
  soccer::See see;
  see.time = world.time;
  add_landmarks(eye, see);
  add_ball(eye, see);
  for (const TruePlayer& player : world.others) add_player(eye, player, see);
  add_lines(eye, see);
  return see;
}

soccer::SenseBody sense_of(const TrueWorld& world) {
  soccer::SenseBody sense;
  sense.time = world.time;
  sense.width = world.width;
  sense.stamina = 8000.0;
  sense.effort = 1.0;
  sense.capacity = 130600.0;
  const TruePlayer& self = world.self;
  sense.speed = math::quantize(self.velocity.length(), 0.01);
  sense.speed_direction = static_cast<int>(
      math::normalize_degrees(soccer::direction_degrees(self.velocity) - self.body - self.neck));
  sense.head_angle = static_cast<int>(self.neck);
  sense.has_focus_point = true;
  sense.focus_distance = world.focus_distance;
  sense.focus_direction = world.focus_direction;
  return sense;
}

}  // namespace cls::tests
