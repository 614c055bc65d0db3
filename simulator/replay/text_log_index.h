// Lines of a text log, indexed by step.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/frame.h"
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

}  // namespace cls::simulator
