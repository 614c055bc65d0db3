// `cls review LOG...`: what cost a team most, and what would have been better.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "base/system/parallel.h"
#include "base/text/suggestion.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/log_progress.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "review/moment.h"
#include "review/review.h"
#include "simulator/replay/logged_match.h"

namespace cls::cli {
namespace {

using review::Review;
using review::ReviewedMatch;
using soccer::Side;

constexpr const char* kReviewDescription =
    "find what cost a team most, and what would have been better\n"
    "Goals against and wasted chances by how they came about. With\n"
    "--replay-decisions the costliest decisions with the ball are played again, each\n"
    "with what the player did and with every alternative, and the difference is\n"
    "estimated in goals (docs/review.md).\n"
    "\n"
    "  cls review runs/                           one team of all matches\n"
    "  cls review game.rcg.gz --side right\n"
    "  cls review cup/matches --team ADA --replay-decisions 10\n"
    "\n"
    "LOG is a game log (rcg), a folder, or a pattern.";

constexpr const char* kReplayGroup = "Decisions played again";

struct ReviewArguments {
  std::vector<std::string> logs;
  std::string team;
  std::string side;
  std::size_t replays = 0;
  review::PlayoutTerms terms;
  std::string continued_by = "planner";
  std::size_t rows = 5;
  std::size_t jobs = base::default_jobs();
  bool json = false;
};

struct LoadedMatch {
  gamelog::MatchLogs logs;
  gamelog::MatchRecord record;
};

// A match of the team, and what playing its decisions again needs.
struct PlayedMatch {
  const LoadedMatch* loaded = nullptr;
  analysis::Flow flow;
  gamelog::RclRecord text;
  std::optional<simulator::TextLogIndex> sent;  // of `text`
  std::shared_ptr<const training::Setup> setup;
  std::string problem;  // why its decisions cannot be played
};

// A decision to be played again, and of which match.
struct Candidate {
  std::size_t match = 0;
  review::Decision decision;
};

const std::string& name_of(const gamelog::MatchRecord& record, Side side) {
  return record.final_teams()[soccer::side_index(side)].name;
}

// Reads the logs; those that cannot be read are reported and left out.
int read_logs(const ReviewArguments& arguments, std::vector<LoadedMatch>& matches) {
  const gamelog::FoundLogs found = gamelog::find_logs(arguments.logs);
  int exit_code = report_missing(found);
  LogProgress progress(found.matches.size());
  for (std::size_t i = 0; i < found.matches.size(); ++i) {
    if (watch_interrupts() != 0) return signal_exit_code(watch_interrupts());
    progress.update(i);
    const gamelog::MatchLogs& logs = found.matches[i];
    if (logs.game.empty()) continue;

    auto record = gamelog::read_rcg_file(logs.game);
    if (!record) {
      exit_code = report_log(exit_code, record.error().message, logs.game, {});
      continue;
    }
    exit_code = report_log(exit_code, "", logs.game, record->errors);
    if (record->frames() > 0) matches.push_back({logs, *std::move(record)});
  }
  return exit_code;
}

// The team of --team or --side; else the one that plays most of the matches, on the left of the
// first if both do.
std::string choose_team(const ReviewArguments& arguments, const std::vector<LoadedMatch>& matches) {
  if (!arguments.team.empty()) return arguments.team;
  const Side wanted = soccer::parse_side(arguments.side).value_or(Side::kLeft);
  std::string team = name_of(matches.front().record, wanted);
  if (!arguments.side.empty()) return team;

  std::map<std::string, int> played;
  for (const LoadedMatch& match : matches) {
    for (const Side side : soccer::kBothSides) ++played[name_of(match.record, side)];
  }
  for (const auto& [name, count] : played) {
    if (count > played[team]) team = name;
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

// Chooses the costliest decisions of all matches, and plays them again.
class Replays {
 public:
  Replays(const ReviewArguments& arguments, Review& review)
      : arguments_(arguments), review_(review) {}

  // Adds the last match of the review, with its decisions.
  void add(const LoadedMatch& loaded, analysis::MatchStatistics statistics, Side side) {
    std::vector<review::Decision> all = review::find_decisions(statistics, side);
    review_.matches.back().decisions = all.size();
    std::erase_if(all, [&](const review::Decision& one) {
      return !review::has_warm_up(statistics.flow, one.frame);
    });
    for (const review::Decision& one : review::costliest(std::move(all), arguments_.replays)) {
      candidates_.push_back({matches_.size(), one});
    }
    PlayedMatch& match = matches_.emplace_back();
    match.loaded = &loaded;
    match.flow = std::move(statistics.flow);
  }

  void play() {
    std::ranges::stable_sort(candidates_, std::ranges::greater{},
                             [](const Candidate& one) { return one.decision.lost(); });
    if (candidates_.size() > arguments_.replays) candidates_.resize(arguments_.replays);
    prepare_matches();

    std::vector<std::optional<base::Result<review::PlayedDecision>>> played(candidates_.size());
    LogProgress progress(candidates_.size(), "decisions");
    base::parallel_for(
        candidates_.size(), arguments_.jobs,
        [&](std::size_t i) {
          if (watch_interrupts() == 0) played[i] = play_one(candidates_[i]);
        },
        [&](std::size_t count) { progress.update(count); });

    for (std::size_t i = 0; i < played.size(); ++i) collect(candidates_[i], std::move(played[i]));
    std::ranges::stable_sort(
        review_.decisions, std::ranges::greater{},
        [](const review::Verdict& one) { return one.better ? one.cost.value : -1e9; });
  }

 private:
  // Reads the text logs of those matches that have candidates.
  void prepare_matches() {
    std::set<std::size_t> wanted;
    for (const Candidate& one : candidates_) wanted.insert(one.match);
    const std::vector<std::size_t> list(wanted.begin(), wanted.end());
    base::parallel_for(list.size(), arguments_.jobs,
                       [&](std::size_t i) { prepare(matches_[list[i]]); });
  }

  void prepare(PlayedMatch& match) const {
    const gamelog::MatchRecord& record = match.loaded->record;
    match.problem = review::why_not_played(record);
    if (!match.problem.empty()) return;
    if (match.loaded->logs.text.empty()) {
      match.problem = "the text log (rcl) is missing";
      return;
    }

    const training::Driver driver = *training::kDriverNames.parse(arguments_.continued_by);
    auto text = gamelog::read_rcl_file(match.loaded->logs.text);
    auto setup = review::setup_of(record, {driver, driver});
    if (!text || !setup) {
      match.problem = !text ? text.error().message : setup.error().message;
      return;
    }
    match.text = *std::move(text);
    match.sent.emplace(match.text, record.final_teams());
    match.setup = *std::move(setup);
  }

  base::Result<review::PlayedDecision> play_one(const Candidate& candidate) const {
    const PlayedMatch& match = matches_[candidate.match];
    if (!match.problem.empty()) return base::Error{match.problem};
    return review::play_again(match.setup, match.flow, *match.sent, candidate.decision,
                              arguments_.terms);
  }

  void collect(const Candidate& candidate,
               std::optional<base::Result<review::PlayedDecision>> played) {
    if (!played) {
      review_.interrupted = true;
    } else if (*played) {
      review_.decisions.push_back(review::judge(**std::move(played), candidate.match));
    } else {
      review_.skipped.push_back(fmt::format("{} {}: {}", review_.matches[candidate.match].folder,
                                            candidate.decision.cycle, played->error().message));
    }
  }

  const ReviewArguments& arguments_;
  Review& review_;
  std::vector<PlayedMatch> matches_;  // as in the review
  std::vector<Candidate> candidates_;
};

// What is wrong with the arguments: kOk, or an exit code after an error line.
int check_arguments(const ReviewArguments& arguments) {
  if (!arguments.side.empty() && !soccer::parse_side(arguments.side)) {
    return print_error(kUsage, "--side '{}': must be left or right", arguments.side);
  }
  const auto driver = training::kDriverNames.parse(arguments.continued_by);
  if (!driver || !training::perceives(*driver)) {
    return print_error(kUsage, "--continue '{}': must be planner or mock", arguments.continued_by);
  }
  return kOk;
}

int run_review_command(const ReviewArguments& arguments) {
  TRY_STEP(check_arguments(arguments));
  std::vector<LoadedMatch> logs;
  const int exit_code = read_logs(arguments, logs);
  if (logs.empty()) return exit_code != kOk ? exit_code : print_error(kNoInput, "no game log");

  Review review;
  review.team = choose_team(arguments, logs);
  review.terms = arguments.terms;
  review.continued_by = arguments.continued_by == "mock" ? "mock's simple team" : "bundled planner";

  Replays replays(arguments, review);
  for (const LoadedMatch& match : logs) {
    const Side side = side_of_team(arguments, match.record, review.team);
    if (side == Side::kNeutral) continue;
    analysis::MatchStatistics statistics = analysis::compute_statistics(match.record, nullptr);
    review.matches.push_back(review_match(match, statistics, side));
    replays.add(match, std::move(statistics), side);
  }
  if (review.matches.empty()) {
    return print_error(kNoInput, "--team '{}': plays in none of these matches{}", review.team,
                       nearest_team(review.team, logs));
  }

  if (arguments.replays > 0) replays.play();
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
  command.option("--team NAME", arguments.team,
                 "the team (default: the one that plays most of the matches)");
  command.option("--side SIDE", arguments.side,
                 "left or right: the team of that side in the first match");

  command
      .option("--replay-decisions N", arguments.replays,
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
      .setting("--continue TEAM", arguments.continued_by,
               "who plays on after the decision, for both sides: planner or mock")
      .of_group(kReplayGroup);
  command.option("--jobs", arguments.jobs, "decisions played in parallel (default: one per core)")
      .above(0)
      .of_group(kReplayGroup);
  command.setting("--rows N", arguments.rows, "rows of each table").above(0).of_group(kOutputGroup);
  command.flag("--json", arguments.json, "print cls.review/1 as JSON").of_group(kOutputGroup);
}

}  // namespace cls::cli
