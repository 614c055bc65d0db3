// How far a player's beliefs are from the truth, as tables compare it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Mean and 95th percentile (the sorted value at index int(0.95 n)) of n errors.
struct ErrorSummary {
  double mean = 0.0;
  double p95 = 0.0;
  int n = 0;
};

/// The truth at one moment, in the server's coordinates.
struct Truth {
  struct Player {
    bool present = false;
    soccer::Vec2 position;
    double body = 0.0;  ///< degrees
  };
  soccer::Vec2 ball_position;
  std::optional<soccer::Vec2> ball_velocity;            ///< game logs of versions 1 and 2 have none
  std::array<Player, soccer::kPlayersOnPitch> players;  ///< by slot
};

/// Errors of one player over a match. Counted are decisions in play_on: own position and body
/// always; the ball when its pos_count is 0, its velocity when its vel_count is 0; other players
/// when their pos_count is 0 and their number is believed to be known. Metres, metres per cycle
/// and degrees.
class PerceptionError {
 public:
  void add(const WorldModel& world, const Truth& truth);

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

}  // namespace cls::proxy
