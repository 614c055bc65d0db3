// `cls compare NEW BASE`: pairs of matches until a sequential test (SPRT) decides.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/text/fnv1a.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/compare_progress.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/tournament/config/config_file.h"
#include "orchestration/tournament/report/comparison.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;
namespace match = orchestration::match;

constexpr const char* kDescription =
    "test whether NEW is better than BASE\n"
    "Plays pairs of matches with one seed and swapped sides until a sequential\n"
    "probability ratio test (SPRT) decides.\n"
    "\n"
    "  cls compare NEW OLD                         teams of cls.toml\n"
    "  cls compare localhost:50051 mock --elo1 80  or any sides\n"
    "  cls compare NEW OLD --opponents A,B         both against each, same seeds\n"
    "\n"
    "H0: NEW is --elo0 better than BASE; H1: it is --elo1 better. Exit code: 0 if H1\n"
    "is accepted (NEW is better), 1 if H0 is accepted, 3 if the test is undecided\n"
    "after --max-pairs. The same command resumes, also with another --max-pairs;\n"
    "other sides, seed or match settings have another folder.";

struct Arguments {
  std::string candidate;
  std::string base;
  std::vector<std::string> opponents;
  TournamentOptions options;
  SprtSettings sprt;
  std::optional<int> max_pairs;
  SessionOptions session;
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

// Derived from the plan, so that the same command finds it again.
fs::path folder_of(const Arguments& arguments, const Comparison& comparison) {
  if (!arguments.options.folder.empty()) return arguments.options.folder;
  const TournamentConfig& config = comparison.config;
  const auto plan = static_cast<std::uint32_t>(base::fnv1a(format_config(config, true)));
  return fs::path("runs") /
         fmt::format("compare-{}-{}-{:08x}", config.teams[0].name, config.teams[1].name, plan);
}

int exit_code_of(const RunSummary& summary, const ComparisonVerdict& known) {
  if (known.state.decision == SprtDecision::kH1) return kOk;
  if (known.state.decision == SprtDecision::kH0) return kFailed;
  if (summary.end == RunEnd::kInterrupted) return signal_exit_code(summary.signal);
  return summary.end == RunEnd::kStopRequested ? kInterrupted : kUndecided;
}

int run(const Arguments& arguments) {
  Comparison comparison;
  if (const int code = make_comparison(arguments, comparison); code != kOk) return code;
  const SessionOptions& session = arguments.session;
  RunOptions options;
  options.folder = folder_of(arguments, comparison);
  options.config = comparison.config;
  options.last_match = last_match(comparison);
  options.next = [&](std::span<const ScheduledMatch> so_far) {
    return next_fixtures(comparison, so_far);
  };
  ComparisonVerdict known;
  options.decided = [&](std::span<const ScheduledMatch> matches) {
    known = verdict(comparison, matches);
    return known.state.decision != SprtDecision::kOpen;
  };
  const auto outlook_of = [&](const std::vector<ScheduledMatch>& matches) {
    const ComparisonVerdict so_far = verdict(comparison, matches);
    return Outlook{
        expected_samples_left(comparison, so_far) * matches_in_sample(comparison),
        fmt::format("{}/: {}", options.folder.string(), comparison_outlook(comparison, so_far))};
  };
  const OpenedFolder opened = begin_session(options.folder, options.config, session, outlook_of);
  if (opened.exit_code != kOk) return opened.exit_code;
  known = verdict(comparison, opened.matches);
  CompareProgress progress(comparison, known, stderr_is_terminal(), session.quiet);
  const auto make = [&](const TournamentConfig& config) {
    return make_executor(config, options.folder, own_program());
  };
  const auto summary = run_tournament(options, make, progress, watch_interrupts());
  progress.clear();
  if (!summary) return print_error(kWriteFailed, summary.error().message);
  fmt::print("{}", session.json ? comparison_json(comparison, summary->matches)
                                : comparison_text(comparison, summary->matches, stdout_width()));
  if (!session.json) fmt::print("{}/\n", options.folder.string());
  const int exit_code =
      end_session(*summary, options.config, session, exit_code_of(*summary, known), false);
  if (summary->end == RunEnd::kComplete && !session.quiet) {
    print_error(0, "undecided; the same command with a larger --max-pairs continues");
  }
  return exit_code;
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
  command->add_option("--dir", arguments->options.folder,
                      "folder (default: ./runs/compare-<NEW>-<BASE>-<hash of the plan>)");
  add_condition_options(*command, arguments->options);
  add_session_options(*command, arguments->session, "verdict");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
