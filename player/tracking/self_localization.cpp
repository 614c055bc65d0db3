// Self localization by landmarks: each distance and direction in a see message is an interval
// observation of the pose.
#include "player/tracking/tracking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "base/fixed_list.h"
#include "player/world/candidates.h"
#include "soccer/directions.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;

constexpr double kDegreesPerRadian = 180.0 / math::kPi;
constexpr double kHalfDegree = 0.5;
// Tolerance for rounding errors.
constexpr double kSlack = 1e-4;

using SlabList = base::FixedList<Slab<3>, kMaxSlabs>;

struct Pose {
  Vec2 position;
  double face = 0.0;
};

/// Rotates by 180 degrees for the right team.
Vec2 own_frame(Vec2 point, Side side) { return side == Side::kRight ? -point : point; }

/// Position of a flag or goal in the own frame.
Vec2 landmark_position(const WorldModel& world, const Observation& seen) {
  return own_frame(soccer::kLandmarks[seen.index].position, world.our_side);
}

/// A border line in the own frame: a point on it, and its outward normal.
struct LineGeometry {
  Vec2 point;
  Vec2 outward;
};

LineGeometry line_geometry(std::uint8_t index, Side side) {
  static constexpr std::array<Vec2, soccer::kPitchLineCount> kOutward{
      {{-1.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}};  // by PitchLine
  const Vec2 outward = own_frame(kOutward[index], side);
  return {{outward.x * soccer::kHalfLength, outward.y * soccer::kHalfWidth}, outward};
}

/// Context of one see message.
struct SeeContext {
  const WorldModel& world;
  const DistanceTable& distances;
  double neck = 0.0;
  double focus_error = 0.0;

  Vec2 focus(const Pose& pose) const {
    return pose.position + soccer::polar_degrees(world.self.focus_distance,
                                                 pose.face + world.self.focus_direction.degrees());
  }

  /// With the focus point at `from`.
  DistanceRange landmark_range(double printed, Vec2 landmark, Vec2 from) const {
    if (world.self.focus_distance <= 0.0) return distances.range(printed);
    return distances.range(printed, soccer::distance(from, landmark), focus_error);
  }

  /// Variance of the distance of a landmark with Gaussian noise.
  double landmark_variance(double distance, Vec2 landmark, Vec2 from) const {
    const soccer::PlayerType& type = world.self_type();
    return gaussian_distance_variance(type.land_dist_noise_rate, distance,
                                      type.land_focus_dist_noise_rate,
                                      soccer::distance(from, landmark));
  }

  double printed_middle(double printed) const {
    return world.self.gaussian_see ? printed : distances.range(printed).middle();
  }
};

/// Uncertainty of the focus point position.
double focus_error_of(const WorldModel& world) {
  const Gaussian<3>& pose = world.self_tracker.pose;
  constexpr double kSure = 3.0;
  constexpr double kLinearization = 0.01;
  const double position = std::sqrt(std::max(pose.at(0, 0), pose.at(1, 1)));
  const double sideways = math::to_radians(std::sqrt(pose.at(2, 2))) * world.self.focus_distance;
  return kSure * (position + sideways) + kLinearization;
}

/// A visible flag or goal, from the pose at which its intervals are linearized.
struct SeenLandmark {
  const Observation* seen = nullptr;
  Vec2 landmark;
  Vec2 offset;
};
using SeenLandmarkList = base::FixedList<SeenLandmark, kMaxSlabs>;

SeenLandmarkList seen_landmarks(const SeeContext& context, const soccer::See& see, const Pose& at) {
  SeenLandmarkList out;
  for (const Observation& seen : see.objects) {
    if (seen.kind != ObservedKind::kLandmark) continue;
    const Vec2 landmark = landmark_position(context.world, seen);
    out.push_back({&seen, landmark, landmark - at.position});
  }
  return out;
}

/// Adds the direction and distance intervals of a flag or goal in global direction `degrees`, with
/// the focus point at `focus`.
void add_landmark(const SeeContext& context, const SeenLandmark& mark, double degrees,
                  const Pose& at, Vec2 focus, SlabList& slabs) {
  const double distance = mark.offset.length();
  constexpr double kMinDistance = 0.3;  // the linearization is invalid here
  if (distance < kMinDistance) return;

  const Observation& seen = *mark.seen;
  const Vec2 e = mark.offset / distance;
  const double turn = math::normalize_degrees(seen.direction - (degrees - at.face));
  const double per_meter = kDegreesPerRadian / distance;
  slabs.push_back({{e.y * per_meter, -e.x * per_meter, -1.0},
                   turn - kHalfDegree - kSlack,
                   turn + kHalfDegree + kSlack});

  if (seen.detail == ObservedDetail::kDirection) return;
  if (context.world.self.gaussian_see) {
    const double off = seen.distance - distance;
    slabs.push_back(
        {{-e.x, -e.y, 0.0}, off, off, context.landmark_variance(distance, mark.landmark, focus)});
    return;
  }
  const DistanceRange range = context.landmark_range(seen.distance, mark.landmark, focus);
  slabs.push_back(
      {{-e.x, -e.y, 0.0}, range.low - distance - kSlack, range.high - distance + kSlack});
}

/// Angle between the line's normal and the line of sight, from the reported direction, which is
/// relative to the line itself; ambiguous sign at 0.
std::optional<DistanceRange> line_of_sight_angle(int printed, double expected) {
  if (printed == -90) return DistanceRange{0.0, kHalfDegree};
  if (printed == 90) return DistanceRange{-kHalfDegree, 0.0};

  const double middle = printed < 0    ? printed + 90.0
                        : printed > 0  ? printed - 90.0
                        : expected < 0 ? -90.0
                                       : 90.0;
  if (std::fabs(math::normalize_degrees(middle - expected)) > 90.0) return std::nullopt;
  return DistanceRange{middle - kHalfDegree, middle + kHalfDegree};
}

/// Adds the direction and distance intervals of a border line, linearized at `at`.
void add_line(const SeeContext& context, const Observation& seen, const Pose& at, SlabList& slabs) {
  LineGeometry line = line_geometry(seen.index, context.world.our_side);

  double gap = soccer::dot(line.outward, line.point - at.position);
  if (gap < 0.0) {  // the agent is outside
    line.outward = -line.outward;
    gap = -gap;
  }

  const double expected =
      math::normalize_degrees(soccer::direction_degrees(line.outward) - at.face);
  const std::optional<DistanceRange> angle = line_of_sight_angle(seen.direction, expected);
  if (!angle) return;
  slabs.push_back(
      {{0.0, 0.0, -1.0}, angle->low - expected - kSlack, angle->high - expected + kSlack});

  // At flat angles the distance carries little information and is strongly nonlinear.
  constexpr double kFlat = 75.0;
  constexpr double kMinDistance = 1.0;
  if (seen.detail == ObservedDetail::kDirection || std::fabs(expected) > kFlat ||
      gap < kMinDistance) {
    return;
  }

  const math::SinCos s = math::sincos(math::to_radians(expected));
  const double distance = gap / s.cos;
  const double per_degree = -gap * s.sin / (s.cos * s.cos) / kDegreesPerRadian;
  const DistanceRange range = context.distances.range(seen.distance);
  slabs.push_back({{-line.outward.x / s.cos, -line.outward.y / s.cos, per_degree},
                   range.low - distance - kSlack,
                   range.high - distance + kSlack});
}

SlabList slabs_at(const SeeContext& context, const soccer::See& see, const Pose& at) {
  const SeenLandmarkList landmarks = seen_landmarks(context, see, at);
  base::FixedList<Vec2, SeenLandmarkList::capacity()> offsets;
  for (const SeenLandmark& one : landmarks) offsets.push_back(one.offset);
  std::array<double, SeenLandmarkList::capacity()> degrees;
  soccer::directions(offsets.begin(), offsets.size(), degrees.data());

  SlabList slabs;
  const Vec2 focus = context.focus(at);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    add_landmark(context, landmarks[i], degrees[i], at, focus, slabs);
  }
  for (const Observation& seen : see.objects) {
    if (seen.kind == ObservedKind::kLine) add_line(context, seen, at, slabs);
  }
  return slabs;
}

/// Worst interval violation of a pose, in half widths (three standard deviations of Gaussian
/// noise); `shift` is its offset from the linearization point.
double worst_violation(const SlabList& slabs, const VecN<3>& shift) {
  double worst = 0.0;
  for (const Slab<3>& slab : slabs) {
    const double at = dot(slab.direction, shift);
    const double outside = std::max(slab.low - at, at - slab.high);
    const double half =
        std::max(0.5 * (slab.high - slab.low), 3.0 * std::sqrt(slab.noise_variance));
    worst = std::max(worst, outside / half);
  }
  return worst;
}

/// Face direction from a visible border line, assuming the agent is inside the pitch.
std::optional<double> face_from_line(const SeeContext& context, const soccer::See& see) {
  for (const Observation& seen : see.objects) {
    if (seen.kind != ObservedKind::kLine || seen.direction == 0) continue;
    const LineGeometry line = line_geometry(seen.index, context.world.our_side);
    const double observed = seen.direction < 0 ? seen.direction + 90.0 : seen.direction - 90.0;
    return soccer::direction_degrees(line.outward) - observed;
  }
  return std::nullopt;
}

/// A landmark with direction and distance.
bool has_place(const Observation& seen) {
  return seen.kind == ObservedKind::kLandmark && seen.detail != ObservedDetail::kDirection;
}

/// Initial pose from the nearest landmark; orientation from the landmark farthest from it, or from
/// a line.
std::optional<Pose> pose_from_scratch(const SeeContext& context, const soccer::See& see) {
  Lowest<const Observation*> closest{std::numeric_limits<double>::infinity()};
  for (const Observation& seen : see.objects) {
    if (has_place(seen)) closest.offer(seen.distance, &seen);
  }
  if (closest.value == nullptr) return std::nullopt;

  const Observation& nearest = *closest.value;
  const auto seen_at = [&](const Observation& seen) {
    return soccer::polar_degrees(context.printed_middle(seen.distance), seen.direction);
  };

  const Vec2 origin = landmark_position(context.world, nearest);
  Highest<const Observation*> other{5.0};
  for (const Observation& seen : see.objects) {
    if (!has_place(seen)) continue;
    other.offer(soccer::distance(landmark_position(context.world, seen), origin), &seen);
  }

  Pose pose;
  if (other.value != nullptr) {
    pose.face = soccer::direction_degrees(landmark_position(context.world, *other.value) - origin) -
                soccer::direction_degrees(seen_at(*other.value) - seen_at(nearest));
  } else if (const std::optional<double> face = face_from_line(context, see)) {
    pose.face = *face;
  } else {
    return std::nullopt;
  }

  pose.position = origin - soccer::rotated_degrees(seen_at(nearest), pose.face);
  return pose;
}

/// Updates `pose` by a see message, relinearizing while the mean moves. Returns the worst interval
/// violation of the result, in half widths.
double fit(const SeeContext& context, const soccer::See& see, Gaussian<3>& estimate, int rounds) {
  const Gaussian<3> prior = estimate;
  Gaussian<3> origin = prior;  // linearization point

  for (int round = 0; round < rounds; ++round) {
    const Pose at{{origin.mean[0], origin.mean[1]}, origin.mean[2] + context.neck};
    const SlabList slabs = slabs_at(context, see, at);
    Gaussian<3> shift = prior;  // estimate of the offset from the origin
    for (std::size_t i = 0; i < 3; ++i) shift.mean[i] = prior.mean[i] - origin.mean[i];

    shift.mean[2] = math::normalize_degrees(shift.mean[2]);
    constexpr int kSweeps = 4;
    condition(shift, std::span<const Slab<3>>(slabs.begin(), slabs.size()), kSweeps);
    estimate.covariance = shift.covariance;
    for (std::size_t i = 0; i < 3; ++i) estimate.mean[i] = origin.mean[i] + shift.mean[i];
    estimate.mean[2] = math::normalize_degrees(estimate.mean[2]);

    const double violation = worst_violation(slabs, shift.mean);
    const double moved = Vec2{shift.mean[0], shift.mean[1]}.length();
    if (moved < 0.1 && std::fabs(shift.mean[2]) < 0.5) return violation;
    origin.mean = estimate.mean;
  }

  // The estimate has not converged: evaluate the intervals at the final pose.
  const Pose at{{estimate.mean[0], estimate.mean[1]}, estimate.mean[2] + context.neck};
  return worst_violation(slabs_at(context, see, at), {});
}

bool fit_from_scratch(const SeeContext& context, const soccer::See& see, Gaussian<3>& estimate) {
  const std::optional<Pose> start = pose_from_scratch(context, see);
  if (!start) return false;

  estimate = {};
  estimate.mean = {start->position.x, start->position.y,
                   math::normalize_degrees(start->face - context.neck)};
  estimate.at(0, 0) = estimate.at(1, 1) = 1.0;
  estimate.at(2, 2) = 25.0;

  constexpr int kRounds = 4;
  fit(context, see, estimate, kRounds);
  return true;
}

}  // namespace

bool localize(WorldModel& world, const soccer::See& see) {
  SelfState& self = world.self;
  SelfTracker& tracker = world.self_tracker;
  const SeeContext context{world, world.parameters->landmark_distances, self.neck.degrees(),
                           focus_error_of(world)};

  const double body_before = tracker.pose.mean[2];
  // Small violations are normal; a violation above one half width means that the pose is wrong.
  constexpr double kContradiction = 1.6;
  bool reinitialize = false;

  bool seen = std::ranges::any_of(see.objects, [](const Observation& o) {
    return o.kind == ObservedKind::kLandmark || o.kind == ObservedKind::kLine;
  });
  if (tracker.located && seen) {
    constexpr int kRounds = 5;  // one suffices unless messages were lost or the agent was moved
    reinitialize = fit(context, see, tracker.pose, kRounds) > kContradiction;
  }

  if (!tracker.located || reinitialize) {
    Gaussian<3> fresh_pose;
    // The focus point position is still unknown.
    const SeeContext blind{world, context.distances, context.neck, 2.0 * self.focus_distance};
    if (fit_from_scratch(blind, see, fresh_pose)) {
      tracker.pose = fresh_pose;
      tracker.located = true;
    } else {
      seen = false;
    }
  }
  if (!seen) return false;

  // Rounding errors bound the accuracy.
  constexpr double kMinVariance = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) tracker.pose.at(i, i) += kMinVariance;

  const double corrected = math::normalize_degrees(tracker.pose.mean[2] - body_before);
  self.velocity = soccer::rotated_degrees(self.velocity, corrected * tracker.heading_follows_body);
  return true;
}

}  // namespace cls::player
