// Fake executor and made-up results.
#include "tests/tournament/fake_executor.h"

#include <thread>

#include "tournament/schedule/schedule.h"

namespace cls::tournament {

TournamentConfig config_of(Format format, int teams) {
  TournamentConfig config;
  config.format = format;
  for (int i = 0; i < teams; ++i) {
    config.teams.push_back(
        {i < 26 ? std::string(1, static_cast<char>('A' + i)) : "T" + std::to_string(i), "mock"});
  }
  return config;
}

Outcome score(int left, int right) {
  Outcome outcome;
  outcome.left_score = left;
  outcome.right_score = right;
  return outcome;
}

Outcome fault(match::EndReason reason) {
  Outcome outcome;
  outcome.end_reason = reason;
  outcome.fault = soccer::Side::kLeft;
  outcome.message = "its process ended";
  return outcome;
}

Outcome better_wins(const Fixture& fixture) {
  return fixture.left < fixture.right ? score(1, 0) : score(0, 1);
}

std::vector<ScheduledMatch> play_all(const TournamentConfig& config, const Referee& referee) {
  std::vector<ScheduledMatch> matches;
  while (true) {
    const std::vector<Fixture> next = next_fixtures(config, matches);
    if (next.empty()) return matches;
    for (const Fixture& fixture : next) {
      matches.push_back(planned(fixture));
      matches.back().outcome = referee(fixture);
    }
  }
}

namespace {

std::string pair_of(const Fixture& fixture) {
  const TournamentConfig names = config_of(Format::kList, 64);
  return names.teams[static_cast<std::size_t>(fixture.left)].name + "-" +
         names.teams[static_cast<std::size_t>(fixture.right)].name;
}

}  // namespace

std::vector<std::string> pairs_of(const std::vector<Fixture>& fixtures) {
  std::vector<std::string> pairs;
  for (const Fixture& fixture : fixtures) pairs.push_back(pair_of(fixture));
  return pairs;
}

std::vector<std::string> pairs_of(const std::vector<ScheduledMatch>& matches) {
  std::vector<std::string> pairs;
  for (const ScheduledMatch& match : matches) pairs.push_back(pair_of(match.fixture));
  return pairs;
}

std::vector<std::string> ranking(const TournamentConfig& config,
                                 const std::vector<ScheduledMatch>& matches) {
  std::vector<std::string> names;
  const std::vector<RankedTable> all = tables(config, matches);
  for (const Standing& row : all.back().standings) {
    names.push_back(config.teams[static_cast<std::size_t>(row.team)].name);
  }
  return names;
}

base::Result<void> FakeExecutor::start(std::span<const Assignment> assignments) {
  for (const Assignment& assignment : assignments) {
    record_.started.push_back(assignment);
    running_.push_back(assignment);
  }
  return {};
}

base::Result<std::vector<FinishedMatch>> FakeExecutor::wait(std::chrono::milliseconds) {
  std::vector<FinishedMatch> finished;
  std::vector<Assignment> running;
  for (const Assignment& assignment : running_) {
    auto outcome = interrupted_ ? std::nullopt : referee_(assignment);
    if (!outcome && !interrupted_) {
      running.push_back(assignment);
      continue;
    }
    if (outcome) outcome->attempts = assignment.number;
    finished.push_back({assignment.fixture.index, std::move(outcome)});
  }
  running_ = std::move(running);
  if (finished.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return finished;
}

void FakeExecutor::interrupt() {
  interrupted_ = true;
  ++record_.interruptions;
}

}  // namespace cls::tournament
