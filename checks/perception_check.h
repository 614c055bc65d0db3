// Compares the world model of a player, replayed from its transcript, with the game log.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "gamelog/record/match_record.h"
#include "player/perception/perception_error.h"
#include "player/perception/transcript.h"

namespace cls::checks {

using WorldModelObserver = std::function<void(const player::WorldModel&)>;

struct PerceptionCheck {
  std::string team;
  soccer::Side side = soccer::Side::kLeft;
  int unum = 0;
  int decisions = 0;  ///< with a frame in the log, in any play mode
  player::PerceptionError errors;
  std::vector<player::TranscriptError> damage;
};

/// Replays the transcript (proxy/transcript.h) and calls `on_decision`, if there is one, with the
/// world model of each compared decision. The k-th sense_body of a time belongs to the k-th
/// frame of that time. Errors: no player in the transcript, team or
/// side not in the log, no common cycle.
base::Result<PerceptionCheck> check_perception(std::string_view transcript,
                                               const gamelog::MatchRecord& log,
                                               const WorldModelObserver& on_decision = {});

/// A text table, and the document of `cls check perception --json`.
std::string to_text(const PerceptionCheck& check);
std::string to_json(const PerceptionCheck& check);

}  // namespace cls::checks
