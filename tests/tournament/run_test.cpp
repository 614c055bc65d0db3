// Running a tournament: storing, resuming, rerunning, forfeits and automatic concurrency.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "league/schedule/schedule.h"
#include "match/result/match_result.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/report/report_model.h"
#include "tournament/run/tournament_run.h"
#include "tournament/slots/concurrency.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"
#include "tournament/store/store.h"

namespace cls::tournament {
namespace {

using soccer::EndReason;

namespace fs = std::filesystem;

class TournamentRunTest : public testing::Test {
 protected:
  using Judge = std::function<std::optional<Outcome>(const Assignment&)>;

  RunSummary run(TournamentConfig config, Judge judge) {
    EXPECT_TRUE(prepare_folder(folder_.path(), config).ok());
    RunOptions options;
    options.folder = folder_.path();
    options.config = std::move(config);
    options.decided = decided_;
    options.last_match = last_match_;
    const auto make = [&](const TournamentConfig&) {
      return base::Result<std::unique_ptr<MatchExecutor>>(
          std::make_unique<FakeExecutor>(judge, record_));
    };
    TournamentObserver observer;
    auto summary = run_tournament(options, make, observer, signal_);
    if (!summary) throw std::runtime_error(summary.error().message);
    return *std::move(summary);
  }

  std::vector<base::Json> events() const {
    std::vector<base::Json> all;
    std::istringstream lines(tests::read_file(folder_.path() / "events.jsonl"));
    for (std::string line; std::getline(lines, line);) all.push_back(base::Json::parse(line));
    return all;
  }

  std::map<int, int> starts() const {
    std::map<int, int> times;
    for (const Assignment& one : record_.started) ++times[one.fixture.index];
    return times;
  }

  tests::TemporaryFolder folder_;
  FakeExecutor::Record record_;
  std::function<bool(std::span<const ScheduledMatch>)> decided_;
  std::optional<int> last_match_;
  std::atomic<int> signal_{0};
};

std::optional<Outcome> fair(const Assignment& assignment) {
  return better_wins(assignment.fixture);
}

TEST_F(TournamentRunTest, PlaysEveryMatchOnceAndStoresIt) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 4);
  const RunSummary summary = run(config, fair);
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(summary.progress.done, 12);
  EXPECT_EQ(record_.started.size(), 12u);

  const auto state = read_tournament(folder_.path());
  ASSERT_TRUE(state) << state.error().message;
  EXPECT_EQ(state->matches.size(), 12u);
  EXPECT_EQ(ranking(state->config.competition, state->matches),
            (std::vector<std::string>{"A", "B", "C", "D"}));
  EXPECT_TRUE(state->running.empty());

  run(config, fair);
  EXPECT_EQ(record_.started.size(), 12u) << "no match is played twice";
}

TEST_F(TournamentRunTest, NumbersEventsOverAllRuns) {
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

TEST_F(TournamentRunTest, PlaysOnWhenEventsCannotBeWritten) {
  fs::create_symlink("/dev/full", folder_.path() / "events.jsonl");
  const RunSummary summary = run(config_of(Format::kRoundRobin, 3), fair);
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(summary.progress.done, 6);
  EXPECT_NE(summary.write_error.find("events.jsonl: No space left on device"), std::string::npos)
      << summary.write_error;
}

TEST_F(TournamentRunTest, ResumesRoundsThatDependOnStoredResults) {
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
  const auto uninterrupted = play_all(config.competition, better_wins);
  ASSERT_EQ(state->matches.size(), uninterrupted.size());

  for (std::size_t i = 0; i < uninterrupted.size(); ++i) {
    EXPECT_EQ(state->matches[i].fixture, uninterrupted[i].fixture);
  }
  EXPECT_EQ(ranking(config.competition, state->matches),
            ranking(config.competition, uninterrupted));
}

TEST_F(TournamentRunTest, StopsAtFaultAndReplaysThatMatchInNextRun) {
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  const auto broken = [](const Assignment& one) -> std::optional<Outcome> {
    if (one.fixture.index == 3 && one.number == 1) return fault(EndReason::kCrashed);
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

  std::map<int, int> final_results;
  for (const auto& event : events()) {
    if (event["type"] == "match_finished" && !event["again"].get<bool>())
      ++final_results[event["match"].get<int>()];
  }

  EXPECT_EQ(final_results[3], 1) << "the match is played again";
}

TEST_F(TournamentRunTest, LeavesFoldersOfWorkProcessesThatAreAlive) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const std::string own = unfinished_host() + "-" + std::to_string(::getpid());
  const fs::path alive = folder_.path() / unfinished_folder(1, 1, own);
  // Above the highest number that a kernel gives.
  const fs::path killed = folder_.path() / unfinished_folder(1, 1, unfinished_host() + "-4999999");
  fs::create_directories(alive);
  fs::create_directories(killed);
  run(config, fair);
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_FALSE(fs::exists(killed));
}

// A `work` process may be killed at any moment, also when the match has an outcome already.
TEST_F(TournamentRunTest, RemovesWhatKilledWorkProcessesLeft) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const auto leftover = [&](const std::string& extension) {
    fs::path path = folder_.path() / unfinished_folder(1, 1, unfinished_host() + "-4999999");
    path += extension;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "{";
    return path;
  };
  std::vector<fs::path> left = {leftover(".json"), folder_.path() / "unfinished/.partial-1.json",
                                folder_.path() / ".partial-2.jsonl"};
  for (std::size_t i = 1; i < left.size(); ++i) std::ofstream(left[i]) << "{";
  int played = 0;
  run(config, [&](const Assignment& one) {
    if (++played > 1) left.push_back(leftover(""));  // when match 1 has its outcome
    return fair(one);
  });
  for (const fs::path& path : left) EXPECT_FALSE(fs::exists(path)) << path;
}

TEST_F(TournamentRunTest, ScoresForfeitThreeNilAgainstSideAtFault) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.execution.on_crash = OnCrash::kForfeit;
  const RunSummary summary = run(config, [](const Assignment& one) -> std::optional<Outcome> {
    Outcome outcome = fault(EndReason::kCrashed);
    if (one.fixture.index == 2) outcome.fault.reset();
    return outcome;
  });

  EXPECT_EQ(summary.end, RunEnd::kComplete);

  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_TRUE(matches[0].outcome->forfeit);
  EXPECT_EQ(matches[0].outcome->left_score, 0);
  EXPECT_EQ(matches[0].outcome->right_score, 3);
  EXPECT_EQ(matches[0].outcome->end_reason, EndReason::kCrashed);
  EXPECT_FALSE(matches[1].outcome->counts()) << "no forfeit without a side at fault";
  EXPECT_EQ(summary.progress.invalid, 1);
}

// Who is six goals behind does not gain by leaving.
TEST_F(TournamentRunTest, KeepsAScoreThatIsWorseThanAForfeit) {
  const std::vector<std::pair<int, int>> played = {{0, 6}, {1, 3}, {2, 0}, {1, 4}};
  const std::vector<std::pair<int, int>> counted = {{0, 6}, {0, 3}, {0, 3}, {1, 4}};
  for (std::size_t i = 0; i < played.size(); ++i) {
    TournamentConfig config = config_of(Format::kRoundRobin, 2);
    config.execution.on_crash = OnCrash::kForfeit;
    fs::remove_all(folder_.path());
    run(config, [&](const Assignment&) -> std::optional<Outcome> {
      Outcome outcome = fault(EndReason::kCrashed);
      outcome.left_score = played[i].first;
      outcome.right_score = played[i].second;
      return outcome;
    });

    const Outcome outcome = *read_tournament(folder_.path())->matches[0].outcome;
    EXPECT_TRUE(outcome.forfeit);
    EXPECT_EQ(std::pair(outcome.left_score, outcome.right_score), counted[i]);
  }
}

TEST_F(TournamentRunTest, LimitsReruns) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.execution.on_crash = OnCrash::kRerun;
  config.execution.max_reruns = 2;
  const RunSummary summary = run(config, [](const Assignment& one) -> std::optional<Outcome> {
    if (one.fixture.index == 1 && one.number < 3) return fault(EndReason::kStalled);
    if (one.fixture.index == 2) return fault(EndReason::kStalled);
    return better_wins(one.fixture);
  });

  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(starts()[1], 3);
  EXPECT_EQ(starts()[2], 3);

  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_TRUE(matches[0].outcome->played());
  EXPECT_EQ(matches[0].outcome->attempts, 3);
  EXPECT_EQ(matches[1].outcome->end_reason, EndReason::kStalled);
}

TEST_F(TournamentRunTest, StopsWhenDecided) {
  decided_ = [](std::span<const ScheduledMatch> matches) { return count(matches).finished >= 5; };
  TournamentConfig config = config_of(Format::kRoundRobin, 5);
  EXPECT_EQ(run(config, fair).end, RunEnd::kDecided);
  EXPECT_LE(record_.started.size(), 7u);
  run(config, fair);
  EXPECT_LE(record_.started.size(), 7u) << "it is still decided";
}

TEST_F(TournamentRunTest, PlaysNoMatchAfterTheLast) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 4);
  last_match_ = 5;
  const RunSummary some = run(config, fair);
  EXPECT_EQ(some.end, RunEnd::kComplete);
  EXPECT_EQ(some.progress.total, 5);
  EXPECT_EQ(some.progress.done, 5);
  EXPECT_EQ(some.matches.size(), 5u);

  last_match_ = 3;
  EXPECT_EQ(run(config, fair).progress.done, 3) << "two of the store do not count";
  EXPECT_EQ(record_.started.size(), 5u);

  last_match_.reset();
  EXPECT_EQ(run(config, fair).progress.done, 12);
}

TEST_F(TournamentRunTest, CollectsResultFilesOfWork) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const auto fixtures = next_fixtures(config.competition, {});
  fs::create_directories(folder_.path() / "results");
  Outcome outcome = score(4, 2);

  ASSERT_TRUE(
      base::write_file(folder_.path() / result_file(2, 1), format_work_result(fixtures[1], outcome))
          .ok());

  std::ofstream(folder_.path() / "results" / "000001.1.json.tmp") << "{";
  std::ofstream(folder_.path() / "results" / "000001.1.json") << "{ half";
  const std::vector<ScheduledMatch> unplayed = {planned(fixtures[0]), planned(fixtures[1])};
  const auto results = collect_work_results(folder_.path(), unplayed);

  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].index, 2);
  EXPECT_EQ(results[0].outcome.left_score, 4);
}

TEST_F(TournamentRunTest, RecoversResultOfMatchThatOutlivedTheRun) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  ASSERT_TRUE(prepare_folder(folder_.path(), config).ok());

  {
    auto store = Store::open(folder_.path() / "tournament.db");
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->add(next_fixtures(config.competition, {})).ok());
    ASSERT_TRUE(store->begin_attempts(std::vector{1, 2}).ok());
  }
  match::MatchResult result;
  result.left.name = "A";
  result.left.score = 2;
  result.seed = next_fixtures(config.competition, {})[0].seed;
  const fs::path finished =
      folder_.path() / match_folder(config, next_fixtures(config.competition, {})[0], 1);
  fs::create_directories(finished);

  ASSERT_TRUE(base::write_file(finished / "result.json", to_json(result)).ok());

  result.end_reason = soccer::EndReason::kInterrupted;
  result.seed = next_fixtures(config.competition, {})[1].seed;
  const fs::path broken =
      folder_.path() / match_folder(config, next_fixtures(config.competition, {})[1], 1);
  fs::create_directories(broken);

  ASSERT_TRUE(base::write_file(broken / "result.json", to_json(result)).ok());

  run(config, fair);
  EXPECT_EQ(starts().count(1), 0u);
  EXPECT_EQ(starts()[2], 1);
  EXPECT_EQ(record_.started.front().number, 2) << "the second attempt";

  const auto matches = read_tournament(folder_.path())->matches;
  EXPECT_EQ(matches[0].outcome->left_score, 2);
  EXPECT_FALSE(fs::exists(broken)) << "the folder of an interrupted attempt is removed";
}

TEST(Concurrency, DecreasesAfterMissedCycles) {
  TournamentConfig config;
  Concurrency automatic(config, 4);
  EXPECT_EQ(automatic.current(), 4);

  Outcome clean = score(0, 0);
  EXPECT_FALSE(automatic.adapt(clean));

  Outcome missed = score(0, 0);
  missed.right.missed = 1;
  EXPECT_TRUE(automatic.adapt(missed));
  EXPECT_EQ(automatic.current(), 3);

  for (int i = 0; i < 10; ++i) automatic.adapt(clean);
  EXPECT_EQ(automatic.current(), 3) << "a number that was too high is not tried again";

  for (int i = 0; i < 10; ++i) automatic.adapt(missed);
  EXPECT_EQ(automatic.current(), 1);
}

TEST(Concurrency, AssignsWholeCoresToEachMatch) {
  const std::vector<std::vector<int>> cores = {{0, 4}, {1, 5}, {2, 6}, {3, 7}, {8}};
  EXPECT_EQ(cpus_of_slot(cores, 0, 2), (std::vector<int>{0, 4, 1, 5}));
  EXPECT_EQ(cpus_of_slot(cores, 1, 2), (std::vector<int>{2, 6, 3, 7}));
  EXPECT_EQ(cpus_of_slot(cores, 4, 5), (std::vector<int>{8}));
  EXPECT_EQ(cpus_of_slot(cores, 6, 9), (std::vector<int>{1, 5})) << "more matches than cores";
  EXPECT_TRUE(cpus_of_slot({}, 1, 2).empty()) << "no pinning";
}

TEST(Concurrency, StartsLowAndIncreasesInRealTime) {
  TournamentConfig config;
  config.conditions.options["mode"] = "realtime";
  Concurrency automatic(config, 8);
  EXPECT_EQ(automatic.current(), 2);

  const Outcome clean = score(0, 0);
  EXPECT_FALSE(automatic.adapt(clean));
  EXPECT_TRUE(automatic.adapt(clean));
  EXPECT_EQ(automatic.current(), 3);

  config.execution.concurrency = 5;
  Concurrency given(config, 1);
  EXPECT_EQ(given.current(), 5);
  EXPECT_FALSE(given.adapt(clean));
}

}  // namespace
}  // namespace cls::tournament
