// Feature set "hfo_low": HFO's low-level features, 59 + 9 per teammate + 9 per opponent. Its
// quirks are preserved: the landmarks are those of the attacked half, players at x <= 0 are left
// out, players are sorted by distance, numbers are divided by 100.
#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"
#include "training/features/feature_set.h"
#include "training/features/feature_writer.h"

namespace cls::training {
namespace {

// Maxima that HFO's authors observed; values are clipped to them.
constexpr double kSelfSpeed = 0.46;
constexpr double kPlayerSpeed = 0.75;
constexpr double kBallSpeed = 5.0;
constexpr double kStamina = 8000.0;
constexpr int kPlayerFeatures = 8;

struct Landmark {
  const char* name;
  double x;
  double y;
};

// kGoalHalfWidth: half of server::goal_width's default, as in HFO.
constexpr double kGoalHalfWidth = 7.01;
constexpr double kBoxX = soccer::kHalfLength - soccer::kPenaltyAreaLength;
constexpr Landmark kLandmarks[] = {{"goal_center", soccer::kHalfLength, 0.0},
                                   {"goal_post_top", soccer::kHalfLength, -kGoalHalfWidth},
                                   {"goal_post_bottom", soccer::kHalfLength, kGoalHalfWidth},
                                   {"box_center", kBoxX, 0.0},
                                   {"box_top", kBoxX, -soccer::kPenaltyAreaWidth / 2.0},
                                   {"box_bottom", kBoxX, soccer::kPenaltyAreaWidth / 2.0},
                                   {"center_field", 0.0, 0.0},
                                   {"corner_top_left", 0.0, -soccer::kHalfWidth},
                                   {"corner_top_right", soccer::kHalfLength, -soccer::kHalfWidth},
                                   {"corner_bottom_right", soccer::kHalfLength, soccer::kHalfWidth},
                                   {"corner_bottom_left", 0.0, soccer::kHalfWidth}};

double max_distance() {
  return std::sqrt(soccer::kHalfLength * soccer::kHalfLength +
                   soccer::kPitchWidth * soccer::kPitchWidth);
}

void append_landmark(Columns& out, const std::string& name) {
  append(out, name, {"_sin", "_cos", "_proximity"});
}

void append_player(Columns& out, const std::string& name) {
  append_landmark(out, name);
  append(out, name, {"_body_sin", "_body_cos", "_speed", "_velocity_sin", "_velocity_cos"});
}

Columns columns(int teammates, int opponents) {
  Columns out;
  append(out, "self_",
         {"position_valid", "velocity_valid", "velocity_sin", "velocity_cos", "speed", "body_sin",
          "body_cos"});
  append(out, "", {"stamina", "frozen", "hits_ball", "hits_player", "hits_post", "kickable"});
  for (const Landmark& landmark : kLandmarks) append_landmark(out, landmark.name);
  append(out, "", {"left_proximity", "right_proximity", "top_proximity", "bottom_proximity"});

  append(out, "ball", {"_position_valid"});
  append_landmark(out, "ball");
  append(out, "ball", {"_velocity_valid", "_speed", "_velocity_sin", "_velocity_cos"});

  const auto name = [](const char* team, int i) { return team + std::to_string(i); };
  for (int i = 1; i <= teammates; ++i) append_player(out, name("teammate", i));
  for (int i = 1; i <= opponents; ++i) append_player(out, name("opponent", i));
  for (int i = 1; i <= teammates; ++i) append(out, name("teammate", i), {"_number"}, "100");
  for (int i = 1; i <= opponents; ++i) append(out, name("opponent", i), {"_number"}, "100");

  append(out, "", {"last_action_worked"});
  return out;
}

void add_proximity(FeatureWriter& out, double distance, double maximum) {
  out.scaled(1.0 - std::clamp(distance / maximum, 0.0, 1.0), 0.0, 1.0);
}

/// Position and body direction of the agent.
struct Pose {
  Vec2 position;
  Vec2 forward;
};

void add_landmark(FeatureWriter& out, const Pose& me, Vec2 point) {
  const Vec2 to = point - me.position;
  out.direction(to.is_zero() ? Vec2{1.0, 0.0} : to, me.forward);
  add_proximity(out, to.length(), max_distance());
}

void add_velocity(FeatureWriter& out, Vec2 velocity, double maximum) {
  out.scaled(velocity.length(), 0.0, maximum);
  out.direction(velocity.is_zero() ? Vec2{1.0, 0.0} : velocity, {1.0, 0.0});
}

void add_player(FeatureWriter& out, const Pose& me, const ScenePlayer& player) {
  add_landmark(out, me, player.position);
  out.angle(player.body_known ? player.body : 0.0);
  if (player.velocity_known) {
    add_velocity(out, player.velocity, kPlayerSpeed);
  } else {
    out.same(3, 0.0F);
  }
}

void add_self(FeatureWriter& out, const PointOfView& view, const Pose& pose) {
  const ScenePlayer& me = view.me();
  out.flag(me.seen);
  out.flag(me.velocity_known);

  // The angle from the velocity to the body.
  const double speed = me.velocity.length();
  const Vec2 along = speed > 0.0 ? me.velocity / speed : Vec2{1.0, 0.0};
  out.value(cross(along, pose.forward));
  out.value(dot(along, pose.forward));
  out.scaled(speed, 0.0, kSelfSpeed);

  out.value(pose.forward.y);
  out.value(pose.forward.x);
  out.scaled(me.stamina, 0.0, kStamina);
  out.flag(me.frozen);
  out.flag(me.hit_ball);
  out.flag(me.hit_player);
  out.flag(me.hit_post);
  out.flag(can_kick(view.scene, view.self));
}

void add_ball(FeatureWriter& out, const Scene& scene, const Pose& pose) {
  out.flag(scene.ball_seen);
  if (scene.ball_seen) {
    add_landmark(out, pose, scene.ball);
  } else {
    out.same(3, 0.0F);
  }

  out.flag(scene.ball_velocity_known);
  if (scene.ball_velocity_known) {
    add_velocity(out, scene.ball_velocity, kBallSpeed);
  } else {
    out.same(3, 0.0F);
  }
}

/// The seats that HFO lists: seen, in the attacked half, nearest first.
Seats listed(const PointOfView& view, Seats all) {
  sort_by_distance(view.scene, view.me().position, all);
  Seats seats;
  for (const Seat seat : all) {
    const ScenePlayer& player = view.scene.player(seat);
    if (player.seen && player.position.x > 0.0) seats.push_back(seat);
  }
  return seats;
}

void fill(const PointOfView& view, float* numbers) {
  FeatureWriter out(numbers);
  const Pose pose = {view.me().position, view.me().facing};
  add_self(out, view, pose);
  for (const Landmark& landmark : kLandmarks) add_landmark(out, pose, {landmark.x, landmark.y});

  add_proximity(out, pose.position.x, 1.1 * soccer::kHalfLength);
  add_proximity(out, soccer::kHalfLength - pose.position.x, 1.1 * soccer::kHalfLength);
  add_proximity(out, soccer::kHalfWidth + pose.position.y, 1.05 * soccer::kPitchWidth);
  add_proximity(out, soccer::kHalfWidth - pose.position.y, 1.05 * soccer::kPitchWidth);
  add_ball(out, view.scene, pose);

  const Seats teammates = listed(view, teammates_of(view));
  const Seats opponents = listed(view, opponents_of(view));
  const int missing_teammates = view.teammate_count() - static_cast<int>(teammates.size());
  const int missing_opponents = view.opponent_count() - static_cast<int>(opponents.size());

  for (const Seat seat : teammates) add_player(out, pose, view.scene.player(seat));
  out.same(kPlayerFeatures * missing_teammates, 0.0F);
  for (const Seat seat : opponents) add_player(out, pose, view.scene.player(seat));
  out.same(kPlayerFeatures * missing_opponents, 0.0F);

  for (const Seat seat : teammates) out.value(view.scene.player(seat).unum / 100.0);
  out.same(missing_teammates, -1.0F);
  for (const Seat seat : opponents) out.value(view.scene.player(seat).unum / 100.0);
  out.same(missing_opponents, -1.0F);

  out.flag(view.last_action_worked);
}

}  // namespace

const FeatureSet kHfoLowFeatures = {
    .name = "hfo_low",
    .summary = "HFO's low-level features: angles and distances to landmarks and players",
    .left_only = true,
    .columns = columns,
    .fill = fill};

}  // namespace cls::training
