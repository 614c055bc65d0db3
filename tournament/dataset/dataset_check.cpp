// Compares hashes.
#include "tournament/dataset/dataset_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "base/io/whole_file.h"
#include "base/system/parallel.h"
#include "league/schedule/schedule_check.h"
#include "process/process_host.h"
#include "process/scratch_folder.h"
#include "tournament/store/match_attempt.h"
#include "viewer/page/encoding.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

// Why `file` is not what it was; empty: it is.
std::string why_different(const fs::path& folder, const DatasetFile& file) {
  const auto path = find_dataset_file(folder, file);
  if (!path) return path.error().message;
  const auto bytes = base::read_file(*path);
  if (!bytes) return fmt::format("{}: not readable", file.path);
  return viewer::sha256_hex(*bytes) == file.sha256 ? "" : fmt::format("{}: other bytes", file.path);
}

// Waits for the end of the attempt.
Result<Outcome> finish(MatchAttempt& attempt, const std::atomic<int>& signal) {
  constexpr std::chrono::milliseconds kPollInterval{5};
  while (!attempt.exited()) {
    if (signal != 0) attempt.interrupt();
    attempt.end_overdue();
    std::this_thread::sleep_for(kPollInterval);
  }
  TRY_INIT(const auto outcome, attempt.outcome());
  if (!outcome) return Error{"interrupted"};
  return *outcome;
}

}  // namespace

std::vector<std::string> check_dataset_files(const fs::path& folder,
                                             const std::vector<DatasetMatch>& matches) {
  std::vector<const DatasetFile*> files;
  for (const DatasetMatch& match : matches) {
    for (const DatasetFile& file : match.files) files.push_back(&file);
  }

  std::vector<std::string> problems(files.size());
  base::parallel_for(files.size(), base::default_jobs(),
                     [&](std::size_t i) { problems[i] = why_different(folder, *files[i]); });
  std::erase_if(problems, [](const std::string& problem) { return problem.empty(); });
  return problems;
}

std::vector<DatasetMatch> sample_of(const std::vector<DatasetMatch>& matches, std::size_t count) {
  std::vector<DatasetMatch> played;
  std::ranges::copy_if(matches, std::back_inserter(played),
                       [](const DatasetMatch& match) { return !match.files.empty(); });
  const std::size_t wanted = std::min(count, played.size());
  std::vector<DatasetMatch> sample;
  for (std::size_t i = 0; i < wanted; ++i) {
    sample.push_back(played[(2 * i + 1) * played.size() / (2 * wanted)]);
  }
  return sample;
}

Result<std::vector<std::string>> replay_dataset_match(const TournamentConfig& config,
                                                      const DatasetMatch& match,
                                                      const fs::path& program,
                                                      const std::atomic<int>& signal) {
  TRY(check_teams(config.competition, match.fixture));
  TRY_INIT(const auto scratch, process::ScratchFolder::create());
  TRY_INIT(auto host, process::ProcessHost::create());
  AttemptOptions options;
  options.tournament = scratch.path();
  options.folder = "match";
  options.program = program;
  TRY_INIT(auto attempt, MatchAttempt::start(host, config, match.fixture, 1, options));
  ScheduledMatch again = planned(match.fixture);
  TRY_INIT(again.outcome, finish(attempt, signal));
  TRY_INIT(const auto packed,
           pack_match(config, again, scratch.path() / options.folder, scratch.path() / "packed"));

  std::vector<std::string> problems;
  for (std::size_t i = 0; i < match.files.size(); ++i) {
    if (i < packed.files.size() && packed.files[i] == match.files[i]) continue;
    problems.push_back(fmt::format("{}: other bytes when it is played again", match.files[i].path));
  }
  if (packed.version != match.version && !problems.empty()) {
    problems.back() += fmt::format(" by cls {}; made by {}", packed.version, match.version);
  }
  return problems;
}

}  // namespace cls::tournament
