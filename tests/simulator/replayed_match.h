// Replaying a recorded match step by step and counting how often we agree with the real server.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "simulator/replay.h"
#include "simulator/world.h"
#include "tests/support/recorded_match.h"

namespace cls::tests {

struct Agreement {
  int compared = 0;
  int different = 0;
  std::vector<std::string> first_differences;

  void add(bool same, const std::string& what);
  double rate() const { return compared == 0 ? 0.0 : 1.0 - double(different) / compared; }
};

struct ReplayResult {
  /// By what is compared: ball and player (position and velocity), roughly (the same with the
  /// tolerance that contacts need, which magnify the record's rounding), body, neck, stamina,
  /// effort, capacity, state, counters, mode, clock, score.
  std::map<std::string, Agreement> agreements;
  /// Every referee word with its stamp, as "TIME,STOPPAGE WORD": ours and theirs.
  std::vector<std::string> our_words;
  std::vector<std::string> their_words;
};

/// Each step starts from the recorded frame with the recorded commands and is compared with the
/// next frame; clock, mode, score and the referee's memory are ours throughout. Outcomes of tackle,
/// catch and foul draws are taken from the record, and so is the noise of movements unless the
/// match has none: then positions and velocities compare too.
enum class Noise { kNone, kFromRecord };
ReplayResult replay(const RecordedMatch& match, Noise noise);

}  // namespace cls::tests
