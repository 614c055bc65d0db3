// Reads a text log (rcl).
#pragma once

#include <string>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"

namespace cls::gamelog {

/// Reads to the end (docs/spec/log-formats.md 2). A line that does not start with a time continues
/// the previous datagram. Never fails: parse errors are in RclRecord::errors.
RclRecord read_rcl(base::ByteSource& source);
RclRecord read_rcl(base::InputBuffer& input);

/// Reads a plain or gzip text log, "-" for standard input. Fails if the file does not exist or
/// cannot be opened.
base::Result<RclRecord> read_rcl_file(const std::string& path);

}  // namespace cls::gamelog
