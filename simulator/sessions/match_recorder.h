// Writes a running match to its game log, text log and keepaway log.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/io/byte_sink.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcl/keepaway_log.h"
#include "gamelog/rcl/rcl_writer.h"
#include "gamelog/record/frame.h"
#include "simulator/sessions/connection.h"
#include "simulator/sessions/team_graphic.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// Converts the world to a frame of game logs and monitors.
void to_frame(const World& world, gamelog::Frame& out);

/// Destinations of logs; null for no log. The sinks must outlive the recorder.
struct LogSinks {
  base::ByteSink* game = nullptr;  ///< rcg
  base::ByteSink* text = nullptr;  ///< rcl
  gamelog::RcgVersion version = gamelog::RcgVersion::kV6;
  gamelog::LogDate date = {};
};

/// With server::record_messages the game log also contains messages and commands. A game log of
/// version 1 always contains referee messages.
class MatchRecorder {
 public:
  /// Starts recording.
  void begin(const LogSinks& sinks, const Rules& rules);

  /// Records the frame after a step (docs/spec/simulation-model.md 12.4). Flushes the game log when
  /// the play mode has changed.
  void step(const World& world);

  /// Records a datagram of a player, coach or trainer.
  void command(const World& world, ClientId client, std::string_view text);

  void tile(const World& world, const TeamGraphicTile& tile);

  void referee(Clock clock, std::string_view text);

  /// True if message() has an effect.
  bool records_messages() const { return rcg_ && record_messages_; }

  /// Records a message of a player, a coach or the trainer: `(SPEAKER TEXT)`.
  void message(const World& world, Clock clock, std::string_view text);

  /// Records a new player type or a new goalie.
  void substitution(const World& world, Clock clock, std::string_view text);

  /// Records the result; must be the last call.
  void finish(const World& world);

 private:
  base::ByteSink* game_log_ = nullptr;
  std::optional<gamelog::RcgWriter> rcg_;
  std::optional<gamelog::RclWriter> rcl_;
  bool record_messages_ = false;
  bool record_referee_ = false;
  gamelog::Frame frame_;
  std::string text_;
};

/// Detects episodes in the referee state. Writes nothing unless the match is keepaway.
class KeepawayRecorder {
 public:
  /// The sink must outlive the recorder.
  explicit KeepawayRecorder(base::ByteSink& sink) : log_(sink) {}

  /// Called after every step.
  void step(const World& world);

 private:
  gamelog::KeepawayLogWriter log_;
  int episode_ = 0;  ///< current episode
  int start_ = 0;    ///< start of the episode; 0 for the first, as in rcssserver
};

}  // namespace cls::simulator
