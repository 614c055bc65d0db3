// Reads result.json and manifest.json next to logs.
#include "match/result/recorded_end.h"

#include <fmt/chrono.h>
#include <sys/stat.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"

namespace cls::match {
namespace {

constexpr std::uintmax_t kMaxDocumentBytes = 16 << 20;
constexpr std::size_t kDateDigits = 12;  // YYYYMMDDhhmm

bool all_digits(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

std::string local_minute(std::time_t time) {
  std::tm local{};
  localtime_r(&time, &local);
  return fmt::format("{:%Y%m%d%H%M}", local);
}

// The start in a manifest, "2026-11-21T01:02:03Z"; empty: none.
std::string start_in(const std::string& manifest) {
  const auto document = base::Json::parse_or_discarded(manifest);
  const bool has_start =
      document.is_object() && document.contains("started") && document["started"].is_string();
  return has_start ? document["started"].get<std::string>() : std::string();
}

std::optional<std::time_t> started(const std::string& manifest) {
  std::tm utc{};
  const std::string text = start_in(manifest);
  if (strptime(text.c_str(), "%Y-%m-%dT%H:%M:%SZ", &utc) == nullptr) return std::nullopt;
  return timegm(&utc);
}

bool is_log_of_match(const std::string& name) {
  return name.starts_with(kGameLogFile) || name.starts_with(kTextLogFile);
}

// True for a log of `cls match` that still grows: its manifest has no end, and there is no result.
bool is_running(const std::filesystem::path& log) {
  constexpr std::chrono::seconds kQuiet{60};  // servers write in blocks
  if (!is_log_of_match(log.filename().string())) return false;

  const auto text = base::read_file(log.parent_path() / kManifestFile);
  const auto manifest = base::Json::parse_or_discarded(text.value_or(""));
  if (!manifest.is_object() || !manifest.contains("ended") || !manifest["ended"].is_null()) {
    return false;
  }

  std::error_code error;
  const auto written = std::filesystem::last_write_time(log, error);
  return !error && std::filesystem::file_time_type::clock::now() - written < kQuiet;
}

}  // namespace

std::optional<analysis::RecordedEnd> recorded_end(const std::string& log) {
  const std::filesystem::path path(log);
  const std::filesystem::path document = path.parent_path() / kResultFile;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(document, error);
  if (error && is_running(path)) return analysis::RecordedEnd{analysis::kRunning, false};
  if (error || size > kMaxDocumentBytes) return std::nullopt;

  const auto result = parse_match_result(base::read_file(document).value_or(""));
  const std::string name = path.filename().string();
  if (!result || (result->rcg != name && result->rcl != name)) return std::nullopt;
  return analysis::RecordedEnd{std::string(soccer::name(result->end_reason)), result->valid()};
}

std::string recorded_date(const std::string& log) {
  const std::filesystem::path path(log);
  const std::string name = path.filename().string();
  if (is_log_of_match(name)) {
    const auto manifest = base::read_file(path.parent_path() / kManifestFile);
    if (const auto start = started(manifest.value_or(""))) return local_minute(*start);
  }
  if (name.size() > kDateDigits && all_digits(name.substr(0, kDateDigits))) {
    return name.substr(0, kDateDigits);
  }

  struct stat file = {};
  return ::stat(log.c_str(), &file) == 0 ? local_minute(file.st_mtime) : std::string();
}

std::string recorded_start(const std::filesystem::path& folder) {
  return start_in(base::read_file(folder / kManifestFile).value_or(""));
}

std::vector<analysis::MatchInput> with_recorded_ends(
    const std::vector<gamelog::MatchLogs>& matches) {
  std::vector<analysis::MatchInput> inputs;
  for (const gamelog::MatchLogs& logs : matches) {
    const std::string& log = logs.game.empty() ? logs.text : logs.game;
    inputs.push_back({logs, recorded_end(log), recorded_date(log)});
  }
  return inputs;
}

}  // namespace cls::match
