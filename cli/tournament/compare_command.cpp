// Pairs of matches until a sequential test knows the answer.
#include "cli/tournament/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "base/system/host.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/named_side.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/tournament_options.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/tournament/report/comparison.h"
#include "orchestration/tournament/report/comparison_report.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;
namespace match = orchestration::match;

constexpr const char* kDescription =
    "Is NEW better than BASE? Plays matches until that is known.\n"
    "They come in pairs, sides swapped on one seed; a sequential test (SPRT) tells when to stop.\n"
    "\n"
    "  cls compare NEW OLD                          teams of cls.toml\n"
    "  cls compare localhost:50051 mock --elo1 80   or any sides\n"
    "  cls compare NEW OLD --opponents A,B          both against each, on the same seeds\n"
    "\n"
    "H0: NEW is --elo0 better than BASE, H1: it is --elo1 better. The exit code is 0 when H1 is\n"
    "accepted, 1 when H0 is, or when it is not known after --max-pairs.";

struct Arguments {
  std::string ours;
  std::string base;
  std::vector<std::string> opponents;
  TournamentOptions options;
  SprtSettings sprt;
  std::optional<int> max_pairs;
  bool json = false;
  bool quiet = false;
};

// `side` as a team with a name that no other of `config` has, or an exit code.
int add_team(TournamentConfig& config, std::string side, const std::string& suffix,
             const std::string& config_file) {
  std::string name;
  if (const int exit_code = resolve_named_side(side, name, config_file); exit_code != kDone) {
    return exit_code;
  }
  const auto endpoint = match::parse_endpoint(side);
  if (!endpoint) return complain(kUsage, endpoint.error().message);
  constexpr std::size_t kLongestStem = 10;
  if (name.empty()) {
    name = match::default_team_name(*endpoint);
    if (team_index(config, name) >= 0) name = name.substr(0, kLongestStem) + suffix;
  }
  if (team_index(config, name) >= 0) {
    return complain(kUsage, fmt::format("'{}' is named twice", side));
  }
  config.teams.push_back({name, side});
  return kDone;
}

int make_comparison(const Arguments& arguments, Comparison& comparison) {
  ChosenConfig chosen = choose_conditions(arguments.options);
  if (chosen.exit_code != kDone) return chosen.exit_code;
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
  if (const int code = add_team(config, arguments.ours, "", file); code != kDone) return code;
  if (const int code = add_team(config, arguments.base, "_base", file); code != kDone) return code;
  for (const std::string& opponent : arguments.opponents) {
    if (const int code = add_team(config, opponent, "_opp", file); code != kDone) return code;
  }
  config.matches = {{config.teams[0].name, config.teams[1].name}};
  comparison.sprt = arguments.sprt;
  comparison.max_samples = arguments.max_pairs;
  const auto mistakes = mistakes_in(config);
  for (const std::string& mistake : mistakes) complain(kUsage, mistake);
  const SprtSettings& sprt = comparison.sprt;
  if (sprt.elo0 >= sprt.elo1) return complain(kUsage, "--elo0 must be below --elo1");
  const auto is_rate = [](double rate) { return rate > 0 && rate < 0.5; };
  if (!is_rate(sprt.alpha) || !is_rate(sprt.beta)) {
    return complain(kUsage, "--alpha and --beta must be between 0 and 0.5");
  }
  return mistakes.empty() ? kDone : kUsage;
}

fs::path folder_of(const Arguments& arguments, const Comparison& comparison) {
  if (!arguments.options.folder.empty()) return arguments.options.folder;
  return fs::path("runs") / fmt::format("{}-compare-{}-{}", base::utc_stamp(),
                                        comparison.config.teams[0].name,
                                        comparison.config.teams[1].name);
}

int exit_code_of(const RunSummary& summary, const ComparisonVerdict& known) {
  if (known.state.answer == SprtAnswer::kH1) return kDone;
  if (known.state.answer == SprtAnswer::kH0) return kAnswerIsNo;
  if (summary.end == RunEnd::kInterrupted) {
    return summary.signal == SIGTERM ? kTerminated : kInterrupted;
  }
  return summary.end == RunEnd::kStopRequested ? kInterrupted : kAnswerIsNo;
}

int run(const Arguments& arguments) {
  Comparison comparison;
  if (const int code = make_comparison(arguments, comparison); code != kDone) return code;
  RunOptions options;
  options.folder = folder_of(arguments, comparison);
  options.config = comparison.config;
  options.next = [&](std::span<const ScheduledMatch> so_far) {
    return next_fixtures(comparison, so_far);
  };
  options.enough = [&](std::span<const ScheduledMatch> matches) {
    return verdict(comparison, matches).state.answer != SprtAnswer::kOpen;
  };
  if (const auto ready = prepare_folder(options.folder, options.config); !ready) {
    return complain(holds_plan(options.folder) ? kBadConfig : kCannotCreate, ready.error().message);
  }
  const auto lock = FolderLock::take(options.folder);
  if (!lock) return complain(kCannotCreate, lock.error().message);
  if (!*lock) return complain(kTryAgain, options.folder.string() + " is in use by another cls");
  TournamentProgress progress(stderr_is_terminal() && !arguments.quiet, arguments.quiet);
  const auto make = [&](const TournamentConfig& config) {
    return make_executor(config, options.folder, own_program());
  };
  const auto summary = run_tournament(options, make, progress, watch_interrupts());
  progress.clear();
  if (!summary) return complain(kWriteFailed, summary.error().message);
  fmt::print("{}", arguments.json ? comparison_json(comparison, summary->matches)
                                  : comparison_text(comparison, summary->matches));
  if (!arguments.json) fmt::print("{}/\n", options.folder.string());
  if (!summary->message.empty()) complain(0, summary->message);
  return exit_code_of(*summary, verdict(comparison, summary->matches));
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("compare", kDescription);
  command->add_option("NEW", arguments->ours, "the team in question")->required();
  command->add_option("BASE", arguments->base, "the team it is held against")->required();
  command->add_option("--opponents", arguments->opponents, "teams that both play instead, A,B,...")
      ->delimiter(',')
      ->expected(1);
  command->add_option("--elo0", arguments->sprt.elo0, "Elo difference of H0 (0)");
  command->add_option("--elo1", arguments->sprt.elo1, "Elo difference of H1 (40)");
  command->add_option("--alpha", arguments->sprt.alpha, "probability to accept H1 wrongly (0.05)");
  command->add_option("--beta", arguments->sprt.beta, "probability to accept H0 wrongly (0.05)");
  command
      ->add_option("--max-pairs", arguments->max_pairs,
                   "end undecided after so many pairs (none; with opponents: of each team)")
      ->check(CLI::PositiveNumber);
  command->add_option("--dir", arguments->options.folder,
                      "folder (./runs/<UTC>-compare-<NEW>-<BASE>); again: goes on");
  add_condition_options(*command, arguments->options);
  command->add_flag("--json", arguments->json, "print the verdict as JSON, nothing else");
  command->add_flag("--quiet", arguments->quiet, "no progress, no notes");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
