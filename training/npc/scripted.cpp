// Scripted play: goalie, defenders, and attackers with and without the ball.
#include "training/npc/scripted.h"

#include <cmath>

#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/skills/positions.h"

namespace cls::training {
namespace {

constexpr double kShotRange = 22.0;
constexpr double kShotGap = 0.10;  // radians of free goal
constexpr double kPassGap = 0.30;
constexpr double kTackleChance = 0.8;

bool our_ball(const PointOfView& view, int our_cycles) {
  const Seat rival = nearest_player(view.scene, true, view.scene.ball);
  return rival == kNoSeat || our_cycles < meeting(view.scene, rival).cycles;
}

// The teammate who reaches the ball first goes for it.
bool is_first_to_ball(const PointOfView& view) {
  const int mine = meeting(view.scene, view.self).cycles;
  for (const Seat seat : teammates_of(view)) {
    const ScenePlayer& mate = view.scene.player(seat);
    if (!mate.seen || mate.goalie) continue;
    const int theirs = meeting(view.scene, seat).cycles;
    if (theirs < mine || (theirs == mine && seat < view.self)) return false;
  }
  return true;
}

Seat best_receiver(const PointOfView& view) {
  Seat best = kNoSeat;
  double most = view.me().position.x + 2.0;

  for (const Seat seat : teammates_of(view)) {
    const ScenePlayer& mate = view.scene.player(seat);
    if (!mate.seen || mate.goalie || mate.position.x < most) continue;
    if (lane_gap(view.scene, view.scene.ball, mate.position) < kPassGap) continue;
    best = seat;
    most = mate.position.x;
  }
  return best;
}

PlayerCommand play_ball(const PointOfView& view) {
  const Scene& scene = view.scene;
  const Vec2 goal = {soccer::kHalfLength, 0.0};
  const Shot shot = best_shot(scene, view.self);
  if (distance(scene.ball, goal) < kShotRange && shot.gap > kShotGap) {
    return shoot(scene, view.self);
  }

  const Seat rival = nearest_player(scene, true, scene.ball);
  const bool pressed = rival != kNoSeat && distance(scene.player(rival).position, scene.ball) < 4.0;
  if (pressed) {
    const Seat mate = best_receiver(view);
    if (mate != kNoSeat) return pass_to(scene, view.self, scene.player(mate).position);
    if (distance(scene.ball, goal) < kShotRange) return shoot(scene, view.self);
  }

  return dribble_to(scene, view.self, {soccer::kHalfLength - 5.0, 0.5 * scene.ball.y});
}

PlayerCommand keep_goal(const PointOfView& view) {
  const Scene& scene = view.scene;
  if (can_catch(scene, view.self)) return catch_ball(scene, view.self);
  if (can_kick(scene, view.self)) {
    return kick_to(scene, view.self, {0.0, scene.ball.y < 0.0 ? -30.0 : 30.0}, 3.0);
  }
  const Meeting mine = meeting(scene, view.self);
  const bool near = mine.point.x < -soccer::kHalfLength + 12.0 && std::fabs(mine.point.y) < 14.0;
  if (near && our_ball(view, mine.cycles)) return intercept(scene, view.self);
  return go_to(scene, view.self, goal_line_position(view), 0.4);
}

PlayerCommand defend(const PointOfView& view) {
  const Scene& scene = view.scene;
  if (is_first_to_ball(view)) {
    const Seat holder = nearest_player(scene, true, scene.ball);
    const bool held = holder != kNoSeat && can_kick(scene, holder);
    if (held && tackle_chance(scene, view.self) > kTackleChance) {
      return soccer::Tackle{bearing_degrees(view.me(), {1.0, 0.0}), false};
    }
    return intercept(scene, view.self);
  }

  const Seat rival = opponent_to_mark(view);
  const Vec2 point = rival != kNoSeat ? marking_position(view, rival) : guard_position(view);
  return go_to(scene, view.self, point, 0.8);
}

}  // namespace

PlayerCommand scripted_command(const PointOfView& view) {
  const Scene& scene = view.scene;
  const ScenePlayer& me = view.me();
  if (!scene.ball_seen || me.frozen) return stand();
  if (me.goalie) return keep_goal(view);
  if (can_kick(scene, view.self)) return play_ball(view);

  // Who is nearer to the own goal's side of the ball's next owner decides attack or defense.
  const Seat rival = nearest_player(scene, true, scene.ball);
  const Seat mate = nearest_player(scene, false, scene.ball);
  const bool theirs = rival != kNoSeat && mate != kNoSeat &&
                      meeting(scene, rival).cycles < meeting(scene, mate).cycles;

  if (theirs) return defend(view);
  if (is_first_to_ball(view)) return intercept(scene, view.self);
  return go_to(scene, view.self, support_position(view), 1.5);
}

}  // namespace cls::training
