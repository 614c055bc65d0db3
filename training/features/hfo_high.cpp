// Feature set "hfo_high": HFO's high-level features, 12 + 6 per teammate + 3 per opponent. Missing
// values are -2 and uniform numbers are not scaled, as in HFO; the bounds say so.
#include <cmath>

#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/features/feature_set.h"
#include "training/features/feature_writer.h"
#include "training/scene/openings.h"

namespace cls::training {
namespace {

namespace math = soccer::math;

constexpr float kMissing = -2.0F;

double max_distance() {
  return std::sqrt(soccer::kHalfLength * soccer::kHalfLength +
                   soccer::kHalfWidth * soccer::kHalfWidth);
}

Columns columns(int teammates, int opponents) {
  Columns out;
  append(out, "self_", {"x", "y", "body"});
  append(out, "", {"ball_x", "ball_y", "kickable", "goal_distance", "goal_angle", "goal_opening"});
  append(out, "", {"nearest_opponent_distance"}, "1", kMissing);

  for (const char* what : {"_goal_opening", "_nearest_opponent_distance", "_pass_opening"}) {
    for (int i = 1; i <= teammates; ++i) {
      append(out, "teammate" + std::to_string(i), {what}, "1", kMissing);
    }
  }
  const auto append_positions = [&](const char* team, int count) {
    for (int i = 1; i <= count; ++i) {
      const std::string name = team + std::to_string(i);
      append(out, name, {"_x", "_y"}, "1", kMissing);
      append(out, name, {"_number"}, "number", kMissing, 11);
    }
  };
  append_positions("teammate", teammates);
  append_positions("opponent", opponents);

  append(out, "", {"last_action_worked", "stamina"});
  return out;
}

/// Writes positions, angles and distances in HFO's scale.
struct Scale {
  FeatureWriter& out;
  const PointOfView& view;

  void x(double x) const {
    const double margin = 0.1 * soccer::kHalfLength;
    out.scaled(x, view.stage.left - margin, view.stage.right + margin);
  }
  void y(double y) const { out.scaled(y, -1.1 * soccer::kHalfWidth, 1.1 * soccer::kHalfWidth); }
  void length(double length) const { out.scaled(length, 0.0, max_distance()); }
  void width(double angle) const { out.scaled(angle, 0.0, math::kPi); }
  void angle(double angle) const { out.scaled(angle, -math::kPi, math::kPi); }
  void nearest_opponent(const Openings& openings, Seat eye) const {
    const double meters = openings.nearest_opponent(eye);
    if (!std::isfinite(meters)) return out.same(1, kMissing);
    length(meters);
  }
  void position(Seat seat) const {
    const ScenePlayer& player = view.scene.player(seat);
    x(player.position.x);
    y(player.position.y);
    out.same(1, static_cast<float>(player.unum));
  }
};

Seats seen(const PointOfView& view, const Seats& all) {
  Seats seats;
  for (const Seat seat : all) {
    if (view.scene.player(seat).seen) seats.push_back(seat);
  }
  return seats;
}

void add_players(FeatureWriter& out, const Scale& scale, const PointOfView& view,
                 const Openings& openings) {
  const Seats teammates = seen(view, teammates_of(view));
  const Seats opponents = seen(view, opponents_of(view));
  const int no_teammates = view.teammate_count() - static_cast<int>(teammates.size());
  const int no_opponents = view.opponent_count() - static_cast<int>(opponents.size());

  for (const Seat seat : teammates) scale.width(openings.to_goal(seat));
  out.same(no_teammates, kMissing);
  for (const Seat seat : teammates) scale.nearest_opponent(openings, seat);
  out.same(no_teammates, kMissing);
  for (const Seat seat : teammates) scale.width(openings.to_teammate(view.self, seat));
  out.same(no_teammates, kMissing);
  for (const Seat seat : teammates) scale.position(seat);
  out.same(3 * no_teammates, kMissing);
  for (const Seat seat : opponents) scale.position(seat);
  out.same(3 * no_opponents, kMissing);
}

void fill(const PointOfView& view, float* numbers) {
  FeatureWriter out(numbers);
  const Scale scale{out, view};
  const Openings& openings = *view.openings;
  const ScenePlayer& me = view.me();

  scale.x(me.position.x);
  scale.y(me.position.y);
  scale.angle(me.body);
  scale.x(view.scene.ball.x);
  scale.y(view.scene.ball.y);
  out.flag(can_kick(view.scene, view.self));

  // A team that plays in the left half of its own coordinates defends the goal there.
  const Vec2 goal = {view.stage.right > 0.0 ? soccer::kHalfLength : -soccer::kHalfLength, 0.0};
  const Vec2 to_goal = goal - me.position;
  scale.length(to_goal.length());
  scale.angle(soccer::direction_radians(to_goal));
  scale.width(openings.to_goal(view.self));
  scale.nearest_opponent(openings, view.self);

  add_players(out, scale, view, openings);
  out.flag(view.last_action_worked);
  out.scaled(me.stamina, 0.0, view.scene.server->stamina_max);
}

}  // namespace

const FeatureSet kHfoHighFeatures = {
    .name = "hfo_high",
    .summary = "HFO's high-level features: positions, openings to goal and teammates",
    .needs_openings = true,
    .columns = columns,
    .fill = fill};

}  // namespace cls::training
