// The situation in which the simple team decides, as plain data.
#pragma once

#include "base/fixed_list.h"
#include "soccer/geometry.h"
#include "soccer/pitch.h"

namespace cls::player {

using soccer::Vec2;

/// Cycles to the ball when no player can reach it.
constexpr int kNeverReached = 1000;

/// The middle of each goal line.
constexpr Vec2 kOurGoal{-soccer::kHalfLength, 0.0};
constexpr Vec2 kTheirGoal{soccer::kHalfLength, 0.0};

/// Play modes that the team tells apart.
enum class TeamMode : unsigned char {
  kPlayOn,
  kBeforeKickOff,  ///< or after a goal
  kKickOff,
  kGoalKick,
  kGoalieCatch,
  kFreeKick,
  kPenalty,  ///< of a shoot-out
  kOther,
};

/// A player as the agent estimates it.
struct SeenPlayer {
  int unum = 0;
  Vec2 position;
  Vec2 velocity;
  int age = 0;  ///< cycles since its position was seen
  bool goalie = false;
  bool tackling = false;
};

/// One agent's view. Coordinates: the own team attacks +x. Numbers have the precision of a State.
struct Situation {
  /// Players whose position is older count as absent.
  static constexpr int kMaxAge = 20;
  static constexpr std::size_t kMaxPlayers = 22;  ///< of a State

  TeamMode mode = TeamMode::kOther;
  bool our_set_play = false;
  int set_play_count = 0;  ///< cycles since play was stopped

  int unum = 0;
  bool goalie = false;
  Vec2 position;
  double stamina = 0.0;
  double catch_probability = 0.0;
  bool kickable = false;

  Vec2 ball;
  Vec2 ball_velocity;
  int ball_age = 0;
  /// Cycles until the agent, a teammate or an opponent can have the ball.
  int own_steps = kNeverReached;
  int teammates_steps = kNeverReached;
  int opponents_steps = kNeverReached;
  bool teammate_kicks = false;  ///< can kick the ball now
  bool opponent_kicks = false;

  double offside_line = 0.0;  ///< x at which teammates become offside
  base::FixedList<SeenPlayer, kMaxPlayers> teammates;
  base::FixedList<Vec2, kMaxPlayers> opponents;  ///< not older than kMaxAge

  bool ball_is_known() const { return ball_age < 10; }
  int own_reach() const { return kickable ? 0 : own_steps; }
  int teammates_reach() const { return teammate_kicks ? 0 : teammates_steps; }
  int opponents_reach() const { return opponent_kicks ? 0 : opponents_steps; }

  /// Distance of the nearest opponent to a point; 1000 when none is known.
  double nearest_opponent_to(Vec2 point) const;
  /// Margin of a straight ball path: the smallest distance of an opponent from it, minus the
  /// distance the opponent covers meanwhile (`base` meters plus `spread` meters per meter of the
  /// path). Negative: an opponent intercepts.
  double lane_margin(Vec2 from, Vec2 to, double base, double spread) const;

  /// No teammate is nearer to the ball; equal distances go to the lower uniform number.
  bool is_nearest_to_ball() const;
};

}  // namespace cls::player
