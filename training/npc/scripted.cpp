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

// The fielder who reaches the ball first goes for it; of equals the one with the lowest seat.
Seat first_to_ball(const Scene& scene, const Seats& team, const TeamSituation& now) {
  Seat first = kNoSeat;
  for (const Seat seat : team) {
    const ScenePlayer& player = scene.player(seat);
    if (!player.seen || player.goalie) continue;
    const int cycles = now.meeting_of(seat).cycles;
    const int best = first == kNoSeat ? cycles + 1 : now.meeting_of(first).cycles;
    if (cycles < best || (cycles == best && seat < first)) first = seat;
  }
  return first;
}

bool our_ball(const TeamSituation& now, int our_cycles) {
  return now.rival() == kNoSeat || our_cycles < now.rival_cycles;
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

PlayerCommand play_ball(const PointOfView& view, const TeamSituation& now) {
  const Scene& scene = view.scene;
  const Vec2 goal = {soccer::kHalfLength, 0.0};
  const Shot shot = best_shot(scene, view.self);
  if (distance(scene.ball, goal) < kShotRange && shot.gap > kShotGap) {
    return shoot(scene, view.self);
  }

  const bool pressed =
      now.rival() != kNoSeat && distance(scene.player(now.rival()).position, scene.ball) < 4.0;
  if (pressed) {
    const Seat mate = best_receiver(view);
    if (mate != kNoSeat) return pass_to(scene, view.self, scene.player(mate).position);
    if (distance(scene.ball, goal) < kShotRange) return shoot(scene, view.self);
  }

  return dribble_to(scene, view.self, {soccer::kHalfLength - 5.0, 0.5 * scene.ball.y});
}

PlayerCommand keep_goal(const PointOfView& view, const TeamSituation& now) {
  const Scene& scene = view.scene;
  if (can_catch(scene, view.self)) return catch_ball(scene, view.self);
  if (can_kick(scene, view.self)) {
    return kick_to(scene, view.self, {0.0, scene.ball.y < 0.0 ? -30.0 : 30.0}, 3.0);
  }
  const Meeting& mine = now.meeting_of(view.self);
  const bool near = mine.point.x < -soccer::kHalfLength + 12.0 && std::fabs(mine.point.y) < 14.0;
  if (near && our_ball(now, mine.cycles)) return meet(scene, view.self, mine);
  return go_to(scene, view.self, goal_line_position(view), 0.4);
}

PlayerCommand defend(const PointOfView& view, const TeamSituation& now) {
  const Scene& scene = view.scene;
  if (view.self == now.first) {
    const bool held = now.rival() != kNoSeat && can_kick(scene, now.rival());
    if (held && tackle_chance(scene, view.self) > kTackleChance) {
      return soccer::Tackle{bearing_degrees(view.me(), {1.0, 0.0}), false};
    }
    return meet(scene, view.self, now.meeting_of(view.self));
  }

  const Seat marked = opponent_to_mark(view, now.marking);
  const Vec2 point = marked != kNoSeat ? marking_position(view, marked) : guard_position(view);
  return go_to(scene, view.self, point, 0.8);
}

}  // namespace

TeamSituation assess(const Scene& scene, const Cast& cast) {
  TeamSituation now;
  now.marking = weigh_marking(scene, cast);
  const BallPath path = ball_path(scene);
  const Seats team = seats_of(scene.side, cast.team(scene.side));

  for (const Seat seat : team) {
    now.meetings[static_cast<std::size_t>(seat)] = meeting(scene, path, seat);
  }
  if (now.rival() != kNoSeat) now.rival_cycles = meeting(scene, path, now.rival()).cycles;

  const Seat mate = now.marking.chaser;
  now.theirs =
      now.rival() != kNoSeat && mate != kNoSeat && now.rival_cycles < now.meeting_of(mate).cycles;
  now.first = first_to_ball(scene, team, now);
  return now;
}

PlayerCommand scripted_command(const PointOfView& view, const TeamSituation& now) {
  const Scene& scene = view.scene;
  const ScenePlayer& me = view.me();
  if (!scene.ball_seen || me.frozen) return stand();
  if (me.goalie) return keep_goal(view, now);
  if (can_kick(scene, view.self)) return play_ball(view, now);

  if (now.theirs) return defend(view, now);
  if (view.self == now.first) return meet(scene, view.self, now.meeting_of(view.self));
  return go_to(scene, view.self, support_position(view), 1.5);
}

}  // namespace cls::training
