// Writes tar archives (POSIX ustar).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/io/byte_sink.h"
#include "base/result.h"

namespace cls::base {

/// Appends a file. `name` has at most 100 bytes, slashes between folders; a longer one is an error,
/// and so are more than 8 GB. `time`: of its last change, in seconds since 1970.
Result<void> append_to_tar(const std::string& name, std::string_view bytes, std::int64_t time,
                           ByteSink& sink);

/// Called once, after the last file.
void end_tar(ByteSink& sink);

}  // namespace cls::base
