// Reading a text log (rcl).
#pragma once

#include <string>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"

namespace cls::gamelog {

/// Reads to the end (log-formats 2). Lines that do not start with a time belong to the datagram
/// before them. Never fails: what makes no sense is in RclRecord::damage.
RclRecord read_rcl(base::ByteSource& source);
RclRecord read_rcl(base::InputBuffer& input);

/// The same for a file, plain or gzip, "-" for standard input. An error means that there is no
/// such file or that it cannot be opened.
base::Result<RclRecord> read_rcl_file(const std::string& path);

}  // namespace cls::gamelog
