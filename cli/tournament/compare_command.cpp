// `cls compare NEW BASE`: pairs of matches until a sequential test decides.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/fnv1a.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/tournament/comparison_run.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "match/terms/endpoint.h"
#include "tournament/config/config_file.h"
#include "tournament/report/comparison.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;
namespace match = match;

constexpr const char* kCompareDescription =
    "test whether NEW is better than BASE\n"
    "Plays pairs of matches with one seed and swapped sides until a sequential\n"
    "test decides; a larger difference is decided sooner.\n"
    "\n"
    "  cls compare NEW OLD                         teams of cls.toml\n"
    "  cls compare localhost:50051 mock --elo1 80  or any sides\n"
    "  cls compare NEW OLD --opponents A,B         both against each, same seeds\n"
    "  cls compare NEW OLD --measure goals         by goal difference\n"
    "  cls compare NEW OLD --book moments.book.gz  on situations of a book\n"
    "\n"
    "NEW is better if it is better than BASE by more than --elo0, with confidence\n"
    "1 - alpha, and not better if it is better by less than --elo1, with confidence\n"
    "1 - beta (with goals and with --book: --goals0, --goals1).\n"
    "Exit code: 0 better, 1 not better, 3 undecided after --max-pairs. The same\n"
    "command resumes, also with another test or --max-pairs; other sides, seed or\n"
    "match settings have another folder.";

struct CompareArguments {
  std::string candidate;
  std::string base;
  std::vector<std::string> opponents;
  TournamentOptions options;
  TestSettings test;
  std::string test_name = "betting";
  std::string measure;
  std::optional<int> max_goals;
  std::optional<int> max_pairs;
  SessionOptions session;
};

// Adds `side` as a team with a distinct name. Returns an exit code.
int add_team(TournamentConfig& config, std::string side, const std::string& suffix,
             const std::string& config_file) {
  std::string name;
  TRY_STEP(resolve_team_name(side, name, config_file));
  TRY_INIT_OR(kUsage, const auto endpoint, parse_side(side, config_file));

  constexpr std::size_t kMaxStem = 10;
  if (name.empty()) {
    name = match::default_team_name(endpoint);
    if (team_index(config.competition, name) >= 0) name = name.substr(0, kMaxStem) + suffix;
  }

  if (team_index(config.competition, name) >= 0) {
    return print_error(kUsage, "'{}' is named twice", side);
  }
  config.competition.teams.push_back({name, side});
  return kOk;
}

// Situations have values, whole matches points and goals.
int choose_measure(const CompareArguments& arguments, Comparison& comparison) {
  match::MatchOptions options = match_options(comparison.config.conditions);
  if (const auto loaded = match::load_book(options); !loaded) {
    return print_error(exit_code_of_book(options.book), "--book: " + loaded.error().message);
  }

  const bool book = !options.book.empty();
  const std::string measure =
      arguments.measure.empty() ? (book ? "value" : "points") : arguments.measure;
  if (measure == "value" && !book) {
    return print_error(kUsage, "--measure value needs --book: whole matches have points and goals");
  }

  if (measure == "points") comparison.test.measure = Measure::kPoints;
  if (measure == "goals") comparison.test.measure = Measure::kGoals;
  if (measure == "value") {
    comparison.test.measure = Measure::kValue;
    comparison.test.max_goals = kMaxValue;
  }
  if (arguments.max_goals) comparison.test.max_goals = *arguments.max_goals;
  return kOk;
}

int make_comparison(const CompareArguments& arguments, Comparison& comparison) {
  ChosenConfig chosen = choose_conditions(arguments.options);
  if (chosen.exit_code != kOk) return chosen.exit_code;

  TournamentConfig& config = comparison.config;
  config = std::move(chosen.config);
  config.competition.format = Format::kList;
  config.competition.rounds.reset();
  config.competition.swap_sides = true;
  config.competition.gauntlet.clear();
  config.competition.teams.clear();
  // Sides are resolved for the working directory already.
  config.execution.folder = fs::current_path();

  const std::string& file = arguments.options.config_file;
  TRY_STEP(add_team(config, arguments.candidate, "", file));
  TRY_STEP(add_team(config, arguments.base, "_base", file));
  for (const std::string& opponent : arguments.opponents) {
    TRY_STEP(add_team(config, opponent, "_opp", file));
  }

  config.competition.matches = {
      {config.competition.teams[0].name, config.competition.teams[1].name}};
  comparison.test = arguments.test;
  comparison.test.kind = arguments.test_name == "sprt" ? TestKind::kSprt : TestKind::kBetting;
  TRY_STEP(choose_measure(arguments, comparison));
  comparison.max_samples = arguments.max_pairs;

  const auto errors = validate(config);
  print_errors(kUsage, errors);
  const std::string error = test_error(comparison.test);
  if (!error.empty()) return print_error(kUsage, error);
  return errors.empty() ? kOk : kUsage;
}

// Derived from the plan, so that the same command finds it again.
fs::path folder_of(const CompareArguments& arguments, const Comparison& comparison) {
  if (!arguments.options.folder.empty()) return arguments.options.folder;

  const TournamentConfig& config = comparison.config;
  const auto plan = static_cast<std::uint32_t>(base::fnv1a(format_config(config, true)));
  return fs::path("runs") / fmt::format("compare-{}-{}-{:08x}", config.competition.teams[0].name,
                                        config.competition.teams[1].name, plan);
}

int run_compare(const CompareArguments& arguments) {
  Comparison comparison;
  TRY_STEP(make_comparison(arguments, comparison));

  const fs::path folder = folder_of(arguments, comparison);
  if (arguments.options.folder.empty()) {
    if (const auto created = base::create_folders(folder.parent_path()); !created) {
      return print_error(kCannotCreate, created.error().message + "; --dir selects another folder");
    }
  }
  return run_comparison(comparison, folder, arguments.session);
}

void add_test_options(Command& command, CompareArguments& arguments) {
  TestSettings& test = arguments.test;
  command
      .setting("--test WHICH", arguments.test_name,
               "betting adapts to the difference; sprt as in chess engine testing")
      .one_of({"betting", "sprt"});

  command
      .option(
          "--measure WHAT", arguments.measure,
          "what counts: points, goals (difference), or with --book value (default: points, with "
          "--book value)")
      .one_of({"points", "goals", "value"});

  command.setting("--elo0", test.elo0, "Elo difference of H0");
  command.setting("--elo1", test.elo1, "Elo difference of H1");
  command.setting("--goals0", test.goals0,
                  "with --measure goals or value: goal difference per match under H0");
  command.setting("--goals1", test.goals1,
                  "with --measure goals or value: goal difference per match under H1");

  command
      .option("--max-goals", arguments.max_goals,
              "a goal difference or value above it counts as this (default: 3, with --book 8)")
      .range(1, 100);
  command.setting("--alpha", test.alpha,
                  "probability of a type I error (NEW wrongly called better)");
  command.setting("--beta", test.beta,
                  "probability of a type II error (NEW wrongly called not better)");
}

}  // namespace

void add_compare_command(Command& app) {
  auto [command, arguments] = app.command("compare", kCompareDescription, run_compare);
  command.group = kPlayCommands;
  command.starts_programs = true;

  command.option("NEW", arguments.candidate, "the team under test").required();
  command.option("BASE", arguments.base, "the reference team").required();
  command
      .option("--opponents A,B,...", arguments.opponents,
              "opponents of both teams: A,B,... (default: each other)")
      .of_group(kTeamsGroup)
      .split_at(',')
      .takes(1);

  add_test_options(command, arguments);
  command
      .option("--max-pairs", arguments.max_pairs,
              "maximum pairs; with --opponents: per team (default: no limit)")
      .above(0);

  command.option("--dir DIR", arguments.options.folder,
                 "folder (default: ./runs/compare-<NEW>-<BASE>-<hash of the plan>)");
  add_condition_options(command, arguments.options);
  add_session_options(command, arguments.session, "verdict");
}

}  // namespace cls::cli
