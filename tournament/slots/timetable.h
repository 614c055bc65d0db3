// When the matches of a tournament start.
#pragma once

#include <ctime>
#include <span>
#include <string>
#include <vector>

#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// How long the matches took that were played to the end.
struct PlayTime {
  double seconds = 0.0;
  int matches = 0;
};
PlayTime play_time(std::span<const ScheduledMatch> matches);

/// The expected start of a match that was not played.
struct PlannedStart {
  int match = 0;   ///< its number
  int server = 1;  ///< from 1; the same server plays one match after the other
  std::time_t time = 0;
};

struct Timetable {
  std::vector<PlannedStart> starts;  ///< by number of the match
  int servers = 1;
  int slot_minutes = 0;  ///< from one match to the next on a server
};

/// Assigns the matches without an outcome to servers in their order, each as early as its server,
/// `start_times` and, once the tournament has begun, `now` allow; a stage begins when the one
/// before is over. Empty without `start_times`, or while the length of a match is unknown. `config`
/// must be valid.
Timetable timetable(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                    std::time_t now);

/// The planned start of a match, or null.
const PlannedStart* find_start(const Timetable& timetable, int match);

}  // namespace cls::tournament
