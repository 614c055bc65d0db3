// Visual sensor: geometry of observations, their noise, and the fields sent
// (docs/spec/simulation-model.md 7).
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
constexpr double kPointDeviation = 1.25;  // degrees, at distance 0
constexpr int kFirstKickMarkVersion = 13;
constexpr int kFirstFocusVersion = 18;

/// Below `far` a detail is always sent, above `too_far` never; in between at random.
struct Range {
  double far;
  double too_far;
};

/// The observing player, and values that are the same for all objects.
struct Observer {
  const Player& player;
  const soccer::PlayerType& type;
  const soccer::ServerParams& params;
  Vec2 focus;
  bool focus_elsewhere;
  Vec2 face;  ///< unit vector
  double half_cone;
  double edge;  ///< signed_square of the cosine to the face below which nothing can be in view
  double near_squared;  ///< squared visible_distance plus a margin
  bool high_quality;
  Range landmark_motion = {20.0, 40.0};
  Range ball_motion = {20.0, 40.0};
  Range unum = {20.0, 40.0};
  Range team = {40.0, 60.0};
  std::array<soccer::TeamName, 2> team_names = {};
};

/// Monotonic, so lengths can be compared without square roots.
double signed_square(double x) { return x * std::fabs(x); }

Observer make_observer(const World& world, const Player& player) {
  const bool with_focus = player.client_version >= kFirstFocusVersion;
  const double direction = face_direction(player);
  const double half_cone = view_cone(player.view, world.params().visible_angle) / 2.0;

  Observer observer{player,
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
    const soccer::PlayerType& type = observer.type;
    observer.landmark_motion = {type.flag_chg_far_length, type.flag_chg_too_far_length};
    observer.ball_motion = {type.ball_vel_far_length, type.ball_vel_too_far_length};
    observer.unum = {type.unum_far_length, type.unum_too_far_length};
    observer.team = {type.team_far_length, type.team_too_far_length};
  }

  for (const Side side : {Side::kLeft, Side::kRight}) {
    observer.team_names[side == Side::kRight ? 1 : 0] = visible_team_name(world, player.side, side);
  }
  return observer;
}

/// An object in the view cone, or within visible_distance.
struct Sighting {
  bool in_view;
  Vec2 offset;
  double distance;
  double direction;  ///< radians, relative to the face; exact when rounded to degrees
};

/// Approximates soccer::direction_radians with a maximum error of kDirectionError, several times as
/// fast. The polynomial is 4.4.47 of Abramowitz and Stegun.
double approximate_direction(const Vec2& offset) {
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
constexpr double kDirectionError = 2e-5;

/// True if an error of kDirectionError could change the rounded direction or the visibility.
bool needs_exact_direction(const Observer& observer, double direction) {
  const double magnitude = std::fabs(direction);
  const double degrees = math::to_degrees(magnitude);
  const double from_rounding = std::fabs(degrees - std::floor(degrees) - 0.5);

  return from_rounding < math::to_degrees(kDirectionError) ||
         std::fabs(magnitude - observer.half_cone) < kDirectionError ||
         magnitude > math::kPi - kDirectionError;
}

double relative_to_face(const Observer& observer, double direction) {
  return math::normalize_radians(math::normalize_radians(direction - observer.player.body) -
                                 observer.player.neck);
}

double direction_to(const Observer& observer, const Vec2& offset, double squared_distance) {
  if (squared_distance > 0.0) {
    const double rough = relative_to_face(observer, approximate_direction(offset));
    if (!needs_exact_direction(observer, rough)) return rough;
  }

  return relative_to_face(observer, soccer::direction_radians(offset));
}

// Vectors by reference: passed by value, the compiler would copy them from registers to memory.
std::optional<Sighting> sight(const Observer& observer, const Vec2& object, double reach) {
  const Vec2 offset = object - observer.player.position;
  const double squared = offset.squared_length();
  if (squared > observer.near_squared &&
      signed_square(dot(offset, observer.face)) < squared * observer.edge) {
    return std::nullopt;
  }

  const double distance = std::sqrt(squared);
  const bool near = distance <= observer.params.visible_distance;
  const double direction = direction_to(observer, offset, squared);
  const bool in_view = std::fabs(direction) < observer.half_cone && distance < reach;
  if (!in_view && !near) return std::nullopt;
  return Sighting{in_view, offset, distance, direction};
}

int seen_angle(const Observer& observer, double angle) {
  return rounded_degrees(
      math::normalize_radians(angle - observer.player.body - observer.player.neck));
}

struct NoiseRates {
  double distance;
  double focus_distance;
};

/// Distance as sent, with quantization or Gaussian noise.
double noisy_distance(const Observer& observer, const DistanceQuantizer& quantize,
                      const NoiseRates& rates, Vec2 object, double distance, RandomStream& noise) {
  const double from_focus =
      observer.focus_elsewhere ? soccer::distance(object, observer.focus) : distance;

  if (observer.player.view.gaussian) {
    const double deviation = distance * rates.distance + from_focus * rates.focus_distance;
    return std::max(0.0, noise.normal(distance, deviation));
  }

  const double off = distance - quantize(distance);
  const double off_focus = observer.focus_elsewhere ? from_focus - quantize(from_focus) : off;
  return math::quantize(std::max(0.0, distance - (off_focus + off) / 2.0), kDistanceStep);
}

bool is_missed(double distance, Range range, RandomStream& noise) {
  const double probability = (distance - range.far) / (range.too_far - range.far);
  if (probability >= 1.0) return true;
  if (probability <= 0.0) return false;
  return noise.bernoulli(probability);
}

void set_motion(const Observer& observer, const Sighting& seen, Vec2 velocity, Observation& out) {
  out.distance_change = 0.0;
  out.direction_change = 0.0;
  if (seen.distance == 0.0) return;

  const Vec2 relative = velocity - observer.player.velocity;
  const Vec2 away = seen.offset / seen.distance;
  const double radial = dot(relative, away);
  const double turning = exact_degrees(cross(away, relative) / seen.distance);

  if (turning != 0.0) out.direction_change = math::quantize(turning, soccer::kDirectionChangeStep);
  out.distance_change =
      observer.player.view.gaussian
          ? math::quantize(radial * out.distance / seen.distance,
                           soccer::kGaussianDistanceChangeStep)
          : out.distance * math::quantize(radial / seen.distance, soccer::kDistanceChangeStep);
}

/// Adds an observation with the fields that every object has: kind, direction and, in high quality,
/// distance.
Observation& add_observation(const Observer& observer, const Sighting& seen, ObservedKind kind,
                             ObservedKind near, double distance, soccer::See& out) {
  Observation& object = out.objects.emplace_back();
  object.kind = seen.in_view ? kind : near;
  object.detail = observer.high_quality ? ObservedDetail::kPosition : ObservedDetail::kDirection;
  object.direction = static_cast<std::int16_t>(rounded_degrees(seen.direction));
  object.distance = distance;
  return object;
}

void see_landmarks(const VisionModel& model, const Observer& observer, RandomStream& noise,
                   soccer::See& out) {
  const NoiseRates rates = {observer.type.land_dist_noise_rate,
                            observer.type.land_focus_dist_noise_rate};

  for (std::size_t i = 0; i < soccer::kLandmarks.size(); ++i) {
    const soccer::Landmark& landmark = soccer::kLandmarks[i];
    const auto seen = sight(observer, landmark.position, observer.type.flag_max_observation_length);
    if (!seen) continue;

    const double distance =
        noisy_distance(observer, model.landmarks, rates, landmark.position, seen->distance, noise);
    const ObservedKind near =
        landmark.is_goal() ? ObservedKind::kCloseGoal : ObservedKind::kCloseFlag;
    Observation& object =
        add_observation(observer, *seen, ObservedKind::kLandmark, near, distance, out);
    object.index = static_cast<std::uint8_t>(i);
    if (!seen->in_view || !observer.high_quality) continue;
    if (is_missed(distance, observer.landmark_motion, noise)) continue;
    object.detail = ObservedDetail::kMotion;
    set_motion(observer, *seen, Vec2{}, object);
  }
}

NoiseRates object_rates(const Observer& observer) {
  return {observer.type.dist_noise_rate, observer.type.focus_dist_noise_rate};
}

void see_ball(const VisionModel& model, const Observer& observer, const Ball& ball,
              RandomStream& noise, soccer::See& out) {
  const auto seen = sight(observer, ball.position, observer.type.ball_max_observation_length);
  if (!seen) return;

  const double distance = noisy_distance(observer, model.objects, object_rates(observer),
                                         ball.position, seen->distance, noise);
  Observation& object = add_observation(observer, *seen, ObservedKind::kBall,
                                        ObservedKind::kCloseBall, distance, out);

  if (!seen->in_view || !observer.high_quality) return;
  if (is_missed(distance, observer.ball_motion, noise)) return;

  object.detail = ObservedDetail::kMotion;
  set_motion(observer, *seen, ball.velocity, object);
}

void set_arm(const World& world, const Observer& observer, const Player& other, double distance,
             RandomStream& noise, Observation& out) {
  if (!is_pointing(world, other)) return;

  const double min_deviation = math::to_radians(kPointDeviation);
  const double share = distance / observer.type.team_too_far_length;
  const double deviation =
      share * share * share * share * (math::kPi - min_deviation) + min_deviation;
  const double direction = arm_aim(other).direction +
                           (other.neck + other.body - observer.player.body - observer.player.neck);

  out.pointing = true;
  out.point_direction = static_cast<std::int16_t>(
      rounded_degrees(math::normalize_radians(noise.normal(direction, deviation))));
}

void see_player(const VisionModel& model, const World& world, const Observer& observer,
                const Player& other, RandomStream& noise, soccer::See& out) {
  const auto seen = sight(observer, other.position, observer.type.player_max_observation_length);
  if (!seen) return;

  const double distance = noisy_distance(observer, model.objects, object_rates(observer),
                                         other.position, seen->distance, noise);
  Observation& object = add_observation(observer, *seen, ObservedKind::kPlayer,
                                        ObservedKind::kClosePlayer, distance, out);

  if (!seen->in_view || is_missed(distance, observer.team, noise)) return;
  object.team = observer.team_names[other.side == Side::kRight ? 1 : 0];

  const bool anonymous = is_missed(distance, observer.unum, noise);
  if (!anonymous) {
    object.unum = static_cast<std::uint8_t>(other.unum);
    object.goalie = other.goalie;
  }

  if (!observer.high_quality) return;
  if (!anonymous) {
    object.detail = ObservedDetail::kPose;
    set_motion(observer, *seen, other.velocity, object);
    object.body = static_cast<std::int16_t>(seen_angle(observer, other.body));
    object.head = static_cast<std::int16_t>(seen_angle(observer, other.body + other.neck));
  }
  set_arm(world, observer, other, seen->distance, noise, object);

  if (other.tackle_cycles > 0) {
    object.mark = soccer::ActionMark::kTackling;
  } else if (observer.player.client_version >= kFirstKickMarkVersion && other.kick_cycles >= 0) {
    object.mark = soccer::ActionMark::kKicked;
  }
}

void see_lines(const VisionModel& model, const Observer& observer, soccer::See& out) {
  for (const SightLine& line : lines_in_sight(observer.player)) {
    Observation& object = out.objects.emplace_back();
    object.kind = ObservedKind::kLine;
    object.detail = observer.high_quality ? ObservedDetail::kPosition : ObservedDetail::kDirection;
    object.index = static_cast<std::uint8_t>(line.line);
    object.distance = math::quantize(model.landmarks(line.distance), kDistanceStep);
    object.direction = static_cast<std::int16_t>(rounded_degrees(line.direction));
  }
}

constexpr int kMantissaBits = 6;
constexpr int kRestBits = 52 - kMantissaBits;

/// Exponent and leading mantissa bits; monotonic for positive numbers.
std::uint64_t leading_bits(double value) {
  return std::bit_cast<std::uint64_t>(value) >> kRestBits;
}

}  // namespace

DistanceQuantizer::DistanceQuantizer(double step) : step_(step) {
  constexpr double kMinDistance = 0.05;
  constexpr double kMaxDistance = 250.0;
  constexpr double kMaxValues = 100000.0;
  if (step_ < math::kEps) return;
  const double first = std::rint(math::log(kMinDistance) / step_);
  const double last = std::rint(math::log(kMaxDistance) / step_);
  if (last - first > kMaxValues) return;

  first_ = static_cast<int>(first);
  for (double k = first; k <= last; k += 1.0) values_.push_back(math::exp(k * step_));
  for (double k = first; k <= last + 1.0; k += 1.0) edges_.push_back(math::exp((k - 0.5) * step_));
  make_table();
}

// Makes a table only for steps so large that few edges share their leading bits.
void DistanceQuantizer::make_table() {
  constexpr double kMinStep = 0.5 / (1 << kMantissaBits);
  if (step_ < kMinStep) return;

  first_bits_ = leading_bits(edges_.front()) + 1;
  const std::uint64_t end_bits = leading_bits(edges_.back());
  std::uint32_t edge = 0;
  for (std::uint64_t bits = first_bits_; bits < end_bits; ++bits) {
    const double min = std::bit_cast<double>(bits << kRestBits);
    while (edges_[edge + 1] < min) ++edge;
    begins_.push_back(edge);
  }
}

// Null outside the table, and so close to an edge that only the logarithm decides.
const double* DistanceQuantizer::look_up(double distance) const {
  constexpr double kMargin = 1e-12;
  const std::uint64_t bits = leading_bits(distance) - first_bits_;
  if (bits >= begins_.size()) return nullptr;

  std::size_t edge = begins_[bits];
  while (edges_[edge + 1] < distance) ++edge;

  const double margin = distance * kMargin;
  if (distance - edges_[edge] < margin || edges_[edge + 1] - distance < margin) return nullptr;
  return &values_[edge];
}

double DistanceQuantizer::operator()(double distance) const {
  if (step_ < math::kEps) return distance + math::kEps;
  if (const double* value = look_up(distance + math::kEps)) return *value;

  const double multiple = std::rint(math::log(distance + math::kEps) / step_);
  const double index = multiple - first_;
  if (index >= 0.0 && index < static_cast<double>(values_.size())) {
    return values_[static_cast<std::size_t>(index)];
  }
  return math::exp(multiple * step_);
}

int view_interval(const View& view) {
  const int width = static_cast<int>(view.width);
  if (view.synchronous) return width + 1;

  const int rounds = 2 << width;
  return view.quality == soccer::ViewQuality::kHigh ? rounds : rounds / 2;
}

void see(const VisionModel& model, const World& world, Slot slot, RandomStream& noise,
         soccer::See& out) {
  const Observer observer = make_observer(world, world.player(slot));
  out.time = world.clock.time;
  out.objects.clear();

  see_landmarks(model, observer, noise, out);
  see_ball(model, observer, world.ball, noise, out);
  for (const Player& other : world.players) {
    if (other.enabled && other.slot() != slot) {
      see_player(model, world, observer, other, noise, out);
    }
  }
  see_lines(model, observer, out);
}

}  // namespace cls::simulator
