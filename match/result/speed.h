// Shares of the wall time of a match, and the party that limits its speed.
#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "soccer/side.h"

namespace cls::match {

/// Shares of the wall time; their sum is 1.
struct SpeedShares {
  double server = 0.0;          ///< over UDP with external teams: and their programs
  double agents = 0.0;          ///< of cls: world models, skills, commands
  double left_playmaker = 0.0;  ///< awaited; of an external team in lockstep: its programs
  double right_playmaker = 0.0;
  double trainer_playmaker = 0.0;
  double clock = 0.0;  ///< waits of real time and --speed
};

/// Time from the senses of a cycle to a side's last command, of the slower side, in ms.
struct DecisionTimes {
  double p50 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

/// The party that limits the speed of a match.
enum class SpeedLimit {
  kNothing,  ///< no cycle was played
  kLeftPlaymaker,
  kRightPlaymaker,
  kBothPlaymakers,
  kTrainerPlaymaker,
  kAgents,
  kServer,
  kClock,
  kServerAndTeams,  ///< a server of its own, which hides how long external teams take
};

/// Its name in result.json, such as "left playmaker"; empty for kNothing.
std::string_view name(SpeedLimit limit);

/// The limit of this name, if there is one.
std::optional<SpeedLimit> parse_speed_limit(std::string_view name);

struct SpeedResult {
  SpeedLimit limited_by = SpeedLimit::kNothing;
  SpeedShares shares;
  DecisionTimes decision_ms;
  bool fits_100_ms = false;  ///< 99 % of the decisions arrive in time for a server in real time

  /// The share of `limited_by`.
  double limiting_share() const;
};

/// The time that a side took for its decisions.
struct TurnTimes {
  std::chrono::nanoseconds total{0};
  std::chrono::nanoseconds playmaker{0};  ///< of that, waiting for replies
};

/// Adds up. Sides decide concurrently: of the time in which several of them were at work, each gets
/// an equal part.
class SpeedMeter {
 public:
  using Duration = std::chrono::nanoseconds;
  struct SideTurn {
    soccer::Side side = soccer::Side::kLeft;
    TurnTimes times;
  };

  void add_server(Duration time) { server_ += time; }
  void add_clock(Duration time) { clock_ += time; }
  /// `wall` is the time that passed until all of `turns` were over. Sorts `turns`.
  void add_turns(Duration wall, std::span<SideTurn> turns);

  /// The limiting party, and the shares.
  SpeedResult result() const;

 private:
  Duration server_{0};
  Duration clock_{0};
  Duration agents_{0};
  std::array<Duration, 3> playmakers_{};  ///< left, right, trainer
};

/// "limited by the right Playmaker (97 %)".
std::string limiting_party(const SpeedResult& speed);

/// The line of the summary: "limited by the right Playmaker (97 %), p99 104 ms: too slow for real
/// time".
std::string describe(const SpeedResult& speed);

}  // namespace cls::match
