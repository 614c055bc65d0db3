// Reads names of folders and events.
#include "tournament/store/lost_store.h"

#include <fmt/format.h>

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

// The attempt in the name of a match folder: 2 in "000017-RED-vs-BLUE.2".
int attempt_in(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const std::size_t dot = name.rfind('.');
  return dot == name.npos ? 1 : base::parse_int(name.substr(dot + 1)).value_or(0);
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

FoundAttempts find_attempts(const fs::path& folder) {
  FoundAttempts found;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kMatchesFolder, code)) {
    if (!holds_result(entry.path())) continue;
    found[match_number(entry.path()).value_or(0)].insert(attempt_in(entry.path()));
  }
  return found;
}

bool was_begun(const fs::path& folder) {
  std::error_code code;
  if (!recorded_matches(folder).empty()) return true;
  return !fs::exists(folder / kResultsFolder, code) && !find_attempts(folder).empty();
}

Result<void> check_lost_results(const fs::path& folder, const FoundAttempts& found) {
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

int latest_attempt(const TournamentConfig& config, const Fixture& fixture, const fs::path& folder,
                   const FoundAttempts& found) {
  const auto attempts = found.find(fixture.index);
  if (attempts == found.end()) return 0;
  for (auto attempt = attempts->second.rbegin(); attempt != attempts->second.rend(); ++attempt) {
    if (was_played(folder / match_folder(config, fixture, *attempt), fixture)) return *attempt;
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
