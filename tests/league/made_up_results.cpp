// Made-up results.
#include "tests/league/made_up_results.h"

#include "league/schedule/schedule.h"
#include "soccer/random.h"

namespace cls::league {

Competition competition_of(Format format, int teams) {
  Competition competition;
  competition.format = format;
  for (int i = 0; i < teams; ++i) {
    competition.teams.push_back(
        {i < 26 ? std::string(1, static_cast<char>('A' + i)) : "T" + std::to_string(i), "mock"});
  }
  return competition;
}

Outcome score(int left, int right) {
  Outcome outcome;
  outcome.left_score = left;
  outcome.right_score = right;
  return outcome;
}

Outcome fault(soccer::EndReason reason) {
  Outcome outcome;
  outcome.end_reason = reason;
  outcome.fault = soccer::Side::kLeft;
  outcome.message = "its process ended";
  return outcome;
}

Outcome better_wins(const Fixture& fixture) {
  return fixture.left < fixture.right ? score(1, 0) : score(0, 1);
}

Referee random_results(std::uint64_t seed) {
  return [seed](const Fixture& fixture) {
    soccer::RandomStream random(seed, "results", static_cast<std::uint64_t>(fixture.index));
    Outcome outcome =
        score(static_cast<int>(random.integer(4)), static_cast<int>(random.integer(4)));
    if (fixture.decides && outcome.left_score == outcome.right_score) {
      outcome.left_penalties = 3;
      outcome.right_penalties = random.integer(2) == 0 ? 2 : 4;
    }
    return outcome;
  };
}

std::vector<ScheduledMatch> play_all(const Competition& competition, const Referee& referee) {
  std::vector<ScheduledMatch> matches;
  while (true) {
    const std::vector<Fixture> next = next_fixtures(competition, matches);
    if (next.empty()) return matches;
    for (const Fixture& fixture : next) {
      matches.push_back(planned(fixture));
      matches.back().outcome = referee(fixture);
    }
  }
}

std::vector<std::string> pairs_of(const std::vector<Fixture>& fixtures) {
  const Competition names = competition_of(Format::kList, 64);
  std::vector<std::string> pairs;
  for (const Fixture& fixture : fixtures) {
    pairs.push_back(names.team(fixture.left) + "-" + names.team(fixture.right));
  }
  return pairs;
}

std::vector<std::string> pairs_of(const std::vector<ScheduledMatch>& matches) {
  std::vector<Fixture> fixtures;
  for (const ScheduledMatch& match : matches) fixtures.push_back(match.fixture);
  return pairs_of(fixtures);
}

std::vector<std::string> ranking(const Competition& competition,
                                 const std::vector<ScheduledMatch>& matches) {
  const std::vector<RankedTable> all = tables(competition, matches);
  std::vector<std::string> names;
  for (const Standing& row : all.back().standings) names.push_back(competition.team(row.team));
  return names;
}

}  // namespace cls::league
