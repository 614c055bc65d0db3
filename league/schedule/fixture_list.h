// Internals of the schedule: the list of matches that a format appends to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "league/competition/competition.h"
#include "league/matches/fixture.h"
#include "league/schedule/schedule.h"
#include "league/schedule/standings.h"

namespace cls::league {

/// The earlier matches, and those to schedule next. Assigns their numbers and seeds.
class FixtureList {
 public:
  FixtureList(const Competition& competition, std::span<const ScheduledMatch> so_far);

  /// The whole, or the stage that is being scheduled.
  const Competition& competition() const { return stage_ ? *stage_ : competition_; }
  std::span<const ScheduledMatch> so_far() const { return so_far_; }

  /// What follows belongs to a stage, played as `competition` says: its name precedes the names of
  /// groups and ties, here and in of_stage().
  void begin_stage(Competition competition, std::string name);

  /// Appends a pairing: two matches on one seed with sides swapped, or one match. `swapped`: the
  /// second team starts on the left.
  void add_pairing(int round, std::string_view stage, int first, int second, bool swapped = false);
  /// Appends one match that must have a winner.
  void add_decider(int round, std::string_view stage, int left, int right);

  /// Records a tie of the bracket and returns its position there.
  int add_tie(BracketTie tie);
  std::span<const BracketTie> ties() const { return bracket_; }
  std::vector<BracketTie> take_bracket() { return std::move(bracket_); }

  /// The earlier matches of a stage.
  std::vector<ScheduledMatch> of_stage(std::string_view stage) const;

  std::vector<Fixture> take() { return std::move(added_); }
  bool added_any() const { return !added_.empty(); }

 private:
  void add(int round, std::string_view stage, int left, int right, bool decides);
  std::string full_name(std::string_view stage) const;

  const Competition& competition_;
  std::optional<Competition> stage_;
  std::string stage_name_;
  std::span<const ScheduledMatch> so_far_;
  std::vector<Fixture> added_;
  std::vector<BracketTie> bracket_;
  int last_pairing_ = 0;
};

/// Team indices in seeding order: that of the file, or random.
std::vector<int> seeding(const Competition& competition);

/// The rounds of a round robin by the circle method, each a list of disjoint pairs. Every team is
/// on the left about as often as on the right.
std::vector<std::vector<std::pair<int, int>>> circle_rounds(std::span<const int> teams);

// The formats; each appends the matches that can be played next.
Progress schedule_round_robin(FixtureList& list);
Progress schedule_gauntlet(FixtureList& list);
Progress schedule_list(FixtureList& list);
Progress schedule_groups(FixtureList& list);
Progress schedule_single_elimination(FixtureList& list);
Progress schedule_double_elimination(FixtureList& list);
Progress schedule_swiss(FixtureList& list);
Progress schedule_stages(FixtureList& list);

std::vector<Bye> swiss_byes(const Competition& competition, std::span<const ScheduledMatch> so_far);

/// Plays a bracket as far as its entrants are known, `seeds` best first. Returns the ranks known so
/// far.
using PlayBracket = Ranks (*)(FixtureList& list, const std::vector<int>& seeds, int first_round);
Ranks schedule_knockout(FixtureList& list, const std::vector<int>& seeds, int first_round);

/// The bracket of a stage; null for groups.
PlayBracket bracket_of(StageFormat format);

/// Teams by group, assigned in serpentine order: 1 to group A, 2 to B, 3 to B, 4 to A, ... A gap is
/// a turn that assigns no team.
std::vector<std::vector<int>> serpentine(std::span<const std::optional<int>> order,
                                         std::size_t groups);

/// The rows of `table` in the order of ranks.
std::vector<Standing> order_by_rank(const Ranks& ranks, const std::vector<Standing>& table);

/// "group A"; from the 27th on by number.
std::string group_name(std::size_t group);

}  // namespace cls::league
