// Stages: each is a function of the results of those before it. Every call repeats them all, so the
// matches are the only state.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "league/matches/stage_name.h"
#include "league/schedule/fixture_list.h"

namespace cls::league {
namespace {

using Slots = std::vector<std::optional<int>>;

// The state of a stage.
struct Played {
  Ranks ranks;                           // of all teams that have taken part until now
  std::vector<std::vector<int>> groups;  // teams by rank, when the groups were drawn
  bool complete = false;
};

std::vector<int> flat(const Ranks& ranks) {
  std::vector<int> teams;
  for (const std::vector<int>& shared : ranks) {
    teams.insert(teams.end(), shared.begin(), shared.end());
  }
  return teams;
}

// Those of `teams` that are not among `others`.
std::vector<int> without(const std::vector<int>& teams, const std::vector<int>& others) {
  std::vector<int> rest;
  std::ranges::copy_if(teams, std::back_inserter(rest), [&others](int team) {
    return std::ranges::find(others, team) == others.end();
  });
  return rest;
}

// The ranks of a table.
Ranks ranks_of(const std::vector<Standing>& table) {
  Ranks ranks;
  int last = 0;
  for (const Standing& row : table) {
    if (row.rank != std::exchange(last, row.rank)) ranks.emplace_back();
    ranks.back().push_back(row.team);
  }
  return ranks;
}

// All winners of groups, then all second, ...; with `gaps` also the places that smaller groups
// lack.
Slots row_by_row(const std::vector<std::vector<int>>& groups, bool gaps) {
  std::size_t rows = 0;
  for (const auto& group : groups) rows = std::max(rows, group.size());
  Slots slots;
  for (std::size_t row = 0; row < rows; ++row) {
    for (const auto& group : groups) {
      if (row < group.size()) {
        slots.emplace_back(group[row]);
      } else if (gaps) {
        slots.emplace_back();
      }
    }
  }
  return slots;
}

class Stages {
 public:
  explicit Stages(FixtureList& list)
      : list_(list),
        competition_(list.competition()),
        breakers_(tie_breakers_of(competition_)),
        orders_(decided_orders(list.so_far())) {}

  std::vector<RankedTable> play() {
    for (const Stage& stage : competition_.stages) {
      begin(stage);
      const PlayBracket bracket = bracket_of(stage.format);
      Played now = bracket == nullptr ? play_groups() : play_bracket(bracket);

      for (const std::vector<int>& rest : out_) now.ranks.push_back(rest);
      for (const ScheduledMatch& match : matches_of({stage.name})) {
        rounds_ = std::max(rounds_, match.fixture.round);
      }
      before_ = std::move(now);
      if (!before_.complete) break;
    }
    tables_.push_back(final_table());
    return std::move(tables_);
  }

 private:
  // Sets the entrants of the stage and those that it leaves out.
  void begin(const Stage& stage) {
    stage_ = &stage;
    Competition competition = competition_;
    competition.format = Format::kKnockout;
    competition.rounds = stage.legs;
    competition.swap_sides = false;
    competition.third_place = stage.third_place;
    list_.begin_stage(std::move(competition), stage.name);

    slots_ = ranked_entrants();
    out_.clear();
    leave_out_withdrawn();
    leave_out(stage.teams > 0 ? base::index(stage.teams) : slots_.size());
    for (const std::string& team : stage.join) slots_.emplace_back(team_index(competition_, team));
  }

  Slots ranked_entrants() {
    if (stage_ == &competition_.stages.front()) return first_entrants();

    if (!stage_->ranked_by.empty()) {
      rank_by_earlier_stages();
    } else if (before_.groups.size() == base::index(stage_->groups)) {
      return regrouped_entrants();
    }
    const std::vector<int> order = flat(before_.ranks);
    return {order.begin(), order.end()};
  }

  void rank_by_earlier_stages() {
    const std::vector<int> teams = flat(before_.ranks);
    RankedTable table;
    table.title = fmt::format("average of {}", fmt::join(stage_->ranked_by, ", "));
    table.standings = standings(teams, matches_of(stage_->ranked_by), breakers_);
    table.average = true;
    const int places = stage_->teams > 0 ? stage_->teams : competition_.team_count();
    draw_lots(competition_.seed, table.title, places, orders_, table.standings);

    before_.ranks = ranks_of(table.standings);
    tables_.push_back(std::move(table));
  }

  // Groups are drawn again so that their sizes remain as equal as they were. Teams that the stage
  // before left out have the last ranks, and fill the places that smaller groups lacked.
  Slots regrouped_entrants() const {
    const std::vector<int> rest = without(flat(before_.ranks), flat(before_.groups));
    Slots slots = row_by_row(before_.groups, stage_->teams == 0 && rest.empty());
    slots.insert(slots.end(), rest.begin(), rest.end());
    return slots;
  }

  Slots first_entrants() const {
    Slots slots;
    for (const int team : seeding(competition_)) {
      const bool later = std::ranges::any_of(competition_.stages, [&](const Stage& stage) {
        return std::ranges::count(stage.join, competition_.team(team)) > 0;
      });
      if (!later) slots.emplace_back(team);
    }
    return slots;
  }

  // Teams that left before the stage began, unless its groups are given: those they are drawn from
  // have as many places as before.
  void leave_out_withdrawn() {
    if (!stage_->drawn.empty() || !stage_->divisions.empty()) return;
    const std::vector<ScheduledMatch> own = matches_of({stage_->name});
    const std::span<const ScheduledMatch> all = list_.so_far();
    const auto before = own.empty() ? all : all.first(base::index(own.front().fixture.index) - 1);
    for (const int team : withdrawn_teams(before)) std::erase(slots_, std::optional(team));
  }

  // Only the first `teams` slots take part; the others keep their ranks behind them.
  void leave_out(std::size_t teams) {
    slots_.resize(std::min(slots_.size(), teams));
    const std::vector<int> in = entrants();
    for (const std::vector<int>& shared : before_.ranks) {
      std::vector<int> rest = without(shared, in);
      if (!rest.empty()) out_.push_back(std::move(rest));
    }
  }

  std::vector<int> entrants() const {
    std::vector<int> teams;
    for (const std::optional<int>& slot : slots_) {
      if (slot) teams.push_back(*slot);
    }
    return teams;
  }

  std::vector<std::vector<int>> groups_now() const {
    if (!stage_->drawn.empty()) {
      std::vector<std::vector<int>> groups;
      for (const auto& names : stage_->drawn) {
        groups.emplace_back();
        for (const std::string& name : names)
          groups.back().push_back(team_index(competition_, name));
      }
      return groups;
    }

    if (stage_->divisions.empty()) {
      return serpentine(slots_, base::index(stage_->groups));
    }

    const std::vector<int> teams = entrants();
    std::vector<std::vector<int>> groups;
    auto next = teams.begin();
    for (const int size : stage_->divisions) {
      groups.emplace_back(next, next + size);
      next += size;
    }
    return groups;
  }

  // Letters continue from stage to stage, as those of the league do.
  std::string name_of_group(std::size_t group, std::size_t groups) const {
    return groups == 1 ? std::string() : group_name(first_group_ + group);
  }

  void schedule_groups(const std::vector<std::vector<int>>& groups) {
    for (int leg = 1; leg <= stage_->legs; ++leg) {
      for (std::size_t i = 0; i < groups.size(); ++i) {
        std::string name = name_of_group(i, groups.size());
        if (stage_->legs > 1) name += fmt::format("{}leg {}", name.empty() ? "" : ", ", leg);
        for (const auto& day : circle_rounds(groups[i])) {
          for (const auto& [first, second] : day) {
            list_.add_pairing(rounds_ + leg, name, first, second, leg % 2 == 0);
          }
        }
      }
    }
  }

  // How many places of each group matter to the next stage.
  int places_that_go_on(std::size_t groups) const {
    if (stage_ == &competition_.stages.back()) return 0;
    const int teams = (stage_ + 1)->teams;
    const int each = static_cast<int>(groups);
    return teams > 0 ? (teams + each - 1) / each : competition_.team_count();
  }

  Played play_groups() {
    const std::vector<std::vector<int>> groups = groups_now();
    const std::vector<ScheduledMatch> own = matches_of({stage_->name});
    if (own.empty()) schedule_groups(groups);

    Played result;
    result.complete = !own.empty() && all_have_outcomes(own);
    const int places = result.complete ? places_that_go_on(groups.size()) : 0;
    Ranks in_turn;  // of one division after the other
    std::vector<std::vector<int>> sorted;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      RankedTable table = table_of(groups[i], name_of_group(i, groups.size()));
      draw_lots(competition_.seed, table.title, places, orders_, table.standings);
      const Ranks ranks = ranks_of(table.standings);
      in_turn.insert(in_turn.end(), ranks.begin(), ranks.end());
      sorted.push_back(flat(ranks));
      tables_.push_back(std::move(table));
    }

    if (groups.size() > 1) first_group_ += groups.size();
    if (stage_->divisions.empty() && groups.size() > 1) {
      result.ranks = shared_by_row(sorted);
      result.groups = std::move(sorted);
    } else {
      result.ranks = std::move(in_turn);
    }
    return result;
  }

  RankedTable table_of(const std::vector<int>& teams, const std::string& group) const {
    std::vector<std::string> counted = stage_->carry;
    counted.push_back(stage_->name);
    return {StageName{stage_->name, group}.text(),
            standings(teams, matches_of(counted), breakers_)};
  }

  static Ranks shared_by_row(const std::vector<std::vector<int>>& groups) {
    Ranks ranks;
    for (const auto& group : groups) {
      if (group.size() > ranks.size()) ranks.resize(group.size());
      for (std::size_t row = 0; row < group.size(); ++row) ranks[row].push_back(group[row]);
    }
    return ranks;
  }

  Played play_bracket(PlayBracket bracket) {
    const std::size_t first_tie = list_.ties().size();
    Played result;
    result.ranks = bracket(list_, entrants(), rounds_ + 1);

    const auto ties = list_.ties().subspan(first_tie);
    result.complete =
        std::ranges::all_of(ties, [](const BracketTie& tie) { return tie.winner.has_value(); });
    return result;
  }

  std::vector<ScheduledMatch> matches_of(const std::vector<std::string>& stages) const {
    std::vector<ScheduledMatch> found;
    std::ranges::copy_if(
        list_.so_far(), std::back_inserter(found), [&stages](const ScheduledMatch& match) {
          return std::ranges::count(stages, parse_stage_name(match.fixture.stage).stage) > 0;
        });
    return found;
  }

  // All teams; those that have not joined yet are last.
  RankedTable final_table() const {
    Ranks ranks = before_.ranks;
    const std::vector<int> order = seeding(competition_);
    std::vector<int> later = without(order, flat(ranks));
    if (!later.empty()) ranks.push_back(std::move(later));

    return {before_.complete ? "final standings" : "standings so far",
            order_by_rank(ranks, standings(order, list_.so_far(), breakers_))};
  }

  FixtureList& list_;
  const Competition& competition_;
  const std::vector<TieBreaker> breakers_;
  const std::vector<MatchDecision> orders_;
  const Stage* stage_ = nullptr;
  Slots slots_;  // of the stage, by rank; a gap is a place that a smaller group lacked
  Ranks out_;    // teams that have taken part, but not in this stage
  Played before_;
  std::vector<RankedTable> tables_;
  int rounds_ = 0;
  std::size_t first_group_ = 0;
};

}  // namespace

Progress schedule_stages(FixtureList& list) { return {Stages(list).play(), {}}; }

}  // namespace cls::league
