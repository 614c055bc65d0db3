// Action set "hfo": HFO's twenty actions with its ids. Targets in x and y are -1..1 in HFO's scale:
// the half of the task and a margin of 10 percent.
#include <cmath>

#include "training/actions/shared_actions.h"

namespace cls::training {
namespace {

const Column kX = {"x", "half", -1, 1};
const Column kY = {"y", "half", -1, 1};
const Column kSpeed = {"speed", "m/cycle", 0, 3};
const Column kNumber = {"number", "number", 1, 11};

Vec2 target(const PointOfView& view, const float* v) {
  const double margin = 0.1 * soccer::kHalfLength;
  const double left = view.stage.left - margin;
  const double right = view.stage.right + margin;
  return {left + (v[0] + 1.0) / 2.0 * (right - left), v[1] * 1.1 * soccer::kHalfWidth};
}

bool has_no_ball(const PointOfView& view) { return !has_ball(view); }
bool can_pass(const PointOfView& view) { return has_ball(view) && view.teammate_count() > 0; }
bool can_mark(const PointOfView& view) { return view.opponent_count() > 0; }

PlayerCommand kick_to_target(const PointOfView& view, const float* v) {
  return kick_to(view.scene, view.self, target(view, v), v[2]);
}
PlayerCommand move_to(const PointOfView& view, const float* v) {
  return go_to(view.scene, view.self, target(view, v), 0.25);
}
PlayerCommand dribble_to_target(const PointOfView& view, const float* v) {
  return dribble_to(view.scene, view.self, target(view, v));
}
PlayerCommand intercept_ball(const PointOfView& view, const float*) {
  return intercept(view.scene, view.self);
}

// The seen player with the number of the values; kNoSeat if none of `seats` has it.
Seat numbered(const PointOfView& view, const Seats& seats, const float* v) {
  const int number = static_cast<int>(std::lround(v[0]));
  for (const Seat seat : seats) {
    const ScenePlayer& player = view.scene.player(seat);
    if (player.seen && player.unum == number) return seat;
  }
  return kNoSeat;
}

// A number that no teammate wears acts as noop.
PlayerCommand pass(const PointOfView& view, const float* v) {
  const Seat mate = numbered(view, teammates_of(view), v);
  if (mate == kNoSeat) return stand();
  return pass_to(view.scene, view.self, view.scene.player(mate).position);
}

// Towards the goal.
PlayerCommand dribble(const PointOfView& view, const float*) {
  const Vec2 goal = {soccer::kHalfLength - 3.0, 0.0};
  return dribble_to(view.scene, view.self, goal);
}
PlayerCommand reduce_angle(const PointOfView& view, const float*) {
  return go_to(view.scene, view.self, angle_reducing_position(view), 0.5);
}
PlayerCommand mark(const PointOfView& view, const float* v) {
  const Seat opponent = numbered(view, opponents_of(view), v);
  if (opponent == kNoSeat) return stand();
  return go_to(view.scene, view.self, marking_position(view, opponent), 0.5);
}
PlayerCommand go_to_ball(const PointOfView& view, const float*) {
  return go_to(view.scene, view.self, view.scene.ball, 0.5);
}

}  // namespace

const ActionSet& hfo_actions() {
  static const ActionSet set = {.name = "hfo",
                                .version = 2,
                                .summary = "HFO's twenty actions; QUIT acts as NOOP",
                                .actions = {{"DASH", {kPower, kDirection}, dash},
                                            {"TURN", {kDirection}, turn},
                                            {"TACKLE", {kDirection}, tackle, tackle_reaches},
                                            {"KICK", {kPower, kDirection}, kick, has_ball},
                                            {"KICK_TO", {kX, kY, kSpeed}, kick_to_target, has_ball},
                                            {"MOVE_TO", {kX, kY}, move_to},
                                            {"DRIBBLE_TO", {kX, kY}, dribble_to_target},
                                            {"INTERCEPT", {}, intercept_ball},
                                            {"MOVE", {}, support},
                                            {"SHOOT", {}, shoot_at_goal, has_ball},
                                            {"PASS", {kNumber}, pass, can_pass},
                                            {"DRIBBLE", {}, dribble, has_ball},
                                            {"CATCH", {}, catch_now, catch_reaches},
                                            {"NOOP", {}, nothing},
                                            {"QUIT", {}, nothing},
                                            {"REDUCE_ANGLE_TO_GOAL", {}, reduce_angle},
                                            {"MARK_PLAYER", {kNumber}, mark, can_mark},
                                            {"DEFEND_GOAL", {}, guard},
                                            {"GO_TO_BALL", {}, go_to_ball, has_no_ball},
                                            {"REORIENT", {}, face_ball}}};
  return set;
}

}  // namespace cls::training
