// Steps the ball until a player can reach it.
#include "analysis/play/interception_time.h"

#include <array>
#include <cmath>
#include <limits>

#include "soccer/math.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kSmallTurn = 15.0;
constexpr double kWideTurn = 90.0;
constexpr double kRunning = 0.4;  // share of top speed

int turning_cycles(const gamelog::MatchRecord& record, std::size_t entry, Vec2 target) {
  const Vec2 path = target - record.players.position[entry];
  const double off = std::fabs(soccer::math::normalize_degrees(soccer::direction_degrees(path) -
                                                               record.players.body[entry]));
  if (off < kSmallTurn) return 0;
  const double speed = Vec2(record.players.velocity[entry]).length();
  const bool runs = speed > kRunning * type_of(record, entry).player_speed_max;
  return off > kWideTurn && runs ? 2 : 1;
}

// A player's values that are constant over all cycles.
struct Runner {
  std::size_t entry = 0;
  Vec2 position;
  double radius = 0.0;
  double speed = 0.0;
  int turns = -1;  ///< not computed yet

  double reach(int cycles, int standing) const {
    return radius + std::max(0, cycles - standing) * speed;
  }
};

Runner runner_at(const gamelog::MatchRecord& record, std::size_t entry) {
  Runner runner;
  runner.entry = entry;
  runner.position = record.players.position[entry];
  runner.radius = kickable_radius(record, entry);
  runner.speed = type_of(record, entry).player_speed_max * kShareOfTopSpeed;
  return runner;
}

// Turning cycles are computed only for players that could reach the ball without turning.
bool reaches(const gamelog::MatchRecord& record, Runner& runner, Vec2 ball, int cycles) {
  const double squared = soccer::squared_distance(runner.position, ball);
  const double furthest = runner.reach(cycles, 1);
  if (squared > furthest * furthest) return false;
  if (runner.turns < 0) runner.turns = turning_cycles(record, runner.entry, ball);
  const double reach = runner.reach(cycles, 1 + runner.turns);
  return squared <= reach * reach;
}

// Predicts the ball; its velocity decays.
class RollingBall {
 public:
  RollingBall(const gamelog::MatchRecord& record, std::size_t frame)
      : position_(record.ball_position[frame]),
        velocity_(record.ball_velocity[frame]),
        decay_(record.server.ball_decay) {}

  Vec2 position() const { return position_; }
  void step() {
    position_ += velocity_;
    velocity_ *= decay_;
  }

 private:
  Vec2 position_;
  Vec2 velocity_;
  double decay_;
};

}  // namespace

std::optional<Interception> first_to_ball(const gamelog::MatchRecord& record, std::size_t frame) {
  std::array<Runner, gamelog::kSlots> runners;
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    if (gamelog::is_enabled(record, entry)) runners[count++] = runner_at(record, entry);
  }

  RollingBall ball(record, frame);
  for (int cycles = 0; cycles <= kMaxInterceptionCycles; ++cycles, ball.step()) {
    std::optional<Interception> first;
    double nearest = std::numeric_limits<double>::max();
    bool both = false;

    for (std::size_t i = 0; i < count; ++i) {
      if (!reaches(record, runners[i], ball.position(), cycles)) continue;
      const std::size_t slot = runners[i].entry - entry_of(frame, 0);
      both = both || (first && !same_team(first->slot, slot));
      const double distance = soccer::distance(runners[i].position, ball.position());
      if (distance < nearest) {
        nearest = distance;
        first = Interception{slot, cycles};
      }
    }
    if (first) return both ? std::nullopt : first;
  }
  return std::nullopt;
}

std::optional<int> cycles_to_ball(const gamelog::MatchRecord& record, std::size_t frame,
                                  std::size_t slot) {
  Runner runner = runner_at(record, entry_of(frame, slot));
  RollingBall ball(record, frame);
  for (int cycles = 0; cycles <= kMaxInterceptionCycles; ++cycles, ball.step()) {
    if (reaches(record, runner, ball.position(), cycles)) return cycles;
  }
  return std::nullopt;
}

}  // namespace cls::analysis
