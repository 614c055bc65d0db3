// Numbers and seeds of new matches; seeding and round-robin order.
#include "tournament/schedule/fixture_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "soccer/random.h"
#include "tournament/schedule/schedule.h"

namespace cls::tournament {

FixtureList::FixtureList(const TournamentConfig& config, std::span<const ScheduledMatch> so_far)
    : config_(config), so_far_(so_far) {
  for (const ScheduledMatch& match : so_far) {
    last_pairing_ = std::max(last_pairing_, match.fixture.pairing);
  }
}

void FixtureList::begin_stage(TournamentConfig config, std::string name) {
  stage_ = std::move(config);
  stage_name_ = std::move(name);
}

std::string FixtureList::full_name(std::string_view stage) const {
  if (stage_name_.empty()) return std::string(stage);
  return stage.empty() ? stage_name_ : fmt::format("{}, {}", stage_name_, stage);
}

void FixtureList::add_pairing(int round, std::string_view stage, int first, int second,
                              bool swapped) {
  if (swapped) std::swap(first, second);
  ++last_pairing_;
  add(round, stage, first, second, false);
  if (config().swap_sides) add(round, stage, second, first, false);
}

void FixtureList::add_decider(int round, std::string_view stage, int left, int right) {
  ++last_pairing_;
  add(round, stage, left, right, true);
}

void FixtureList::add(int round, std::string_view stage, int left, int right, bool decides) {
  Fixture fixture;
  fixture.index = static_cast<int>(so_far_.size() + added_.size()) + 1;
  fixture.round = round;
  fixture.stage = full_name(stage);
  fixture.pairing = last_pairing_;
  fixture.left = left;
  fixture.right = right;
  fixture.seed = pairing_seed(config_.seed, last_pairing_);
  fixture.decides = decides;
  added_.push_back(std::move(fixture));
}

int FixtureList::add_tie(BracketTie tie) {
  tie.stage = full_name(tie.stage);
  bracket_.push_back(std::move(tie));
  return static_cast<int>(bracket_.size()) - 1;
}

std::vector<ScheduledMatch> FixtureList::of_stage(std::string_view stage) const {
  const std::string name = full_name(stage);
  std::vector<ScheduledMatch> found;
  for (const ScheduledMatch& match : so_far_) {
    if (match.fixture.stage == name) found.push_back(match);
  }
  return found;
}

std::vector<int> seeding(const TournamentConfig& config) {
  std::vector<int> order(config.teams.size());
  std::iota(order.begin(), order.end(), 0);
  if (config.draw) {
    soccer::RandomStream random(config.seed, "seeding");
    random.shuffle(std::span<int>(order));
  }
  return order;
}

std::vector<std::vector<std::pair<int, int>>> circle_rounds(std::span<const int> teams) {
  std::vector<int> seats(teams.begin(), teams.end());
  if (seats.size() % 2 == 1) seats.push_back(-1);
  const std::size_t count = seats.size();
  std::vector<std::vector<std::pair<int, int>>> rounds;
  for (std::size_t round = 0; round + 1 < count; ++round) {
    rounds.emplace_back();
    for (std::size_t k = 0; k < count / 2; ++k) {
      std::pair<int, int> pair(seats[k], seats[count - 1 - k]);
      if (pair.first < 0 || pair.second < 0) continue;
      // The first seat is fixed, so its sides alternate by round; other teams change seats.
      if (k == 0 ? round % 2 == 1 : k % 2 == 1) std::swap(pair.first, pair.second);
      rounds.back().push_back(pair);
    }
    std::rotate(seats.begin() + 1, seats.end() - 1, seats.end());
  }
  return rounds;
}

}  // namespace cls::tournament
