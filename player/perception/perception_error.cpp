// Collects estimation errors against the ground truth.
#include "player/perception/perception_error.h"

#include <algorithm>
#include <numeric>

#include "base/index.h"

namespace cls::player {

void PerceptionError::add(const WorldModel& world, const GroundTruth& truth) {
  if (world.game.mode != PlayMode::kPlayOn) return;
  ++cycles_;

  const bool right = world.our_side == Side::kRight;
  const auto own = [right](Vec2 v) { return right ? -v : v; };
  const auto real = [&](Side side, int unum) {
    return truth.players[base::index(soccer::slot_of(side, unum))];
  };

  const GroundTruth::Player self = real(world.our_side, world.unum);
  self_.push_back(soccer::distance(world.self.position, own(self.position)));
  const AngleDeg body(right ? self.body + 180.0 : self.body);
  body_angle_.push_back((world.self.body - body).abs());

  if (world.ball.pos_count == 0) {
    ball_.push_back(soccer::distance(world.ball.position, own(truth.ball_position)));
  }
  if (world.ball.vel_count == 0 && truth.ball_velocity) {
    ball_velocity_.push_back(soccer::distance(world.ball.velocity, own(*truth.ball_velocity)));
  }

  const auto add_team = [&](const PlayerList& players, std::vector<double>& errors) {
    for (const PlayerState& player : players) {
      if (player.pos_count != 0 || player.unum == 0) continue;
      const GroundTruth::Player there = real(player.side, player.unum);
      if (there.present) errors.push_back(distance(player.position, own(there.position)));
    }
  };

  add_team(world.teammates, teammates_);
  add_team(world.opponents, opponents_);
}

ErrorSummary PerceptionError::summary(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  const double n = static_cast<double>(errors.size());
  return {sum / n, errors[static_cast<std::size_t>(0.95 * n)], static_cast<int>(errors.size())};
}

}  // namespace cls::player
