// A match between mocks: cycles per second, and the time of each part.
#include <benchmark/benchmark.h>

#include <chrono>

#include "tests/support/mock_match.h"

namespace cls::bench {
namespace {

double us(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) * 1e-3; }

void mock_match(benchmark::State& bench) {
  const auto threads = static_cast<int>(bench.range(0));
  const auto steps = static_cast<int>(bench.range(1));
  const auto calls =
      bench.range(2) != 0 ? tests::MockCalls::kGrpcInProcess : tests::MockCalls::kDirect;
  for (auto _ : bench) {
    tests::MockMatch match(7, threads, calls);
    const auto begin = std::chrono::steady_clock::now();
    match.play(steps);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    bench.SetIterationTime(took.count());
    const auto per_step = [&](double microseconds) { return microseconds / steps; };
    proxy::TeamTimes sum;
    double mock_us = 0.0;
    for (const int side : {0, 1}) {
      const proxy::TeamTimes& times = match.team(side).times();
      sum.perceive += times.perceive;
      sum.state += times.state;
      sum.begin += times.begin;
      sum.wait += times.wait;
      sum.act += times.act;
      mock_us += static_cast<double>(match.mock(side).decision_nanoseconds()) * 1e-3;
    }
    bench.counters["steps_per_second"] = steps / took.count();
    bench.counters["simulator_us"] = per_step(match.simulator_seconds() * 1e6);
    bench.counters["perceive_us"] = per_step(us(sum.perceive));
    bench.counters["state_us"] = per_step(us(sum.state));
    bench.counters["begin_us"] = per_step(us(sum.begin));
    bench.counters["wait_us"] = per_step(us(sum.wait));
    bench.counters["act_us"] = per_step(us(sum.act));
    bench.counters["mock_us"] = per_step(mock_us);
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
