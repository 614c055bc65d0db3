// Generates direct, lead and through passes, and crosses of the agent.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "player/planner/generator_parameters.h"
#include "player/planner/generators.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr PassSearchParameters kNumbers = kGenerators.pass;

/// Inside the pitch by a margin, and not near our goal line.
bool may_receive_at(Vec2 point, double margin) {
  constexpr double kOwnGoalMargin = 5.0;
  return inside_pitch(point, margin) && point.x > -soccer::kHalfLength + kOwnGoalMargin;
}

/// Points around a receiver for lead passes: rings of directions.
constexpr std::array<double, 6> kRings{1.1, 2.2, 3.3, 4.4, 6.0, 8.0};
constexpr int kRingDirections = 24;

const std::vector<Vec2>& ring_points() {
  static const std::vector<Vec2> points = [] {
    std::vector<Vec2> all;
    for (const double radius : kRings) {
      for (int i = 0; i < kRingDirections; ++i) {
        all.push_back(soccer::polar_degrees(radius, 360.0 * i / kRingDirections));
      }
    }
    return all;
  }();

  return points;
}

/// A direction of through passes.
struct Ray {
  AngleDeg angle;
  Vec2 unit;
};

const std::vector<Ray>& through_rays() {
  static const std::vector<Ray> rays = [] {
    std::vector<Ray> all;
    for (int ray = -7; ray <= 7; ++ray) {
      const AngleDeg angle(ray * 40.0 / 7.0);
      all.push_back({angle, soccer::polar(1.0, angle)});
    }
    return all;
  }();

  return rays;
}

class PassSearch {
 public:
  PassSearch(const PlannerField& field, std::vector<PlanAction>& out) : field_(field), out_(out) {
    const WorldModel& world = field.world;
    const PlannerParameters& parameters = field.parameters;

    for (const FieldPlayer& teammate : field.teammates) {
      if (teammate.unum == 0 || teammate.age > parameters.pass_age || teammate.ghost ||
          teammate.lying) {
        continue;
      }

      if (distance(teammate.position, field.ball) > parameters.pass_distance) continue;
      if (teammate.position.x > world.lines.offside && field.open_play) continue;
      if (teammate.goalie && teammate.position.x < kNumbers.goalie_x) continue;
      receivers_.push_back(&teammate);
    }

    usual_speed_ = ReachTable(world.server(), world.parameters->type(0)).settled_speed();
  }

  void run() {
    for (const FieldPlayer* receiver : receivers_) {
      direct(*receiver);
      lead(*receiver);
      through(*receiver);
    }
  }

 private:
  /// Conservative estimate of the cycles until the receiver is at the point.
  int receiver_cycles(const FieldPlayer& receiver, Vec2 point, bool free_run) const {
    const Vec2 way = point - receiver.rest;
    double dist = way.length();
    if (!free_run) dist = kNumbers.care * dist + receiver.unseen_run;

    const int turns = dist < receiver.control
                          ? 0
                          : turns_to_face(receiver, way, way.length(),
                                          slack_for(receiver.control, dist, kFifteenDegrees));

    return turns + receiver.reach->cycles(dist) + (turns > 0 ? 1 : 0);
  }

  bool nearest_receiver(const FieldPlayer& receiver, Vec2 point) const {
    const double own = squared_distance(receiver.rest, point);
    return std::ranges::none_of(receivers_, [&](const FieldPlayer* other) {
      return other != &receiver && squared_distance(other->rest, point) < own;
    });
  }

  struct Speeds {
    double min_first = 0.0;
    double min_arrival = 0.0;
    double max_arrival = 3.0;
  };

  /// Adds a pass to the point that takes `first` to `last` cycles: the fastest one that no opponent
  /// can stop.
  bool try_ball(const FieldPlayer& receiver, Vec2 point, int first, int last, const Speeds& speeds,
                PlanTag tag) {
    const Vec2 way = point - field_.ball;
    const double length = way.length();
    const Vec2 direction = way / length;
    const double max = field_.world.server().ball_speed_max;
    int theirs_from = kNever;  // an opponent is at the point from this cycle on

    for (int n = std::max(1, first); n <= std::min(last, kPlannerHorizon); ++n) {
      const double speed = field_.first_speed(length, n);
      if (speed > max) continue;
      if (speed < speeds.min_first) break;

      const double arrival = speed * field_.speed_left(n);
      if (arrival > speeds.max_arrival) continue;
      if (arrival < speeds.min_arrival) break;

      const int kicks = field_.kicks_for(direction, speed);
      if (!field_.open_play && !reachable_at_once(direction, speed)) continue;

      const PlannerParameters& parameters = field_.parameters;
      const StopRules rules{
          .head_start = kicks - 1,
          .count_age = tag != PlanTag::kStrictThrough ||
                       (point.x < field_.world.lines.offside && point.x < 30.0),
          .extra_reach = point.x < 25.0 ? parameters.pass_margin : parameters.pass_margin_deep};

      const int arrives = n + kicks - 1;
      if (arrives >= theirs_from) continue;
      if (tag != PlanTag::kStrictDirect &&
          opponent_gets_there(field_, point, arrives, rules.count_age)) {
        theirs_from = arrives;
        continue;
      }
      if (is_stopped(field_, {direction, speed, n}, rules)) continue;
      add(receiver, point, speed, n, kicks, tag);
      return true;
    }
    return false;
  }

  bool reachable_at_once(Vec2 direction, double speed) const {
    return (direction * speed - field_.ball_velocity).length() <= field_.kick_limit;
  }

  void add(const FieldPlayer& receiver, Vec2 point, double speed, int n, int kicks, PlanTag tag) {
    const bool behind_them =
        field_.ball.x <= 30.0 && point.x > field_.world.lines.their_defense_players;
    out_.push_back({.category = PlanCategory::kPass,
                    .tag = tag,
                    .sender = field_.self.unum,
                    .target = receiver.unum,
                    .target_point = point,
                    .first_speed = speed,
                    .duration = n + kicks,
                    .kicks = kicks,
                    .final = behind_them});
  }

  /// Speed of a ball that the receiver can still control, with `dashes` toward it.
  static double fastest_arrival(const FieldPlayer& receiver, double dashes) {
    const double push = 100.0 * receiver.type->dash_power_rate * receiver.type->effort_max;
    return receiver.control + dashes * push;
  }

  int fewest_cycles(double length) const {
    const double max = field_.world.server().ball_speed_max;
    int n = 1;
    while (n < kPlannerHorizon && max * field_.roll(n) < length) ++n;
    return n;
  }

  void direct(const FieldPlayer& receiver) {
    const Vec2 point = receiver.rest;
    const double length = distance(point, field_.ball);
    const double own_area = kickable_area(field_.world);

    if (length < kNumbers.shortest * own_area ||
        length > kNumbers.longest * field_.longest_roll() || !may_receive_at(point, 1.5)) {
      return;
    }
    if (distance(point, kOwnGoal) < kNumbers.own_goal && point.x < field_.ball.x) return;

    const Speeds speeds{usual_speed_, receiver.reach->settled_speed(),
                        fastest_arrival(receiver, kNumbers.direct_push)};
    const int ready = receiver.reach->cycles(receiver.unseen_run);
    const int first = std::max({3, fewest_cycles(length), ready});
    try_ball(receiver, point, first, first + 4, speeds, PlanTag::kStrictDirect);
  }

  void lead(const FieldPlayer& receiver) {
    const Speeds speeds{usual_speed_, field_.parameters.lead_arrival_speed,
                        fastest_arrival(receiver, kNumbers.lead_push)};
    for (std::size_t ring = 0; ring < kRings.size(); ++ring) {
      for (std::size_t i = 0; i < kRingDirections; i += ring < 2 ? 2 : 1) {
        const Vec2 point = receiver.rest + ring_points()[ring * kRingDirections + i];
        const double length = distance(point, field_.ball);
        if (length < 3.0 || length > kNumbers.longest * field_.longest_roll() ||
            !may_receive_at(point, 2.0)) {
          continue;
        }
        if (distance(point, kOwnGoal) < kNumbers.own_goal && point.x < field_.ball.x + 1.0) {
          continue;
        }
        if (!nearest_receiver(receiver, point)) continue;

        const int ready = receiver_cycles(receiver, point, false);
        const int first = std::max({3, fewest_cycles(length), ready});
        try_ball(receiver, point, first, first + 3, speeds, PlanTag::kStrictLead);
      }
    }
  }

  void through(const FieldPlayer& receiver) {
    const double offside = field_.world.lines.offside;
    const double min_x = std::min({std::max(10.0, field_.ball.x + 10.0), offside - 10.0, 31.0});
    if (receiver.position.x < min_x - 30.0) return;

    const Speeds speeds{field_.parameters.through_first_speed, 0.0,
                        fastest_arrival(receiver, kNumbers.lead_push)};
    const bool runs = receiver.velocity.length() > 0.2;
    const AngleDeg heading = runs ? AngleDeg::of(receiver.velocity) : AngleDeg();

    for (const Ray& ray : through_rays()) {
      const bool on_its_way = runs && (heading - ray.angle).abs() < 15.0;
      for (double far = 6.0; far <= 30.0; far += 2.0) {
        const Vec2 point = receiver.rest + ray.unit * far;
        if (point.x < min_x || !may_receive_at(point, 2.5) || point.x > 50.0) continue;

        const double length = distance(point, field_.ball);
        if (length < 5.0 || length > kNumbers.longest_through * field_.longest_roll()) continue;
        if (!nearest_receiver(receiver, point)) continue;

        const int ready = receiver_cycles(receiver, point, true) + (on_its_way ? 0 : 1);
        const int first = std::max(fewest_cycles(length), ready);
        try_ball(receiver, point, first, first + 3, speeds, PlanTag::kStrictThrough);
      }
    }
  }

  const PlannerField& field_;
  std::vector<PlanAction>& out_;
  base::FixedList<const FieldPlayer*, 22> receivers_;
  double usual_speed_ = 1.0;
};

/// Smallest angle between a direction and the opponents up to `far` meters from the ball, degrees.
double free_angle(const PlannerField& field, AngleDeg straight, double off, double far) {
  double gap = 180.0;
  for (const FieldOpponent& opponent : field.opponents) {
    if (squared_distance(opponent.position, field.ball) > far * far) continue;
    const AngleDeg there = AngleDeg::of(opponent.position - field.ball);
    gap = std::min(gap, (there - straight - off).abs());
  }

  return gap;
}

/// The longest cross along a direction, up to `dist` meters, that its receiver gets first.
std::optional<PlanAction> cross_along(const PlannerField& field, const FieldPlayer& receiver,
                                      Vec2 direction, double dist) {
  const double max = field.world.server().ball_speed_max;

  for (double back = 0.0; back <= 3.6; back += 0.9) {
    const double length = dist - back;
    const Vec2 point = field.ball + direction * length;
    const int ready = cycles_to_get(receiver, point) + 1;

    for (int n = std::max(2, ready); n <= 12; ++n) {
      const double speed = field.first_speed(length, n);
      if (speed > max) continue;
      if (speed < field.parameters.cross_speed * max) break;
      if (speed * field.speed_left(n) < 1.0) break;

      const int kicks = field.kicks_for(direction, speed);
      if (!field.open_play && kicks > 1) continue;
      const StopRules rules{.head_start = kicks - 1, .count_age = false};
      if (is_stopped(field, {direction, speed, n}, rules)) continue;

      return PlanAction{.category = PlanCategory::kPass,
                        .tag = PlanTag::kCross,
                        .sender = field.self.unum,
                        .target = receiver.unum,
                        .target_point = point,
                        .first_speed = speed,
                        .duration = std::max(1, n + kicks - 3),
                        .kicks = kicks};
    }
  }

  return std::nullopt;
}

}  // namespace

void add_passes(const PlannerField& field, std::vector<PlanAction>& out) {
  if (soccer::is_penalty_mode(field.world.game.mode)) return;
  PassSearch(field, out).run();
}

void add_crosses(const PlannerField& field, std::vector<PlanAction>& out) {
  const PlannerParameters& parameters = field.parameters;
  if (distance(field.ball, kOpponentGoal) > parameters.cross_range) return;
  if (soccer::is_penalty_mode(field.world.game.mode)) return;
  const double longest = field.world.server().ball_speed_max * field.roll(9);
  const double shortest = kNumbers.shortest * kickable_area(field.world);

  for (const FieldPlayer& teammate : field.teammates) {
    if (teammate.unum == 0 || teammate.ghost || teammate.age >= 4 || teammate.lying) continue;
    if (teammate.position.x > field.world.lines.offside && field.open_play) continue;
    if (distance(teammate.position, kOpponentGoal) > parameters.cross_target_range) continue;
    const double dist = distance(teammate.position, field.ball);
    if (dist < shortest || dist > longest) continue;

    const AngleDeg straight = AngleDeg::of(teammate.position - field.ball);
    Highest<PlanAction> best{-1.0};
    for (const double off : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
      const double gap = free_angle(field, straight, off, dist + 2.0);
      if (gap <= best.score) continue;
      const auto cross = cross_along(field, teammate, soccer::polar(1.0, straight + off), dist);
      if (cross) best.offer(gap, *cross);
    }

    if (best.score >= 0.0) out.push_back(best.value);
  }
}

}  // namespace cls::player
