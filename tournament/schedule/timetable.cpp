// Fills servers with matches.
#include "tournament/schedule/timetable.h"

#include <algorithm>
#include <cmath>

#include "base/system/host.h"
#include "tournament/config/start_times.h"
#include "tournament/schedule/concurrency.h"

namespace cls::tournament {
namespace {

constexpr int kSecondsPerMinute = 60;
constexpr int kRoundTo = 5;  // minutes

// Stops of the clock and the teams' start, of a match of the league in real time.
constexpr double kSlotPerPlay = 1.3;

// The stage of a group of it: "first round" of "first round, group C".
std::string whole_stage(const Fixture& fixture) {
  return fixture.stage.substr(0, fixture.stage.find(','));
}

// 0: unknown.
double seconds_of_a_match(const TournamentConfig& config, std::span<const ScheduledMatch> matches) {
  double seconds = 0.0;
  int played = 0;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || !match.outcome->played()) continue;
    seconds += match.outcome->run_seconds;
    ++played;
  }
  const match::MatchOptions options = match_options(config);
  if (mode_of(options) == match::MatchMode::kRealtime) {
    const double whole = options.server.normal_time_cycles();
    const double cycles = options.cycles ? std::min<double>(*options.cycles, whole) : whole;
    return cycles * options.server.simulator_step / 1000.0 * kSlotPerPlay;
  }
  return played == 0 ? 0.0 : seconds / played;
}

int slot_minutes(const TournamentConfig& config, std::span<const ScheduledMatch> matches) {
  if (config.slot_minutes) return static_cast<int>(std::ceil(*config.slot_minutes));
  const double minutes = seconds_of_a_match(config, matches) / kSecondsPerMinute;
  if (minutes <= 1.0) return minutes > 0.0 ? 1 : 0;
  return static_cast<int>(std::ceil(minutes / kRoundTo)) * kRoundTo;
}

// The latest of the times that hold for a fixture; 0: none.
std::time_t not_before(const std::vector<StartTime>& times, const Fixture& fixture) {
  std::time_t latest = 0;
  for (const StartTime& start : times) {
    if (fixture.stage.starts_with(start.stage)) latest = std::max(latest, start.time);
  }
  return latest;
}

}  // namespace

Timetable timetable(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                    std::time_t now) {
  Timetable result;
  result.slot_minutes = slot_minutes(config, matches);
  const auto times = parse_start_times(config.start_times);
  const bool begun = std::any_of(matches.begin(), matches.end(),
                                 [](const ScheduledMatch& match) { return match.outcome; });
  if (result.slot_minutes == 0 || !times || times->empty()) return result;

  result.servers = std::max(1, Concurrency(config, base::usable_cores()).current());
  std::vector<std::time_t> free(static_cast<std::size_t>(result.servers), begun ? now : 0);
  std::string stage;
  for (const ScheduledMatch& match : matches) {
    if (match.outcome) continue;
    const std::string own = whole_stage(match.fixture);
    if (own != stage) {
      stage = own;
      std::fill(free.begin(), free.end(), *std::max_element(free.begin(), free.end()));
    }
    const auto server = std::min_element(free.begin(), free.end());
    const std::time_t start = std::max(*server, not_before(*times, match.fixture));
    result.starts.push_back(
        {match.fixture.index, static_cast<int>(server - free.begin()) + 1, start});
    *server = start + result.slot_minutes * kSecondsPerMinute;
  }
  return result;
}

const PlannedStart* find_start(const Timetable& timetable, int match) {
  const auto found = std::find_if(timetable.starts.begin(), timetable.starts.end(),
                                  [match](const PlannedStart& one) { return one.match == match; });
  return found == timetable.starts.end() ? nullptr : &*found;
}

}  // namespace cls::tournament
