// Numbers and seeds of new matches, and the order of seeding.
#include "league/schedule/fixture_list.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "league/matches/stage_name.h"
#include "soccer/random.h"

namespace cls::league {

FixtureList::FixtureList(const Competition& competition, std::span<const ScheduledMatch> so_far)
    : competition_(competition), so_far_(so_far) {
  for (const ScheduledMatch& match : so_far) {
    last_pairing_ = std::max(last_pairing_, match.fixture.pairing);
  }
}

void FixtureList::begin_stage(Competition competition, std::string name) {
  stage_ = std::move(competition);
  stage_name_ = std::move(name);
}

std::string FixtureList::full_name(std::string_view stage) const {
  return StageName{stage_name_, std::string(stage)}.text();
}

void FixtureList::add_pairing(int round, std::string_view stage, int first, int second,
                              bool swapped) {
  if (swapped) std::swap(first, second);
  ++last_pairing_;
  add(round, stage, first, second, false);
  if (competition().swap_sides) add(round, stage, second, first, false);
}

void FixtureList::add_decider(int round, std::string_view stage, int left, int right) {
  ++last_pairing_;
  add(round, stage, left, right, true);
}

void FixtureList::add(int round, std::string_view stage, int left, int right, bool decides) {
  added_.push_back({.index = static_cast<int>(so_far_.size() + added_.size()) + 1,
                    .round = round,
                    .stage = full_name(stage),
                    .pairing = last_pairing_,
                    .left = left,
                    .right = right,
                    .seed = pairing_seed(competition_.seed, last_pairing_),
                    .decides = decides});
}

int FixtureList::add_tie(BracketTie tie) {
  tie.stage = full_name(tie.stage);
  bracket_.push_back(std::move(tie));
  return static_cast<int>(bracket_.size()) - 1;
}

std::vector<ScheduledMatch> FixtureList::of_stage(std::string_view stage) const {
  std::vector<ScheduledMatch> found;
  std::ranges::copy_if(so_far_, std::back_inserter(found),
                       [name = full_name(stage)](const ScheduledMatch& match) {
                         return match.fixture.stage == name;
                       });
  return found;
}

std::vector<int> seeding(const Competition& competition) {
  std::vector<int> order(competition.teams.size());
  std::iota(order.begin(), order.end(), 0);
  if (competition.draw) {
    soccer::RandomStream random(competition.seed, "seeding");
    random.shuffle(std::span<int>(order));
  }
  return order;
}

}  // namespace cls::league
