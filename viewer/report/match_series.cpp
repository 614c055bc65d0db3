// Counts per frame, summed over windows.
#include "viewer/report/match_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "analysis/play/pitch_areas.h"
#include "analysis/results/match_summary.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kSamples = 121;
constexpr std::size_t kWindowShare = 10;

/// Counts of both teams up to each frame, from 0: entry f has the frames before f.
using Sums = analysis::PerTeam<std::vector<int>>;

std::vector<double> left_shares(const Sums& sums) {
  const std::size_t frames = sums[0].size() - 1;
  const std::size_t half = std::max<std::size_t>(1, frames / kWindowShare / 2);
  std::vector<double> shares;
  for (std::size_t i = 0; i < kSamples && frames > 0; ++i) {
    const std::size_t middle = (frames - 1) * i / (kSamples - 1);
    const std::size_t from = middle - std::min(middle, half);
    const std::size_t to = std::min(frames, middle + half + 1);

    const int left = sums[0][to] - sums[0][from];
    const int right = sums[1][to] - sums[1][from];
    shares.push_back(left + right == 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : static_cast<double>(left) / (left + right));
  }
  return shares;
}

// The shares of counts of single frames, which `count_into` increases at frame + 1.
std::vector<double> shares_of(const analysis::MatchStatistics& all, auto count_into) {
  Sums sums;
  for (std::vector<int>& counts : sums) counts.assign(all.flow.record->frames() + 1, 0);
  count_into(sums);
  for (std::vector<int>& counts : sums) {
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
  }
  return left_shares(sums);
}

// 1, 2 or 5 times a power of ten: at most eight parts.
std::int64_t tick_step(std::int64_t range) {
  std::int64_t step = 10;
  for (int i = 0; range / step > 8; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

}  // namespace

TimeAxis time_axis(const gamelog::MatchRecord& record) {
  TimeAxis axis;
  if (record.frames() == 0) return axis;

  axis.last = static_cast<double>(record.frames() - 1);
  const std::int64_t last = std::ranges::max(record.time);
  const std::int64_t step = tick_step(std::max<std::int64_t>(1, last));

  const double half = analysis::half_time_cycles(record.server);
  std::int64_t next = 0;
  double next_half = half;
  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    const std::int64_t time = record.time[frame];
    if (time >= next) {
      const std::int64_t tick = time / step * step;
      axis.ticks.push_back({static_cast<double>(frame), fmt::to_string(tick)});
      next = tick + step;
    }

    // Extra halves and a shoot-out have other lengths: only normal time is divided.
    if (half >= 1.0 && axis.halves.size() < 2 && static_cast<double>(time) > next_half) {
      axis.halves.push_back(static_cast<double>(frame));
      next_half += half;
    }
  }
  return axis;
}

std::vector<double> possession_over_time(const analysis::MatchStatistics& all) {
  return shares_of(all, [&](Sums& sums) {
    for (std::size_t frame = 0; frame < all.flow.record->frames(); ++frame) {
      const std::int8_t owner = all.flow.owner[frame];
      if (!all.flow.is_live(frame) || owner == analysis::kNoPlayer) continue;
      ++sums[analysis::team_of(owner)][frame + 1];
    }
  });
}

std::vector<double> field_tilt_over_time(const analysis::MatchStatistics& all) {
  return shares_of(all, [&](Sums& sums) {
    for (const analysis::Touch& touch : all.flow.touches) {
      if (touch.live_phase < 0) continue;
      for (const std::int8_t player : touch.nearest) {
        if (player == analysis::kNoPlayer) continue;
        const double x = touch.contact.x * analysis::attack_sign(player);
        if (x > analysis::kThirdBorder) ++sums[analysis::team_of(player)][touch.frame + 1];
      }
    }
  });
}

bool plays_in_goal(const gamelog::MatchRecord& record, std::size_t slot) {
  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    const std::size_t entry = analysis::entry_of(frame, slot);
    if (gamelog::is_enabled(record, entry)) return analysis::is_goalie(record, entry);
  }
  return false;
}

}  // namespace cls::viewer
