// The recorded decisions of a match folder, for its page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// Which decisions of a match: empty lists mean all.
struct DecisionChoice {
  std::vector<std::string> players;  ///< "l7"
  std::vector<CycleRange> cycles;
};

/// What `cls match --record-world-models` wrote into `folder`, as far as it is chosen. A side
/// without a recording, or without a named player, is left out. The error names a file that is
/// corrupt or incomplete.
base::Result<std::vector<PageDecisions>> read_page_decisions(const std::filesystem::path& folder,
                                                             const DecisionChoice& choice);

/// A file of recorded decisions as it lies in a match folder. The error names the file.
base::Result<TeamDecisions> read_recorded_decisions(const std::filesystem::path& file);

/// The missed decisions of a match folder (missed.jsonl). Lines that do not parse are left out.
std::vector<MissedDecision> read_missed_decisions(const std::filesystem::path& folder);

}  // namespace cls::viewer
