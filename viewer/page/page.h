// One HTML file with a match and the program that shows it (docs/formats/view.md).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/results/match_summary.h"
#include "base/io/input_buffer.h"
#include "base/result.h"
#include "base/text/json.h"
#include "gamelog/record/match_record.h"
#include "soccer/side.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::viewer {

/// A decision without a usable reply.
struct MissedDecision {
  int cycle = 0;
  int stopped = 0;     ///< cycles since the clock stopped
  std::string player;  ///< "l7"
  std::string reason;  ///< "deadline"
};

/// The debug log of a side (docs/actions.md), compressed with gzip.
struct PageDrawings {
  soccer::Side side = soccer::Side::kLeft;
  std::string packed;
};

/// The first view of a page, and its data that are not in the log.
struct PageSettings {
  std::optional<int> at{};               ///< cycle; none: the first frame
  std::vector<std::string> players{};    ///< selected: "l7", "r1"
  std::vector<MissedDecision> missed{};  ///< in the order of the match
  std::vector<PageDrawings> drawings{};  ///< texts and drawings of Playmakers
  bool compared = false;                 ///< a second match follows (compare_page.h)
  /// Left and right, as `cls match` names them: "mock"; empty: not known.
  std::array<std::string, 2> sides{};
  base::Json review{};  ///< decisions that were played again (page_review()); null: none
  std::string home{};   ///< address of the page that this one belongs to; empty: none
};

/// Recorded decisions of a side (viewer/decisions): the stream, compressed with gzip.
struct PageDecisions {
  soccer::Side side = soccer::Side::kLeft;
  std::string packed;
};

/// The page. `stream` is the match (write_stream()), `summary` the result of the same match for
/// readers without scripts. With decisions the page has the decision debugger.
std::string write_page(const analysis::MatchSummary& summary, std::string_view stream,
                       const PageSettings& settings,
                       const std::vector<PageDecisions>& decisions = {});

/// Where a live page reads what it shows, relative to its own address.
struct LivePaths {
  std::string stream;
  std::string drawings;  ///< without "-left" or "-right"; empty: nowhere
};

/// The page of a match that is played now. It allows requests to its own host only.
std::string live_page(const std::string& title, const LivePaths& paths,
                      const PageSettings& settings);

/// Elements with the debug logs of a match; their ids begin with `prefix`.
std::string data_elements(std::string_view prefix, const std::vector<PageDrawings>& drawings);

/// JSON text as the content of a script element that browsers do not run: nothing in it ends the
/// element.
std::string inert_json(std::string json);

/// True if a file that starts like this may be a page.
bool looks_like_page(std::string_view start);
/// True if a file that starts like this, with at least kMatchStart bytes, may be a page, or the
/// stream of a match (docs/formats/view.md) as a file.
bool looks_like_page_or_stream(std::string_view start);
inline constexpr std::size_t kMatchStart = 64;

/// The match of a page. Errors: no page of cls, cut or corrupt.
base::Result<StreamMatch> read_page(std::string_view page);
/// The match of a page or stream with the bytes that `input` has. `from_page` is set.
base::Result<StreamMatch> read_page_or_stream(base::InputBuffer& input);

/// A game log of any version, or the match of a page or stream, also compressed; "-" is standard
/// input. Errors name the file. Parse errors of a log are in the record.
base::Result<StreamMatch> read_log_or_page(const std::string& path);

}  // namespace cls::viewer
