// Searches kick sequences through intermediate ball positions on three rings around the body.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "player/ball_skills/skill_parameters.h"
#include "player/ball_skills/threats.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

constexpr SequenceParameters kNumbers = kSkills.sequence;

struct Ring {
  double share;  ///< fraction of the kickable margin
  int count;
};
constexpr std::array<Ring, 3> kRings{{{0.3, 12}, {0.5, 15}, {0.7, 20}}};
constexpr int kRingPositions = 47;

/// A ring position, for a body along +x.
struct RingPosition {
  Vec2 direction;
  double share;
  double off_body;  ///< angle to the body / 180 degrees
};

const std::array<RingPosition, kRingPositions>& ring_positions() {
  static const auto all = [] {
    std::array<RingPosition, kRingPositions> table;
    std::size_t next = 0;
    for (const Ring& ring : kRings) {
      for (int i = 0; i < ring.count; ++i) {
        const double angle = math::normalize_degrees(360.0 * i / ring.count);
        table[next++] = {soccer::polar_degrees(1.0, angle), ring.share, std::fabs(angle) / 180.0};
      }
    }
    return table;
  }();
  return all;
}

/// Ball at a ring position in a given cycle.
struct BallPosition {
  Vec2 position;
  double limit;  ///< maximum acceleration of a kick from there
  double slack;  ///< position error with the ball still kickable and without collision
  double cost;
};
using BallPositions = std::array<BallPosition, kRingPositions>;

struct KickPlan {
  double score = -1e9;
  double speed = -1.0;
  Vec2 first_velocity;  ///< of the ball after the first kick
};

class Search {
 public:
  Search(const WorldModel& world, Vec2 target, double first_speed, double threshold)
      : world_(world), target_(target), first_speed_(first_speed), threshold_(threshold) {}

  KickPlan best(int max_steps) {
    consider(world_.ball.position, velocity_, limit_, 1, 0.0, nullptr);
    const bool enough = best_.speed >= first_speed_ - 1e-6;
    if (max_steps >= 2 && !enough) search_two_and_three_kicks(max_steps);
    return best_;
  }

 private:
  void fill(BallPositions& out, int cycle) const {
    const soccer::PlayerType& type = world_.self_type();
    const Vec2 here = self_after(world_, cycle);
    const Vec2 body = soccer::polar(1.0, world_.self.body);

    for (std::size_t i = 0; i < out.size(); ++i) {
      const RingPosition& point = ring_positions()[i];
      const Vec2 d = point.direction;
      const double dist = collide_ + point.share * type.kickable_margin;
      out[i].position =
          here + Vec2{d.x * body.x - d.y * body.y, d.x * body.y + d.y * body.x} * dist;

      const double rate = type.kick_power_rate * (1.0 - 0.25 * point.off_body - 0.25 * point.share);
      out[i].limit = kick_limit(world_, rate);
      out[i].slack = type.kickable_margin * std::min(point.share, 1.0 - point.share);

      constexpr double kImpossible = 1e6;
      out[i].cost =
          outside_pitch(out[i].position) ? kImpossible : threats_.cost(out[i].position, cycle);
    }
  }

  /// Evaluates a last kick from `ball` moving with `velocity`; `first`: ball velocity after the
  /// first kick, null if this is the first.
  void consider(Vec2 ball, Vec2 velocity, double limit, int kicks, double cost, const Vec2* first) {
    const Vec2 way = target_ - ball;
    const double length = way.length();
    if (length < 1e-6) return;

    const Vec2 direction = way / length;
    const double possible = max_speed_along(velocity, direction, limit, speed_max_);
    if (possible <= 0.0) return;
    const double speed = std::min(possible, first_speed_);
    const double needed = (direction * speed - velocity).length();
    if (needed > limit + 1e-9) return;  // too fast to decelerate

    double score = kNumbers.base - kNumbers.kicks[kicks] - kNumbers.effort * needed / limit - cost;
    if (speed < first_speed_ - 1e-6) {
      score -= speed < threshold_ ? kNumbers.too_slow : kNumbers.slower;
      score += kNumbers.speed * speed;
    }

    if (score <= best_.score) return;
    // A slow ball could collide with the agent.
    const Vec2 velocity_after = direction * speed;
    for (int n = 1; n <= 2; ++n) {
      const Vec2 there = coast(ball, velocity_after, decay_, n);
      const double apart = distance(there, self_after(world_, kicks - 1 + n));
      if (apart < collide_ + kSkills.dribble.body_gap) return;
    }

    best_ = {score, speed, first != nullptr ? *first : velocity_after};
  }

  void search_two_and_three_kicks(int max_steps) {
    BallPositions second;
    BallPositions third;
    fill(second, 1);
    if (max_steps >= 3) fill(third, 2);

    for (const BallPosition& point : second) {
      const Vec2 step = point.position - world_.ball.position;
      const Vec2 push = step - velocity_;
      if (push.squared_length() > limit_ * limit_) continue;
      const double cost = point.cost + noise_cost(push, limit_, step, point.slack);
      const Vec2 velocity = step * decay_;
      consider(point.position, velocity, point.limit, 2, cost, &step);

      if (max_steps < 3) continue;
      for (const BallPosition& next : third) {
        const Vec2 step2 = next.position - point.position;
        const Vec2 push2 = step2 - velocity;
        if (push2.squared_length() > point.limit * point.limit) continue;
        const double cost2 = cost + next.cost + noise_cost(push2, point.limit, step2, next.slack);
        consider(next.position, step2 * decay_, next.limit, 3, cost2, &step);
      }
    }
  }

  double noise_cost(Vec2 acceleration, double limit, Vec2 step, double slack) const {
    // Half of the maximum error is typical for uniform noise.
    const double power_share = acceleration.length() / limit;
    const double error = world_.self_type().kick_rand * power_share * kNumbers.typical_error +
                         world_.server().ball_rand * step.length();
    return error > slack ? kNumbers.noise * (error - slack) / slack : 0.0;
  }

  const WorldModel& world_;
  Vec2 target_;
  double first_speed_;
  double threshold_;
  Threats threats_{world_};
  double decay_ = world_.server().ball_decay;
  double speed_max_ = world_.server().ball_speed_max;
  double collide_ = collide_distance(world_);
  Vec2 velocity_ = world_.ball.velocity;
  double limit_ = kick_limit(world_);
  KickPlan best_;
};

}  // namespace

bool smart_kick(const WorldModel& world, CommandSlots& slots, Vec2 target, double first_speed,
                double speed_threshold, int max_steps) {
  if (!world.self.kickable) return false;

  const double desired = soccer::between(first_speed, 0.0, world.server().ball_speed_max);
  Search search(world, target, desired, std::min(speed_threshold, desired));
  const KickPlan plan = search.best(std::clamp(max_steps, 1, 3));
  if (plan.speed > 0.0 && plan.speed >= std::min(speed_threshold, desired) - 1e-6) {
    return kick_to_velocity(world, slots, plan.first_velocity);
  }

  hold_ball(world, slots, false, {});
  return false;
}

}  // namespace cls::player
