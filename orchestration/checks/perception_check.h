// Holding what a player believed, by its transcript, against what was, by the game log.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/record/match_record.h"
#include "proxy/perception/perception_error.h"
#include "proxy/perception/transcript.h"

namespace cls::orchestration::checks {

struct PerceptionCheck {
  std::string team;
  soccer::Side side = soccer::Side::kLeft;
  int unum = 0;
  int decisions = 0;  ///< that the log has a frame for, of any play mode
  proxy::PerceptionError errors;
  std::vector<proxy::TranscriptDamage> damage;
};

/// Replays the transcript (proxy/transcript.h). The k-th sense_body of a time belongs to the k-th
/// frame of that time. The error says why the two tell nothing: no player in the transcript, a team
/// or a side that the log does not know, no common cycle.
base::Result<PerceptionCheck> check_perception(std::string_view transcript,
                                               const gamelog::MatchRecord& log);

/// A table for people, and the document of `cls check perception --json`.
std::string to_text(const PerceptionCheck& check);
std::string to_json(const PerceptionCheck& check);

}  // namespace cls::orchestration::checks
