// Groups the lines of a text log by step.
#include "simulator/replay/text_log_index.h"

namespace cls::simulator {

using gamelog::RclLine;
using gamelog::RclSource;

namespace {

Slot last_player(const LoggedStep& step) {
  if (step.received.empty() || step.received.back().source != RclSource::kPlayer) return kNoPlayer;
  return soccer::slot_of(step.received.back().side, step.received.back().unum);
}

}  // namespace

TextLogIndex::TextLogIndex(const gamelog::RclRecord& text, const gamelog::TeamFrames& teams) {
  is_truncated_ = !text.errors.empty();
  std::vector<Side> sides;
  for (const std::string& team : text.teams) {
    const Side side = team == teams[0].name   ? Side::kLeft
                      : team == teams[1].name ? Side::kRight
                                              : Side::kNeutral;
    sides.push_back(side);
    knows_a_team_ = knows_a_team_ || side != Side::kNeutral;
  }
  for (const RclLine& line : text.lines) {
    LoggedStep& step = steps_[{line.time, line.stopped}];
    const std::string_view message = text.text_of(line);
    if (line.source == RclSource::kReferee) {
      step.calls.emplace_back(message);
      step.called_after.push_back(last_player(step));
    } else if (line.source == RclSource::kTrainer) {
      step.received.push_back({line.source, Side::kNeutral, 0, message});
    } else if (line.source != RclSource::kOther && sides[line.team] != Side::kNeutral) {
      step.received.push_back({line.source, sides[line.team], line.unum, message});
    }
  }
}

const LoggedStep* TextLogIndex::at(Clock clock) const {
  const auto found = steps_.find({clock.time, clock.stoppage});
  return found == steps_.end() ? nullptr : &found->second;
}

}  // namespace cls::simulator
