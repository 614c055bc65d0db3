// Positions without the ball.
#include "training/skills/positions.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::training {
namespace {

constexpr Vec2 kOwnGoal = {-soccer::kHalfLength, 0.0};

Vec2 between(Vec2 from, Vec2 to, double meters) {
  return from + soccer::with_length(to - from, meters);
}

// Where the lines of sight from the ball to the posts are halved.
Vec2 bisector(const PointOfView& view) {
  const double post = view.scene.server->goal_width / 2.0;
  const Vec2 ball = view.scene.ball;
  const Vec2 to_top = soccer::with_length(Vec2{-soccer::kHalfLength, -post} - ball, 1.0);
  const Vec2 to_bottom = soccer::with_length(Vec2{-soccer::kHalfLength, post} - ball, 1.0);
  return soccer::with_length(to_top + to_bottom, 1.0);
}

}  // namespace

Vec2 support_position(const PointOfView& view) {
  const Seats mates = teammates_of(view);
  // Lanes from top to bottom, by the order of uniform numbers.
  int lane = 0;
  for (const Seat seat : mates) lane += seat < view.self ? 1 : 0;
  const int lanes = static_cast<int>(mates.size()) + 1;
  const double share = lanes > 1 ? 2.0 * lane / (lanes - 1) - 1.0 : 0.0;

  const Vec2 ball = view.scene.ball;
  const double x = std::clamp(ball.x + 8.0, view.stage.left, soccer::kHalfLength - 6.0);
  const double y = std::clamp(0.5 * ball.y + share * 15.0, -27.0, 27.0);
  return {x, y};
}

Vec2 goal_line_position(const PointOfView& view) {
  const Vec2 ball = view.scene.ball;
  const Vec2 way = bisector(view);
  // Two meters in front of the line, on the bisector.
  const double line = -soccer::kHalfLength + 2.0;
  if (way.x >= -1e-6 || ball.x <= line) return {line, std::clamp(ball.y, -6.0, 6.0)};
  const Vec2 point = ball + way * ((line - ball.x) / way.x);
  return {line, std::clamp(point.y, -6.5, 6.5)};
}

Vec2 guard_position(const PointOfView& view) {
  const double far = distance(view.scene.ball, kOwnGoal);
  return between(kOwnGoal, view.scene.ball, std::min(10.0, far * 0.6));
}

Vec2 marking_position(const PointOfView& view, Seat opponent) {
  return between(view.scene.player(opponent).position, kOwnGoal, 2.0);
}

Vec2 angle_reducing_position(const PointOfView& view) {
  const double far = distance(view.scene.ball, kOwnGoal);
  return view.scene.ball + bisector(view) * std::min(far * 0.5, 8.0);
}

Marking weigh_marking(const Scene& scene, const Cast& cast) {
  Marking marking;
  marking.chaser = nearest_player(scene, false, scene.ball);
  marking.holder = nearest_player(scene, true, scene.ball);
  marking.threats = seats_of(scene.side, cast.others(scene.side));
  sort_by_distance(scene, kOwnGoal, marking.threats);
  return marking;
}

Seat opponent_to_mark(const PointOfView& view, const Marking& marking) {
  int rank = 0;
  for (const Seat seat : teammates_of(view)) {
    const ScenePlayer& mate = view.scene.player(seat);
    rank += mate.seen && !mate.goalie && seat != marking.chaser && seat < view.self ? 1 : 0;
  }

  for (const Seat seat : marking.threats) {
    if (seat == marking.holder || !view.scene.player(seat).seen) continue;
    if (rank-- == 0) return seat;
  }
  return kNoSeat;
}

Seat opponent_to_mark(const PointOfView& view) {
  return opponent_to_mark(view, weigh_marking(view.scene, view.cast));
}

}  // namespace cls::training
