// `cls tournament decide DIR`: decisions of the organizers on matches.
#include <fmt/format.h>

#include <string>
#include <tuple>
#include <vector>

#include "base/system/host.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "base/text/trimmed.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tournament_session.h"
#include "tournament/report/report_tables.h"
#include "tournament/store/decide.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"
#include "tournament/store/results_file.h"

namespace cls::cli {
namespace {

using namespace tournament;

constexpr const char* kDecideDescription =
    "decide on a match or a team, with a reason that the report shows\n"
    "\n"
    "  cls tournament decide cup --match 12 --award 3:0 --reason 'RED did not start'\n"
    "  cls tournament decide cup --match 12 --annul --reason 'wrong binary of BLUE'\n"
    "  cls tournament decide cup --match 12 --replay --reason 'power failure'\n"
    "  cls tournament decide cup --match 12 --as-played --reason 'protest withdrawn'\n"
    "  cls tournament decide cup --withdraw RED --reason 'left the league'\n"
    "  cls tournament decide cup --order RED,BLUE,GREEN --reason 'drawn by lot'\n"
    "  cls tournament decide cup                 list the decisions\n"
    "\n"
    "While no run is in progress; `cls tournament run DIR` plays what follows. Later\n"
    "rounds that a decision changes are drawn again, with --redraw also if they were\n"
    "played.";

struct DecideArguments {
  std::string folder;
  int match = 0;
  bool annul = false;
  bool replay = false;
  bool as_played = false;
  std::string award;
  std::string withdraw;
  std::string order;
  std::string penalties;
  std::string reason;
  bool redraw = false;
  bool json = false;
};

bool lists_only(const DecideArguments& arguments) {
  return arguments.match == 0 && arguments.withdraw.empty() && arguments.order.empty();
}

// An exit code whose error is printed, unless the options describe one decision.
int check_kind(const DecideArguments& arguments) {
  const bool withdraws = !arguments.withdraw.empty();
  const bool orders = !arguments.order.empty();
  const int of_match =
      arguments.annul + arguments.replay + arguments.as_played + !arguments.award.empty();
  if (withdraws + orders > 1 || ((withdraws || orders) && (arguments.match != 0 || of_match > 0))) {
    return print_error(kUsage, "--{} is a decision of its own: without --match and other decisions",
                       withdraws ? "withdraw" : "order");
  }
  if (!withdraws && !orders && of_match != 1) {
    return print_error(kUsage, "one of --award, --annul, --replay and --as-played is required");
  }
  if (arguments.reason.empty()) {
    return print_error(kUsage, "--reason WHY is required: the report shows it");
  }
  return kOk;
}

int add_team(const char* option, const Competition& competition, std::string_view name,
             std::vector<int>& teams) {
  teams.push_back(team_index(competition, name));
  if (teams.back() >= 0) return kOk;
  std::vector<std::string_view> known;
  for (const TeamEntry& team : competition.teams) known.push_back(team.name);
  return print_error(kUsage, "{}: unknown team '{}'{}", option, name,
                     base::did_you_mean(name, known));
}

// The decision that the options describe, or an exit code whose error is printed.
int decision_in(const DecideArguments& arguments, const Competition& competition,
                MatchDecision& decision) {
  decision.match = arguments.match;
  decision.reason = arguments.reason;
  decision.time = base::utc_now();
  if (!arguments.withdraw.empty()) {
    decision.kind = DecisionKind::kWithdraw;
    return add_team("--withdraw", competition, arguments.withdraw, decision.teams);
  }
  if (!arguments.order.empty()) {
    decision.kind = DecisionKind::kOrder;
    for (const std::string_view name : base::split(arguments.order, ',')) {
      TRY_STEP(add_team("--order", competition, base::trimmed(name), decision.teams));
    }
    return kOk;
  }

  decision.kind = arguments.annul       ? DecisionKind::kAnnul
                  : arguments.replay    ? DecisionKind::kReplay
                  : arguments.as_played ? DecisionKind::kAsPlayed
                                        : DecisionKind::kAward;
  if (decision.kind != DecisionKind::kAward) {
    return arguments.penalties.empty() ? kOk : print_error(kUsage, "--penalties requires --award");
  }

  const auto goals = parse_goals(arguments.award);
  if (!goals) {
    return print_error(kUsage, "--award '{}': must be LEFT:RIGHT, such as 3:0", arguments.award);
  }

  std::tie(decision.left_score, decision.right_score) = *goals;
  if (arguments.penalties.empty()) return kOk;
  const auto penalties = parse_goals(arguments.penalties);
  if (!penalties || goals->first != goals->second) {
    return print_error(kUsage,
                       "--penalties '{}': must be LEFT:RIGHT, such as 4:2, "
                       "after a level score",
                       arguments.penalties);
  }
  std::tie(decision.left_penalties, decision.right_penalties) = *penalties;
  return kOk;
}

std::string effect_text(const DecideArguments& arguments, const Competition& teams,
                        const DecisionEffect& effect) {
  if (!arguments.withdraw.empty()) {
    return fmt::format("{} has withdrawn: {} awarded", arguments.withdraw,
                       base::counted(effect.awarded, "match is", "matches are"));
  }

  const MatchDecision& latest = effect.match.history.back();
  if (!arguments.order.empty()) {
    return fmt::format("{}: the order is {}", latest.table, arguments.order);
  }

  const Fixture& fixture = effect.match.fixture;
  const std::string what = decision_text(effect.match);
  return fmt::format("match {}, {}: {} - {}: {}", fixture.index, stage_text(fixture),
                     teams.team(fixture.left), teams.team(fixture.right),
                     what.empty() ? "as played, " + score_text(effect.match) : what);
}

int print_decisions(const DecideArguments& arguments) {
  TRY_INIT_OR(kBadData, const auto state, read_tournament(arguments.folder));
  if (arguments.json) {
    base::Json document = {{"schema", "cls.decisions/1"}};
    document["decisions"] = base::Json::array();
    TRY_INIT_OR(kBadData, const auto decisions, read_decisions(arguments.folder));
    for (const MatchDecision& one : decisions) document["decisions"].push_back(json_of(one));
    return print_json(document);
  }
  const Report report = make_report(state.config, state.matches, arguments.folder);
  const ReportTable table = decisions_table(report);
  fmt::print("{}", table.empty() ? "no decisions\n"
                                 : table.table.format_text({0, stdout_width(), table.key_columns}));
  return kOk;
}

std::string subject_of(const DecideArguments& arguments) {
  if (!arguments.withdraw.empty()) return arguments.withdraw;
  if (!arguments.order.empty()) return arguments.order;
  return fmt::format("match {}", arguments.match);
}

int print_effect(const DecideArguments& arguments, const TournamentConfig& config,
                 const DecisionEffect& effect) {
  if (effect.refused) {
    return print_error(kFailed,
                       "{}: this changes the matches from {} on, of which {} played already; "
                       "nothing was changed; --redraw discards {}, and `cls tournament run` draws "
                       "again",
                       subject_of(arguments), *effect.drawn_again,
                       base::counted(effect.removed_played, "was", "were"),
                       effect.removed_played == 1 ? "it" : "them");
  }

  if (arguments.json) {
    base::Json document = {{"schema", "cls.decide/1"}};
    const MatchDecision& latest = effect.match.history.back();
    if (is_about_teams(latest.kind)) {
      document["decision"] = json_of(latest);
      document["awarded"] = effect.awarded;
    } else {
      document["match"] = json_of(config, effect.match);
    }
    document["drawn_again_from"] = effect.drawn_again ? base::Json(*effect.drawn_again) : nullptr;
    document["removed"] = effect.removed;
    return print_json(document);
  }

  fmt::print("{}\n", effect_text(arguments, config.competition, effect));
  if (effect.drawn_again) {
    fmt::print("removed, and drawn again by the next run: {} from match {} on\n",
               base::counted(effect.removed, "match", "matches"), *effect.drawn_again);
  }

  return kOk;
}

int run_decide(const DecideArguments& arguments) {
  TRY_STEP(check_tournament(arguments.folder, kRunCreatesOne));
  if (lists_only(arguments)) return print_decisions(arguments);
  TRY_STEP(check_kind(arguments));

  TRY_INIT_OR(kCannotCreate, const auto lock, FolderLock::try_lock(arguments.folder));
  if (!lock) {
    return print_error(kTryAgain,
                       "{0}: a run is in progress; `cls tournament stop "
                       "{0}` ends it after its current matches",
                       arguments.folder);
  }

  // Result files of `work` are matches too; this checks the folder as well.
  TRY_INIT_OR(kBadData, const auto state, read_tournament(arguments.folder));
  MatchDecision decision;
  TRY_STEP(decision_in(arguments, state.config.competition, decision));
  const auto effect = decide(arguments.folder, state.config, decision, arguments.redraw);
  const std::string problem = effect ? effect->problem : effect.error().message;
  if (!problem.empty()) {
    return print_error(effect ? kUsage : kWriteFailed, "{}: {}", arguments.folder, problem);
  }
  return print_effect(arguments, state.config, *effect);
}

}  // namespace

void add_tournament_decide_command(Command& app) {
  auto [command, arguments] = app.command("decide", kDecideDescription, run_decide);
  command.option("DIR", arguments.folder, "folder of the tournament").required();
  command.option("--match", arguments.match, "number of the match (default: list the decisions)")
      .above(0);
  command
      .option("--award", arguments.award,
              "LEFT:RIGHT, the result that counts, of the left and the right team")
      .placeholder("SCORE");

  command
      .option("--penalties", arguments.penalties,
              "LEFT:RIGHT, the shoot-out of an awarded level match")
      .placeholder("SCORE");

  command.flag("--annul", arguments.annul, "the match counts for nothing");
  command.flag("--replay", arguments.replay, "the match is played again, on a new seed");
  command.flag("--as-played", arguments.as_played, "take back what was decided before");
  command
      .option("--withdraw", arguments.withdraw,
              "a team that leaves: its matches without a result are won by the opponents, and\n"
              "later rounds do without it")
      .placeholder("TEAM");

  command
      .option("--order", arguments.order,
              "teams that a lot separates in a table, best first, separated by commas")
      .placeholder("TEAMS");

  command.option("--reason", arguments.reason, "why, for the report").placeholder("WHY");
  command.flag("--redraw", arguments.redraw,
               "discard later matches whose teams change, even if they were played");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
