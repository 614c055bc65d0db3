// How far the simulator agrees with a recorded match: figures, misses, noise.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "simulator/replay/step_class.h"

namespace cls::simulator {

struct Tally {
  int steps = 0;
  int agreed = 0;

  void add(bool agrees) {
    ++steps;
    if (agrees) ++agreed;
  }
  int misses() const { return steps - agreed; }
  /// 1 where there is nothing to disagree on.
  double share() const { return steps == 0 ? 1.0 : static_cast<double>(agreed) / steps; }
};

struct ClassTally : Tally {
  double worst = 0.0;  ///< largest difference of position or velocity; metres, metres per cycle
};

/// A step of one object that came out otherwise than recorded.
struct Miss {
  Clock clock;          ///< of the recorded frame
  Slot slot = kNobody;  ///< kNobody: the ball
  StepClass step_class = StepClass::kBallFree;
  std::string what;  ///< "position 0.0123 > 0.0002, body 0.2 > 0.001"
};

/// Why a step was not reckoned from the frame before alone.
enum class Excuse : std::uint8_t {
  kTackle,  ///< its outcome is drawn: taken from the record
  kCatch,
  kFoul,
  kRandomPlace,  ///< the referee puts a player anywhere in its own half
  kHalfTime,     ///< of the pause nothing is recorded; not counted where it differs
  kNoise,        ///< a contact whose noise cannot be told; only where it differs, and not counted
  kLine,         ///< noise decided over which line or past which post the ball went
  kToucher,      ///< noise decided which of two contacts in one cycle was the stronger
  kCameOrLeft,   ///< joined, or was lost without a bye; not counted
};
constexpr std::size_t kExcuseCount = static_cast<std::size_t>(Excuse::kCameOrLeft) + 1;
std::string_view name(Excuse excuse);

/// Lengths of noise as shares of the largest possible: uniform in 0 to 1 says the specification.
struct NoiseSample {
  std::vector<double> shares;

  double mean() const;
  double largest() const;
  /// Largest distance between the shares' distribution and the uniform one (Kolmogorov-Smirnov).
  double distance_to_uniform() const;
};

/// Squares of kick noise as shares of their expectation: mean 1.
struct KickNoise {
  double sum = 0.0;
  int n = 0;

  double mean() const { return n == 0 ? 0.0 : sum / n; }
};

struct LogAgreement {
  static constexpr std::size_t kMostMisses = 5000;

  bool has_noise = false;
  int frames = 0;
  int skipped = 0;  ///< pairs of frames with something missing between them, or without a text log

  Tally ball;
  Tally players;
  std::array<ClassTally, kStepClassCount> by_class;
  int excused = 0;    ///< steps of objects with an excuse
  int uncounted = 0;  ///< of these, left out of ball and players
  std::array<int, kExcuseCount> by_cause = {};

  Tally state;  ///< bits of players
  Tally counters;
  Tally mode;
  Tally clock;
  Tally score;
  Tally words;                             ///< of the referee
  std::vector<std::string> missing_words;  ///< recorded only, "TIME,STOPPED WORD"
  std::vector<std::string> added_words;    ///< ours only
  std::vector<std::string> game_misses;    ///< mode, clock, score, counters, state bits

  std::vector<Miss> misses;  ///< of ball and players, the first kMostMisses

  NoiseSample player_noise;
  NoiseSample ball_noise;
  KickNoise kick_noise;

  int steps() const { return ball.steps + players.steps; }
  int agreed() const { return ball.agreed + players.agreed; }
  double agreement() const { return Tally{steps(), agreed()}.share(); }
  double excused_share() const;
};

}  // namespace cls::simulator
