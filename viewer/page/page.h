// One HTML file with a match and the program that shows it (docs/formats/view.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/results/match_summary.h"
#include "base/result.h"
#include "gamelog/record/match_record.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::viewer {

/// What a page shows first.
struct PageSettings {
  std::optional<int> at;             ///< cycle; none: the first frame
  std::vector<std::string> players;  ///< selected: "l7", "r1"
};

/// The page. `stream` is the match (write_stream()), `summary` the result of the same match for
/// readers without scripts.
std::string write_page(const analysis::MatchSummary& summary, std::string_view stream,
                       const PageSettings& settings);

/// True if a file that starts like this may be a page.
bool looks_like_page(std::string_view start);

/// The match of a page. Errors: no page of cls, cut or corrupt.
base::Result<StreamMatch> read_page(std::string_view page);

/// A game log of any version, or the match of a page; "-" is standard input. Errors name the file.
/// Parse errors of a log are in the record.
base::Result<StreamMatch> read_log_or_page(const std::string& path);

}  // namespace cls::viewer
