// The two logs of a match: lines of the text log by step, and frames with the printed decimals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// A received datagram.
struct LoggedDatagram {
  gamelog::RclSource source = gamelog::RclSource::kPlayer;
  Side side = Side::kNeutral;  ///< neutral for a trainer
  int unum = 0;                ///< 0 for a coach or trainer
  std::string_view text;
};

/// Datagrams and referee messages at one clock.
struct LoggedStep {
  std::vector<LoggedDatagram> received;
  std::vector<std::string> calls;  ///< referee messages
  std::vector<Slot> called_after;  ///< by call: sender of the last datagram before it, or kNoPlayer
};

/// Refers to the text of the record, which must outlive it. Ignores senders of unknown teams.
class TextLogIndex {
 public:
  TextLogIndex(const gamelog::RclRecord& text, const gamelog::TeamFrames& teams);

  /// Null if the log has no line for this clock.
  const LoggedStep* at(Clock clock) const;
  /// By time and stoppage.
  const std::map<std::pair<int, int>, LoggedStep>& steps() const { return steps_; }
  bool knows_a_team() const { return knows_a_team_; }
  /// True if the last step may lack lines.
  bool is_truncated() const { return is_truncated_; }

 private:
  std::map<std::pair<int, int>, LoggedStep> steps_;
  bool knows_a_team_ = false;
  bool is_truncated_ = false;
};

/// Frame `i` with the decimals that the server printed. Records hold single precision, in which
/// objects that touch may no longer do so.
gamelog::Frame printed_frame(const gamelog::MatchRecord& game, std::size_t i);

/// True if any player has one of these state bits.
bool shows_any(const gamelog::Frame& frame, std::uint32_t state_bits);

/// True if one step leads from `before` to `after`.
bool follows(Clock after, Clock before);

/// Number of frames up to the end of the text log, which may be truncated.
std::size_t covered_frames(const gamelog::MatchRecord& game, const TextLogIndex& text);

/// True if the text log has calls for most mode changes of the game log at the same times.
bool same_match(const gamelog::MatchRecord& game, const TextLogIndex& text);

}  // namespace cls::simulator
