// `cls review LOG...`: what cost a team most, and what would have been better.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "base/text/suggestion.h"
#include "cli/logs/counted_logs.h"
#include "cli/logs/review_replays.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/log_progress.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcg/rcg_reader.h"
#include "review/review.h"

namespace cls::cli {
namespace {

using review::Review;
using review::ReviewedMatch;
using soccer::Side;

constexpr const char* kReviewDescription =
    "find what cost a team most, and what would have been better\n"
    "Goals against and wasted chances by how they came about. --reference compares\n"
    "the team with another one, best against the same opponent. With\n"
    "--replay-decisions the costliest decisions with the ball are played again, each\n"
    "with what the player did and with every alternative, and the difference is\n"
    "estimated in goals (docs/review.md).\n"
    "\n"
    "  cls review runs/                           one team of all matches\n"
    "  cls review game.rcg.gz --side right\n"
    "  cls review runs/ --reference planner-runs/  what does a better team do?\n"
    "  cls review cup/matches --team ADA --replay-decisions 10\n"
    "\n"
    "LOG is a game log (rcg), a folder, or a pattern.";

constexpr const char* kReplayGroup = "Decisions played again";

struct ReviewArguments {
  std::vector<std::string> logs;
  std::string team;
  std::string side;
  std::vector<std::string> reference;
  review::PlayoutTerms terms;
  ReplayOptions replays;
  std::string scenarios;
  std::size_t rows = 5;
  bool json = false;
};

const std::string& name_of(const gamelog::MatchRecord& record, Side side) {
  return record.final_teams()[soccer::side_index(side)].name;
}

// Reads the logs; those that cannot be read are reported and left out.
int read_logs(const std::vector<std::string>& logs, std::vector<LoadedMatch>& matches) {
  const gamelog::FoundLogs found = find_counted_logs(logs);
  int exit_code = report_missing(found);
  LogProgress progress(found.matches.size());
  for (std::size_t i = 0; i < found.matches.size(); ++i) {
    if (watch_interrupts() != 0) return signal_exit_code(watch_interrupts());
    progress.update(i);
    const std::string& game = found.matches[i].game;
    if (game.empty()) continue;

    auto record = gamelog::read_rcg_file(game);
    if (!record) {
      exit_code = report_log(exit_code, record.error().message, game, {});
      continue;
    }
    exit_code = report_log(exit_code, "", game, record->errors);
    if (record->frames() > 0) matches.push_back({found.matches[i], *std::move(record)});
  }
  return exit_code;
}

// The team of --team or --side; else the one that plays longest, on the left of the first match if
// both do: a folder may have the scenarios of `cls test`, too.
std::string choose_team(const ReviewArguments& arguments, const std::vector<LoadedMatch>& matches) {
  if (!arguments.team.empty()) return arguments.team;
  const Side wanted = soccer::parse_side(arguments.side).value_or(Side::kLeft);
  std::string team = name_of(matches.front().record, wanted);
  if (!arguments.side.empty()) return team;

  std::map<std::string, std::size_t> frames;
  for (const LoadedMatch& match : matches) {
    for (const Side side : soccer::kBothSides) {
      frames[name_of(match.record, side)] += match.record.frames();
    }
  }
  for (const auto& [name, count] : frames) {
    if (count > frames[team]) team = name;
  }
  return team;
}

// "; did you mean 'NAME'?", or nothing.
std::string nearest_team(const std::string& team, const std::vector<LoadedMatch>& matches) {
  std::vector<std::string_view> names;
  for (const LoadedMatch& match : matches) {
    for (const Side side : soccer::kBothSides) names.push_back(name_of(match.record, side));
  }
  return base::did_you_mean(team, names);
}

// The side of `team` in a match; neutral: it does not play. In a match of twins --side decides.
Side side_of_team(const ReviewArguments& arguments, const gamelog::MatchRecord& record,
                  const std::string& team) {
  const Side first = soccer::parse_side(arguments.side).value_or(Side::kLeft);
  for (const Side side : {first, soccer::opponent(first)}) {
    if (name_of(record, side) == team) return side;
  }
  return Side::kNeutral;
}

ReviewedMatch review_match(const LoadedMatch& match, const analysis::MatchStatistics& statistics,
                           Side side) {
  const gamelog::TeamFrames& teams = match.record.final_teams();
  const std::size_t own = soccer::side_index(side);
  const std::filesystem::path file(match.logs.game);

  ReviewedMatch reviewed;
  reviewed.file = match.logs.game;
  const bool is_match_folder = file.filename().string().starts_with("match.");
  reviewed.folder =
      is_match_folder && file.has_parent_path() ? file.parent_path().string() : file.string();
  reviewed.side = side;
  reviewed.opponent = teams[1 - own].name;
  reviewed.goals = teams[own].score;
  reviewed.goals_against = teams[1 - own].score;
  reviewed.chances = review::find_chances(statistics, side);
  return reviewed;
}

// Compares the team, of which `figures` are, with the team of --reference: in each of its matches
// the one that the reviewed team did not play against.
int compare_with_reference(const ReviewArguments& arguments,
                           const std::vector<review::Figures>& figures, Review& review) {
  std::vector<LoadedMatch> logs;
  const int exit_code = read_logs(arguments.reference, logs);
  if (logs.empty()) {
    return exit_code != kOk ? exit_code : print_error(kNoInput, "--reference: no game log");
  }
  if (figures.size() < 2 || logs.size() < 2) {
    return print_error(kUsage,
                       "--reference: needs two matches of each team at least, has {} and {}",
                       figures.size(), logs.size());
  }

  std::set<std::string> opponents;
  for (const ReviewedMatch& match : review.matches) opponents.insert(match.opponent);
  std::vector<review::Figures> others;
  std::set<std::string> teams;
  for (const LoadedMatch& match : logs) {
    const bool is_right = opponents.contains(name_of(match.record, Side::kLeft)) &&
                          !opponents.contains(name_of(match.record, Side::kRight));
    const Side side = is_right ? Side::kRight : Side::kLeft;
    teams.insert(name_of(match.record, side));
    others.push_back(review::figures_of(analysis::summarize(match.record, nullptr),
                                        analysis::compute_statistics(match.record, nullptr), side));
  }
  review.reference = {fmt::format("{}", fmt::join(teams, ", ")), others.size(),
                      review::differences(figures, others)};
  return exit_code;
}

// What is wrong with the arguments: kOk, or an exit code after an error line.
int check_arguments(const ReviewArguments& arguments) {
  const std::string& continued_by = arguments.replays.continued_by;
  const auto driver = training::kDriverNames.parse(continued_by);
  if (!driver || !training::perceives(*driver)) {
    return print_error(kUsage, "--continue '{}': must be planner or mock", continued_by);
  }
  if (!arguments.replays.save.empty() && arguments.replays.decisions == 0) {
    return print_error(kUsage, "--save: needs --replay-decisions");
  }
  if (!arguments.scenarios.empty() && arguments.replays.decisions == 0) {
    return print_error(kUsage, "--scenarios: needs --replay-decisions");
  }
  return kOk;
}

int run_review_command(const ReviewArguments& arguments) {
  TRY_STEP(check_arguments(arguments));
  std::vector<LoadedMatch> logs;
  int exit_code = read_logs(arguments.logs, logs);
  if (logs.empty()) return exit_code != kOk ? exit_code : print_error(kNoInput, "no game log");

  Review review;
  review.team = choose_team(arguments, logs);
  review.terms = arguments.terms;
  review.continued_by =
      arguments.replays.continued_by == "mock" ? "mock's simple team" : "bundled planner";

  Replays replays(arguments.replays, review);
  TRY_STEP(replays.continue_saved());
  std::vector<review::Figures> figures;
  for (const LoadedMatch& match : logs) {
    const Side side = side_of_team(arguments, match.record, review.team);
    if (side == Side::kNeutral) continue;
    analysis::MatchStatistics statistics = analysis::compute_statistics(match.record, nullptr);
    review.matches.push_back(review_match(match, statistics, side));
    if (!arguments.reference.empty()) {
      const analysis::MatchSummary summary = analysis::summarize(match.record, nullptr);
      figures.push_back(review::figures_of(summary, statistics, side));
    }
    replays.add(match, std::move(statistics), side);
  }
  if (review.matches.empty()) {
    return print_error(kNoInput, "--team '{}': plays in none of these matches{}", review.team,
                       nearest_team(review.team, logs));
  }

  if (!arguments.reference.empty()) {
    const int read = compare_with_reference(arguments, figures, review);
    if (!review.reference) return read;
    if (exit_code == kOk) exit_code = read;
  }
  if (arguments.replays.decisions > 0) TRY_STEP(replays.play());
  if (!arguments.scenarios.empty()) TRY_STEP(replays.write_scenarios(arguments.scenarios));
  if (arguments.json) {
    print_json(to_json(review));
  } else {
    fmt::print("{}", to_text(review, arguments.rows));
  }
  return review.interrupted ? signal_exit_code(watch_interrupts()) : exit_code;
}

}  // namespace

void add_review_command(Command& app) {
  auto [command, arguments] = app.command("review", kReviewDescription, run_review_command);
  command.group = kResultCommands;
  command.option("LOG", arguments.logs, "game logs, folders or patterns").required();
  command.option("--team NAME", arguments.team, "the team (default: the one that plays longest)");
  command
      .option("--side SIDE", arguments.side,
              "left or right: the team of that side in the first match")
      .one_of({"left", "right"});

  command.option("--reference LOG", arguments.reference,
                 "matches of a team to compare with, best against the same opponent; repeatable");

  command
      .option("--replay-decisions N", arguments.replays.decisions,
              "play the N costliest decisions again; about 10 s of a processor core each")
      .of_group(kReplayGroup);
  command
      .setting("--seeds N", arguments.terms.seeds,
               "playouts of each choice; one half chooses the best, the other estimates")
      .above(3)
      .of_group(kReplayGroup);
  command.setting("--cycles N", arguments.terms.cycles, "cycles of a playout")
      .above(0)
      .of_group(kReplayGroup);
  command.setting("--seed N", arguments.terms.seed, "of the first playout").of_group(kReplayGroup);
  command
      .setting("--continue TEAM", arguments.replays.continued_by,
               "who plays on after the decision, for both sides: planner or mock")
      .of_group(kReplayGroup);
  command
      .option("--save FILE", arguments.replays.save,
              "keep the review in FILE after each decision; the same command continues it")
      .of_group(kReplayGroup);
  command
      .option("--scenarios DIR", arguments.scenarios,
              "write a scenario of each decision that has a better alternative, for `cls test`")
      .of_group(kReplayGroup);
  command
      .option("--jobs", arguments.replays.jobs,
              "decisions played in parallel (default: one per core)")
      .above(0)
      .of_group(kReplayGroup);
  command.setting("--rows N", arguments.rows, "rows of each table").above(0).of_group(kOutputGroup);
  command.flag("--json", arguments.json, "print cls.review/1 as JSON").of_group(kOutputGroup);
}

}  // namespace cls::cli
