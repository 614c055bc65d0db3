// `cls convert` into tables: one of a match, or all files of many matches.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/tables/tracking_table.h"
#include "gamelog/record/parse_errors.h"

namespace cls::cli {

enum class MatchTable : unsigned char { kTracking, kPlayerTypes, kEvents };

/// "tracking", "player_types" and "event", as in the names of files.
std::string_view name(MatchTable table);
std::optional<MatchTable> parse_match_table(std::string_view name);

/// The table that a file holds by its name: OUT.tracking.csv, OUT.event.csv.gz.
std::optional<MatchTable> table_of_file(std::string_view path);

/// Files that are written together.
enum class MatchFiles : unsigned char {
  kTables,  ///< NAME.tracking.csv, NAME.player_types.csv, NAME.event.csv
  kArrow,   ///< NAME.frames.arrow, .events.arrow, .player_types.csv; with a text log
            ///< .commands.arrow, with world models .world_models.arrow
  kCdf,     ///< Common Data Format: NAME.match.json, .meta.json, .event.jsonl, .tracking.jsonl
};

struct TableRequest {
  std::string in;   ///< a log, a page, a folder or a data set for write_match_files()
  std::string out;  ///< a file, or the folder for write_match_files()
  analysis::TrackingColumns columns = analysis::TrackingColumns::kAll;
  bool force = false;
  std::size_t jobs = 1;
};

/// The tables of a match that was read.
struct TableCounts {
  std::size_t matches = 0;
  std::size_t frames = 0;
  std::size_t errors = 0;
};

/// Writes one table of one match, and prints errors. The rows of a tracking table are written while
/// the log is read. Returns the exit code.
int write_match_table(MatchTable table, const TableRequest& request, TableCounts& counts);

/// Writes the files of all matches of `request.in` in parallel, and prints errors. Files have the
/// names of the logs, in the folders of the logs. Returns the exit code.
int write_match_files(MatchFiles files, const TableRequest& request, TableCounts& counts);

}  // namespace cls::cli
