// Scheduled matches as JSON: in reports, events, hooks, schedules, result files and the store.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text/json.h"
#include "base/text/json_codec.h"
#include "league/matches/fixture.h"
#include "match/result/match_result.h"
#include "tournament/config/config.h"

namespace cls::league {

// For documents that have those of a fixture among theirs, see base/text/json_codec.h.
void members(base::JsonEncoder& codec, const Fixture& fixture);
void members(base::JsonDecoder& codec, Fixture& fixture);

}  // namespace cls::league

namespace cls::tournament {

/// An element of "matches" in cls.tournament/1: the fixture with team names, and the members of
/// its outcome; without an outcome "end_reason" and "score" are null.
base::Json json_of(const TournamentConfig& config, const ScheduledMatch& match);

/// A line of schedule.jsonl. Teams are indices there.
std::string format_fixture(const Fixture& fixture);
base::Result<Fixture> parse_fixture(std::string_view line);

/// An outcome as a JSON object on one line, as the store holds it.
std::string format_outcome(const Outcome& outcome);
base::Result<Outcome> parse_outcome(std::string_view text);

/// The content of a result file of `cls tournament work`, cls.work/1.
struct WorkResult {
  int index = 0;
  std::uint64_t seed = 0;
  Outcome outcome;
};
std::string format_work_result(const Fixture& fixture, const Outcome& outcome);
base::Result<WorkResult> parse_work_result(std::string_view text);

/// The outcome of a match with this result. The caller adds how the match was run.
Outcome outcome_of(const match::MatchResult& result);

}  // namespace cls::tournament
