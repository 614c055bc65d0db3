// Divides the frames by game time and play mode.
#include "analysis/results/periods.h"

#include <algorithm>

#include "analysis/results/match_summary.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

struct Half {
  PeriodKind kind;
  double start;  // cycles
};

constexpr int kMaxHalves = 100;

// The halves with their starts; one that begins at 0 if halves have no length.
std::vector<Half> halves_of(const soccer::ServerParams& server) {
  std::vector<Half> halves;
  double start = 0.0;
  const auto add = [&](int count, double length, PeriodKind first, PeriodKind others) {
    for (int i = 0; i < std::clamp(count, 0, kMaxHalves) && length > 0.0; ++i) {
      halves.push_back({i == 0 ? first : others, start});
      start += length;
    }
  };

  const double half = half_time_cycles(server);
  const double extra =
      server.half_time == 0 ? 0.0 : half * server.extra_half_time / server.half_time;
  add(server.nr_normal_halfs, half, PeriodKind::kFirstHalf, PeriodKind::kSecondHalf);
  if (!halves.empty()) {
    add(server.nr_extra_halfs, extra, PeriodKind::kFirstExtraHalf, PeriodKind::kSecondExtraHalf);
  }
  if (halves.empty()) halves.push_back({PeriodKind::kFirstHalf, 0.0});
  return halves;
}

// The last half that began before the frame.
const Half& half_at(const std::vector<Half>& halves, int time) {
  const auto later = std::find_if(halves.begin() + 1, halves.end(),
                                  [time](const Half& half) { return half.start >= time; });
  return *std::prev(later);
}

}  // namespace

std::vector<Period> find_periods(const gamelog::MatchRecord& record) {
  const std::vector<Half> halves = halves_of(record.server);
  std::vector<Period> periods;
  bool shoot_out = false;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    shoot_out = shoot_out || soccer::is_penalty_mode(record.mode[i]);
    const Half& half = half_at(halves, record.time[i]);
    const PeriodKind kind = shoot_out ? PeriodKind::kShootOut : half.kind;
    if (periods.empty() || periods.back().kind != kind) {
      const int start = shoot_out ? record.time[i] : static_cast<int>(half.start);
      periods.push_back({kind, i, i, start});
    }
    periods.back().end_frame = i + 1;
  }
  return periods;
}

const Period& period_of(const std::vector<Period>& periods, std::size_t frame) {
  return *std::find_if(periods.begin(), periods.end() - 1,
                       [frame](const Period& period) { return frame < period.end_frame; });
}

double cycle_seconds(const soccer::ServerParams& server) {
  constexpr double kUsual = 0.1;
  return server.simulator_step > 0 ? server.simulator_step / 1000.0 : kUsual;
}

}  // namespace cls::analysis
