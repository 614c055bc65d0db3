// The player with the ball: shot, pass, dribble or clearance.
#include "player/simple_team/play.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "soccer/pitch.h"

namespace cls::player {
namespace {

constexpr double kFullSpeed = 3.0;
constexpr double kPassArrivalSpeed = 1.1;
constexpr double kBallDecay = 0.94;

struct Pass {
  Vec2 target;
  double speed;
  double value;
};

// Kick speed for a ball that rolls `distance` and arrives with speed `arrival`.
double kick_speed(double distance, double arrival) {
  return std::min(arrival + distance * (1.0 - kBallDecay), 2.7);
}

// Value of having the ball at a point: grows forward and toward the opponent goal.
double value_of(Vec2 point) { return point.x - 0.15 * distance(point, kTheirGoal); }

bool may_receive(const SeenPlayer& teammate) {
  return teammate.age <= 8 && !teammate.goalie && !teammate.tackling;
}

// The offside line is an estimate, and forwards stay close to it.
bool is_likely_offside(const Situation& now, Vec2 position) {
  constexpr double kTolerance = 0.6;
  return position.x > 0.0 && position.x > std::max(now.offside_line, now.ball.x) + kTolerance;
}

// To a teammate, slightly ahead of their run.
std::optional<Pass> pass_to(const Situation& now, const SeenPlayer& teammate) {
  constexpr double kMinLength = 5.0;
  constexpr double kMaxLength = 34.0;

  const Vec2 position = teammate.position;
  const Vec2 lead = teammate.velocity * 2.0 + Vec2{position.x < 35.0 ? 1.5 : 0.0, 0.0};
  Vec2 target = position + lead;
  target.x = std::clamp(target.x, -soccer::kHalfLength + 2.0, soccer::kHalfLength - 2.0);
  target.y = std::clamp(target.y, -soccer::kHalfWidth + 1.0, soccer::kHalfWidth - 1.0);

  const double length = distance(now.ball, target);
  if (length < kMinLength || length > kMaxLength || is_likely_offside(now, position)) {
    return std::nullopt;
  }

  // No passes across the own goal: losing such a ball means conceding.
  const bool across = target.x < -30.0 && std::fabs(target.y) < 15.0 && target.x < now.ball.x;
  const double margin = now.lane_margin(now.ball, target, 0.9, 0.25);
  if (across || margin < 0.0) return std::nullopt;

  const double room = std::min(now.nearest_opponent_to(target), 10.0);
  const double value = value_of(target) + 0.6 * room + 0.8 * std::min(margin, 3.0);
  return Pass{target, kick_speed(length, kPassArrivalSpeed), value};
}

// Through pass behind the offside line, to a forward who reaches it first.
std::optional<Pass> through_pass(const Situation& now, const SeenPlayer& teammate) {
  constexpr double kAhead = 11.0;

  const Vec2 position = teammate.position;
  const double line = now.offside_line;
  if (position.x < line - 7.0 || line < 0.0 || is_likely_offside(now, position))
    return std::nullopt;

  const Vec2 target{std::min(line + kAhead, 45.0), position.y * 0.85};
  const double length = distance(now.ball, target);
  if (length < 10.0 || length > 32.0) return std::nullopt;
  if (now.nearest_opponent_to(target) < 0.8 * distance(position, target)) return std::nullopt;
  if (now.lane_margin(now.ball, target, 0.8, 0.16) < 0.0) return std::nullopt;
  return Pass{target, kick_speed(length, 0.7), value_of(target) + 6.0};
}

std::optional<Pass> best_pass(const Situation& now) {
  std::optional<Pass> best;

  for (const SeenPlayer& teammate : now.teammates) {
    if (!may_receive(teammate)) continue;
    for (const auto& pass : {pass_to(now, teammate), through_pass(now, teammate)}) {
      if (pass && (!best || pass->value > best->value)) best = pass;
    }
  }

  return best;
}

// The point of the goal line with the most room from opponents, when in range.
std::optional<Vec2> shot(const Situation& now) {
  constexpr double kRange = 24.0;
  constexpr double kPostMargin = 1.2;
  constexpr double kIntervals = 8;

  if (distance(now.ball, kTheirGoal) > kRange) return std::nullopt;
  const double post = 7.01 - kPostMargin;
  std::optional<Vec2> best;
  double best_margin = 0.0;

  for (int i = 0; i <= kIntervals; ++i) {
    const Vec2 target{kTheirGoal.x, -post + 2.0 * post * i / kIntervals};
    const double margin = now.lane_margin(now.ball, target, 0.8, 0.1);
    if (margin > best_margin) {
      best_margin = margin;
      best = target;
    }
  }

  return best;
}

// Straight toward the goal, or past the opponent in the way.
Vec2 dribble_target(const Situation& now) {
  constexpr double kAhead = 8.0;

  const Vec2 to_goal = with_length(kTheirGoal - now.position, kAhead);
  Vec2 best = now.position + to_goal;
  double best_room = -10.0;

  for (const double degrees : {0.0, 30.0, -30.0, 60.0, -60.0}) {
    Vec2 target = now.position + rotated_degrees(to_goal, degrees);
    if (std::fabs(target.y) > soccer::kHalfWidth - 1.5) continue;

    const double room =
        std::min(now.lane_margin(now.position, target, 0.0, 0.0), 6.0) - std::fabs(degrees) / 40.0;
    if (room > best_room) {
      best_room = room;
      best = target;
    }
  }

  return best;
}

bool is_pressed(const Situation& now) { return now.nearest_opponent_to(now.ball) < 3.0; }

}  // namespace

void attack(const Situation& now, ActionList& list) {
  if (const auto target = shot(now)) {
    list.smart_kick(*target, kFullSpeed, 2.2, 2);
    list.smart_kick(*target, kFullSpeed, 0.1, 1);
    list.watch_goalie_or_scan();
    return;
  }

  const auto pass = best_pass(now);
  const double here = value_of(now.ball) + 0.6 * std::min(now.nearest_opponent_to(now.ball), 10.0);
  if (pass && (is_pressed(now) || pass->value > here + 3.0)) {
    list.smart_kick(pass->target, pass->speed, pass->speed * 0.8, 3);
  }

  const bool in_danger = now.ball.x < 0.0 && is_pressed(now);
  if (in_danger) list.clear_ball();

  list.dribble(dribble_target(now), 90.0, is_pressed(now) ? 2 : 4);
  list.clear_ball();
  list.watch_ball_or_scan(0);
}

void kick_set_play(const Situation& now, ActionList& list) {
  const auto pass = best_pass(now);

  if (pass) {
    list.smart_kick(pass->target, pass->speed, pass->speed * 0.7, 1);
  } else if (now.mode == TeamMode::kKickOff) {
    const double side = now.unum % 2 == 0 ? -1.0 : 1.0;
    list.smart_kick({-12.0, 10.0 * side}, 1.6, 0.5, 1);
  }

  list.smart_kick({std::min(now.ball.x + 25.0, 48.0), now.ball.y * 0.4}, 2.5, 0.5, 1);
  list.watch_ball();
}

}  // namespace cls::player
