// The search for kick sequences: intermediate ball places on three rings around the body.
#include "proxy/ball_skills/smart_kick.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proxy/ball_skills/hold_ball.h"
#include "proxy/ball_skills/kick.h"
#include "proxy/ball_skills/threats.h"
#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

struct Ring {
  double share;  ///< of the kickable margin between the surfaces
  int places;
};
constexpr std::array<Ring, 3> kRings{{{0.3, 12}, {0.5, 15}, {0.7, 20}}};
constexpr int kPlaces = 47;

/// A place beside the body as the rings have it, body pointing along +x.
struct Place {
  Vec2 direction;
  double share;
  double off_body;  ///< share of a half turn
};

const std::array<Place, kPlaces>& places() {
  static const auto all = [] {
    std::array<Place, kPlaces> table;
    std::size_t next = 0;
    for (const Ring& ring : kRings) {
      for (int i = 0; i < ring.places; ++i) {
        const double angle = soccer::math::normalize_degrees(360.0 * i / ring.places);
        table[next++] = {soccer::polar_degrees(1.0, angle), ring.share, std::fabs(angle) / 180.0};
      }
    }
    return table;
  }();
  return all;
}

/// The ball at one of the places in a given cycle.
struct BallPlace {
  Vec2 position;
  double limit;  ///< largest acceleration of a kick from there
  double slack;  ///< error of its place that still leaves it kickable and free of the body
  double cost;
};
using BallPlaces = std::array<BallPlace, kPlaces>;

struct Plan {
  double score = -1e9;
  double speed = -1.0;
  Vec2 first_velocity;  ///< of the ball after the first kick
};

class Search {
 public:
  Search(const WorldModel& world, Vec2 target, double first_speed, double threshold)
      : world_(world),
        threats_(world),
        target_(target),
        first_speed_(first_speed),
        threshold_(threshold),
        decay_(world.server().ball_decay),
        speed_max_(world.server().ball_speed_max),
        collide_(collide_distance(world)),
        velocity_(world.ball.velocity),
        limit_(kick_limit(world)) {}

  Plan best(int max_steps);

 private:
  void fill(BallPlaces& out, int cycle) const;
  /// The last kick, from `ball` moving with `velocity`; `first` is the ball's velocity after the
  /// first kick, zero when this one is the first.
  void consider(Vec2 ball, Vec2 velocity, double limit, int kicks, double cost, const Vec2* first);
  void two_and_three(int max_steps);
  double noise_cost(Vec2 acceleration, double limit, Vec2 step, double slack) const;

  const WorldModel& world_;
  Threats threats_;
  Vec2 target_;
  double first_speed_;
  double threshold_;
  double decay_;
  double speed_max_;
  double collide_;
  Vec2 velocity_;
  double limit_;
  Plan best_;
};

void Search::fill(BallPlaces& out, int cycle) const {
  const soccer::PlayerType& type = world_.self_type();
  const Vec2 here = self_after(world_, cycle);
  const Vec2 body = soccer::polar(1.0, world_.self.body);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Place& place = places()[i];
    const Vec2 d = place.direction;
    const double dist = collide_ + place.share * type.kickable_margin;
    out[i].position = here + Vec2{d.x * body.x - d.y * body.y, d.x * body.y + d.y * body.x} * dist;
    const double rate = type.kick_power_rate * (1.0 - 0.25 * place.off_body - 0.25 * place.share);
    out[i].limit = kick_limit(world_, rate);
    out[i].slack = type.kickable_margin * std::min(place.share, 1.0 - place.share);
    const bool outside = std::fabs(out[i].position.x) > soccer::kHalfLength ||
                         std::fabs(out[i].position.y) > soccer::kHalfWidth;
    out[i].cost = outside ? 1e6 : threats_.cost(out[i].position, cycle);
  }
}

double Search::noise_cost(Vec2 acceleration, double limit, Vec2 step, double slack) const {
  // Half of the largest error is typical of the uniform noise of power and motion.
  const double power_share = acceleration.length() / limit;
  const double error =
      world_.self_type().kick_rand * power_share * 1.4 + world_.server().ball_rand * step.length();
  return error > slack ? 400.0 * (error - slack) / slack : 0.0;
}

void Search::consider(Vec2 ball, Vec2 velocity, double limit, int kicks, double cost,
                      const Vec2* first) {
  const Vec2 way = target_ - ball;
  const double length = way.length();
  if (length < 1e-6) return;
  const Vec2 direction = way / length;
  const double possible = max_speed_along(velocity, direction, limit, speed_max_);
  if (possible <= 0.0) return;
  const double speed = std::min(possible, first_speed_);
  const double needed = (direction * speed - velocity).length();
  if (needed > limit + 1e-9) return;  // too fast to be slowed down that much
  static constexpr double kKickCost[] = {0.0, 0.0, 50.0, 200.0};
  double score = 1000.0 - kKickCost[kicks] - 50.0 * needed / limit - cost;
  if (speed < first_speed_ - 1e-6) {
    score -= speed < threshold_ ? 10000.0 : 1000.0;
    score += 100.0 * speed;
  }
  if (score <= best_.score) return;
  // A slow ball could meet the agent itself.
  const Vec2 velocity_after = direction * speed;
  for (int n = 1; n <= 2; ++n) {
    const Vec2 there = coast(ball, velocity_after, decay_, n);
    if (distance(there, self_after(world_, kicks - 1 + n)) < collide_ + 0.05) return;
  }
  best_ = {score, speed, first != nullptr ? *first : velocity_after};
}

void Search::two_and_three(int max_steps) {
  BallPlaces second;
  BallPlaces third;
  fill(second, 1);
  if (max_steps >= 3) fill(third, 2);
  for (const BallPlace& place : second) {
    const Vec2 step = place.position - world_.ball.position;
    const Vec2 push = step - velocity_;
    if (push.squared_length() > limit_ * limit_) continue;
    const double cost = place.cost + noise_cost(push, limit_, step, place.slack);
    const Vec2 velocity = step * decay_;
    consider(place.position, velocity, place.limit, 2, cost, &step);
    if (max_steps < 3) continue;
    for (const BallPlace& next : third) {
      const Vec2 step2 = next.position - place.position;
      const Vec2 push2 = step2 - velocity;
      if (push2.squared_length() > place.limit * place.limit) continue;
      const double cost2 = cost + next.cost + noise_cost(push2, place.limit, step2, next.slack);
      consider(next.position, step2 * decay_, next.limit, 3, cost2, &step);
    }
  }
}

Plan Search::best(int max_steps) {
  consider(world_.ball.position, velocity_, limit_, 1, 0.0, nullptr);
  const bool enough = best_.speed >= first_speed_ - 1e-6;
  if (max_steps >= 2 && !enough) two_and_three(max_steps);
  return best_;
}

}  // namespace

bool smart_kick(const WorldModel& world, CommandSlots& slots, Vec2 target, double first_speed,
                double speed_threshold, int max_steps) {
  if (!world.self.kickable) return false;
  const double wanted = std::clamp(first_speed, 0.0, world.server().ball_speed_max);
  Search search(world, target, wanted, std::min(speed_threshold, wanted));
  const Plan plan = search.best(std::clamp(max_steps, 1, 3));
  if (plan.speed > 0.0 && plan.speed >= std::min(speed_threshold, wanted) - 1e-6) {
    return kick_to_velocity(world, slots, plan.first_velocity);
  }
  hold_ball(world, slots, false, {});
  return false;
}

}  // namespace cls::proxy
