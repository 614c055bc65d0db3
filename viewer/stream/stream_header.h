// The header of a stream: names, parameters and columns as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "gamelog/record/match_record.h"
#include "viewer/stream/column_table.h"

namespace cls::viewer {

struct StreamForm {
  bool compact = false;  ///< rounded, without velocities: cannot give the log back
  bool live = false;     ///< more frames follow
};

/// A column of a stream. `spec` is null for a column that this program does not know.
struct StreamColumn {
  const ColumnSpec* spec = nullptr;
  Coding coding = Coding::kChanges;
  std::size_t series = 1;
  std::int64_t scale = 0;       ///< 0: integers
  std::size_t of = 0;           ///< kVelocity: position in the list of columns
  bool keeps_integers = false;  ///< later columns need the integers of this one
};

/// Decays of velocities in 1/10000.
struct Decays {
  std::int64_t ball = 9400;
  std::vector<std::int64_t> by_type;

  std::int64_t of_type(std::int64_t type) const;
};

struct StreamHeader {
  gamelog::RcgVersion version = gamelog::RcgVersion::kV6;
  StreamForm form;
  Decays decays;
  std::vector<StreamColumn> columns;
  std::size_t type = 0;  ///< position of the column of player types, if there is one
};

/// The header of a match as it is now.
StreamHeader header_of(const gamelog::MatchRecord& record, StreamForm form);

/// Contents of the chunk H; names and score are those of the last frame.
std::string header_json(const gamelog::MatchRecord& record, const StreamHeader& header);

/// The reverse. Errors: another schema, or columns that contradict each other.
base::Result<StreamHeader> parse_header(std::string_view json);

}  // namespace cls::viewer
