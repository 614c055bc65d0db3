// Searches results of tournaments and of folders.
#include "cli/logs/find_match_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/io/whole_file.h"
#include "gamelog/files/log_files.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace match = match;
namespace tournament = tournament;
using base::Error;
using base::Result;

bool is_match_folder(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / match::kManifestFile, code) ||
         fs::is_regular_file(folder / match::kResultFile, code);
}

// False without a result: then the match was killed, or is running.
bool finished(const fs::path& folder) {
  const auto text = base::read_file(folder / match::kResultFile);
  const auto result =
      text ? match::parse_match_result(*text) : Result<match::MatchResult>(Error{"no result"});
  return result && result->valid();
}

Result<FoundMatch> found(const fs::path& folder, std::string why) {
  if (is_match_folder(folder)) return FoundMatch{folder, std::move(why)};
  return Error{fmt::format("{}: removed (keep_logs), or not played yet", folder.string())};
}

Result<FoundMatch> find_in_tournament(const fs::path& folder, std::optional<int> index) {
  TRY_INIT(const auto state, tournament::read_tournament(folder));

  const auto latest = [&](const tournament::ScheduledMatch& one) {
    return folder /
           (one.outcome && !one.outcome->folder.empty()
                ? fs::path(one.outcome->folder)
                : tournament::match_folder(state.config, one.fixture, std::max(1, one.attempts)));
  };

  if (index) {
    for (const auto& one : state.matches) {
      if (one.fixture.index == *index) return found(latest(one), fmt::format("match {}", *index));
    }
    return Error{fmt::format("{} has {} matches, no match {}", folder.string(),
                             state.matches.size(), *index)};
  }

  const tournament::ScheduledMatch* failed = nullptr;
  const tournament::ScheduledMatch* played = nullptr;
  for (const auto& one : state.matches) {
    if (!one.outcome) continue;
    played = &one;
    if (!one.outcome->finished()) failed = &one;
  }

  if (failed != nullptr) {
    return found(latest(*failed),
                 fmt::format("match {}, the last that failed", failed->fixture.index));
  }

  if (played == nullptr) return Error{fmt::format("{}: no match was played yet", folder.string())};
  return found(latest(*played), fmt::format("match {}; none failed", played->fixture.index));
}

bool has_game_log(const fs::path& folder) {
  const gamelog::FoundLogs logs = gamelog::find_logs({folder.string()});
  return std::ranges::any_of(logs.matches,
                             [](const gamelog::MatchLogs& one) { return !one.game.empty(); });
}

Result<FoundMatch> find_below(const fs::path& folder, WantedMatch wanted) {
  std::vector<std::pair<fs::file_time_type, fs::path>> matches;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::error_code ignored;
    if (!is_match_folder(entry->path())) continue;
    matches.emplace_back(fs::last_write_time(entry->path() / match::kManifestFile, ignored),
                         entry->path());
  }

  if (matches.empty()) {
    return Error{fmt::format("{}: no match folder, no tournament and no folder of matches",
                             folder.string())};
  }

  std::sort(matches.rbegin(), matches.rend());
  if (wanted == WantedMatch::kWithGameLog) {
    const auto logged =
        std::ranges::find_if(matches, [](const auto& one) { return has_game_log(one.second); });
    const bool none = logged == matches.end();
    return FoundMatch{none ? matches.front().second : logged->second, "the latest"};
  }

  const auto failed =
      std::ranges::find_if(matches, [](const auto& one) { return !finished(one.second); });
  if (failed == matches.end()) return FoundMatch{matches.front().second, "the latest; none failed"};
  return FoundMatch{failed->second, "the latest that failed"};
}

}  // namespace

Result<FoundMatch> find_match_folder(const fs::path& folder, std::optional<int> index,
                                     WantedMatch wanted) {
  if (const auto why = base::why_no_folder(folder)) {
    return Error{fmt::format("{}: {}", folder.string(), *why)};
  }

  if (tournament::holds_plan(folder)) return find_in_tournament(folder, index);

  if (index) {
    return Error{fmt::format("--match {}: {} is not a tournament", *index, folder.string())};
  }

  if (is_match_folder(folder)) return FoundMatch{folder, ""};
  return find_below(folder, wanted);
}

}  // namespace cls::cli
