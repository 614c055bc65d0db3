// Writes next to the place of the file and renames.
#include "cli/logs/output_file.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/io/gzip_sink.h"
#include "base/io/replacement.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

OutputFailure cannot_create(const fs::path& out, const std::string& why) {
  return {kCannotCreate, fmt::format("cannot create '{}': {}", out.string(), why)};
}

}  // namespace

std::optional<OutputFailure> write_output(const fs::path& out,
                                          const std::function<bool(base::ByteSink&)>& write) {
  const std::atomic<int>& signal = watch_interrupts();
  std::optional<base::Replacement> replacement;
  if (out != "-") {
    auto started = base::Replacement::start(out);
    if (!started) return OutputFailure{kCannotCreate, started.error().message};
    replacement.emplace(*std::move(started));
  }

  auto sink = base::create_sink(replacement ? replacement->place().string() : "-");
  if (!sink) return cannot_create(out, std::strerror(errno));

  const bool whole = write(**sink);
  const auto closed = (*sink)->close();
  if (!closed) return OutputFailure{kWriteFailed, closed.error().message};
  if (!whole) return OutputFailure{kBadData, ""};
  if (!replacement || replacement->place() == out) return std::nullopt;
  if (signal != 0) return OutputFailure{signal_exit_code(signal), ""};
  const auto finished = replacement->finish();
  return finished ? std::nullopt
                  : std::optional(OutputFailure{kCannotCreate, finished.error().message});
}

int report_failure(const std::optional<OutputFailure>& failure) {
  if (!failure) return kOk;
  return failure->message.empty() ? failure->exit_code
                                  : print_error(failure->exit_code, failure->message);
}

std::optional<OutputFailure> why_not_replaced(const fs::path& out, bool force) {
  std::error_code code;
  if (force || !fs::is_regular_file(out, code)) return std::nullopt;
  return OutputFailure{kCannotCreate,
                       fmt::format("{}: exists; use --force to replace it", out.string())};
}

std::string_view format_of_ending(const fs::path& out) {
  constexpr std::pair<std::string_view, std::string_view> kFormatsByEnding[] = {
      {".html", "html"}, {".htm", "html"},  {".md", "md"},   {".txt", "text"},
      {".csv", "csv"},   {".json", "json"}, {".svg", "svg"}, {".xml", "junit"}};
  const std::string ending = out.extension().string();
  for (const auto& [known, format] : kFormatsByEnding) {
    if (ending == known) return format;
  }
  return {};
}

std::string wrong_ending(const fs::path& out, std::string_view format) {
  const std::string_view named = format_of_ending(out);
  if (named.empty() || named == format) return {};
  return fmt::format("--out '{}': its ending says {}, the format is {}; name another file",
                     out.string(), named, format);
}

}  // namespace cls::cli
