// `cls tune run DIR`: generations of candidates, then the verdict.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/comparison_run.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "cli/tournament/tune_session.h"
#include "tournament/config/config.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/folder.h"
#include "tournament/tuning/candidate.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kTuneRunDescription =
    "search, generation by generation, then compare the best values with the start\n"
    "\n"
    "  cls tune run DIR                     what DIR/tune.toml describes\n"
    "  cls tune run DIR --generations 40    more of them; also after the end\n"
    "  cls tune run DIR --executor slurm    on a cluster\n"
    "\n"
    "Conditions of the matches are those of cls.toml in DIR, in or above the working\n"
    "directory, and of the options. The same command resumes a search, also after\n"
    "kill -9. Exit code: that of the final comparison: 0 the best values are better,\n"
    "1 not better, 3 undecided; 0 without one.";

struct TuneRunArguments {
  TournamentOptions options;
  SessionOptions session;
  std::optional<int> generations;
};

// One line per generation; the status has the matches of the current one.
class TuneProgress : public TournamentProgress {
 public:
  TuneProgress(const Tuning& tuning, bool on_terminal, bool quiet)
      : TournamentProgress(on_terminal, quiet), tuning_(tuning) {}

  void on_match(const TournamentConfig& config, const ScheduledMatch& match,
                const RunProgress& progress) override {
    if (match.outcome && !match.outcome->finished()) {
      TournamentProgress::on_match(config, match, progress);
    }
    matches_ = progress.done;
  }

  void finish_generation(double seconds) {
    seconds_ += seconds;
    played_ += matches_;
    matches_ = 0;
  }

 protected:
  std::string status(const RunProgress& progress) const override {
    const TuneConfig& config = tuning_.config();
    const Race race = tuning_.race();
    std::string text = fmt::format("generation {}/{}  match {}/{}", race.generation,
                                   config.generations, progress.done, progress.total);
    if (!tuning_.history().empty()) {
      text += "  " + score_text(config, tuning_.history().back().score);
    }

    const int played = played_ + progress.done_in_this_run;
    if (played > 0) {
      const int per_generation = (race.opponents == 0 ? 1 : race.candidates) * config.pairs * 2;
      const int left = (config.generations - race.generation + 1) * per_generation - progress.done;
      text += "  " + time_left(left * (seconds_ + progress.seconds) / played);
    }
    return text;
  }

 private:
  const Tuning& tuning_;
  int matches_ = 0;
  int played_ = 0;
  double seconds_ = 0.0;
};

// Plays one generation; an exit code other than kOk ends the run.
int play_generation(const TuneSetup& setup, Tuning& tuning, const TuneRunArguments& arguments,
                    TuneProgress& progress, std::string& write_error) {
  const fs::path folder = fs::absolute(arguments.options.folder);
  TRY_INIT_OR(kCannotCreate, const auto config,
              generation_config(tuning, setup.conditions, setup.opponents, folder));

  if (const auto errors = validate(config); !errors.empty()) {
    print_errors(kBadConfig, errors);
    return kBadConfig;
  }

  RunOptions options;
  const Race race = tuning.race();
  options.folder = generation_folder(arguments.options.folder, race.generation);
  options.config = config;
  options.next = [&](std::span<const ScheduledMatch> so_far) {
    return next_round(tuning.config(), race, so_far);
  };

  // Teams and host are checked once, before the first generation of this run.
  SessionOptions session = arguments.session;
  session.force = false;
  session.no_preflight = session.no_preflight || race.generation > 1;
  session.quiet = true;
  const auto outlook_of = [&](const std::vector<ScheduledMatch>&) { return Outlook{1.0, ""}; };
  const OpenedFolder opened = begin_session(options.folder, options.config, session, outlook_of);
  if (opened.exit_code != kOk) return opened.exit_code;

  const auto summary =
      run_tournament(options, executors_in(options.folder), progress, watch_interrupts());
  progress.clear();
  if (!summary) return print_error(kWriteFailed, summary.error().message);
  progress.finish_generation(summary->progress.seconds);

  if (summary->end == RunEnd::kComplete) {
    if (write_error.empty()) write_error = summary->write_error;
    tuning.record(race_results(tuning.config(), race, summary->matches));
    return kOk;
  }

  const int code = summary->end == RunEnd::kInterrupted ? signal_exit_code(summary->signal)
                   : summary->end == RunEnd::kFault     ? kFailed
                                                        : kInterrupted;
  return end_session(*summary, options.config, arguments.session, code, false);
}

int write_result(const Tuning& tuning, const fs::path& folder) {
  for (const auto& [name, text] :
       {std::pair{fs::path(kBestFile), values_text(tuning.config(), tuning.best())},
        {fs::path("search.svg"), tune_picture(tuning)}}) {
    TRY_OR(kWriteFailed, base::write_file(folder / name, text));
  }
  return kOk;
}

// `write_error`: why an event is lost, which ends no search.
int search(const TuneSetup& setup, Tuning& tuning, const TuneRunArguments& arguments,
           std::string& write_error) {
  const fs::path folder = arguments.options.folder;
  TuneProgress progress(tuning, stderr_is_terminal(), arguments.session.quiet);
  while (!tuning.finished()) {
    TRY_STEP(play_generation(setup, tuning, arguments, progress, write_error));
    TRY_STEP(write_result(tuning, folder));
    if (!arguments.session.quiet) fmt::print(stderr, "{}\n", generation_line(tuning));
  }
  return kOk;
}

// Renames what an earlier search wrote; tune.toml and its template stay.
int set_search_aside(const fs::path& folder) {
  std::error_code code;
  for (const char* name : {"generations", kVerdictFolder, kTunePlanFile}) {
    if (!fs::exists(folder / name, code)) continue;
    TRY_OR(kCannotCreate, base::set_aside(folder / name));
  }
  return kOk;
}

// The final comparison; after more generations it starts over with other values.
int compare_best(const TuneSetup& setup, const Tuning& tuning, const TuneRunArguments& arguments) {
  if (setup.tune.verdict_pairs == 0) return kOk;
  const fs::path folder = arguments.options.folder;
  Comparison comparison;
  TRY_STEP(make_verdict(setup, tuning, folder, comparison));

  if (!check_plan(folder / kVerdictFolder, comparison.config)) {
    TRY_OR(kCannotCreate, base::set_aside(folder / kVerdictFolder));
    TRY_STEP(make_verdict(setup, tuning, folder, comparison));
  }
  SessionOptions session = arguments.session;
  session.force = false;
  return run_comparison(comparison, folder / kVerdictFolder, session, false);
}

int run_tune(const TuneRunArguments& arguments) {
  TuneSetup setup;
  TRY_STEP(make_tune_setup(arguments.options, setup));
  if (arguments.generations) setup.tune.generations = *arguments.generations;

  const fs::path folder = arguments.options.folder;
  TRY_INIT_OR(kCannotCreate, const auto lock, FolderLock::try_lock(folder));
  if (!lock) {
    return print_error(kTryAgain, "{}: another `cls tune run` is in progress", folder.string());
  }

  if (arguments.session.force) {
    TRY_STEP(set_search_aside(folder));
  }
  TRY_STEP(check_tune_plan(folder, setup.tune));

  Tuning tuning(setup.tune);
  TRY_OR(kBadData, replay_generations(tuning, folder));
  std::string write_error;
  TRY_STEP(search(setup, tuning, arguments, write_error));

  const int exit_code = compare_best(setup, tuning, arguments);
  const auto verdict = known_verdict(setup.tune, folder);
  fmt::print("{}", arguments.session.json ? tune_json(tuning, verdict)
                                          : tune_text(tuning, verdict, stdout_width()));
  if (write_error.empty() || exit_code != kOk) return exit_code;
  return print_error(kWriteFailed, write_error);
}

}  // namespace

void add_tune_run_command(Command& app) {
  auto [command, arguments] = app.command("run", kTuneRunDescription, run_tune);
  command.option("DIR", arguments.options.folder, "folder of tune.toml").required();
  command
      .option("--generations", arguments.generations,
              "number of generations (default: that of tune.toml)")
      .above(0);
  add_condition_options(command, arguments.options);
  add_session_options(command, arguments.session, "report");
}

}  // namespace cls::cli
