// Cost of a tournament in addition to its matches: planning, store, processes.
#include <benchmark/benchmark.h>

#include <atomic>
#include <chrono>
#include <string>

#include "base/text/json.h"
#include "bench/measure.h"
#include "league/schedule/schedule.h"
#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"
#include "tournament/run/match_executor.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/folder.h"
#include "tournament/store/store.h"

namespace cls::bench {
namespace {

using namespace tournament;

TournamentConfig two_mocks(int rounds) {
  TournamentConfig config;
  config.competition.teams = {{"RED", "mock"}, {"BLUE", "mock"}};
  config.competition.rounds = rounds;
  return config;
}

void plan_a_million_matches(benchmark::State& state) {
  const TournamentConfig config = two_mocks(500'000);
  for (auto _ : state) {
    const double before = peak_megabytes();
    const auto fixtures = next_fixtures(config.competition, {});
    state.counters["matches"] = static_cast<double>(fixtures.size());
    state.counters["grown_MB"] = peak_megabytes() - before;
  }
}
BENCHMARK(plan_a_million_matches)->Iterations(1)->Unit(benchmark::kMillisecond);

void store_a_million_rows(benchmark::State& state) {
  const auto fixtures = next_fixtures(two_mocks(500'000).competition, {});
  for (auto _ : state) {
    const tests::TemporaryFolder folder;
    auto store = Store::open(folder.path() / kStoreFile);
    if (!store || !store->add(fixtures)) state.SkipWithError("store");
    const auto begin = Clock::now();
    const auto read = store->matches();
    state.counters["read_s"] = seconds_since(begin);
    state.counters["MB"] =
        static_cast<double>(std::filesystem::file_size(folder.path() / kStoreFile)) / 1e6;
    state.counters["peak_MB"] = peak_megabytes();
  }
}
BENCHMARK(store_a_million_rows)->Iterations(1)->Unit(benchmark::kMillisecond);

// Matches that take no time.
class InstantMatches : public MatchExecutor {
 public:
  int free_slots() const override { return 2 - running(); }
  int running() const override { return static_cast<int>(ended_.size()); }
  base::Result<void> start(std::span<const Assignment> assignments) override {
    for (const Assignment& one : assignments) {
      Outcome outcome;
      outcome.attempts = one.number;
      ended_.push_back({one.fixture.index, outcome});
    }
    return {};
  }
  base::Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds) override {
    return std::exchange(ended_, {});
  }
  void interrupt() override {}

 private:
  std::vector<FinishedMatch> ended_;
};

// Schedule, two commits and two events per match, each synced to disk.
void bookkeeping_per_match(benchmark::State& state) {
  constexpr int kMatches = 500;
  const std::atomic<int> no_signal{0};
  for (auto _ : state) {
    const tests::TemporaryFolder folder;
    RunOptions options;
    options.folder = folder.path();
    options.config = two_mocks(kMatches / 2);
    TournamentObserver observer;

    const auto begin = Clock::now();
    const auto summary = run_tournament(
        options,
        [](const TournamentConfig&) {
          return base::Result<std::unique_ptr<MatchExecutor>>(std::make_unique<InstantMatches>());
        },
        observer, no_signal);
    if (!summary || summary->progress.done != kMatches) state.SkipWithError("run");
    state.counters["ms_per_match"] = 1e3 * seconds_since(begin) / kMatches;
  }
}
BENCHMARK(bookkeeping_per_match)->Iterations(1)->Unit(benchmark::kMillisecond);

// Real processes, two in parallel: which share of the time do they play?
void matches_of_mocks(benchmark::State& state) {
  constexpr int kConcurrency = 2;
  const tests::TemporaryFolder folder;
  for (auto _ : state) {
    const auto begin = Clock::now();
    tests::Command playing({tests::cls_binary(), "tournament", "run", folder.path(), "--team",
                            "RED=mock", "--team", "BLUE=mock", "--rounds", "4", "--cycles", "1500",
                            "--concurrency", std::to_string(kConcurrency), "--keep-logs", "none",
                            "--json"});
    const auto played = playing.finish(std::chrono::minutes(15));
    const double elapsed = seconds_since(begin);

    if (played.exit_code != 0) {
      state.SkipWithError(played.err.c_str());
      return;
    }

    const auto report = base::Json::parse(played.out);
    double in_matches = 0.0;
    double processes = 0.0;
    for (const auto& match : report["matches"]) {
      in_matches += match["wall_seconds"].get<double>();
      processes += match["run_seconds"].get<double>() - match["wall_seconds"].get<double>();
    }

    const auto matches = static_cast<double>(report["matches"].size());
    state.counters["share_in_matches"] = in_matches / (kConcurrency * elapsed);
    state.counters["start_and_end_ms"] = 1e3 * processes / matches;
    state.counters["matches_of_6000_per_core_hour"] =
        matches * 1500 / 6000 * 3600 / (kConcurrency * elapsed);
  }
}
BENCHMARK(matches_of_mocks)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace cls::bench
