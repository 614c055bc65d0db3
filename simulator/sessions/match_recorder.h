// Writing a running match into its logs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/io/byte_sink.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcl/rcl_writer.h"
#include "gamelog/record/frame.h"
#include "simulator/sessions/connection.h"
#include "simulator/sessions/tile.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// The world as game logs show it.
void describe(const World& world, gamelog::Frame& out);

/// Where logs go; a null pointer means no such log. The sinks must outlive who writes.
struct LogSinks {
  base::ByteSink* game = nullptr;  ///< rcg
  base::ByteSink* text = nullptr;  ///< rcl
  gamelog::RcgVersion version = gamelog::RcgVersion::kV6;
  gamelog::LogDate date = {};
};

/// Feeds the logs. With server::record_messages the game log holds words and commands too; one of
/// version 1 always holds the referee's words.
class MatchRecorder {
 public:
  /// Until now there is no log.
  void begin(const LogSinks& sinks, const Rules& rules);

  /// Every step, after it (simulation model 12.4). When the play mode has changed, the game log is
  /// flushed.
  void step(const World& world);

  /// What the client of that player, coach or trainer has sent.
  void command(const World& world, ClientId client, std::string_view text);

  /// A coach's picture.
  void tile(const World& world, const Tile& tile);

  void referee(Clock clock, std::string_view text);

  /// True if said() does something.
  bool hears() const { return rcg_ && records_messages_; }

  /// What was said by a player, a coach or the trainer: `(SPEAKER WORDS)`.
  void said(const World& world, Clock clock, std::string_view text);

  /// A player's new type, or a new goalie.
  void substitution(const World& world, Clock clock, std::string_view text);

  /// The result; nothing may follow.
  void finish(const World& world);

 private:
  base::ByteSink* game_log_ = nullptr;
  std::optional<gamelog::RcgWriter> rcg_;
  std::optional<gamelog::RclWriter> rcl_;
  bool records_messages_ = false;
  bool records_referee_ = false;
  gamelog::Frame frame_;
  std::string text_;
};

}  // namespace cls::simulator
