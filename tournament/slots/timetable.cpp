// Fills servers with matches.
#include "tournament/slots/timetable.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/system/host.h"
#include "league/matches/stage_name.h"
#include "match/terms/match_options.h"
#include "tournament/config/start_times.h"
#include "tournament/slots/concurrency.h"

namespace cls::tournament {
namespace {

constexpr int kSecondsPerMinute = 60;
constexpr int kRoundTo = 5;  // minutes

// Stops of the clock and the teams' start, of a match of the league in real time.
constexpr double kSlotPerPlay = 1.3;

// 0: unknown.
double seconds_of_a_match(const TournamentConfig& config, std::span<const ScheduledMatch> matches) {
  const match::MatchOptions options = match_options(config.conditions);
  if (mode_of(options) == match::MatchMode::kRealtime) {
    const double whole = options.server.normal_time_cycles();
    const double cycles = options.cycles ? std::min<double>(*options.cycles, whole) : whole;
    return cycles * options.server.simulator_step / 1000.0 * kSlotPerPlay;
  }
  const PlayTime spent = play_time(matches);
  return spent.matches == 0 ? 0.0 : spent.seconds / spent.matches;
}

int slot_minutes(const TournamentConfig& config, std::span<const ScheduledMatch> matches) {
  if (config.report.slot_minutes) return static_cast<int>(std::ceil(*config.report.slot_minutes));
  const double minutes = seconds_of_a_match(config, matches) / kSecondsPerMinute;
  if (minutes <= 1.0) return minutes > 0.0 ? 1 : 0;
  return static_cast<int>(std::ceil(minutes / kRoundTo)) * kRoundTo;
}

// A start time without a stage holds for all matches. One with a name is that of the stage of this
// name, or of those whose name begins so: "semi-final".
bool holds_for(const StartTime& start, const Competition& competition, const Fixture& fixture) {
  const bool is_stage =
      std::ranges::find(competition.stages, start.stage, &Stage::name) != competition.stages.end();
  return is_stage ? belongs_to(fixture.stage, start.stage) : fixture.stage.starts_with(start.stage);
}

// The latest of the times that hold for a fixture; 0: none.
std::time_t not_before(const std::vector<StartTime>& times, const Competition& competition,
                       const Fixture& fixture) {
  std::time_t latest = 0;
  for (const StartTime& start : times) {
    if (holds_for(start, competition, fixture)) latest = std::max(latest, start.time);
  }
  return latest;
}

}  // namespace

PlayTime play_time(std::span<const ScheduledMatch> matches) {
  PlayTime spent;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || !match.outcome->played()) continue;
    spent.seconds += match.outcome->run_seconds;
    ++spent.matches;
  }
  return spent;
}

Timetable timetable(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                    std::time_t now) {
  Timetable result;
  result.slot_minutes = slot_minutes(config, matches);
  const auto times = parse_start_times(config.report.start_times);
  if (result.slot_minutes == 0 || !times || times->empty()) return result;

  const bool begun =
      std::ranges::any_of(matches, [](const auto& match) { return match.outcome.has_value(); });
  result.servers = std::max(1, Concurrency(config, base::usable_cores()).current());
  std::vector<std::time_t> free(base::index(result.servers), begun ? now : 0);

  std::string stage;
  for (const ScheduledMatch& match : matches) {
    if (match.outcome) continue;
    std::string own = parse_stage_name(match.fixture.stage).stage;
    if (own != stage) {
      stage = std::move(own);
      std::ranges::fill(free, std::ranges::max(free));
    }

    const auto server = std::ranges::min_element(free);
    const std::time_t start =
        std::max(*server, not_before(*times, config.competition, match.fixture));
    result.starts.push_back(
        {match.fixture.index, static_cast<int>(server - free.begin()) + 1, start});
    *server = start + result.slot_minutes * kSecondsPerMinute;
  }
  return result;
}

const PlannedStart* find_start(const Timetable& timetable, int match) {
  const auto found = std::ranges::find(timetable.starts, match, &PlannedStart::match);
  return found == timetable.starts.end() ? nullptr : &*found;
}

}  // namespace cls::tournament
