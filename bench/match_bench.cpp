// A match between mocks: cycles per second, and the time of each part.
#include <benchmark/benchmark.h>

#include <utility>

#include "bench/measure.h"
#include "tests/support/mock_match.h"

namespace cls::bench {
namespace {

void mock_match(benchmark::State& bench) {
  const auto threads = static_cast<int>(bench.range(0));
  const auto steps = static_cast<int>(bench.range(1));
  const auto calls =
      bench.range(2) != 0 ? tests::MockCalls::kGrpcInProcess : tests::MockCalls::kDirect;
  for (auto _ : bench) {
    tests::MockMatch match(7, threads, calls);
    const auto begin = Clock::now();
    match.play(steps);
    const double took = seconds_since(begin);
    bench.SetIterationTime(took);

    bench.counters["steps_per_second"] = steps / took;
    bench.counters["simulator_us"] = match.simulator_seconds() * 1e6 / steps;
    for (const auto& [name, member] : {std::pair{"perceive_us", &proxy::TeamTimes::perceive},
                                       {"state_us", &proxy::TeamTimes::state},
                                       {"begin_us", &proxy::TeamTimes::begin},
                                       {"wait_us", &proxy::TeamTimes::wait},
                                       {"act_us", &proxy::TeamTimes::act}}) {
      const auto sum = match.team(0).times().*member + match.team(1).times().*member;
      bench.counters[name] = static_cast<double>(sum.count()) * 1e-3 / steps;
    }
    const auto mock_ns =
        match.mock(0).decision_nanoseconds() + match.mock(1).decision_nanoseconds();
    bench.counters["mock_us"] = static_cast<double>(mock_ns) * 1e-3 / steps;
  }
}
BENCHMARK(mock_match)
    ->ArgNames({"threads", "steps", "grpc"})
    ->ArgsProduct({{1, 2}, {2000}, {0, 1}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cls::bench
