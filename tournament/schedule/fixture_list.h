// Internals of the schedule: the list of matches that a format appends to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tournament/config/config.h"
#include "tournament/schedule/fixture.h"
#include "tournament/schedule/schedule.h"
#include "tournament/schedule/standings.h"

namespace cls::tournament {

/// The earlier matches, and those to schedule next. Assigns their numbers and seeds.
class FixtureList {
 public:
  FixtureList(const TournamentConfig& config, std::span<const ScheduledMatch> so_far);

  /// That of the tournament, or of the stage that is being scheduled.
  const TournamentConfig& config() const { return stage_ ? *stage_ : config_; }
  std::span<const ScheduledMatch> so_far() const { return so_far_; }

  /// What follows belongs to a stage, played as `config` says: its name precedes the names of
  /// groups and ties, here and in of_stage().
  void begin_stage(TournamentConfig config, std::string name);

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

  const TournamentConfig& config_;
  std::optional<TournamentConfig> stage_;
  std::string stage_name_;
  std::span<const ScheduledMatch> so_far_;
  std::vector<Fixture> added_;
  std::vector<BracketTie> bracket_;
  int last_pairing_ = 0;
};

/// Team indices in seeding order: that of the file, or random.
std::vector<int> seeding(const TournamentConfig& config);

/// The rounds of a round robin by the circle method, each a list of disjoint pairs. Every team is
/// on the left about as often as on the right.
std::vector<std::vector<std::pair<int, int>>> circle_rounds(std::span<const int> teams);

// The formats; each appends the matches that can be played next. Knockout formats also return the
// ranks known so far: element i is a set of teams that share a rank, best first.
void schedule_swiss(FixtureList& list);
std::vector<Bye> swiss_byes(const TournamentConfig& config, std::span<const ScheduledMatch> so_far);
std::vector<std::vector<int>> schedule_knockout(FixtureList& list, std::vector<int> seeds,
                                                int first_round);
std::vector<std::vector<int>> schedule_double_elimination(FixtureList& list,
                                                          std::vector<int> seeds);
std::vector<std::vector<int>> schedule_stepladder(FixtureList& list, const std::vector<int>& seeds,
                                                  int first_round);

/// Plays the stages as far as their entrants are known. Returns the tables, of which the last one
/// ranks the tournament.
std::vector<RankedTable> schedule_stages(FixtureList& list);

/// Teams by group, assigned in serpentine order: 1 to group A, 2 to B, 3 to B, 4 to A, ... A gap is
/// a turn that assigns no team.
std::vector<std::vector<int>> serpentine(std::span<const std::optional<int>> order,
                                         std::size_t groups);

/// The rows of `table` in the order of ranks, of which each is a set of teams that share it.
std::vector<Standing> order_by_rank(const std::vector<std::vector<int>>& ranks,
                                    const std::vector<Standing>& table);

/// Team indices by group, assigned in serpentine order of the seeding.
std::vector<std::vector<int>> groups_of(const TournamentConfig& config);
std::string group_name(std::size_t group);

}  // namespace cls::tournament
