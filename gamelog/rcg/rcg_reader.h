// Reads a game log (rcg) of any version.
#pragma once

#include <string>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "base/result.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Reads as far as the log can be parsed. Never fails: errors are in MatchRecord::errors, and the
/// record holds everything before them. A log without the end of its match (neither a result nor
/// time_over) has an error too.
MatchRecord read_rcg(base::ByteSource& source);
MatchRecord read_rcg(base::InputBuffer& input);

/// Reads a game log into an empty record, whose frames are complete whenever the source is read. So
/// a source that waits for a growing log can look at what was read.
void read_rcg(base::InputBuffer& input, MatchRecord& record);

/// True for the message that says the result, after which a log is complete.
bool is_result(const Note& note);

/// Reads a plain or gzip game log, "-" for standard input. Fails if the file does not exist or
/// cannot be opened.
base::Result<MatchRecord> read_rcg_file(const std::string& path);

}  // namespace cls::gamelog
