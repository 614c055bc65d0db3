// From the logs of a match to its page.
#pragma once

#include <string>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "viewer/page/page.h"

namespace cls::viewer {

struct MatchPageOptions {
  PageSettings settings{};
  std::vector<PageDecisions> decisions{};
  bool compact = false;  ///< half as large; rounds
};

/// The page of a match with its statistics. `text` is the text log of the same match, or null;
/// `file` the name of the log that the page shows.
std::string match_page(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                       const std::string& file, const MatchPageOptions& options = {});

/// The page of a match whose logs are texts in memory; empty if the game log has no frame.
std::string page_of_logs(const std::string& game_log, const std::string& text_log,
                         const std::string& file);

/// One match of cls.stats/1 with events, as the chunk S has it.
std::string match_statistics(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                             const std::string& file);

}  // namespace cls::viewer
