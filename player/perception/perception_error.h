// Accuracy of a world model against the ground truth of a game log.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "player/world/world_model.h"

namespace cls::player {

/// Mean and 95th percentile (the sorted value at index int(0.95 n)) of n errors.
struct ErrorSummary {
  double mean = 0.0;
  double p95 = 0.0;
  int n = 0;
};

/// Ground truth of one step, in server coordinates.
struct GroundTruth {
  struct Player {
    bool present = false;
    Vec2 position;
    double body = 0.0;  ///< degrees
  };
  Vec2 ball_position;
  std::optional<Vec2> ball_velocity;  ///< missing in game logs of versions 1 and 2
  std::array<Player, soccer::kPlayersOnPitch> players;  ///< by slot
};

/// Estimation errors of one player over a match, in play_on: own position and body always; the ball
/// if its pos_count is 0, its velocity if vel_count is 0; other players with pos_count 0 and an
/// estimated number. Meters, meters per cycle, degrees.
class PerceptionError {
 public:
  void add(const WorldModel& world, const GroundTruth& truth);

  int cycles() const { return cycles_; }
  ErrorSummary self() const { return summary(self_); }
  ErrorSummary body_angle() const { return summary(body_angle_); }
  ErrorSummary ball() const { return summary(ball_); }
  ErrorSummary ball_velocity() const { return summary(ball_velocity_); }
  ErrorSummary teammates() const { return summary(teammates_); }
  ErrorSummary opponents() const { return summary(opponents_); }

 private:
  static ErrorSummary summary(std::vector<double> errors);

  int cycles_ = 0;
  std::vector<double> self_;
  std::vector<double> body_angle_;
  std::vector<double> ball_;
  std::vector<double> ball_velocity_;
  std::vector<double> teammates_;
  std::vector<double> opponents_;
};

}  // namespace cls::player
