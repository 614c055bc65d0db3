// The recorded decisions of a match folder, for its page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// What `cls match --record-world-models` wrote into `folder`, of the named players ("l7") or, with
/// no names, of all. A side without a recording, or without a named player, is left out. The error
/// names a file that is corrupt or incomplete.
base::Result<std::vector<PageDecisions>> read_page_decisions(
    const std::filesystem::path& folder, const std::vector<std::string>& players);

/// The missed decisions of a match folder (missed.jsonl). Lines that do not parse are left out.
std::vector<MissedDecision> read_missed_decisions(const std::filesystem::path& folder);

}  // namespace cls::viewer
