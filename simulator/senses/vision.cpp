// Seeing: geometry of an observation, its errors, and what of it is told (simulation model 7).
#include "simulator/senses/vision.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/sight_lines.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;
using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;

constexpr double kDistanceStep = 0.1;
constexpr double kDistanceChangeStep = 0.02;
constexpr double kGaussianDistanceChangeStep = 0.01;
constexpr double kDirectionChangeStep = 0.1;
constexpr double kPointDeviation = 1.25;  // degrees, at no distance at all
constexpr int kFirstKickMarkVersion = 13;
constexpr int kFirstFocusVersion = 18;

/// From where on something is never told any more; between the two it is missed now and then.
struct Range {
  double far;
  double too_far;
};

/// The observer, with everything that is the same for all objects.
struct Eyes {
  const Player& player;
  const soccer::PlayerType& type;
  const soccer::ServerParams& params;
  Vec2 focus;
  bool focus_elsewhere;
  Vec2 face;  ///< unit vector
  double half_cone;
  double edge;  ///< cosine to the face below which surely nothing is in view, as signed_square
  double reach_around;  ///< squared distance within which things are near, and a bit more
  bool high_quality;
  Range landmark_motion = {20.0, 40.0};
  Range ball_motion = {20.0, 40.0};
  Range number = {20.0, 40.0};
  Range team = {40.0, 60.0};
  std::array<soccer::TeamName, 2> team_names = {};
};

/// Keeps the order of numbers, so that lengths can be compared without their roots.
double signed_square(double x) { return x * std::fabs(x); }

Eyes open_eyes(const World& world, const Player& player) {
  const bool with_focus = player.client_version >= kFirstFocusVersion;
  const double direction = face_direction(player);
  const double half_cone = view_cone(player.view, world.params().visible_angle) / 2.0;
  Eyes eyes{player,
            world.type_of(player),
            world.params(),
            with_focus ? focus_point(player) : player.position,
            with_focus && player.view.focus_distance != 0.0,
            soccer::polar_radians(1.0, direction),
            half_cone,
            signed_square(math::cos(half_cone) - 1e-6),
            signed_square(world.params().visible_distance) * (1.0 + 1e-9),
            player.view.quality == soccer::ViewQuality::kHigh};
  if (with_focus) {
    const soccer::PlayerType& type = eyes.type;
    eyes.landmark_motion = {type.flag_chg_far_length, type.flag_chg_too_far_length};
    eyes.ball_motion = {type.ball_vel_far_length, type.ball_vel_too_far_length};
    eyes.number = {type.unum_far_length, type.unum_too_far_length};
    eyes.team = {type.team_far_length, type.team_too_far_length};
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    eyes.team_names[side == Side::kRight ? 1 : 0] = shown_name(world, player.side, side);
  }
  return eyes;
}

/// An object that is in view, or near although it is not.
struct Sighting {
  bool in_view;
  Vec2 offset;
  double distance;
  double direction;  ///< radians, relative to the face; right in whole degrees
};

/// As soccer::direction_radians, several times as fast, but only within kRough of it. The
/// polynomial is Abramowitz and Stegun's 4.4.47.
double rough_direction(const Vec2& offset) {
  const double x = std::fabs(offset.x);
  const double y = std::fabs(offset.y);
  const double slope = std::min(x, y) / std::max(x, y);
  const double square = slope * slope;
  double angle =
      slope *
      (0.9998660 +
       square * (-0.3302995 + square * (0.1801410 + square * (-0.0851330 + square * 0.0208351))));
  if (y > x) angle = math::kPi / 2.0 - angle;
  if (offset.x < 0.0) angle = math::kPi - angle;
  return std::copysign(angle, offset.y);
}
constexpr double kRough = 2e-5;

/// Could a direction that is off by kRough be told, or be in view, where the right one is not?
bool is_doubtful(const Eyes& eyes, double direction) {
  const double magnitude = std::fabs(direction);
  const double degrees = math::to_degrees(magnitude);
  const double from_rounding = std::fabs(degrees - std::floor(degrees) - 0.5);
  return from_rounding < math::to_degrees(kRough) ||
         std::fabs(magnitude - eyes.half_cone) < kRough || magnitude > math::kPi - kRough;
}

double relative_to_face(const Eyes& eyes, double direction) {
  return math::normalize_radians(math::normalize_radians(direction - eyes.player.body) -
                                 eyes.player.neck);
}

double direction_seen(const Eyes& eyes, const Vec2& offset, double squared_distance) {
  if (squared_distance > 0.0) {
    const double rough = relative_to_face(eyes, rough_direction(offset));
    if (!is_doubtful(eyes, rough)) return rough;
  }
  return relative_to_face(eyes, soccer::direction_radians(offset));
}

// By reference: of two numbers that came in registers the compiler would make one by way of memory.
std::optional<Sighting> sight(const Eyes& eyes, const Vec2& object, double reach) {
  const Vec2 offset = object - eyes.player.position;
  const double squared = offset.squared_length();
  if (squared > eyes.reach_around && signed_square(dot(offset, eyes.face)) < squared * eyes.edge) {
    return std::nullopt;
  }
  const double distance = std::sqrt(squared);
  const bool near = distance <= eyes.params.visible_distance;
  const double direction = direction_seen(eyes, offset, squared);
  const bool in_view = std::fabs(direction) < eyes.half_cone && distance < reach;
  if (!in_view && !near) return std::nullopt;
  return Sighting{in_view, offset, distance, direction};
}

int whole_degrees(double radians) { return static_cast<int>(std::rint(exact_degrees(radians))); }

int seen_angle(const Eyes& eyes, double angle) {
  return whole_degrees(math::normalize_radians(angle - eyes.player.body - eyes.player.neck));
}

struct NoiseRates {
  double distance;
  double focus_distance;
};

/// The distance that the player is told.
double noisy_distance(const Eyes& eyes, const DistanceSteps& steps, const NoiseRates& rates,
                      Vec2 object, double distance, RandomStream& noise) {
  const double from_focus = eyes.focus_elsewhere ? soccer::distance(object, eyes.focus) : distance;
  if (eyes.player.view.gaussian) {
    const double deviation = distance * rates.distance + from_focus * rates.focus_distance;
    return std::max(0.0, noise.normal(distance, deviation));
  }
  const double off = distance - steps(distance);
  const double off_focus = eyes.focus_elsewhere ? from_focus - steps(from_focus) : off;
  return math::quantize(std::max(0.0, distance - (off_focus + off) / 2.0), kDistanceStep);
}

bool missed(double distance, Range range, RandomStream& noise) {
  const double probability = (distance - range.far) / (range.too_far - range.far);
  if (probability >= 1.0) return true;
  if (probability <= 0.0) return false;
  return noise.bernoulli(probability);
}

void tell_motion(const Eyes& eyes, const Sighting& seen, Vec2 velocity, Observation& out) {
  out.distance_change = 0.0;
  out.direction_change = 0.0;
  if (seen.distance == 0.0) return;
  const Vec2 relative = velocity - eyes.player.velocity;
  const Vec2 away = seen.offset / seen.distance;
  const double radial = dot(relative, away);
  const double turning = exact_degrees(cross(away, relative) / seen.distance);
  if (turning != 0.0) out.direction_change = math::quantize(turning, kDirectionChangeStep);
  out.distance_change =
      eyes.player.view.gaussian
          ? math::quantize(radial * out.distance / seen.distance, kGaussianDistanceChangeStep)
          : out.distance * math::quantize(radial / seen.distance, kDistanceChangeStep);
}

/// What is told of everything: kind, direction and, in high quality, the distance.
Observation& begin(const Eyes& eyes, const Sighting& seen, ObservedKind kind, ObservedKind near,
                   double distance, soccer::See& out) {
  Observation& object = out.objects.emplace_back();
  object.kind = seen.in_view ? kind : near;
  object.detail = eyes.high_quality ? ObservedDetail::kPosition : ObservedDetail::kDirection;
  object.direction = static_cast<std::int16_t>(whole_degrees(seen.direction));
  object.distance = distance;
  return object;
}

void see_landmarks(const VisionModel& model, const Eyes& eyes, RandomStream& noise,
                   soccer::See& out) {
  const NoiseRates rates = {eyes.type.land_dist_noise_rate, eyes.type.land_focus_dist_noise_rate};
  for (std::size_t i = 0; i < soccer::kLandmarks.size(); ++i) {
    const soccer::Landmark& landmark = soccer::kLandmarks[i];
    const auto seen = sight(eyes, landmark.position, eyes.type.flag_max_observation_length);
    if (!seen) continue;
    const double distance =
        noisy_distance(eyes, model.landmarks, rates, landmark.position, seen->distance, noise);
    const ObservedKind near =
        landmark.is_goal() ? ObservedKind::kCloseGoal : ObservedKind::kCloseFlag;
    Observation& object = begin(eyes, *seen, ObservedKind::kLandmark, near, distance, out);
    object.index = static_cast<std::uint8_t>(i);
    if (!seen->in_view || !eyes.high_quality) continue;
    if (missed(distance, eyes.landmark_motion, noise)) continue;
    object.detail = ObservedDetail::kMotion;
    tell_motion(eyes, *seen, Vec2{}, object);
  }
}

NoiseRates thing_rates(const Eyes& eyes) {
  return {eyes.type.dist_noise_rate, eyes.type.focus_dist_noise_rate};
}

void see_ball(const VisionModel& model, const Eyes& eyes, const Ball& ball, RandomStream& noise,
              soccer::See& out) {
  const auto seen = sight(eyes, ball.position, eyes.type.ball_max_observation_length);
  if (!seen) return;
  const double distance =
      noisy_distance(eyes, model.things, thing_rates(eyes), ball.position, seen->distance, noise);
  Observation& object =
      begin(eyes, *seen, ObservedKind::kBall, ObservedKind::kCloseBall, distance, out);
  if (!seen->in_view || !eyes.high_quality) return;
  if (missed(distance, eyes.ball_motion, noise)) return;
  object.detail = ObservedDetail::kMotion;
  tell_motion(eyes, *seen, ball.velocity, object);
}

void tell_arm(const World& world, const Eyes& eyes, const Player& other, double distance,
              RandomStream& noise, Observation& out) {
  if (!is_pointing(world, other)) return;
  const double least = math::to_radians(kPointDeviation);
  const double share = distance / eyes.type.team_too_far_length;
  const double deviation = share * share * share * share * (math::kPi - least) + least;
  const double direction =
      arm_aim(other).direction + (other.neck + other.body - eyes.player.body - eyes.player.neck);
  out.pointing = true;
  out.point_direction = static_cast<std::int16_t>(
      whole_degrees(math::normalize_radians(noise.normal(direction, deviation))));
}

void see_player(const VisionModel& model, const World& world, const Eyes& eyes, const Player& other,
                RandomStream& noise, soccer::See& out) {
  const auto seen = sight(eyes, other.position, eyes.type.player_max_observation_length);
  if (!seen) return;
  const double distance =
      noisy_distance(eyes, model.things, thing_rates(eyes), other.position, seen->distance, noise);
  Observation& object =
      begin(eyes, *seen, ObservedKind::kPlayer, ObservedKind::kClosePlayer, distance, out);
  if (!seen->in_view || missed(distance, eyes.team, noise)) return;
  object.team = eyes.team_names[other.side == Side::kRight ? 1 : 0];
  const bool anonymous = missed(distance, eyes.number, noise);
  if (!anonymous) {
    object.unum = static_cast<std::uint8_t>(other.unum);
    object.goalie = other.goalie;
  }
  if (!eyes.high_quality) return;
  if (!anonymous) {
    object.detail = ObservedDetail::kPose;
    tell_motion(eyes, *seen, other.velocity, object);
    object.body = static_cast<std::int16_t>(seen_angle(eyes, other.body));
    object.head = static_cast<std::int16_t>(seen_angle(eyes, other.body + other.neck));
  }
  tell_arm(world, eyes, other, seen->distance, noise, object);
  if (other.tackle_cycles > 0) {
    object.mark = soccer::ActionMark::kTackling;
  } else if (eyes.player.client_version >= kFirstKickMarkVersion && other.kick_cycles >= 0) {
    object.mark = soccer::ActionMark::kKicked;
  }
}

void see_lines(const VisionModel& model, const Eyes& eyes, soccer::See& out) {
  for (const SightLine& line : lines_in_sight(eyes.player)) {
    Observation& object = out.objects.emplace_back();
    object.kind = ObservedKind::kLine;
    object.detail = eyes.high_quality ? ObservedDetail::kPosition : ObservedDetail::kDirection;
    object.index = static_cast<std::uint8_t>(line.line);
    object.distance = math::quantize(model.landmarks(line.distance), kDistanceStep);
    object.direction = static_cast<std::int16_t>(whole_degrees(line.direction));
  }
}

constexpr int kMantissaBits = 6;
constexpr int kRestBits = 52 - kMantissaBits;

/// Exponent and the beginning of the mantissa: grows with a positive number.
std::uint64_t first_bits(double value) { return std::bit_cast<std::uint64_t>(value) >> kRestBits; }

}  // namespace

DistanceSteps::DistanceSteps(double step) : step_(step) {
  constexpr double kShortest = 0.05;
  constexpr double kLongest = 250.0;
  constexpr double kMostValues = 100000.0;
  if (step_ < math::kEps) return;
  const double first = std::rint(math::log(kShortest) / step_);
  const double last = std::rint(math::log(kLongest) / step_);
  if (last - first > kMostValues) return;
  first_ = static_cast<int>(first);
  for (double k = first; k <= last; k += 1.0) values_.push_back(math::exp(k * step_));
  for (double k = first; k <= last + 1.0; k += 1.0) edges_.push_back(math::exp((k - 0.5) * step_));
  make_table();
}

// Only for steps so long that few edges have the same first bits.
void DistanceSteps::make_table() {
  constexpr double kShortestStep = 0.5 / (1 << kMantissaBits);
  if (step_ < kShortestStep) return;
  first_bits_ = first_bits(edges_.front()) + 1;
  const std::uint64_t last_bits = first_bits(edges_.back());
  std::uint32_t edge = 0;
  for (std::uint64_t bits = first_bits_; bits < last_bits; ++bits) {
    const double least = std::bit_cast<double>(bits << kRestBits);
    while (edges_[edge + 1] < least) ++edge;
    begins_.push_back(edge);
  }
}

// Null where the table does not reach, and so near to an edge that only the logarithm decides.
const double* DistanceSteps::look_up(double distance) const {
  constexpr double kMargin = 1e-12;
  const std::uint64_t bits = first_bits(distance) - first_bits_;
  if (bits >= begins_.size()) return nullptr;
  std::size_t edge = begins_[bits];
  while (edges_[edge + 1] < distance) ++edge;
  const double margin = distance * kMargin;
  if (distance - edges_[edge] < margin || edges_[edge + 1] - distance < margin) return nullptr;
  return &values_[edge];
}

double DistanceSteps::operator()(double distance) const {
  if (step_ < math::kEps) return distance + math::kEps;
  if (const double* value = look_up(distance + math::kEps)) return *value;
  const double multiple = std::rint(math::log(distance + math::kEps) / step_);
  const double index = multiple - first_;
  if (index >= 0.0 && index < static_cast<double>(values_.size())) {
    return values_[static_cast<std::size_t>(index)];
  }
  return math::exp(multiple * step_);
}

void see(const VisionModel& model, const World& world, Slot observer, RandomStream& noise,
         soccer::See& out) {
  const Eyes eyes = open_eyes(world, world.player(observer));
  out.time = world.clock.time;
  out.objects.clear();
  see_landmarks(model, eyes, noise, out);
  see_ball(model, eyes, world.ball, noise, out);
  for (const Player& other : world.players) {
    if (other.enabled && other.slot() != observer) {
      see_player(model, world, eyes, other, noise, out);
    }
  }
  see_lines(model, eyes, out);
}

}  // namespace cls::simulator
