// A scheduled match as JSON: the same object in reports, events, hooks and the files of `work`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// Members of cls.tournament/1 "matches": index, round, stage, pairing, left, right (names), seed,
/// decides, state and, with an outcome, everything in it; `score` is [left, right].
nlohmann::ordered_json json_of(const TournamentConfig& config, const ScheduledMatch& match);

/// A line of schedule.jsonl, and back. Teams are numbers there.
std::string schedule_line(const Fixture& fixture);
base::Result<Fixture> fixture_from_line(const std::string& line);

/// The file that `work` leaves, and back. The error says what is wrong with the text.
std::string outcome_document(const Fixture& fixture, const Outcome& outcome);
struct DeliveredOutcome {
  int index = 0;
  std::uint64_t seed = 0;
  Outcome outcome;
};
base::Result<DeliveredOutcome> outcome_from_document(const std::string& text);

/// The outcome told by the result.json of a match folder. An error when there is none, or one that
/// is not whole.
base::Result<Outcome> outcome_from_result(const std::string& text);

}  // namespace cls::orchestration::tournament
