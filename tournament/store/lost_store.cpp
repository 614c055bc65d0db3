// Reads names of folders and events.
#include "tournament/store/lost_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "base/text/number_text.h"
#include "tournament/store/folder.h"
#include "tournament/store/json_lines.h"
#include "tournament/store/match_attempt.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

// The number in "000017-RED-vs-BLUE.2"; 0: another name.
int match_number(const std::string& name) {
  return base::parse_int(name.substr(0, name.find('-'))).value_or(0);
}

// The attempt in it.
int attempt_in(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == name.npos ? 1 : base::parse_int(name.substr(dot + 1)).value_or(0);
}

// Numbers of the matches whose folders have results, and the highest attempt.
struct Found {
  std::set<int> matches;
  int attempts = 0;
};

Found find_results(const fs::path& folder) {
  Found found;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kMatchesFolder, code)) {
    if (!holds_result(entry.path())) continue;
    const std::string name = entry.path().filename().string();
    found.matches.insert(match_number(name));
    found.attempts = std::max(found.attempts, attempt_in(name));
  }
  return found;
}

/// A line of events.jsonl.
struct Event {
  std::string type;
  int match = 0;
  bool again = false;  ///< the match is played again
};

template <typename Codec>
void members(Codec& codec, typename Codec::template Object<Event>& event) {
  codec.member("type", event.type);
  codec.member("match", event.match);
  codec.member("again", event.again);
}

// Numbers of the matches whose outcome was recorded. A torn line at the end tells nothing, nor does
// a device or a pipe in place of the file.
std::set<int> recorded_matches(const fs::path& folder) {
  std::set<int> matches;
  std::error_code code;
  const fs::path file = folder / kTournamentEvents;
  if (!fs::is_regular_file(file, code)) return matches;

  const auto text = read_if_there(file);
  std::istringstream lines(text ? *text : std::string());
  for (std::string line; std::getline(lines, line);) {
    const auto event = parse_json<Event>(line);
    if (event && event->type == "match_finished" && !event->again) matches.insert(event->match);
  }
  return matches;
}

}  // namespace

bool was_begun(const fs::path& folder) {
  std::error_code code;
  if (!recorded_matches(folder).empty()) return true;
  return !fs::exists(folder / kResultsFolder, code) && !find_results(folder).matches.empty();
}

Result<void> check_lost_results(const fs::path& folder) {
  const std::set<int> found = find_results(folder).matches;
  for (const int match : recorded_matches(folder)) {
    const bool by_work = fs::exists(folder / result_file(match, 1));
    if (found.contains(match) || by_work) continue;
    return Error{fmt::format(
        "{} is missing or empty, and match {} was played, but {}/ has no result of it: restore {} "
        "from a copy, or --force begins anew and renames this folder to {}.old",
        (folder / kStoreFile).string(), match, kMatchesFolder, kStoreFile, folder.string())};
  }
  return {};
}

int latest_attempt(const TournamentConfig& config, const Fixture& fixture, const fs::path& folder) {
  for (int attempt = find_results(folder).attempts; attempt > 0; --attempt) {
    if (was_played(folder / match_folder(config, fixture, attempt), fixture)) return attempt;
  }
  return 0;
}

Error lost_store(const fs::path& folder) {
  return Error{
      fmt::format("{} is missing or empty, but matches were played: `cls tournament run {}` reads "
                  "their results again",
                  (folder / kStoreFile).string(), folder.string())};
}

}  // namespace cls::tournament
