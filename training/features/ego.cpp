// Feature sets "ego": the pitch as an agent sees it from its own position, for every task.
#include "training/features/feature_set.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"
#include "training/features/feature_writer.h"
#include "training/features/mode_columns.h"

namespace cls::training {
namespace {

constexpr double kFar = 60.0;         // distances beyond it count as this far
constexpr double kBallSpeed = 3.0;    // ball_speed_max
constexpr double kPlayerSpeed = 1.2;  // above player_speed_max of all types
constexpr int kPlayerColumns = 10;
constexpr double kOld = 30.0;  // cycles; older estimates count as this old
constexpr double kFrozen = 10.0;
constexpr double kLong = 100.0;    // cycles of a play mode; longer ones count as this long
constexpr int kFixedColumns = 31;  // of version 1, without the other players
constexpr double kMaxDashPower = 100.0;

void append_player(Columns& out, const std::string& who) {
  append(out, who, {"_seen"}, "0/1");
  append(out, who, {"_sin", "_cos"});
  append(out, who, {"_distance"}, "60 m", 0);
  append(out, who, {"_vx", "_vy"}, "1.2 m/cycle");
  append(out, who, {"_body_sin", "_body_cos"});
  append(out, who, {"_goalie"}, "0/1");
  append(out, who, {"_ball_distance"}, "60 m", 0);
}

Columns columns(int teammates, int opponents) {
  Columns out = {{"self_x", "52.5 m", -1.2F, 1.2F}, {"self_y", "34 m", -1.2F, 1.2F}};
  append(out, "self", {"_sin", "_cos"});
  append(out, "self", {"_forward_speed", "_sideward_speed"}, "1.2 m/cycle");
  append(out, "self", {"_stamina"}, "8000", 0);
  append(out, "", {"self_kickable", "self_frozen", "play_on"}, "0/1");
  append(out, "", {"time_left"}, "1", 0);

  append(out, "ball", {"_seen"}, "0/1");
  append(out, "ball", {"_sin", "_cos"});
  append(out, "ball", {"_distance"}, "60 m", 0);
  append(out, "ball", {"_vx", "_vy"}, "3 m/cycle");
  append(out, "ball", {"_x"}, "52.5 m", -1.2F, 1.2F);
  append(out, "ball", {"_y"}, "34 m", -1.2F, 1.2F);

  for (const char* goal : {"their_goal", "their_left_post", "their_right_post", "own_goal"}) {
    append(out, goal, {"_sin", "_cos"});
    append(out, goal, {"_distance"}, "60 m", 0);
  }

  for (int i = 1; i <= teammates; ++i) append_player(out, "teammate" + std::to_string(i));
  for (int i = 1; i <= opponents; ++i) append_player(out, "opponent" + std::to_string(i));
  return out;
}

void append_ages(Columns& out, const std::string& who) {
  append(out, who, {"_age", "_velocity_age"}, "30 cycles", 0);
}

void append_body(Columns& out, const std::string& who) {
  append_ages(out, who);
  append(out, who, {"_body_age"}, "30 cycles", 0);
  append(out, who, {"_kickable_area"}, "2 m", 0);
  append(out, who, {"_speed_max"}, "1.2 m/cycle", 0);
  append(out, who, {"_decay"}, "1", 0);
  append(out, who, {"_touched_last"}, "0/1");
}

// Those of version 1 come first.
Columns columns_2(int teammates, int opponents) {
  Columns out = columns(teammates, opponents);
  append(out, "self", {"_effort", "_recovery", "_capacity"}, "1", 0);
  append(out, "self", {"_neck_sin", "_neck_cos"});
  append(out, "self", {"_frozen_cycles"}, "10 cycles", 0);
  append_body(out, "self");
  append_mode(out);
  append(out, "mode", {"_age"}, "100 cycles", 0);
  append(out, "", {"touched_by_own"});  // -1: by the other team, 0: not known
  append(out, "offside_line", {"_x"}, "52.5 m", -1.2F, 1.2F);
  append_ages(out, "ball");
  for (int i = 1; i <= teammates; ++i) append_body(out, "teammate" + std::to_string(i));
  for (int i = 1; i <= opponents; ++i) append_body(out, "opponent" + std::to_string(i));
  return out;
}

/// The agent's axes: `forward` is a unit vector along the body.
class Axes {
 public:
  Axes(Vec2 origin, Vec2 forward)
      : origin_(origin), x_(Pair::of(forward.x)), y_(forward.y, -forward.y) {}

  Pair to(const Vec2& point) const { return Pair(point) - origin_; }
  /// dot() and cross() of `forward` and a vector.
  Pair along_and_across(Pair v) const { return x_ * v + y_ * v.swapped(); }

 private:
  Pair origin_;
  Pair x_;
  Pair y_;
};

void add_vector(FeatureWriter& out, const Axes& axes, const Vec2& v, double scale) {
  out.values(axes.along_and_across(Pair(v)) / Pair::of(scale));
}

/// A point as the agent sees it.
struct Sight {
  Pair direction;   ///< sine and cosine of its angle to `forward`; (0, 1) at the own place
  double distance;  ///< meters
};

Sight sight_of(const Axes& axes, const Vec2& point) {
  const Pair to = axes.to(point);
  const Pair squares = to * to;
  const double distance = std::sqrt(squares.first() + squares.second());
  if (distance <= 0.0) return {Pair(0.0, 1.0), distance};
  return {axes.along_and_across(to).swapped() / Pair::of(distance), distance};
}

void add_point(FeatureWriter& out, const Axes& axes, const Vec2& point) {
  const Sight sight = sight_of(axes, point);
  out.values(sight.direction);
  out.value(sight.distance / kFar, 0.0);
}

void add_player(FeatureWriter& out, const Axes& axes, const Scene& scene, Seat seat) {
  static constexpr Vec2 kUnknown;
  const ScenePlayer& player = scene.player(seat);
  if (!player.seen) {
    out.flag(false);
    out.same(kPlayerColumns - 1, 0.0F);
    return;
  }

  const Sight sight = sight_of(axes, player.position);
  const double ball_distance = scene.ball_seen ? player.ball_distance : kFar;
  const Pair distances = Pair(sight.distance, ball_distance) / Pair::of(kFar);

  out.flag(true);
  out.values(sight.direction);
  out.value(distances.first(), 0.0);
  add_vector(out, axes, player.velocity_known ? player.velocity : kUnknown, kPlayerSpeed);
  out.values(axes.along_and_across(Pair(player.facing)));
  out.flag(player.goalie);
  out.value(distances.second(), 0.0);
}

void add_players(FeatureWriter& out, const Axes& axes, const Scene& scene, const Seats& seats) {
  FeatureWriter writer = out;  // which stays in a register
  for (const Seat seat : seats) add_player(writer, axes, scene, seat);
  out = writer;
}

void add_self(FeatureWriter& out, const PointOfView& view, const Axes& axes) {
  const ScenePlayer& me = view.me();
  out.value(me.position.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(me.position.y / soccer::kHalfWidth, -1.2, 1.2);
  out.value(me.facing.y);
  out.value(me.facing.x);
  add_vector(out, axes, me.velocity, kPlayerSpeed);
  out.value(me.stamina / view.scene.server->stamina_max, 0.0);
  out.flag(can_kick(view.scene, view.self));
  out.flag(me.frozen);
  out.flag(view.scene.play_on);
  out.value(view.time_left, 0.0);
}

void add_ball(FeatureWriter& out, const Scene& scene, const Axes& axes) {
  out.flag(scene.ball_seen);
  if (!scene.ball_seen) return out.same(7, 0.0F);
  add_point(out, axes, scene.ball);
  add_vector(out, axes, scene.ball_velocity_known ? scene.ball_velocity : Vec2{}, kBallSpeed);
  out.value(scene.ball.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(scene.ball.y / soccer::kHalfWidth, -1.2, 1.2);
}

void fill(const PointOfView& view, float* numbers) {
  FeatureWriter out(numbers);
  const ScenePlayer& me = view.me();
  const Axes axes(me.position, me.facing);
  add_self(out, view, axes);
  add_ball(out, view.scene, axes);

  const double post = view.scene.server->goal_width / 2.0;
  add_point(out, axes, {soccer::kHalfLength, 0.0});
  add_point(out, axes, {soccer::kHalfLength, -post});
  add_point(out, axes, {soccer::kHalfLength, post});
  add_point(out, axes, {-soccer::kHalfLength, 0.0});

  add_players(out, axes, view.scene, teammates_of(view));
  add_players(out, axes, view.scene, opponents_of(view));
}

void add_ages(FeatureWriter& out, int age, int velocity_age) {
  out.value(age / kOld, 0.0);
  out.value(velocity_age / kOld, 0.0);
}

/// How old an estimate is, and what a player's type can do. Of unseen players: as old as can be.
void add_body(FeatureWriter& out, const Scene& scene, Seat seat) {
  const ScenePlayer& player = scene.player(seat);
  if (!player.seen || player.type == nullptr) {
    out.same(3, 1.0F);
    out.same(3, 0.0F);
    return out.flag(scene.last_touch == seat);
  }

  add_ages(out, player.age, player.velocity_age);
  out.value(player.body_age / kOld, 0.0);
  out.value(player.kickable_area / 2.0, 0.0);
  out.value(player.type->real_speed_max(kMaxDashPower) / kPlayerSpeed, 0.0);
  out.value(player.type->player_decay, 0.0);
  out.flag(scene.last_touch == seat);
}

/// The second last opponent that is seen, or the ball, or the half-way line.
double offside_line(const Scene& scene) {
  double last = 0.0;
  double second = 0.0;
  for (Seat seat = soccer::kPlayersPerTeam; seat < kSeats; ++seat) {
    const ScenePlayer& player = scene.player(seat);
    if (!player.on_pitch || !player.seen) continue;
    second = std::max(second, std::min(last, player.position.x));
    last = std::max(last, player.position.x);
  }
  return scene.ball_seen ? std::max(second, scene.ball.x) : second;
}

void fill_2(const PointOfView& view, float* numbers) {
  fill(view, numbers);
  const Scene& scene = view.scene;
  const int others = view.teammate_count() + view.opponent_count();
  FeatureWriter out(numbers + kFixedColumns + kPlayerColumns * others);

  const ScenePlayer& me = view.me();
  out.value(me.effort, 0.0);
  out.value(me.recovery, 0.0);
  out.value(me.capacity < 0.0 ? 1.0 : me.capacity / scene.server->stamina_capacity, 0.0);
  out.angle(me.neck);
  out.value(me.frozen_cycles / kFrozen, 0.0);
  add_body(out, scene, view.self);

  add_mode(out, scene.mode, scene.side);
  out.value(scene.mode_age / kLong, 0.0);
  out.value(soccer::sign(scene.last_touch_side) * soccer::sign(scene.side));
  out.value(offside_line(scene) / soccer::kHalfLength, -1.2, 1.2);
  add_ages(out, scene.ball_age, scene.ball_velocity_age);

  for (const Seat seat : teammates_of(view)) add_body(out, scene, seat);
  for (const Seat seat : opponents_of(view)) add_body(out, scene, seat);
}

}  // namespace

const FeatureSet kEgoFeatures = {
    .name = "ego",
    .summary = "egocentric: directions relative to the body, own team attacks +x",
    .columns = columns,
    .fill = fill};

const FeatureSet kEgo2Features = {.name = "ego",
                                  .version = 2,
                                  .summary =
                                      "ego, ages of estimates, own condition, abilities, play mode "
                                      "and its age, last toucher, offside line",
                                  .columns = columns_2,
                                  .fill = fill_2};

}  // namespace cls::training
