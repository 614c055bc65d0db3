// The lines of a text log by the step they belong to.
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

/// A datagram as it was received.
struct SentText {
  gamelog::RclSource source = gamelog::RclSource::kPlayer;
  Side side = Side::kNeutral;  ///< neutral: a trainer
  int unum = 0;                ///< 0: a coach or trainer
  std::string_view text;
};

/// What was received and called while the clock showed one time.
struct LogMoment {
  std::vector<SentText> sent;
  std::vector<std::string> words;  ///< of the referee
  std::vector<Slot> called_after;  ///< by word: the player heard last before it, or kNobody
};

/// Refers to the record's text, which must outlive it. Senders of unknown teams are left out.
class TextLogIndex {
 public:
  TextLogIndex(const gamelog::RclRecord& text, const gamelog::TeamFrames& teams);

  /// Null when nothing happened.
  const LogMoment* at(Clock clock) const;
  /// By time and stoppage.
  const std::map<std::pair<int, int>, LogMoment>& moments() const { return moments_; }
  bool knows_a_team() const { return knows_a_team_; }
  /// True if the last moment may lack lines.
  bool is_damaged() const { return is_damaged_; }

 private:
  std::map<std::pair<int, int>, LogMoment> moments_;
  bool knows_a_team_ = false;
  bool is_damaged_ = false;
};

}  // namespace cls::simulator
