// Writing a running match into its two logs.
#pragma once

#include <optional>
#include <string_view>

#include "gamelog/byte_sink.h"
#include "gamelog/frame.h"
#include "gamelog/rcg_writer.h"
#include "gamelog/rcl_writer.h"
#include "simulator/server/connection.h"
#include "simulator/server/tile.h"
#include "simulator/world.h"

namespace cls::simulator {

/// The world as game logs show it.
void describe(const World& world, gamelog::Frame& out);

/// Feeds a game log (rcg) and a text log (rcl).
class MatchRecorder {
 public:
  /// A null pointer means no such log; until now there is none. The sinks must outlive the
  /// recorder.
  void begin(gamelog::ByteSink* game_log, gamelog::ByteSink* text_log, const Rules& rules);

  /// Every step, after it (simulation model 12.4). When the play mode has changed, the game log is
  /// flushed.
  void step(const World& world);

  /// What the client of that player, coach or trainer has sent.
  void command(const World& world, ClientId client, std::string_view text);

  /// A coach's picture.
  void tile(const World& world, const Tile& tile);

  void referee(Clock clock, std::string_view text);

  /// The result; nothing may follow.
  void finish(const World& world);

 private:
  gamelog::ByteSink* game_log_ = nullptr;
  std::optional<gamelog::RcgWriter> rcg_;
  std::optional<gamelog::RclWriter> rcl_;
  gamelog::Frame frame_;
};

}  // namespace cls::simulator
