// Writes beside the place of the file and renames.
#include "cli/logs/output_file.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/io/gzip_sink.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

OutputFailure cannot_create(const fs::path& out, const std::string& why) {
  return {kCannotCreate, fmt::format("cannot create '{}': {}", out.string(), why)};
}

// Beside the file, with its ending, which decides about compression.
fs::path partial_file(const fs::path& out) {
  std::error_code code;
  const fs::file_type type = fs::symlink_status(out, code).type();
  const bool renamed = type == fs::file_type::regular || type == fs::file_type::not_found;
  if (out == "-" || !renamed) return out;
  return out.parent_path() / ("partial-" + out.filename().string());
}

}  // namespace

std::optional<OutputFailure> write_output(const fs::path& out,
                                          const std::function<bool(base::ByteSink&)>& write) {
  const fs::path partial = partial_file(out);
  const std::atomic<int>& signal = watch_interrupts();
  auto sink = base::create_sink(partial.string());
  if (!sink) return cannot_create(out, std::strerror(errno));
  const bool whole = write(**sink);
  const auto closed = (*sink)->close();
  if (partial == out) {
    if (!closed) return OutputFailure{kWriteFailed, closed.error().message};
    return whole ? std::nullopt : std::optional(OutputFailure{kBadData, ""});
  }

  std::error_code code;
  if (closed && whole && signal == 0) {
    fs::rename(partial, out, code);
    if (!code) return std::nullopt;
  }
  std::error_code ignored;
  fs::remove(partial, ignored);
  if (!closed) return OutputFailure{kWriteFailed, closed.error().message};
  if (code) return cannot_create(out, code.message());
  if (!whole) return OutputFailure{kBadData, ""};
  return OutputFailure{signal_exit_code(signal), ""};
}

std::optional<OutputFailure> why_not_replaced(const fs::path& out, bool force) {
  std::error_code code;
  if (force || !fs::is_regular_file(out, code)) return std::nullopt;
  return OutputFailure{kCannotCreate,
                       fmt::format("{}: exists; use --force to replace it", out.string())};
}

}  // namespace cls::cli
