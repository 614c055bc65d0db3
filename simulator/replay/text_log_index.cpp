// Sorting lines.
#include "simulator/replay/text_log_index.h"

namespace cls::simulator {

using gamelog::RclLine;
using gamelog::RclSource;

namespace {

Slot last_player(const LogMoment& moment) {
  if (moment.sent.empty() || moment.sent.back().source != RclSource::kPlayer) return kNobody;
  return soccer::slot_of(moment.sent.back().side, moment.sent.back().unum);
}

}  // namespace

TextLogIndex::TextLogIndex(const gamelog::RclRecord& text, const gamelog::TeamFrames& teams) {
  is_damaged_ = !text.damage.empty();
  std::vector<Side> sides;
  for (const std::string& team : text.teams) {
    const Side side = team == teams[0].name   ? Side::kLeft
                      : team == teams[1].name ? Side::kRight
                                              : Side::kNeutral;
    sides.push_back(side);
    knows_a_team_ = knows_a_team_ || side != Side::kNeutral;
  }
  for (const RclLine& line : text.lines) {
    LogMoment& moment = moments_[{line.time, line.stopped}];
    const std::string_view words = text.text_of(line);
    if (line.source == RclSource::kReferee) {
      moment.words.emplace_back(words);
      moment.called_after.push_back(last_player(moment));
    } else if (line.source == RclSource::kTrainer) {
      moment.sent.push_back({line.source, Side::kNeutral, 0, words});
    } else if (line.source != RclSource::kOther && sides[line.team] != Side::kNeutral) {
      moment.sent.push_back({line.source, sides[line.team], line.unum, words});
    }
  }
}

const LogMoment* TextLogIndex::at(Clock clock) const {
  const auto found = moments_.find({clock.time, clock.stoppage});
  return found == moments_.end() ? nullptr : &found->second;
}

}  // namespace cls::simulator
