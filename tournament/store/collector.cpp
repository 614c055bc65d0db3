// Creates and collects result files.
#include "tournament/store/collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <thread>

#include "base/io/whole_file.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_attempt.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

// Removes the folder of an interrupted match, whose process has ended, from below matches/. Of two
// processes that do so, the second one moves what the first has published, and puts it back.
void remove_interrupted(const fs::path& folder, const Fixture& fixture, const fs::path& aside) {
  if (!was_interrupted(folder, fixture)) return;
  std::error_code code;
  fs::rename(folder, aside, code);
  if (code) return;
  if (was_interrupted(aside, fixture)) {
    fs::remove_all(aside, code);
  } else {
    fs::rename(aside, folder, code);
  }
}

// Renames the match folder to its final name. A folder of that name stays, unless it is that of an
// interrupted match: a process may be playing in it. Returns the resulting name.
fs::path publish_folder(const fs::path& tournament, const Fixture& fixture,
                        const fs::path& unfinished, const fs::path& final_name) {
  const fs::path aside = tournament / (unfinished.string() + ".aside");
  remove_interrupted(tournament / final_name, fixture, aside);
  if (!claim_folder(tournament / final_name)) return unfinished;
  std::error_code code;
  fs::rename(tournament / unfinished, tournament / final_name, code);
  return code ? unfinished : final_name;
}

// Creates the result file atomically. If another process has created it, that outcome counts.
Result<Outcome> publish_result(const fs::path& tournament, const Fixture& fixture, int attempt,
                               Outcome outcome) {
  const fs::path file = tournament / result_file(fixture.index, attempt);
  // There clean_up_unfinished() finds it when this process is killed.
  const fs::path own =
      tournament /
      unfinished_folder(fixture.index, attempt, unfinished_label() + file.extension().string());
  std::error_code code;
  fs::create_directories(file.parent_path(), code);
  fs::create_directories(own.parent_path(), code);
  TRY(base::write_file_durably(own, format_work_result(fixture, outcome)));

  fs::create_hard_link(own, file, code);
  if (code) {
    if (auto existing = read_work_result(tournament, fixture, attempt)) {
      fs::remove(own, code);
      return *std::move(existing);
    }
    fs::rename(own, file, code);  // no hard links on this file system, or a corrupt file
    if (code) return Error{fmt::format("cannot create {}: {}", file.string(), code.message())};
    return outcome;
  }

  fs::remove(own, code);
  return outcome;
}

// Returns nothing when interrupted.
Result<std::optional<Outcome>> play(const TournamentConfig& config, const Fixture& fixture,
                                    int attempt, const AttemptOptions& options,
                                    const std::atomic<int>& stop_signal) {
  constexpr std::chrono::milliseconds kPollInterval{5};
  TRY_INIT(auto host, process::ProcessHost::create());
  TRY_INIT(auto running, MatchAttempt::start(host, config, fixture, attempt, options));
  while (!running.exited()) {
    std::this_thread::sleep_for(kPollInterval);
    running.end_overdue();
    if (stop_signal != 0) running.interrupt();
  }
  return running.outcome();
}

}  // namespace

std::vector<WorkResultName> list_work_results(const fs::path& folder) {
  std::vector<WorkResultName> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kResultsFolder, code)) {
    const std::string name = entry.path().filename().string();
    const auto parts = parse_attempt_name(name);
    if (parts && parts->rest == "json") names.push_back({parts->index, parts->attempt});
  }
  return names;
}

std::optional<Outcome> read_work_result(const fs::path& folder, const Fixture& fixture,
                                        int attempt) {
  const auto text = base::read_file(folder / result_file(fixture.index, attempt));
  if (!text) return std::nullopt;
  auto read = parse_work_result(*text);
  if (!read || read->seed != fixture.seed) return std::nullopt;
  return std::move(read->outcome);
}

std::vector<WorkResult> collect_work_results(const fs::path& folder,
                                             std::span<const ScheduledMatch> matches) {
  std::map<int, int> latest;
  for (const WorkResultName& name : list_work_results(folder)) {
    latest[name.index] = std::max(latest[name.index], name.attempt);
  }

  std::vector<WorkResult> results;
  for (const auto& [index, attempt] : latest) {
    if (index < 1 || index > std::ssize(matches)) continue;
    const ScheduledMatch& match = matches[base::index(index) - 1];
    if (match.outcome || attempt <= match.settled) continue;
    if (auto outcome = read_work_result(folder, match.fixture, attempt)) {
      results.push_back({index, match.fixture.seed, *std::move(outcome)});
    }
  }
  return results;
}

Result<std::optional<Outcome>> work(const fs::path& folder, const Fixture& fixture, int attempt,
                                    const fs::path& program, const std::atomic<int>& stop_signal) {
  if (auto existing = read_work_result(folder, fixture, attempt)) {
    return std::optional<Outcome>(*std::move(existing));
  }

  TRY_INIT(const auto config, read_plan(folder));
  const fs::path unfinished = unfinished_folder(fixture.index, attempt, unfinished_label());
  auto outcome = play(config, fixture, attempt, {folder, unfinished, program, {}}, stop_signal);

  std::error_code code;
  if (!outcome || !*outcome || !keeps_folder(config, **outcome)) {
    fs::remove_all(folder / unfinished, code);
    if (!outcome || !*outcome) return outcome;
    (*outcome)->folder.clear();
  } else if (auto existing = read_work_result(folder, fixture, attempt)) {
    fs::remove_all(folder / unfinished, code);
    return std::optional<Outcome>(*std::move(existing));
  } else if (const fs::path published = publish_folder(folder, fixture, unfinished,
                                                       match_folder(config, fixture, attempt));
             published != unfinished) {
    (*outcome)->folder = published.string();
  } else if (auto earlier = recover_result(config, fixture, attempt, folder)) {
    // Another process has published its folder, but not yet its result file.
    fs::remove_all(folder / unfinished, code);
    *outcome = *std::move(earlier);
  }

  TRY_INIT(auto published, publish_result(folder, fixture, attempt, **std::move(outcome)));
  return std::optional<Outcome>(std::move(published));
}

}  // namespace cls::tournament
