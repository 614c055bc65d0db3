// Agreement of the simulator with a recorded match: classes of steps, tallies, misses, noise
// samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/world/event.h"

namespace cls::simulator {

/// The event of an object in a step. The most specific class applies: a player that dashed into
/// another one collided.
enum class StepClass : std::uint8_t {
  kBallFree,  ///< no contact
  kBallStopped,
  kBallKick,
  kBallTackle,
  kBallCatch,
  kBallHeld,
  kBallCollision,
  kBallPost,
  kBallPlaced,  ///< by the referee or a trainer
  kBallHalfTime,
  kPlayerIdle,
  kPlayerBlocked,  ///< by a tackle or a foul
  kPlayerDash,
  kPlayerTurn,
  kPlayerKick,
  kPlayerTackle,
  kPlayerCatch,
  kPlayerMove,
  kPlayerCollision,
  kPlayerPost,
  kPlayerPlaced,  ///< by the referee (cleared from the ball, moved to the own half) or a trainer
  kPlayerHalfTime,
};
constexpr std::size_t kStepClassCount = static_cast<std::size_t>(StepClass::kPlayerHalfTime) + 1;

/// "ball_free", "player_dash", ...
std::string_view name(StepClass step_class);

/// True for contacts and placements, which magnify the rounding of a log.
bool magnifies_rounding(StepClass step_class);

/// `before` is the world before the commands, `after` the world after step().
StepClass ball_class(const World& before, const World& after);
StepClass player_class(const World& before, const World& after, Slot slot);

struct Tally {
  int steps = 0;
  int agreed = 0;

  void add(bool agrees) {
    ++steps;
    if (agrees) ++agreed;
  }
  int misses() const { return steps - agreed; }
  /// 1 if there are no steps.
  double share() const { return steps == 0 ? 1.0 : static_cast<double>(agreed) / steps; }
};

struct ClassTally : Tally {
  double worst = 0.0;  ///< largest difference of position or velocity; meters, meters per cycle
};

/// A step of one object whose result differs from the record.
struct Miss {
  Clock clock;            ///< of the recorded frame
  Slot slot = kNoPlayer;  ///< kNoPlayer: the ball
  StepClass step_class = StepClass::kBallFree;
  std::string what;  ///< "position 0.0123 > 0.0002, body 0.2 > 0.001"
};

/// Why the previous frame alone does not determine a step.
enum class Excuse : std::uint8_t {
  kTackle,  ///< random outcome, taken from the record
  kCatch,
  kFoul,
  kRandomPlace,  ///< the referee moves a player to a random position in its own half
  kHalfTime,     ///< the pause is not recorded; not counted if it differs
  kNoise,        ///< a contact whose noise is unknown; only if it differs, and not counted
  kLine,         ///< noise decided which line the ball crossed or which post it passed
  kToucher,      ///< noise decided which of two contacts in one cycle was stronger
  kCameOrLeft,   ///< connected, or disconnected without bye; not counted
};
constexpr std::size_t kExcuseCount = static_cast<std::size_t>(Excuse::kCameOrLeft) + 1;
std::string_view name(Excuse excuse);

/// Lengths of noise divided by the maximum; specified as uniform in 0 to 1.
struct NoiseSample {
  std::vector<double> shares;

  double mean() const;
  double largest() const;
  /// Kolmogorov-Smirnov distance between the distribution of `shares` and the uniform one.
  double distance_to_uniform() const;
};

/// Squares of kick noise divided by their expectation; the expected mean is 1.
struct KickNoise {
  double sum = 0.0;
  int n = 0;

  double mean() const { return n == 0 ? 0.0 : sum / n; }
};

struct LogAgreement {
  static constexpr std::size_t kMaxMisses = 5000;

  bool has_noise = false;
  int frames = 0;
  int skipped = 0;  ///< pairs of frames with a gap between them or without a text log

  Tally ball;
  Tally players;
  std::array<ClassTally, kStepClassCount> by_class;
  int excused = 0;    ///< steps with an excuse
  int uncounted = 0;  ///< excused steps not counted in `ball` and `players`
  std::array<int, kExcuseCount> by_cause = {};

  Tally state;  ///< bits of players
  Tally counters;
  Tally mode;
  Tally clock;
  Tally score;
  Tally calls;                             ///< referee messages
  std::vector<std::string> missing_calls;  ///< recorded only, "TIME,STOPPED MESSAGE"
  std::vector<std::string> extra_calls;    ///< simulated only
  std::vector<std::string> game_misses;    ///< mode, clock, score, counters, state bits

  std::vector<Miss> misses;  ///< of ball and players; the first kMaxMisses

  NoiseSample player_noise;
  NoiseSample ball_noise;
  KickNoise kick_noise;

  int steps() const { return ball.steps + players.steps; }
  int agreed() const { return ball.agreed + players.agreed; }
  double agreement() const { return Tally{steps(), agreed()}.share(); }
  double excused_share() const;
};

}  // namespace cls::simulator
