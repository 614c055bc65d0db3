// A file that appears when it is complete.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/io/byte_sink.h"

namespace cls::cli {

/// Why a file was not written.
struct OutputFailure {
  int exit_code = 0;
  std::string message;  ///< empty: a signal, or `write` gave up
};

/// Calls `write` with a sink for `out`, compressed if its name ends in ".gz". Leaves the complete
/// file, or what was there before: if `write` returns false, after a failure, and after a signal
/// that watch_interrupts() has seen. "-" is standard output; it, devices and links are written
/// directly.
std::optional<OutputFailure> write_output(const std::filesystem::path& out,
                                          const std::function<bool(base::ByteSink&)>& write);

/// Prints the message of a failure, if there are both. Returns the exit code, kOk without a
/// failure.
int report_failure(const std::optional<OutputFailure>& failure);

/// The failure of an existing file that may not be replaced.
std::optional<OutputFailure> why_not_replaced(const std::filesystem::path& out, bool force);

/// The format that a file has by its ending: "html" (.html, .htm), "md" (.md), "text" (.txt),
/// "csv", "json", "svg", "junit" (.xml); empty: none of these.
std::string_view format_of_ending(const std::filesystem::path& out);

/// Why `format` does not fit the ending of `out`; empty: it does.
std::string wrong_ending(const std::filesystem::path& out, std::string_view format);

}  // namespace cls::cli
