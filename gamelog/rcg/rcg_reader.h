// Reading a game log (rcg) of any version.
#pragma once

#include <string>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "base/result.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Reads to the end or to where the bytes make no sense any more. Never fails: what could not be
/// read is in MatchRecord::damage, with everything before it in the record. A log without the end
/// of its match (neither a result nor time_over: killed or still being written) is damaged too.
MatchRecord read_rcg(base::ByteSource& source);
MatchRecord read_rcg(base::InputBuffer& input);

/// The same for a file, plain or gzip, "-" for standard input. An error means that there is no
/// such file or that it cannot be opened.
base::Result<MatchRecord> read_rcg_file(const std::string& path);

}  // namespace cls::gamelog
