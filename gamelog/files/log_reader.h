// Reading a log whose kind only its bytes tell.
#pragma once

#include <string>
#include <variant>

#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// A game log, or a text log if the bytes start with a time and a tab.
using AnyLog = std::variant<MatchRecord, RclRecord>;

/// Plain or gzip, "-" for standard input. An error means that there is no such file or that it
/// cannot be opened; what makes no sense is in the record's damage.
base::Result<AnyLog> read_log_file(const std::string& path);

}  // namespace cls::gamelog
