// `cls compare NEW BASE`: pairs of matches until a sequential test (SPRT) decides.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/system/host.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/tournament_options.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/tournament/report/comparison.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;
namespace match = orchestration::match;

constexpr const char* kDescription =
    "test whether NEW is better than BASE\n"
    "Plays pairs of matches with one seed and swapped sides until a sequential probability\n"
    "ratio test (SPRT) decides.\n"
    "\n"
    "  cls compare NEW OLD                          teams of cls.toml\n"
    "  cls compare localhost:50051 mock --elo1 80   or any sides\n"
    "  cls compare NEW OLD --opponents A,B          both against each, with the same seeds\n"
    "\n"
    "H0: NEW is --elo0 better than BASE; H1: it is --elo1 better. Exit code: 0 if H1 is\n"
    "accepted, 1 if H0 is accepted or the test is undecided after --max-pairs.";

struct Arguments {
  std::string candidate;
  std::string base;
  std::vector<std::string> opponents;
  TournamentOptions options;
  SprtSettings sprt;
  std::optional<int> max_pairs;
  bool json = false;
  bool quiet = false;
};

// Adds `side` as a team with a distinct name. Returns an exit code.
int add_team(TournamentConfig& config, std::string side, const std::string& suffix,
             const std::string& config_file) {
  std::string name;
  if (const int exit_code = resolve_team_name(side, name, config_file); exit_code != kOk) {
    return exit_code;
  }
  const auto endpoint = match::parse_endpoint(side);
  if (!endpoint) return print_error(kUsage, endpoint.error().message);
  constexpr std::size_t kMaxStem = 10;
  if (name.empty()) {
    name = match::default_team_name(*endpoint);
    if (team_index(config, name) >= 0) name = name.substr(0, kMaxStem) + suffix;
  }
  if (team_index(config, name) >= 0) {
    return print_error(kUsage, fmt::format("'{}' is named twice", side));
  }
  config.teams.push_back({name, side});
  return kOk;
}

int make_comparison(const Arguments& arguments, Comparison& comparison) {
  ChosenConfig chosen = choose_conditions(arguments.options);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  TournamentConfig& config = comparison.config;
  config = std::move(chosen.config);
  config.format = Format::kList;
  config.rounds.reset();
  config.swap_sides = true;
  config.gauntlet.clear();
  config.teams.clear();
  // Sides are resolved for the working directory already.
  config.folder = fs::current_path();
  const std::string& file = arguments.options.config_file;
  if (const int code = add_team(config, arguments.candidate, "", file); code != kOk) return code;
  if (const int code = add_team(config, arguments.base, "_base", file); code != kOk) return code;
  for (const std::string& opponent : arguments.opponents) {
    if (const int code = add_team(config, opponent, "_opp", file); code != kOk) return code;
  }
  config.matches = {{config.teams[0].name, config.teams[1].name}};
  comparison.sprt = arguments.sprt;
  comparison.max_samples = arguments.max_pairs;
  const auto errors = validate(config);
  print_errors(kUsage, errors);
  const SprtSettings& sprt = comparison.sprt;
  if (sprt.elo0 >= sprt.elo1) return print_error(kUsage, "--elo0 must be below --elo1");
  const auto is_rate = [](double rate) { return rate > 0 && rate < 0.5; };
  if (!is_rate(sprt.alpha) || !is_rate(sprt.beta)) {
    return print_error(kUsage, "--alpha and --beta must be between 0 and 0.5");
  }
  return errors.empty() ? kOk : kUsage;
}

fs::path folder_of(const Arguments& arguments, const Comparison& comparison) {
  if (!arguments.options.folder.empty()) return arguments.options.folder;
  return fs::path("runs") / fmt::format("{}-compare-{}-{}", base::utc_stamp(),
                                        comparison.config.teams[0].name,
                                        comparison.config.teams[1].name);
}

int exit_code_of(const RunSummary& summary, const ComparisonVerdict& known) {
  if (known.state.decision == SprtDecision::kH1) return kOk;
  if (known.state.decision == SprtDecision::kH0) return kFailed;
  if (summary.end == RunEnd::kInterrupted) {
    return signal_exit_code(summary.signal);
  }
  return summary.end == RunEnd::kStopRequested ? kInterrupted : kFailed;
}

int run(const Arguments& arguments) {
  Comparison comparison;
  if (const int code = make_comparison(arguments, comparison); code != kOk) return code;
  RunOptions options;
  options.folder = folder_of(arguments, comparison);
  options.config = comparison.config;
  options.next = [&](std::span<const ScheduledMatch> so_far) {
    return next_fixtures(comparison, so_far);
  };
  options.decided = [&](std::span<const ScheduledMatch> matches) {
    return verdict(comparison, matches).state.decision != SprtDecision::kOpen;
  };
  if (const auto ready = prepare_folder(options.folder, options.config); !ready) {
    return print_error(holds_plan(options.folder) ? kBadConfig : kCannotCreate,
                       ready.error().message);
  }
  const auto lock = FolderLock::try_lock(options.folder);
  if (!lock) return print_error(kCannotCreate, lock.error().message);
  if (!*lock) return print_error(kTryAgain, options.folder.string() + ": in use by another cls");
  TournamentProgress progress(stderr_is_terminal() && !arguments.quiet, arguments.quiet);
  const auto make = [&](const TournamentConfig& config) {
    return make_executor(config, options.folder, own_program());
  };
  const auto summary = run_tournament(options, make, progress, watch_interrupts());
  progress.clear();
  if (!summary) return print_error(kWriteFailed, summary.error().message);
  fmt::print("{}", arguments.json ? comparison_json(comparison, summary->matches)
                                  : comparison_text(comparison, summary->matches));
  if (!arguments.json) fmt::print("{}/\n", options.folder.string());
  if (!summary->message.empty()) print_error(0, summary->message);
  return exit_code_of(*summary, verdict(comparison, summary->matches));
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("compare", kDescription);
  command->add_option("NEW", arguments->candidate, "the team under test")->required();
  command->add_option("BASE", arguments->base, "the reference team")->required();
  command
      ->add_option("--opponents", arguments->opponents,
                   "opponents of both teams: A,B,... (default: each other)")
      ->delimiter(',')
      ->expected(1);
  command->add_option("--elo0", arguments->sprt.elo0, "Elo difference of H0")
      ->capture_default_str();
  command->add_option("--elo1", arguments->sprt.elo1, "Elo difference of H1")
      ->capture_default_str();
  command
      ->add_option("--alpha", arguments->sprt.alpha,
                   "probability of a type I error (accept H1 wrongly)")
      ->capture_default_str();
  command
      ->add_option("--beta", arguments->sprt.beta,
                   "probability of a type II error (accept H0 wrongly)")
      ->capture_default_str();
  command
      ->add_option("--max-pairs", arguments->max_pairs,
                   "maximum pairs; with --opponents: per team (default: no limit)")
      ->check(CLI::PositiveNumber);
  command->add_option(
      "--dir", arguments->options.folder,
      "folder; an existing one is resumed (default: ./runs/<UTC>-compare-<NEW>-<BASE>)");
  add_condition_options(*command, arguments->options);
  command->add_flag("--json", arguments->json, "print only the verdict as JSON");
  command->add_flag("--quiet", arguments->quiet, "print no progress and no notes");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
