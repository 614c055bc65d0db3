// Feature set "team": the pitch as a player of a team knows it, along the axes of the pitch, and
// the targets of what it may choose.
#include <algorithm>
#include <string>

#include "player/movement/home_positions.h"
#include "player/options/options.h"
#include "soccer/pitch.h"
#include "training/features/feature_set.h"
#include "training/features/feature_writer.h"
#include "training/features/mode_columns.h"

namespace cls::training {
namespace {

constexpr double kFar = 60.0;         // meters; more counts as this far
constexpr double kRoom = 20.0;        // the same of opponents around a place
constexpr double kBallSpeed = 3.0;    // ball_speed_max
constexpr double kPlayerSpeed = 1.2;  // above player_speed_max of all types
constexpr double kOld = 30.0;         // cycles; older estimates count as this old
constexpr double kReach = 40.0;       // cycles; later arrivals count as this late
constexpr double kLong = 100.0;       // cycles of a play mode
constexpr double kHeld = 30.0;        // cycles with the ball
constexpr double kGap = 30.0;         // degrees
constexpr int kPlayerColumns = 15;
constexpr int kTargetColumns = 8;
constexpr const char* kReaches[] = {"self_reach", "first_teammate_reach", "second_teammate_reach",
                                    "first_opponent_reach", "second_opponent_reach"};

void append_place(Columns& out, const std::string& who) {
  append(out, who, {"_x"}, "52.5 m", -1.2F, 1.2F);
  append(out, who, {"_y"}, "34 m", -1.2F, 1.2F);
}

void append_player(Columns& out, const std::string& who) {
  append(out, who, {"_seen"}, "0/1", 0);
  append_place(out, who);
  append(out, who, {"_dx", "_dy"}, "60 m");
  append(out, who, {"_vx", "_vy"}, "1.2 m/cycle");
  append(out, who, {"_body_cos", "_body_sin"});
  append(out, who, {"_ball_distance", "_self_distance"}, "60 m", 0);
  append(out, who, {"_room"}, "20 m", 0);
  append(out, who, {"_goalie", "_frozen"}, "0/1", 0);
  append(out, who, {"_age"}, "30 cycles", 0);
}

Columns columns(int teammates, int opponents) {
  Columns out;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    append(out, "self_is_" + std::to_string(unum), {""}, "0/1", 0);
  }
  append_place(out, "self");
  append(out, "self", {"_vx", "_vy"}, "1.2 m/cycle");
  append(out, "self", {"_body_cos", "_body_sin"});
  append(out, "self", {"_stamina", "_effort", "_recovery", "_capacity"}, "1", 0);
  append(out, "self", {"_room"}, "20 m", 0);
  append_place(out, "home");
  append(out, "", {"kickable"}, "0/1", 0);
  append(out, "", {"held"}, "30 cycles", 0);
  append_mode(out);
  append(out, "mode", {"_age"}, "100 cycles", 0);

  append(out, "ball", {"_seen"}, "0/1", 0);
  append_place(out, "ball");
  append(out, "ball", {"_dx", "_dy"}, "60 m");
  append(out, "ball", {"_vx", "_vy"}, "3 m/cycle");
  append(out, "ball", {"_age", "_velocity_age"}, "30 cycles", 0);
  append(out, "ball", {"_goal_distance"}, "60 m", 0);
  append(out, "", {"offside_line_x", "own_line_x", "their_line_x"}, "52.5 m", -1.2F, 1.2F);
  for (const char* name : kReaches) append(out, name, {""}, "40 cycles", 0);
  append(out, "", {"shot_gap"}, "30 deg", 0);

  for (int i = 1; i <= teammates; ++i) append_player(out, "teammate" + std::to_string(i));
  for (int i = 1; i <= opponents; ++i) append_player(out, "opponent" + std::to_string(i));

  for (int i = 0; i < player::kTargetOptions; ++i) {
    const std::string name = player::option_name(player::kDribbleOption + i);
    append(out, name, {"_legal"}, "0/1", 0);
    append_place(out, name);
    append(out, name, {"_cycles"}, "40 cycles", 0);
    append(out, name, {"_speed"}, "3 m/cycle", 0);
    append(out, name, {"_room"}, "20 m", 0);
    append(out, name, {"_goal_distance"}, "60 m", 0);
    append(out, name, {"_goal_side"}, "1");
  }
  return out;
}

void add_place(FeatureWriter& out, Vec2 place) {
  out.value(place.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(place.y / soccer::kHalfWidth, -1.2, 1.2);
}

void add_pair(FeatureWriter& out, Vec2 v, double scale) {
  out.value(v.x / scale);
  out.value(v.y / scale);
}

void add_switch(FeatureWriter& out, bool on) { out.value(on ? 1.0 : 0.0); }

void add_share(FeatureWriter& out, double number, double most) { out.value(number / most, 0.0); }

/// Distance to the nearest seen player of the other team.
double room_around(const Scene& scene, Vec2 place, bool opponents) {
  const Seat nearest = nearest_player(scene, opponents, place);
  return nearest == kNoSeat ? kRoom : distance(scene.player(nearest).position, place);
}

void add_player(FeatureWriter& out, const PointOfView& view, Seat seat) {
  const Scene& scene = view.scene;
  const ScenePlayer& player = scene.player(seat);
  add_switch(out, player.seen);
  if (!player.seen) return out.same(kPlayerColumns - 1, 0.0F);

  const Vec2 from_self = player.position - view.me().position;
  add_place(out, player.position);
  add_pair(out, from_self, kFar);
  add_pair(out, player.velocity_known ? player.velocity : Vec2{}, kPlayerSpeed);
  add_pair(out, player.body_known ? player.facing : Vec2{}, 1.0);
  add_share(out, scene.ball_seen ? distance(player.position, scene.ball) : kFar, kFar);
  add_share(out, from_self.length(), kFar);
  add_share(out, room_around(scene, player.position, !is_opponent(seat)), kRoom);
  add_switch(out, player.goalie);
  add_switch(out, player.frozen);
  add_share(out, player.age, kOld);
}

void add_self(FeatureWriter& out, const PointOfView& view) {
  const ScenePlayer& me = view.me();
  const soccer::ServerParams& server = *view.scene.server;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) add_switch(out, me.unum == unum);
  add_place(out, me.position);
  add_pair(out, me.velocity, kPlayerSpeed);
  add_pair(out, me.facing, 1.0);
  add_share(out, me.stamina, server.stamina_max);
  add_share(out, me.effort, 1.0);
  add_share(out, me.recovery, 1.0);
  add_share(out, me.capacity < 0.0 ? 1.0 : me.capacity / server.stamina_capacity, 1.0);
  add_share(out, room_around(view.scene, me.position, true), kRoom);
  add_place(out, own_home_position(*view.world));
  add_switch(out, view.world->self.kickable);
  add_share(out, view.options->held(*view.world), kHeld);
}

void add_ball(FeatureWriter& out, const PointOfView& view) {
  const Scene& scene = view.scene;
  add_switch(out, scene.ball_seen);
  if (!scene.ball_seen) {
    out.same(6, 0.0F);
    return out.same(3, 1.0F);
  }
  add_place(out, scene.ball);
  add_pair(out, scene.ball - view.me().position, kFar);
  add_pair(out, scene.ball_velocity_known ? scene.ball_velocity : Vec2{}, kBallSpeed);
  add_share(out, scene.ball_age, kOld);
  add_share(out, scene.ball_velocity_age, kOld);
  add_share(out, distance(scene.ball, {soccer::kHalfLength, 0.0}), kFar);
}

void add_situation(FeatureWriter& out, const player::WorldModel& world, double shot_gap) {
  for (const double x : {world.lines.offside, world.lines.our_defense, world.lines.their_defense}) {
    out.value(x / soccer::kHalfLength, -1.2, 1.2);
  }
  const player::InterceptTable& table = world.intercept;
  for (const int steps :
       {table.best_self_steps(), table.first_teammate_steps, table.second_teammate_steps,
        table.first_opponent_steps, table.second_opponent_steps}) {
    add_share(out, steps, kReach);
  }
  add_share(out, shot_gap, kGap);
}

void add_target(FeatureWriter& out, const player::OptionTarget* target) {
  add_switch(out, target != nullptr);
  if (target == nullptr) return out.same(kTargetColumns - 1, 0.0F);
  const player::PlanAction& action = target->action;
  const Vec2 goal = Vec2{soccer::kHalfLength, 0.0} - action.target_point;
  add_place(out, action.target_point);
  add_share(out, action.duration, kReach);
  add_share(out, action.first_speed, kBallSpeed);
  add_share(out, target->room, kRoom);
  add_share(out, goal.length(), kFar);
  out.value(goal.y / std::max(1.0, goal.length()));
}

void fill(const PointOfView& view, float* numbers) {
  FeatureWriter out(numbers);
  const player::OptionTable& options = *view.options;
  add_self(out, view);
  add_mode(out, view.scene.mode, view.scene.side);
  add_share(out, view.scene.mode_age, kLong);
  add_ball(out, view);
  add_situation(out, *view.world, options.shot_gap);
  for (const Seat seat : teammates_of(view)) add_player(out, view, seat);
  for (const Seat seat : opponents_of(view)) add_player(out, view, seat);
  for (int i = 0; i < player::kTargetOptions; ++i) {
    add_target(out, options.target(player::kDribbleOption + i));
  }
}

}  // namespace

const FeatureSet kTeamFeatures = {
    .name = "team",
    .summary =
        "for the actions options: own state and home, ball, lines, reach, players with the "
        "ages of their estimates, and the targets of dribbles and passes",
    .needs_options = true,
    .columns = columns,
    .fill = fill};

}  // namespace cls::training
