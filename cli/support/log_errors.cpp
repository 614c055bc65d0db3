// Parse errors of logs, one line each.
#include "cli/support/log_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/io/standard_streams.h"
#include "cli/support/print_error.h"
#include "tournament/dataset/dataset.h"

namespace cls::cli {
namespace {

constexpr std::size_t kShownErrors = 5;

}  // namespace

void report_errors(std::string_view path, const gamelog::ParseErrors& errors) {
  const std::size_t shown = std::min(errors.first.size(), kShownErrors);
  for (std::size_t i = 0; i < shown; ++i) {
    print_error(0, gamelog::format_error(path, errors.first[i]));
  }

  if (errors.count > shown) {
    print_error(0, "{}: {} more errors", path, errors.count - shown);
  }
}

int report_missing(const gamelog::FoundLogs& found) {
  for (const std::string& missing : found.missing) {
    if (tournament::is_dataset(missing)) {
      print_error(0, "{0}: a data set, which has no logs; cls convert {0} --tables DIR reads it",
                  missing);
    } else {
      print_error(0, "{}: no such log", missing);
    }
  }
  return found.missing.empty() ? kOk : kNoInput;
}

int report_log(int exit_code, const std::string& unreadable, std::string_view path,
               const gamelog::ParseErrors& errors) {
  if (!unreadable.empty()) {
    print_error(0, unreadable);
    exit_code = kNoInput;
  }

  report_errors(path, errors);
  return !errors.empty() && exit_code == kOk ? kBadData : exit_code;
}

int unreadable_code(const std::string& path) {
  std::error_code code;
  if (path == "-") return base::input_was_closed() ? kNoInput : kBadData;
  const bool opens = std::filesystem::is_regular_file(path, code) && std::ifstream(path).good();
  return opens ? kBadData : kNoInput;
}

}  // namespace cls::cli
