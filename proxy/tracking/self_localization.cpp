// Localisation by landmarks: every printed distance and direction is an interval the pose must fit.
#include "proxy/tracking/self_localization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "proxy/world/fixed_list.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;
using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;
using soccer::PitchLine;
using soccer::Vec2;

constexpr double kDegreesPerRadian = 180.0 / math::kPi;
constexpr double kHalfDegree = 0.5;
// Rounding of what is printed, and of the reckoning here.
constexpr double kSlack = 1e-4;

using SlabList = FixedList<Slab<3>, kMaxSlabs>;

struct Pose {
  Vec2 position;
  double face = 0.0;
};

/// Landmarks as the own team sees them: turned by 180 degrees for the right one.
Vec2 own_frame(Vec2 point, soccer::Side side) {
  return side == soccer::Side::kRight ? -point : point;
}

/// A line of the pitch in the own frame: a point of it, and the direction in which it lies for
/// somebody on the pitch.
struct LineGeometry {
  Vec2 point;
  Vec2 outward;
};

LineGeometry line_geometry(std::uint8_t index, soccer::Side side) {
  LineGeometry line;
  switch (static_cast<PitchLine>(index)) {
    case PitchLine::kLeft:
      line = {{-soccer::kHalfLength, 0.0}, {-1.0, 0.0}};
      break;
    case PitchLine::kRight:
      line = {{soccer::kHalfLength, 0.0}, {1.0, 0.0}};
      break;
    case PitchLine::kTop:
      line = {{0.0, -soccer::kHalfWidth}, {0.0, -1.0}};
      break;
    case PitchLine::kBottom:
      line = {{0.0, soccer::kHalfWidth}, {0.0, 1.0}};
      break;
  }
  return {own_frame(line.point, side), own_frame(line.outward, side)};
}

/// What a look is judged with: parameters, focus, neck.
struct Look {
  const WorldModel& world;
  const DistanceTable& distances;
  double neck = 0.0;
  double focus_error = 0.0;

  DistanceRange landmark_range(double printed, Vec2 landmark, const Pose& pose) const {
    const SelfState& self = world.self;
    if (self.focus_distance <= 0.0) return distances.range(printed);
    const Vec2 focus =
        pose.position +
        soccer::polar_degrees(self.focus_distance, pose.face + self.focus_direction.degrees());
    return distances.range(printed, soccer::distance(focus, landmark), focus_error);
  }
};

/// How far the focus point may be from where the pose puts it.
double focus_error_of(const WorldModel& world) {
  const Gaussian<3>& pose = world.self_tracker.pose;
  constexpr double kSure = 3.0;
  constexpr double kLinearisation = 0.01;
  const double position = std::sqrt(std::max(pose.at(0, 0), pose.at(1, 1)));
  const double sideways = math::to_radians(std::sqrt(pose.at(2, 2))) * world.self.focus_distance;
  return kSure * (position + sideways) + kLinearisation;
}

/// Both intervals of a flag or goal, linearised at `at`.
void add_landmark(const Look& look, const Observation& seen, const Pose& at, SlabList& slabs) {
  const Vec2 landmark = own_frame(soccer::kLandmarks[seen.index].position, look.world.our_side);
  const Vec2 offset = landmark - at.position;
  const double distance = offset.length();
  constexpr double kTooNear = 0.3;  // the linearisation says nothing here
  if (distance < kTooNear) return;
  const Vec2 e = offset / distance;
  const double angle = soccer::direction_degrees(offset) - at.face;
  const double turn = math::normalize_degrees(seen.direction - angle);
  const double per_metre = kDegreesPerRadian / distance;
  slabs.push_back({{e.y * per_metre, -e.x * per_metre, -1.0},
                   turn - kHalfDegree - kSlack,
                   turn + kHalfDegree + kSlack});
  if (seen.detail == ObservedDetail::kDirection) return;
  const DistanceRange range = look.landmark_range(seen.distance, landmark, at);
  slabs.push_back(
      {{-e.x, -e.y, 0.0}, range.low - distance - kSlack, range.high - distance + kSlack});
}

/// The angle from the line's normal to the line of sight, from the printed direction (which counts
/// from the line itself); the sign of the angle is lost when that is 0.
std::optional<DistanceRange> sight_angle(int printed, double expected) {
  if (printed == -90) return DistanceRange{0.0, kHalfDegree};
  if (printed == 90) return DistanceRange{-kHalfDegree, 0.0};
  const double middle = printed < 0    ? printed + 90.0
                        : printed > 0  ? printed - 90.0
                        : expected < 0 ? -90.0
                                       : 90.0;
  if (std::fabs(math::normalize_degrees(middle - expected)) > 90.0) return std::nullopt;
  return DistanceRange{middle - kHalfDegree, middle + kHalfDegree};
}

/// Direction and distance along the line of sight of a border line, linearised at `at`.
void add_line(const Look& look, const Observation& seen, const Pose& at, SlabList& slabs) {
  LineGeometry line = line_geometry(seen.index, look.world.our_side);
  double gap = soccer::dot(line.outward, line.point - at.position);
  if (gap < 0.0) {  // we are beyond it
    line.outward = -line.outward;
    gap = -gap;
  }
  const double expected =
      math::normalize_degrees(soccer::direction_degrees(line.outward) - at.face);
  const std::optional<DistanceRange> angle = sight_angle(seen.direction, expected);
  if (!angle) return;
  slabs.push_back(
      {{0.0, 0.0, -1.0}, angle->low - expected - kSlack, angle->high - expected + kSlack});
  // Along a line that is looked at flat the distance tells little and is far from linear.
  constexpr double kFlat = 75.0;
  constexpr double kTooNear = 1.0;
  if (seen.detail == ObservedDetail::kDirection || std::fabs(expected) > kFlat || gap < kTooNear) {
    return;
  }
  const math::SinCos s = math::sincos(math::to_radians(expected));
  const double distance = gap / s.cos;
  const double per_degree = -gap * s.sin / (s.cos * s.cos) / kDegreesPerRadian;
  const DistanceRange range = look.distances.range(seen.distance);
  slabs.push_back({{-line.outward.x / s.cos, -line.outward.y / s.cos, per_degree},
                   range.low - distance - kSlack,
                   range.high - distance + kSlack});
}

SlabList slabs_at(const Look& look, const soccer::See& see, const Pose& at) {
  SlabList slabs;
  for (const Observation& seen : see.objects) {
    if (seen.kind == ObservedKind::kLandmark) add_landmark(look, seen, at, slabs);
    if (seen.kind == ObservedKind::kLine) add_line(look, seen, at, slabs);
  }
  return slabs;
}

/// How badly a pose breaks the worst of the intervals, in their own half widths; `shift` leads to
/// it from where they were linearised.
double worst_violation(const SlabList& slabs, const VecN<3>& shift) {
  double worst = 0.0;
  for (const Slab<3>& slab : slabs) {
    const double at = dot(slab.direction, shift);
    const double outside = std::max(slab.low - at, at - slab.high);
    worst = std::max(worst, outside / (0.5 * (slab.high - slab.low)));
  }
  return worst;
}

/// Face from a visible border line, if we stand inside the pitch.
std::optional<double> face_from_line(const Look& look, const soccer::See& see) {
  for (const Observation& seen : see.objects) {
    if (seen.kind != ObservedKind::kLine || seen.direction == 0) continue;
    const LineGeometry line = line_geometry(seen.index, look.world.our_side);
    const double sight = seen.direction < 0 ? seen.direction + 90.0 : seen.direction - 90.0;
    return soccer::direction_degrees(line.outward) - sight;
  }
  return std::nullopt;
}

/// A first pose from the nearest landmark, turned by the one farthest from it or by a line.
std::optional<Pose> pose_from_scratch(const Look& look, const soccer::See& see) {
  const Observation* nearest = nullptr;
  for (const Observation& seen : see.objects) {
    if (seen.kind != ObservedKind::kLandmark || seen.detail == ObservedDetail::kDirection) continue;
    if (nearest == nullptr || seen.distance < nearest->distance) nearest = &seen;
  }
  if (nearest == nullptr) return std::nullopt;
  const auto place = [&](const Observation& seen) {
    return own_frame(soccer::kLandmarks[seen.index].position, look.world.our_side);
  };
  const auto seen_at = [&](const Observation& seen) {
    return soccer::polar_degrees(look.distances.range(seen.distance).middle(), seen.direction);
  };
  const Observation* other = nullptr;
  double longest = 5.0;
  for (const Observation& seen : see.objects) {
    if (seen.kind != ObservedKind::kLandmark || seen.detail == ObservedDetail::kDirection) continue;
    const double base = soccer::distance(place(seen), place(*nearest));
    if (base > longest) {
      longest = base;
      other = &seen;
    }
  }
  Pose pose;
  if (other != nullptr) {
    pose.face = soccer::direction_degrees(place(*other) - place(*nearest)) -
                soccer::direction_degrees(seen_at(*other) - seen_at(*nearest));
  } else if (const std::optional<double> face = face_from_line(look, see)) {
    pose.face = *face;
  } else {
    return std::nullopt;
  }
  pose.position = place(*nearest) - soccer::rotated_degrees(seen_at(*nearest), pose.face);
  return pose;
}

/// Conditions `belief` (about x, y, body) on the see; relinearises while the mean still moves.
/// Returns how badly the result breaks the worst interval, in half widths.
double fit(const Look& look, const soccer::See& see, Gaussian<3>& belief, int rounds) {
  const Gaussian<3> prior = belief;
  Gaussian<3> origin = prior;  // where the intervals are linearised
  for (int round = 0; round < rounds; ++round) {
    const Pose at{{origin.mean[0], origin.mean[1]}, origin.mean[2] + look.neck};
    const SlabList slabs = slabs_at(look, see, at);
    Gaussian<3> shift = prior;  // belief about the difference to the origin
    for (std::size_t i = 0; i < 3; ++i) shift.mean[i] = prior.mean[i] - origin.mean[i];
    shift.mean[2] = math::normalize_degrees(shift.mean[2]);
    constexpr int kSweeps = 4;
    condition<3>(shift, std::span<const Slab<3>>(slabs.begin(), slabs.size()), kSweeps);
    belief.covariance = shift.covariance;
    for (std::size_t i = 0; i < 3; ++i) belief.mean[i] = origin.mean[i] + shift.mean[i];
    belief.mean[2] = math::normalize_degrees(belief.mean[2]);
    const double violation = worst_violation(slabs, shift.mean);
    const double moved = Vec2{shift.mean[0], shift.mean[1]}.length();
    if (moved < 0.1 && std::fabs(shift.mean[2]) < 0.5) return violation;
    origin.mean = belief.mean;
  }
  // It came from far: where it has arrived the intervals may look different.
  const Pose at{{belief.mean[0], belief.mean[1]}, belief.mean[2] + look.neck};
  return worst_violation(slabs_at(look, see, at), {});
}

bool fit_from_scratch(const Look& look, const soccer::See& see, Gaussian<3>& belief) {
  const std::optional<Pose> start = pose_from_scratch(look, see);
  if (!start) return false;
  belief = {};
  belief.mean = {start->position.x, start->position.y,
                 math::normalize_degrees(start->face - look.neck)};
  belief.at(0, 0) = belief.at(1, 1) = 1.0;
  belief.at(2, 2) = 25.0;
  constexpr int kRounds = 4;
  fit(look, see, belief, kRounds);
  return true;
}

}  // namespace

bool localize(WorldModel& world, const soccer::See& see) {
  SelfState& self = world.self;
  SelfTracker& tracker = world.self_tracker;
  const Look look{world, world.parameters->landmark_distances, self.neck.degrees(),
                  focus_error_of(world)};
  const double body_before = tracker.pose.mean[2];
  // The worst interval may be broken by a little where the belief is a compromise; a pose that
  // breaks one by its own half width is somewhere else.
  constexpr double kContradiction = 1.6;
  bool fresh = false;
  bool seen = std::any_of(see.objects.begin(), see.objects.end(), [](const Observation& o) {
    return o.kind == ObservedKind::kLandmark || o.kind == ObservedKind::kLine;
  });
  if (tracker.located && seen) {
    constexpr int kRounds = 5;  // one is enough unless messages were lost or we were moved
    fresh = fit(look, see, tracker.pose, kRounds) > kContradiction;
  }
  if (!tracker.located || fresh) {
    Gaussian<3> anew;
    // Nothing is known yet about where the focus point is.
    const Look blind{world, look.distances, look.neck, 2.0 * self.focus_distance};
    if (fit_from_scratch(blind, see, anew)) {
      tracker.pose = anew;
      tracker.located = true;
    } else {
      seen = false;
    }
  }
  if (!seen) return false;
  // However many intervals agree, rounding in the server and here keeps it from being a point.
  constexpr double kLeastVariance = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) tracker.pose.at(i, i) += kLeastVariance;
  const double corrected = math::normalize_degrees(tracker.pose.mean[2] - body_before);
  self.velocity = soccer::rotated_degrees(self.velocity, corrected * tracker.heading_follows_body);
  return true;
}

}  // namespace cls::proxy
