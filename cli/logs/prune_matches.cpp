// Finds match folders by their files, sorts them by the time of their manifest.
#include "cli/logs/prune_matches.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/io/whole_file.h"
#include "match/result/match_folder.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace match = match;

// A match without a result was killed, or is played now: then its files change.
bool may_be_running(const fs::path& folder) {
  constexpr std::chrono::minutes kQuiet{10};
  std::error_code code;
  if (fs::exists(folder / match::kResultFile, code)) return false;

  const auto now = fs::file_time_type::clock::now();
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    std::error_code ignored;
    if (now - entry.last_write_time(ignored) < kQuiet) return true;
  }
  return false;
}

std::uintmax_t bytes_in(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code code;
  for (const auto& entry : fs::recursive_directory_iterator(folder, code)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored) && !entry.is_symlink(ignored)) {
      bytes += entry.file_size(ignored);
    }
  }
  return bytes;
}

}  // namespace

base::Result<PrunedMatches> find_old_matches(const fs::path& folder, std::size_t keep) {
  if (const auto why = base::why_no_folder(folder)) {
    return base::Error{fmt::format("{}: {}", folder.string(), *why)};
  }
  if (tournament::holds_plan(folder)) {
    return base::Error{fmt::format(
        "{}: a tournament, whose report needs its matches; remove the whole folder, or let "
        "keep_logs of its cls.toml delete logs",
        folder.string())};
  }

  std::vector<std::pair<fs::file_time_type, fs::path>> matches;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    std::error_code ignored;
    if (entry.is_symlink(ignored) || !match::is_match_folder(entry.path())) continue;
    if (may_be_running(entry.path())) continue;
    matches.emplace_back(fs::last_write_time(entry.path() / match::kManifestFile, ignored),
                         entry.path());
  }

  std::ranges::sort(matches);
  PrunedMatches pruned;
  pruned.left = std::min(keep, matches.size());
  matches.resize(matches.size() - pruned.left);
  for (auto& [time, path] : matches) {
    pruned.bytes += bytes_in(path);
    pruned.folders.push_back(std::move(path));
  }

  return pruned;
}

base::Result<void> delete_matches(const PrunedMatches& matches) {
  for (const fs::path& folder : matches.folders) {
    std::error_code code;
    fs::remove_all(folder, code);
    if (code) return base::Error{fmt::format("{}: {}", folder.string(), code.message())};
  }
  return {};
}

}  // namespace cls::cli
