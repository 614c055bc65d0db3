// The order of the writes: what a kill leaves between two of them, the next run completes.
#include "tournament/store/decide.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/text/counted.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tournament/store/collector.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Result;

// A match that is drawn again has the number and the seed of an old one, but other teams.
void remove_work_results(const fs::path& folder, int first) {
  std::error_code code;
  for (const WorkResultName& name : list_work_results(folder)) {
    if (name.index >= first) fs::remove(folder / result_file(name.index, name.attempt), code);
  }
}

bool lacks_winner(const MatchDecision& decision, const Fixture& fixture) {
  return decision.kind == DecisionKind::kAward && fixture.decides &&
         winner_sign(awarded({}, decision)) == 0;
}

// Sets the number of a withdrawal. Why there is none; empty: there is.
std::string place_withdrawal(const Competition& competition, MatchDecision& decision,
                             std::span<const ScheduledMatch> matches) {
  const int team = decision.teams.front();
  // Rounds of which nothing was played are drawn again without the team.
  decision.match = 1;
  for (const ScheduledMatch& match : matches) {
    if (match.outcome) decision.match = match.fixture.index;
  }
  if (matches.empty()) {
    return fmt::format("no match is scheduled yet: remove {} from cls.toml",
                       competition.team(team));
  }
  const std::vector<int> gone = withdrawn_teams(matches);
  return std::ranges::count(gone, team) == 0
             ? ""
             : fmt::format("{} has withdrawn already", competition.team(team));
}

// Sets the number and the table of an order. Why there is none; empty: there is.
std::string place_order(const Competition& competition, MatchDecision& decision,
                        std::span<const ScheduledMatch> matches) {
  std::string known;
  for (const EqualTeams& equal : equal_teams(competition, matches)) {
    if (std::ranges::is_permutation(equal.teams, decision.teams)) {
      const auto first = std::ranges::find_if(matches, [&decision](const ScheduledMatch& match) {
        return match.fixture.left == decision.teams.front() ||
               match.fixture.right == decision.teams.front();
      });
      decision.table = equal.table;
      decision.match = first->fixture.index;
      return {};
    }
    known += fmt::format("; {}: {}", equal.table, team_list(competition, equal.teams));
  }
  return fmt::format("no lot separates these teams: {}{}", team_list(competition, decision.teams),
                     known.empty() ? "; no lot was drawn so far" : known);
}

// Why there is nothing to decide; empty: there is.
std::string problem_of(const Competition& competition, MatchDecision& decision,
                       std::span<const ScheduledMatch> matches) {
  if (decision.kind == DecisionKind::kWithdraw) {
    return place_withdrawal(competition, decision, matches);
  }
  if (decision.kind == DecisionKind::kOrder) return place_order(competition, decision, matches);
  const int number = decision.match;
  if (number < 1 || number > std::ssize(matches)) {
    return fmt::format("no match {}: {} so far", number,
                       base::counted(matches.size(), "match is", "matches are") + " scheduled");
  }

  const ScheduledMatch& match = matches[base::index(number) - 1];
  if (decision.kind == DecisionKind::kReplay && !match.outcome) {
    return fmt::format("match {} was not played yet", number);
  }
  if (decision.kind == DecisionKind::kAsPlayed && !match.decision) {
    return fmt::format("match {} counts as played already", number);
  }
  if (lacks_winner(decision, match.fixture)) {
    return fmt::format("match {} must have a winner: award goals, or penalties too",
                       match.fixture.index);
  }
  return "";
}

// Number of matches that `after` awards because a team has left, and `before` does not.
int newly_awarded(std::span<const ScheduledMatch> before, std::span<const ScheduledMatch> after) {
  int number = 0;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    if (is_by_withdrawal(after[i]) && !is_by_withdrawal(before[i])) ++number;
  }
  return number;
}

// Number of matches that were played, or decided on.
int with_results(std::span<const ScheduledMatch> matches) {
  return static_cast<int>(std::ranges::count_if(matches, [](const ScheduledMatch& one) {
    return one.outcome.has_value() && !is_by_withdrawal(one);
  }));
}

// Removes the matches from `first` on from store, folder and decisions. A team that has left does
// not take part in what is drawn again.
Result<void> remove_matches(const fs::path& folder, Store& store, int first,
                            std::vector<MatchDecision>& decisions) {
  TRY(store.remove_from(first));
  remove_work_results(folder, first);
  for (MatchDecision& one : decisions) {
    if (one.kind == DecisionKind::kWithdraw) one.match = std::min(one.match, first - 1);
  }
  std::erase_if(decisions, [first](const MatchDecision& one) { return one.match >= first; });
  return {};
}

}  // namespace

Result<std::vector<ScheduledMatch>> decided_matches(const fs::path& folder, Store& store) {
  TRY_INIT(auto matches, store.matches());
  TRY_INIT(const auto decisions, read_decisions(folder));
  if (decisions.empty()) return matches;

  std::vector<std::uint64_t> seeds;
  for (const ScheduledMatch& match : matches) seeds.push_back(match.fixture.seed);
  apply_decisions(matches, decisions);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Fixture& fixture = matches[i].fixture;
    if (fixture.seed == seeds[i]) continue;
    TRY(store.plan_again(fixture.index, fixture.seed));
  }
  TRY(write_schedule(folder, matches));
  return matches;
}

Result<DecisionEffect> decide(const fs::path& folder, const TournamentConfig& config,
                              MatchDecision decision, bool redraw) {
  TRY_INIT(auto store, Store::open(folder / kStoreFile));
  TRY_INIT(auto matches, decided_matches(folder, store));
  TRY_INIT(auto decisions, read_decisions(folder));
  DecisionEffect effect;
  effect.problem = problem_of(config.competition, decision, matches);
  if (!effect.problem.empty()) return effect;

  const std::size_t at = base::index(decision.match) - 1;
  const ScheduledMatch before = matches[at];
  if (before.outcome && !is_about_teams(decision.kind)) {
    decision.before = result_text(*before.outcome);
    decision.folder = before.outcome->folder;
    decision.began = before.outcome->started;
  }
  if (decision.kind == DecisionKind::kReplay) decision.seed = seed_of_replay(before.fixture.seed);
  decisions.push_back(decision);

  // From the results as played: a decision may take back an earlier one.
  TRY_INIT(auto after, store.matches());
  apply_decisions(after, decisions);
  effect.match = after[at];
  if (const auto contradiction = find_contradiction(config.competition, after)) {
    const auto removed = std::span(after).subspan(base::index(contradiction->first) - 1);
    effect.drawn_again = contradiction->first;
    effect.removed = static_cast<int>(removed.size());
    effect.removed_played = with_results(removed);
    effect.refused = effect.removed_played > 0 && !redraw;
    if (effect.refused) return effect;
    TRY(remove_matches(folder, store, contradiction->first, decisions));
  }

  TRY(write_decisions(folder, decisions));
  TRY_INIT(const auto stored, decided_matches(folder, store));
  effect.awarded = newly_awarded(matches, stored);
  return effect;
}

}  // namespace cls::tournament
