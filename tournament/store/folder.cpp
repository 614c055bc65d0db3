// Files of a tournament's folder.
#include "tournament/store/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <thread>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/number_text.h"
#include "base/text/stored_formats.h"
#include "league/schedule/schedule_check.h"
#include "tournament/config/config_file.h"
#include "tournament/store/collector.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/lost_store.h"
#include "tournament/store/match_document.h"
#include "tournament/store/pauses_file.h"
#include "tournament/store/store.h"

namespace cls::tournament {
namespace fs = std::filesystem;
using base::Error;
using base::Result;

fs::path match_folder(const TournamentConfig& config, const Fixture& fixture, int attempt) {
  const Competition& teams = config.competition;
  const std::string stem = fmt::format("{:06}-{}-vs-{}", fixture.index, teams.team(fixture.left),
                                       teams.team(fixture.right));
  return fs::path(kMatchesFolder) / (attempt == 1 ? stem : fmt::format("{}.{}", stem, attempt));
}

fs::path result_file(int index, int attempt) {
  return fs::path(kResultsFolder) / fmt::format("{:06}.{}.json", index, attempt);
}

bool claim_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder.parent_path(), code);
  return fs::create_directory(folder, code);
}

std::string unfinished_host() {
  std::string host = base::host_name();
  std::ranges::replace(host, '/', '-');
  return host;
}

std::string unfinished_label() { return fmt::format("{}-{}", unfinished_host(), ::getpid()); }

fs::path unfinished_folder(int index, int attempt, std::string_view label) {
  return fs::path(kUnfinishedFolder) / fmt::format("{:06}.{}.{}", index, attempt, label);
}

std::optional<AttemptName> parse_attempt_name(std::string_view name) {
  const std::size_t first = name.find('.');
  const std::size_t second = first == name.npos ? first : name.find('.', first + 1);
  if (second == name.npos) return std::nullopt;
  const auto index = base::parse_int(name.substr(0, first));
  const auto attempt = base::parse_int(name.substr(first + 1, second - first - 1));
  if (!index || !attempt) return std::nullopt;
  return AttemptName{*index, *attempt, name.substr(second + 1)};
}

std::optional<int> match_number(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return base::parse_int(name.substr(0, name.find_first_not_of("0123456789")));
}

bool is_inside(const fs::path& file, const fs::path& folder) {
  std::error_code code;
  const fs::path whole = fs::canonical(file, code);
  const fs::path root = code ? fs::path() : fs::canonical(folder, code);
  if (code) return false;
  return std::ranges::mismatch(root, whole).in1 == root.end();
}

Result<std::optional<FolderLock>> FolderLock::try_lock(const fs::path& folder) {
  const fs::path path = folder / kLockFile;
  base::UniqueFd file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (!file) {
    return Error{fmt::format("cannot create {}: {}", path.string(), std::strerror(errno))};
  }

  constexpr int kTries = 5;
  constexpr std::chrono::milliseconds kPause{20};
  for (int tries = 1; ::flock(file.get(), LOCK_EX | LOCK_NB) != 0; ++tries) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) {
      return Error{fmt::format(
          "cannot lock {}: {}; use a folder on a file system with locks, such as a local disk",
          path.string(), std::strerror(errno))};
    }
    if (tries == kTries) return std::optional<FolderLock>();
    std::this_thread::sleep_for(kPause);
  }
  return std::optional<FolderLock>(FolderLock(std::move(file)));
}

Result<std::string> read_if_there(const fs::path& file) {
  if (auto text = base::read_file(file)) return *std::move(text);
  std::error_code code;
  if (!fs::exists(file, code) && !code) return std::string();
  return Error{fmt::format("{}: cannot be read", file.string())};
}

bool FolderLock::is_held(const fs::path& folder) {
  const base::UniqueFd file(::open((folder / kLockFile).c_str(), O_RDONLY | O_CLOEXEC));
  return file && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

bool holds_plan(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / kPlanFile, code);
}

Result<TournamentConfig> read_plan(const fs::path& folder) {
  if (!holds_plan(folder)) {
    return Error{fmt::format("{} holds no tournament (no {})", folder.string(), kPlanFile)};
  }
  ParsedConfig parsed = read_config(folder / kPlanFile);
  if (!parsed.errors.empty()) return Error{parsed.errors.front()};
  // The plan was valid when cls wrote it.
  if (const auto errors = validate(parsed.config); !errors.empty()) {
    return Error{fmt::format("{}: not the plan of a tournament: {}", (folder / kPlanFile).string(),
                             errors.front())};
  }
  return std::move(parsed.config);
}

Result<void> check_plan(const fs::path& folder, const TournamentConfig& config) {
  if (!holds_plan(folder)) return {};
  std::error_code code;
  const bool begun =
      fs::exists(folder / kStoreFile, code) || fs::exists(folder / kResultsFolder, code);
  const auto before = read_plan(folder);
  if (!before && begun) return before.error();
  const std::string difference = before ? first_difference(config, *before) : "unreadable";
  if (difference.empty()) return {};
  if (!begun) {
    fs::remove(folder / kScheduleFile, code);
    return {};
  }
  return Error{
      fmt::format("{} holds another plan: {}; the options of its first run continue it, --force "
                  "renames the folder and starts again",
                  folder.string(), difference)};
}

Result<void> write_plan(const fs::path& folder, const TournamentConfig& config) {
  TRY(base::create_folders(folder));
  return base::write_file_durably(
      folder / kPlanFile,
      fmt::format("schema = {}\n\n{}", base::kConfigSchema, format_config(config)));
}

Result<void> prepare_folder(const fs::path& folder, const TournamentConfig& config) {
  TRY(check_plan(folder, config));
  return write_plan(folder, config);
}

Result<void> write_schedule(const fs::path& folder, const std::vector<ScheduledMatch>& matches) {
  std::string text;
  for (const ScheduledMatch& match : matches) text += format_fixture(match.fixture);
  return base::write_file_durably(folder / kScheduleFile, text);
}

namespace {

// Calls `visit` with each line's fixture until it returns false.
template <typename Visit>
Result<void> read_schedule(const fs::path& path, Visit visit) {
  std::ifstream stream(path);
  if (!stream) return Error{fmt::format("{}: no such file", path.string())};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    auto fixture = parse_fixture(line);
    if (!fixture) {
      return Error{fmt::format("{}:{}: {}", path.string(), number, fixture.error().message)};
    }
    if (!visit(*std::move(fixture))) break;
  }
  return {};
}

}  // namespace

Result<Fixture> read_fixture(const fs::path& schedule, int index) {
  std::optional<Fixture> found;
  TRY(read_schedule(schedule, [&](Fixture fixture) {
    if (fixture.index == index) found = std::move(fixture);
    return !found;
  }));
  if (!found) return Error{fmt::format("{} has no match {} yet", schedule.string(), index)};
  return *std::move(found);
}

namespace {

Error corrupt(const fs::path& file, const Error& error) {
  return Error{
      fmt::format("{}: {}: the file is corrupt or was changed", file.string(), error.message)};
}

Result<std::vector<ScheduledMatch>> schedule_in(const fs::path& folder) {
  std::vector<ScheduledMatch> matches;
  TRY(read_schedule(folder / kScheduleFile, [&](Fixture fixture) {
    matches.push_back(planned(std::move(fixture)));
    return true;
  }));
  return matches;
}

bool is_replay(const Fixture& fixture, std::span<const MatchDecision> decisions) {
  return std::ranges::any_of(decisions, [&fixture](const MatchDecision& decision) {
    return decision.kind == DecisionKind::kReplay && decision.match == fixture.index &&
           decision.seed == fixture.seed;
  });
}

// schedule.jsonl is written before the store. Matches that the store lacks were not played; those
// that a decision has replayed have another seed.
Result<void> add_scheduled(const fs::path& folder, std::span<const MatchDecision> decisions,
                           std::vector<ScheduledMatch>& matches) {
  auto read = schedule_in(folder);
  if (!read) return {};
  std::vector<ScheduledMatch>& scheduled = *read;
  for (std::size_t i = 0; i < std::min(matches.size(), scheduled.size()); ++i) {
    const Fixture& stored = matches[i].fixture;
    if (is_replay(stored, decisions)) scheduled[i].fixture.seed = stored.seed;
    if (stored == scheduled[i].fixture) continue;
    return corrupt(folder / kStoreFile,
                   {fmt::format("match {} is not that of {}", i + 1, kScheduleFile)});
  }

  for (std::size_t i = matches.size(); i < scheduled.size(); ++i) {
    matches.push_back(std::move(scheduled[i]));
  }
  return {};
}

Result<void> check_file(const fs::path& file, const TournamentState& state) {
  const auto rows = check_rows(state.config.competition, state.matches);
  if (!rows) return corrupt(file, rows.error());
  return {};
}

Result<void> check_decisions(const fs::path& file, const Competition& competition,
                             std::span<const MatchDecision> decisions) {
  for (const MatchDecision& decision : decisions) {
    for (const int team : decision.teams) {
      if (team >= 0 && team < competition.team_count()) continue;
      return corrupt(file, {fmt::format("there is no team {}: the plan has {} teams, from 0", team,
                                        competition.team_count())});
    }
  }
  return {};
}

// The matches of the store, and those that are scheduled only.
Result<void> read_store(const fs::path& folder, std::span<const MatchDecision> decisions,
                        TournamentState& state) {
  TRY_INIT(const auto store, Store::open_to_read(folder / kStoreFile));
  TRY_INIT(state.matches, store.matches());
  state.stored = state.matches.size();
  TRY(check_file(folder / kStoreFile, state));
  TRY(add_scheduled(folder, decisions, state.matches));
  if (FolderLock::is_held(folder)) {
    TRY_INIT(state.running, store.running());
  }
  return {};
}

}  // namespace

Result<TournamentState> read_tournament(const fs::path& folder, bool may_be_lost) {
  TournamentState state;
  TRY_INIT(state.config, read_plan(folder));
  TRY_INIT(const auto decisions, read_decisions(folder));
  TRY(check_decisions(folder / kDecisionsFile, state.config.competition, decisions));
  TRY_INIT(const auto pauses, read_pauses(folder));
  state.paused = is_paused(pauses);

  std::error_code code;
  if (fs::exists(folder / kStoreFile, code)) {
    TRY(read_store(folder, decisions, state));
  } else if (fs::exists(folder / kScheduleFile, code)) {
    TRY_INIT(state.matches, schedule_in(folder));
  }
  TRY(check_file(folder / kScheduleFile, state));
  if (state.stored == 0 && was_begun(folder)) {
    if (!may_be_lost) return lost_store(folder);
    state.matches.clear();
  }

  for (WorkResult& result : collect_work_results(folder, state.matches)) {
    state.matches[base::index(result.index) - 1].outcome = std::move(result.outcome);
  }
  apply_decisions(state.matches, decisions);
  return state;
}

}  // namespace cls::tournament
