// Groups the lines of a text log by step, restores printed decimals and matches both logs.
#include "simulator/replay/logged_match.h"

#include <algorithm>
#include <cmath>

#include "simulator/referee/modes.h"

namespace cls::simulator {

using gamelog::Frame;
using gamelog::MatchRecord;
using gamelog::RclLine;
using gamelog::RclSource;

namespace {

Slot last_player(const LoggedStep& step) {
  if (step.received.empty() || step.received.back().source != RclSource::kPlayer) return kNoPlayer;
  return soccer::slot_of(step.received.back().side, step.received.back().unum);
}

double printed(double value, double decimals) {
  constexpr double kSingle = 0.1;  // exceeds the error of single precision
  const double whole = std::rint(value * decimals);
  return std::fabs(value * decimals - whole) < kSingle ? whole / decimals : value;
}

Vec2 printed(Vec2 v) { return {printed(v.x, 1e4), printed(v.y, 1e4)}; }

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

Frame printed_frame(const MatchRecord& game, std::size_t i) {
  Frame frame = frame_at(game, i);
  frame.ball_position = printed(frame.ball_position);
  frame.ball_velocity = printed(frame.ball_velocity);
  for (gamelog::PlayerFrame& player : frame.players) {
    player.position = printed(player.position);
    player.velocity = printed(player.velocity);
    player.body = printed(player.body, 1e3);
    player.neck = printed(player.neck, 1e3);
  }
  return frame;
}

bool shows_any(const Frame& frame, std::uint32_t state_bits) {
  return std::ranges::any_of(frame.players,
                             [=](const auto& player) { return (player.state & state_bits) != 0; });
}

bool follows(Clock after, Clock before) {
  return after == Clock{before.time, before.stoppage + 1} || after == Clock{before.time + 1, 0};
}

std::size_t covered_frames(const MatchRecord& game, const TextLogIndex& text) {
  std::size_t frames = game.frames();
  const int last = text.steps().empty() ? 0 : text.steps().rbegin()->first.first;
  // The commands of a cycle lead to the frame of the next cycle.
  const int covered = text.is_truncated() ? last : last + 1;
  while (frames > 1 && game.time[frames - 1] > covered) --frames;
  return frames;
}

bool same_match(const MatchRecord& game, const TextLogIndex& text) {
  int changes = 0;
  int called = 0;
  for (std::size_t i = 1; i < covered_frames(game, text); ++i) {
    if (game.mode[i] == game.mode[i - 1] || is_goal(game.mode[i])) continue;
    ++changes;
    const std::string_view mode = soccer::name(game.mode[i]);
    // The time of a call is from before or after the clock advanced.
    auto step = text.steps().lower_bound({game.time[i] - 1, 0});
    for (; step != text.steps().end() && step->first.first <= game.time[i]; ++step) {
      const std::vector<std::string>& calls = step->second.calls;
      if (std::ranges::find(calls, mode) == calls.end()) continue;
      ++called;
      break;
    }
  }
  return 2 * called >= changes;
}

}  // namespace cls::simulator
