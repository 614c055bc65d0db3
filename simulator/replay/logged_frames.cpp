// Restores printed decimals and matches frames with a text log.
#include "simulator/replay/logged_frames.h"

#include <algorithm>
#include <cmath>

#include "simulator/referee/modes.h"

namespace cls::simulator {

using gamelog::Frame;
using gamelog::MatchRecord;

namespace {

double printed(double value, double decimals) {
  constexpr double kSingle = 0.1;  // exceeds the error of single precision
  const double whole = std::rint(value * decimals);
  return std::fabs(value * decimals - whole) < kSingle ? whole / decimals : value;
}

Vec2 printed(Vec2 v) { return {printed(v.x, 1e4), printed(v.y, 1e4)}; }

}  // namespace

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
  return std::any_of(frame.players.begin(), frame.players.end(),
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
      if (std::find(calls.begin(), calls.end(), mode) != calls.end()) {
        ++called;
        break;
      }
    }
  }
  return 2 * called >= changes;
}

}  // namespace cls::simulator
