// Asks the tournaments above the logs which matches count.
#include "cli/logs/counted_logs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/text/counted.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "league/matches/playing.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

// Without "." and "..", and without a slash at the end.
fs::path plain_path(const fs::path& path) {
  std::error_code code;
  fs::path plain = fs::absolute(path, code).lexically_normal();
  return plain.has_filename() ? plain : plain.parent_path();
}

// Match folders of the tournament in `folder` that do not count; none if it is not a tournament.
std::set<fs::path> annulled_in(const fs::path& folder) {
  std::set<fs::path> annulled;
  if (!tournament::holds_plan(folder)) return annulled;
  const auto state = tournament::read_tournament(folder, true);
  if (!state) return annulled;
  for (const league::ScheduledMatch& match : state->matches) {
    for (const league::Playing& playing : league::playings_of(match)) {
      if (playing.annulled) annulled.insert(folder / playing.folder);
    }
  }
  return annulled;
}

// Knows the tournaments that it was asked about.
class Decisions {
 public:
  bool annul(const fs::path& log) {
    const fs::path match = log.parent_path();
    for (fs::path folder = match; folder != folder.parent_path(); folder = folder.parent_path()) {
      const auto [known, is_new] = annulled_.try_emplace(folder);
      if (is_new) known->second = annulled_in(folder);
      if (known->second.contains(match)) return true;
    }
    return false;
  }

 private:
  std::map<fs::path, std::set<fs::path>> annulled_;  // by folder
};

}  // namespace

gamelog::FoundLogs find_counted_logs(const std::vector<std::string>& arguments) {
  gamelog::FoundLogs found = gamelog::find_logs(arguments);
  std::set<fs::path> named;
  for (const std::string& argument : arguments) named.insert(plain_path(argument));

  Decisions decisions;
  const auto left_out = std::erase_if(found.matches, [&](const gamelog::MatchLogs& logs) {
    if (logs.game == "-" || logs.text == "-") return false;
    const fs::path log = plain_path(logs.game.empty() ? logs.text : logs.game);
    return !named.contains(log) && !named.contains(log.parent_path()) && decisions.annul(log);
  });
  if (left_out > 0) {
    print_error(0, "{} left out: annulled or played again by decision",
                base::counted(static_cast<int>(left_out), "match", "matches"));
  }
  return found;
}

}  // namespace cls::cli
