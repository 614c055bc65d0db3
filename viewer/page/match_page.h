// From the logs of a match to its page.
#pragma once

#include <string>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// The page of a match with its statistics. `text` is the text log of the same match, or null;
/// `file` the name of the log that the page shows. A compact page is half as large and rounds.
std::string match_page(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                       const std::string& file, bool compact, const PageSettings& settings);

}  // namespace cls::viewer
