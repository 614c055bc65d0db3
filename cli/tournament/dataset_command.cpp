// `cls dataset make SPEC DIR` and `cls dataset verify DIR`.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <future>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "base/system/own_program.h"
#include "base/system/parallel.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tournament/dataset/data_card.h"
#include "tournament/dataset/dataset.h"
#include "tournament/dataset/dataset_check.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;
using base::Json;
using Clock = std::chrono::steady_clock;

constexpr const char* kDatasetMakeDescription =
    "play the matches of SPEC and store what happened and what each player knew\n"
    "\n"
    "  cls init cup && cls dataset make cup/cls.toml data\n"
    "  cls dataset make cup/cls.toml data --rounds 100 --cycles 3000\n"
    "\n"
    "SPEC is a cls.toml: teams, rounds, seed, settings. After any interruption\n"
    "(Ctrl-C, kill -9, power failure) the same command resumes. The same SPEC gives\n"
    "the same bytes, in any number of parallel matches, if the sides are\n"
    "deterministic. DIR/README.md says what is in DIR.";

constexpr const char* kPackedFolder = "packed";

double own_cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Packs matches on threads while others are played. A match is packed when its line is on disk;
// then its match folder is removed.
class Packer {
 public:
  Packer(const TournamentConfig& config, fs::path dataset)
      : config_(config), dataset_(std::move(dataset)) {}

  /// Each match once, however often this is called. Waits while each processor packs one: after a
  /// kill many matches can be left unpacked, and each needs memory for its whole log.
  void pack(const ScheduledMatch& match) {
    std::erase_if(running_, [this](std::future<base::Result<void>>& one) {
      if (one.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
      note(one.get());
      return true;
    });
    if (is_packed(match) || !begun_.insert(match.fixture.index).second) return;
    while (running_.size() >= base::default_jobs()) {
      note(running_.front().get());
      running_.pop_front();
    }
    running_.push_back(std::async(std::launch::async, [this, match] { return work(match); }));
  }

  void wait() {
    for (auto& one : running_) note(one.get());
    running_.clear();
  }

  bool is_packed(const ScheduledMatch& match) const {
    std::error_code code;
    return fs::exists(line_file(match.fixture), code);
  }

  /// Lines of all packed matches among these.
  base::Result<std::vector<DatasetMatch>> packed(const std::vector<ScheduledMatch>& matches) const {
    std::vector<DatasetMatch> all;
    for (const ScheduledMatch& match : matches) {
      const auto line = base::read_file(line_file(match.fixture));
      if (!line) return base::Error{line_file(match.fixture).string() + ": no such file"};
      TRY_INIT(auto parsed, parse_dataset_match(*line));
      all.push_back(std::move(parsed));
    }
    return all;
  }

  const std::string& error() const { return error_; }

 private:
  fs::path work_folder() const { return dataset_ / kDatasetWork; }
  fs::path line_file(const Fixture& fixture) const {
    return work_folder() / kPackedFolder / fmt::format("{:06}.json", fixture.index);
  }

  base::Result<void> work(const ScheduledMatch& match) const {
    const fs::path folder = work_folder() / match.outcome->folder;
    TRY_INIT(const auto packed, pack_match(config_, match, folder, dataset_));
    TRY(base::create_folders(work_folder() / kPackedFolder));
    TRY(base::write_file_durably(line_file(match.fixture), format_dataset_match(packed)));
    std::error_code code;
    if (!packed.files.empty()) fs::remove_all(folder, code);
    return {};
  }

  void note(const base::Result<void>& result) {
    if (!result && error_.empty()) error_ = result.error().message;
  }

  const TournamentConfig& config_;
  fs::path dataset_;
  std::deque<std::future<base::Result<void>>> running_;
  std::set<int> begun_;  // numbers of matches
  std::string error_;
};

class DatasetProgress : public TournamentProgress {
 public:
  DatasetProgress(Packer& packer, bool quiet)
      : TournamentProgress(stderr_is_terminal(), quiet), packer_(packer) {}

  void on_match(const TournamentConfig& config, const ScheduledMatch& match,
                const RunProgress& progress) override {
    TournamentProgress::on_match(config, match, progress);
    packer_.pack(match);
  }

 private:
  Packer& packer_;
};

struct MakeArguments {
  TournamentOptions tournament;
  std::string folder;
  SessionOptions session;
};

struct Figures {
  double seconds = 0.0;
  int played = 0;          ///< in this run
  double own_share = 0.0;  ///< of the processors, for all but the matches
};

Figures figures_of(const RunSummary& summary, Clock::time_point begin) {
  Figures figures;
  figures.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  figures.played = summary.progress.done_in_this_run;
  figures.own_share = own_cpu_seconds() /
                      std::max(1e-3, figures.seconds * static_cast<double>(base::default_jobs()));
  return figures;
}

void print_result(const MakeArguments& arguments, const std::vector<DatasetMatch>& matches,
                  const Figures& figures) {
  const DatasetSize size = size_of(matches);
  if (arguments.session.json) {
    print_json({{"schema", "cls.dataset/1"},
                {"folder", arguments.folder},
                {"matches", matches.size()},
                {"valid", size.valid},
                {"bytes", size.bytes},
                {"played", figures.played},
                {"seconds", figures.seconds},
                {"own_share", figures.own_share}});
    return;
  }

  fmt::print("{}/: {}, {:.1f} MB ({:.2f} MB a match)\n", arguments.folder,
             base::counted(matches.size(), "match", "matches"), size.megabytes(),
             size.megabytes_each());
  if (figures.played == 0) return;

  fmt::print("1000 matches: {:.1f} GB, {:.0f} min on this host; packing takes {:.0f} % of it\n",
             size.megabytes_each(), figures.seconds / figures.played * 1000 / 60,
             100 * figures.own_share);
}

int make_dataset(const MakeArguments& arguments) {
  const Clock::time_point begin = Clock::now();
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  const TournamentConfig config = dataset_config(chosen.config);
  if (const auto errors = validate(config); !errors.empty()) {
    return print_errors(kBadConfig, errors);
  }
  if (config.execution.executor != ExecutorKind::kLocal) {
    return print_error(kBadConfig, "executor: a data set is made on this host (\"local\")");
  }

  RunOptions options;
  options.folder = fs::path(arguments.folder) / kDatasetWork;
  options.config = config;
  options.config.execution.keep_logs = KeepLogs::kAll;  // until they are packed
  const auto outlook_of = [&config](const std::vector<ScheduledMatch>& matches) {
    std::size_t left = next_fixtures(config.competition, matches).size();
    for (const ScheduledMatch& match : matches) left += match.outcome ? 0 : 1;
    return Outlook{static_cast<double>(left), fmt::format("{} matches to play", left)};
  };
  const OpenedFolder opened =
      begin_session(options.folder, options.config, arguments.session, outlook_of);
  if (opened.exit_code != kOk) return opened.exit_code;
  if (const auto checked = check_schedule(config.competition, opened.matches); !checked) {
    return print_error(kBadData, "{}: {}", arguments.folder, checked.error().message);
  }

  warn_of_twins(config, arguments.session);
  Packer packer(options.config, arguments.folder);
  DatasetProgress progress(packer, arguments.session.quiet);
  const auto summary =
      run_tournament(options, executors_in(options.folder), progress, watch_interrupts());
  progress.clear();
  if (!summary) return print_error(kWriteFailed, summary.error().message);

  // Those that ended before an earlier run packed them.
  for (const ScheduledMatch& match : summary->matches) {
    if (match.outcome) packer.pack(match);
  }
  packer.wait();
  if (!packer.error().empty()) return print_error(kWriteFailed, packer.error());

  int exit_code = summary->progress.invalid == 0 ? kOk : kFailed;
  if (summary->end == RunEnd::kComplete) {
    TRY_INIT_OR(kBadData, const auto matches, packer.packed(summary->matches));
    TRY_OR(kWriteFailed, write_dataset(config, matches, arguments.folder));
    print_result(arguments, matches, figures_of(*summary, begin));
  } else if (summary->end == RunEnd::kInterrupted) {
    exit_code = signal_exit_code(summary->signal);
  } else {
    exit_code = summary->end == RunEnd::kStopRequested ? kInterrupted : kFailed;
  }
  return end_session(*summary, options.config, arguments.session, exit_code, false);
}

struct VerifyArguments {
  std::string folder;
  std::size_t sample = 1;
  bool run_programs = false;
  bool json = false;
};

// The matches of `sample` that may be played again: without --run-programs those of built-in sides.
// Says on stderr why the others are not.
std::vector<DatasetMatch> playable(const VerifyArguments& arguments, const TournamentConfig& config,
                                   std::vector<DatasetMatch> sample) {
  if (arguments.run_programs) return sample;
  std::string why;
  std::erase_if(sample, [&](const DatasetMatch& match) {
    if (!check_teams(config.competition, match.fixture)) return false;  // an error of its own
    const std::string part = foreign_part(config, match.fixture);
    if (!part.empty()) why = part;
    return !part.empty();
  });
  if (!why.empty()) {
    fmt::print(stderr,
               "cls: matches are not played again: {}; --run-programs plays them with your rights, "
               "for data sets of people whom you trust\n",
               why);
  }
  return sample;
}

int report_problems(const VerifyArguments& arguments, std::size_t matches, std::size_t again,
                    const std::vector<std::string>& problems, int exit_code) {
  if (arguments.json) {
    print_json({{"schema", "cls.dataset/1"},
                {"folder", arguments.folder},
                {"matches", matches},
                {"played_again", again},
                {"problems", problems}});
  } else if (problems.empty()) {
    fmt::print("{}/: {} as they were made, {} played again with the same bytes\n", arguments.folder,
               base::counted(matches, "match", "matches"), again);
  } else {
    print_errors(exit_code, problems);
  }
  return problems.empty() ? kOk : exit_code;
}

int verify_dataset(const VerifyArguments& arguments) {
  const fs::path folder = arguments.folder;
  if (!is_dataset(folder)) {
    return print_error(kNoInput,
                       "{}: not a finished data set (no {}); `cls dataset "
                       "make` makes one, or resumes it",
                       arguments.folder, kDatasetMatches);
  }

  TRY_INIT_OR(kBadData, const auto matches, read_dataset_matches(folder));
  const std::vector<std::string> corrupt = check_dataset_files(folder, matches);
  if (!corrupt.empty()) return report_problems(arguments, matches.size(), 0, corrupt, kBadData);

  TRY_INIT_OR(kBadData, const auto config, read_dataset_plan(folder));
  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  const std::atomic<int>& signal = watch_interrupts();
  const std::vector<DatasetMatch> sample =
      playable(arguments, config, sample_of(matches, arguments.sample));
  std::vector<std::string> different;
  for (const DatasetMatch& match : sample) {
    const auto found = replay_dataset_match(config, match, program, signal);
    if (signal != 0) return signal_exit_code(signal);
    if (!found) {
      return print_error(kFailed, "match {}: {}", match.fixture.index, found.error().message);
    }
    different.insert(different.end(), found->begin(), found->end());
  }

  return report_problems(arguments, matches.size(), sample.size(), different, kFailed);
}

void add_dataset_make(Command& dataset) {
  auto [command, arguments] = dataset.command("make", kDatasetMakeDescription, make_dataset);
  command.option("SPEC", arguments.tournament.config_file, "a cls.toml").required();
  command.option("DIR", arguments.folder, "folder of the data set").required();
  add_override_options(command, arguments.tournament);
  add_session_options(command, arguments.session, "figures");
}

void add_dataset_verify(Command& dataset) {
  auto [command, arguments] = dataset.command(
      "verify",
      "check the hashes of all files, and play some matches again\n"
      "\n"
      "  cls dataset verify data\n"
      "  cls dataset verify data --sample 0     hashes only\n"
      "\n"
      "Without --run-programs only matches of built-in sides are played again: a data\n"
      "set of a stranger starts no program and reaches no other host.\n"
      "\n"
      "Exit code: 0 if all is as it was, 65 if files are missing or corrupt, 1 if a\n"
      "match played again has other bytes: another version of cls or of a side.",
      verify_dataset);

  command.option("DIR", arguments.folder, "folder of the data set").required();
  command.setting("--sample", arguments.sample, "matches to play again");
  command.flag("--run-programs", arguments.run_programs,
               "start the programs that the data set names, with your rights");
  command.flag("--json", arguments.json, "print the problems as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace

void add_dataset_command(Command& app) {
  Command& command =
      app.command("dataset",
                  "make matches for learning and research, with what each player knew\n"
                  "\n"
                  "  cls dataset make cup/cls.toml data     plays the matches; again to resume\n"
                  "  cls dataset verify data                hashes, and a match played again\n"
                  "  cls convert data --tables tables --format arrow\n"
                  "\n"
                  "docs/data.md describes files and columns.");
  command.group = kPlayCommands;
  command.starts_programs = true;
  add_dataset_make(command);
  add_dataset_verify(command);
}

}  // namespace cls::cli
