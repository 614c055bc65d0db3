// Running a tournament: what is stored, what is played again and what never is.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/io/whole_file.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/tournament/report/report_model.h"
#include "orchestration/tournament/run/concurrency.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/store/collector.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_document.h"
#include "orchestration/tournament/store/store.h"
#include "tests/orchestration/tournament/played.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;

class TournamentRunTest : public testing::Test {
 protected:
  using Judge = std::function<std::optional<Outcome>(const Assignment&)>;

  RunSummary run(TournamentConfig config, Judge judge) {
    EXPECT_TRUE(prepare_folder(folder_.path(), config).ok());
    RunOptions options;
    options.folder = folder_.path();
    options.config = std::move(config);
    options.enough = enough_;
    const auto make = [&](const TournamentConfig&) {
      return base::Result<std::unique_ptr<MatchExecutor>>(
          std::make_unique<FakeExecutor>(judge, record_));
    };
    TournamentObserver nobody;
    auto summary = run_tournament(options, make, nobody, signal_);
    if (!summary) throw std::runtime_error(summary.error().message);
    return *std::move(summary);
  }

  std::vector<nlohmann::json> events() const {
    std::vector<nlohmann::json> all;
    std::istringstream lines(tests::read_file(folder_.path() / "events.jsonl"));
    for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }

  std::map<int, int> starts() const {
    std::map<int, int> times;
    for (const Assignment& one : record_.started) ++times[one.fixture.index];
    return times;
  }

  tests::TemporaryFolder folder_;
  FakeExecutor::Record record_;
  std::function<bool(std::span<const ScheduledMatch>)> enough_;
  std::atomic<int> signal_{0};
};

std::optional<Outcome> fair(const Assignment& assignment) {
  return better_wins(assignment.fixture);
}

TEST_F(TournamentRunTest, PlaysEverythingOnceAndKeepsIt) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 4);
  const RunSummary summary = run(config, fair);
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(summary.progress.done, 12);
  EXPECT_EQ(record_.started.size(), 12u);
  const auto state = read_tournament(folder_.path());
  ASSERT_TRUE(state) << state.error().message;
  EXPECT_EQ(state->matches.size(), 12u);
  EXPECT_EQ(ranking(state->config, state->matches), (std::vector<std::string>{"A", "B", "C", "D"}));
  EXPECT_TRUE(state->running.empty());
  run(config, fair);
  EXPECT_EQ(record_.started.size(), 12u) << "nothing is played twice";
}

TEST_F(TournamentRunTest, EventsAreNumberedOverAllRuns) {
  run(config_of(Format::kRoundRobin, 2), fair);
  run(config_of(Format::kRoundRobin, 2), fair);
  const auto all = events();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i]["schema"], "cls.events/1");
    EXPECT_EQ(all[i]["seq"], i);
  }
  EXPECT_EQ(all.front()["type"], "tournament_started");
  EXPECT_EQ(all.back()["type"], "tournament_ended");
  EXPECT_EQ(all.back()["end"], "complete");
}

TEST_F(TournamentRunTest, RoundsThatFollowFromResultsAreDrawnFromTheStore) {
  TournamentConfig config = config_of(Format::kDoubleElimination, 6);
  int left = 4;
  const auto some = [&](const Assignment& assignment) -> std::optional<Outcome> {
    if (left == 0) {
      signal_ = SIGINT;
      return std::nullopt;
    }
    --left;
    return better_wins(assignment.fixture);
  };
  int runs = 0;
  for (RunEnd end = RunEnd::kInterrupted; end != RunEnd::kComplete; ++runs) {
    left = 4;
    signal_ = 0;
    end = run(config, some).end;
    ASSERT_LT(runs, 20);
  }
  EXPECT_GT(runs, 2);
  const auto state = read_tournament(folder_.path());
  const auto unbroken = play_all(config, better_wins);
  ASSERT_EQ(state->matches.size(), unbroken.size());
  for (std::size_t i = 0; i < unbroken.size(); ++i) {
    EXPECT_EQ(state->matches[i].fixture, unbroken[i].fixture);
  }
  EXPECT_EQ(ranking(config, state->matches), ranking(config, unbroken));
}

TEST_F(TournamentRunTest, AFaultStopsAndTheNextRunPlaysThatMatchAgain) {
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  const auto broken = [](const Assignment& one) -> std::optional<Outcome> {
    if (one.fixture.index == 3 && one.number == 1) return fault("crashed");
    return better_wins(one.fixture);
  };
  const RunSummary first = run(config, broken);
  EXPECT_EQ(first.end, RunEnd::kFault);
  EXPECT_EQ(first.message, "match 3 is invalid (crashed): its process ended");
  EXPECT_EQ(count(read_tournament(folder_.path())->matches).invalid, 1);
  const RunSummary second = run(config, broken);
  EXPECT_EQ(second.end, RunEnd::kComplete);
  EXPECT_EQ(second.progress.invalid, 0);
  EXPECT_EQ(starts()[3], 2);
}

TEST_F(TournamentRunTest, AForfeitIsThreeNilAgainstTheSideAtFault) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.on_crash = OnCrash::kForfeit;
  const RunSummary summary = run(config, [](const Assignment& one) -> std::optional<Outcome> {
    Outcome outcome = fault("crashed");
    if (one.fixture.index == 2) outcome.fault.reset();
    return outcome;
  });
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_TRUE(matches[0].outcome->forfeit);
  EXPECT_EQ(matches[0].outcome->left_score, 0);
  EXPECT_EQ(matches[0].outcome->right_score, 3);
  EXPECT_EQ(matches[0].outcome->end_reason, "crashed");
  EXPECT_FALSE(matches[1].outcome->counts()) << "nobody's fault is nobody's forfeit";
  EXPECT_EQ(summary.progress.invalid, 1);
}

TEST_F(TournamentRunTest, RerunsAreLimited) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.on_crash = OnCrash::kRerun;
  config.max_reruns = 2;
  const RunSummary summary = run(config, [](const Assignment& one) -> std::optional<Outcome> {
    if (one.fixture.index == 1 && one.number < 3) return fault("stalled");
    if (one.fixture.index == 2) return fault("stalled");
    return better_wins(one.fixture);
  });
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(starts()[1], 3);
  EXPECT_EQ(starts()[2], 3);
  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_TRUE(matches[0].outcome->played());
  EXPECT_EQ(matches[0].outcome->attempts, 3);
  EXPECT_EQ(matches[1].outcome->end_reason, "stalled");
}

TEST_F(TournamentRunTest, EnoughEndsTheRun) {
  enough_ = [](std::span<const ScheduledMatch> matches) { return count(matches).finished >= 5; };
  TournamentConfig config = config_of(Format::kRoundRobin, 5);
  EXPECT_EQ(run(config, fair).end, RunEnd::kDecided);
  EXPECT_LE(record_.started.size(), 7u);
  run(config, fair);
  EXPECT_LE(record_.started.size(), 7u) << "it is still decided";
}

TEST_F(TournamentRunTest, WhatWorkLeftIsTakenUp) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const auto fixtures = next_fixtures(config, {});
  fs::create_directories(folder_.path() / "results");
  Outcome outcome = score(4, 2);
  ASSERT_TRUE(
      base::write_file(folder_.path() / result_file(2, 1), outcome_document(fixtures[1], outcome))
          .ok());
  std::ofstream(folder_.path() / "results" / "000001.1.json.tmp") << "{";
  std::ofstream(folder_.path() / "results" / "000001.1.json") << "{ half";
  const std::vector<ScheduledMatch> planned_ones = {planned(fixtures[0]), planned(fixtures[1])};
  const auto deliveries = collect_results(folder_.path(), planned_ones);
  ASSERT_EQ(deliveries.size(), 1u);
  EXPECT_EQ(deliveries[0].index, 2);
  EXPECT_EQ(deliveries[0].outcome.left_score, 4);
}

TEST_F(TournamentRunTest, AMatchThatEndedWhenClsDidIsNotPlayedAgain) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  ASSERT_TRUE(prepare_folder(folder_.path(), config).ok());
  {
    auto store = Store::open(folder_.path() / "tournament.db");
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->add(next_fixtures(config, {})).ok());
    ASSERT_TRUE(store->begin_attempts(std::vector{1, 2}).ok());
  }
  match::MatchResult result;
  result.left.name = "A";
  result.left.score = 2;
  const fs::path finished = folder_.path() / match_folder(config, next_fixtures(config, {})[0], 1);
  fs::create_directories(finished);
  ASSERT_TRUE(base::write_file(finished / "result.json", to_json(result)).ok());
  result.end_reason = match::EndReason::kInterrupted;
  const fs::path broken = folder_.path() / match_folder(config, next_fixtures(config, {})[1], 1);
  fs::create_directories(broken);
  ASSERT_TRUE(base::write_file(broken / "result.json", to_json(result)).ok());
  run(config, fair);
  EXPECT_EQ(starts().count(1), 0u);
  EXPECT_EQ(starts()[2], 1);
  EXPECT_EQ(record_.started.front().number, 2) << "the second attempt";
  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_EQ(matches[0].outcome->left_score, 2);
  EXPECT_FALSE(fs::exists(broken)) << "an attempt without result leaves nothing";
}

TEST(Store, KeepsEveryField) {
  const tests::TemporaryFolder folder;
  Outcome outcome = fault("late");
  outcome.left_score = 1;
  outcome.left_penalties = 3;
  outcome.right_penalties = 0;
  outcome.cycles = 77;
  outcome.wall_seconds = 1.5;
  outcome.run_seconds = 1.75;
  outcome.cycles_per_second = 51.25;
  outcome.deterministic = false;
  outcome.mode = "lockstep";
  outcome.started = "2026-01-01T00:00:00Z";
  outcome.ended = "2026-01-01T00:00:02Z";
  outcome.host = "here";
  outcome.load = 0.5;
  outcome.version = "1";
  outcome.server = "embedded 1";
  outcome.folder = "matches/1";
  outcome.left = {10, 2, 3, 4.5, 9.5, 0.25};
  outcome.right = {11, 0, 1, 5.5, 8.5, 0.75};
  const auto fixtures = next_fixtures(config_of(Format::kKnockout, 2), {});
  {
    auto store = Store::open(folder.path() / "db");
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->add(fixtures).ok());
    EXPECT_EQ(*store->begin_attempts(std::vector{1}), std::vector{1});
    EXPECT_EQ(*store->running(), std::vector{1});
    ASSERT_TRUE(store->finish(1, outcome).ok());
  }
  const auto store = Store::open_to_read(folder.path() / "db");
  ASSERT_TRUE(store);
  const auto matches = store->matches();
  ASSERT_TRUE(matches);
  EXPECT_EQ((*matches)[0].fixture, fixtures[0]);
  const auto config = config_of(Format::kKnockout, 2);
  ScheduledMatch before = planned(fixtures[0]);
  before.outcome = outcome;
  EXPECT_EQ(json_of(config, (*matches)[0]), json_of(config, before));
  EXPECT_FALSE((*matches)[1].outcome);
  const auto again = outcome_from_document(outcome_document(fixtures[0], outcome));
  ASSERT_TRUE(again);
  before.outcome = again->outcome;
  EXPECT_EQ(json_of(config, (*matches)[0]), json_of(config, before));
}

TEST(Store, TwoRunsAtOnceAreRefused) {
  const tests::TemporaryFolder folder;
  const auto first = FolderLock::take(folder.path());
  ASSERT_TRUE(first && *first);
  const auto second = FolderLock::take(folder.path());
  ASSERT_TRUE(second.ok());
  EXPECT_FALSE(second->has_value());
}

TEST(Concurrency, GoesDownWhenCyclesAreMissed) {
  TournamentConfig config;
  Concurrency automatic(config, 4);
  EXPECT_EQ(automatic.now(), 4);
  Outcome clean = score(0, 0);
  EXPECT_FALSE(automatic.learn(clean));
  Outcome missed = score(0, 0);
  missed.right.missed = 1;
  EXPECT_TRUE(automatic.learn(missed));
  EXPECT_EQ(automatic.now(), 3);
  for (int i = 0; i < 10; ++i) automatic.learn(clean);
  EXPECT_EQ(automatic.now(), 3) << "what was too much is not tried again";
  for (int i = 0; i < 10; ++i) automatic.learn(missed);
  EXPECT_EQ(automatic.now(), 1);
}

TEST(Concurrency, EachMatchHasWholeCoresOfItsOwn) {
  const std::vector<std::vector<int>> cores = {{0, 4}, {1, 5}, {2, 6}, {3, 7}, {8}};
  EXPECT_EQ(share_of(cores, 0, 2), (std::vector<int>{0, 4, 1, 5}));
  EXPECT_EQ(share_of(cores, 1, 2), (std::vector<int>{2, 6, 3, 7}));
  EXPECT_EQ(share_of(cores, 4, 5), (std::vector<int>{8}));
  EXPECT_EQ(share_of(cores, 6, 9), (std::vector<int>{1, 5})) << "more matches than cores";
  EXPECT_TRUE(share_of({}, 1, 2).empty()) << "nobody is pinned";
}

TEST(Concurrency, AgainstTheClockItBeginsLowAndGrows) {
  TournamentConfig config;
  config.mode = "realtime";
  Concurrency automatic(config, 8);
  EXPECT_EQ(automatic.now(), 2);
  const Outcome clean = score(0, 0);
  EXPECT_FALSE(automatic.learn(clean));
  EXPECT_TRUE(automatic.learn(clean));
  EXPECT_EQ(automatic.now(), 3);
  config.concurrency = 5;
  Concurrency given(config, 1);
  EXPECT_EQ(given.now(), 5);
  EXPECT_FALSE(given.learn(clean));
}

}  // namespace
}  // namespace cls::orchestration::tournament
