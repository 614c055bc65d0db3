// Reads a log and detects its kind by its first bytes.
#pragma once

#include <string>
#include <variant>

#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// A game log, or a text log if the bytes start with a time and a tab.
using AnyLog = std::variant<MatchRecord, RclRecord>;

/// Reads a plain or gzip file, "-" for standard input. Fails if the file does not exist or cannot
/// be opened; parse errors are in the record.
base::Result<AnyLog> read_log_file(const std::string& path);

}  // namespace cls::gamelog
