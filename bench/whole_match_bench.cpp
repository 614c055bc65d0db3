// A whole match as `cls match mock mock` plays it, compared with the upper bound of gRPC alone,
// measured in the same run.
#include <benchmark/benchmark.h>

#include <atomic>

#include "base/io/byte_sink.h"
#include "bench/measure.h"
#include "bench/rpc_ceiling.h"
#include "match/match_setup.h"
#include "match/sides/agent_side.h"

namespace cls::bench {
namespace {

double process_cpu_seconds() { return cpu_seconds(CLOCK_PROCESS_CPUTIME_ID); }

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

double agent_seconds(const proxy::TeamTimes& times) {
  return seconds(times.perceive) + seconds(times.state) + seconds(times.act);
}

// Both sides run in parallel on two cores, so their times add up to CPU time on an idle host. The
// rest after simulator, agents and mock is RPC: serializing, gRPC's client and server, its
// threads.
void report(benchmark::State& bench, const match::Match& match, double cpu) {
  const match::MatchResult result = match.result();
  const auto steps = static_cast<double>(result.steps);
  double agents = 0.0;
  double mock = 0.0;
  for (const auto& each : match.sides()) {
    const auto& side = dynamic_cast<const match::AgentSide&>(*each);
    agents += agent_seconds(side.team().times());
    mock += side.mock_cpu_seconds();
  }

  const double simulator = match.times().server;
  const auto us_per_step = [steps](double total) { return total * 1e6 / steps; };

  bench.counters["cycles_per_second"] = result.cycles_per_second;
  bench.counters["steps_per_second"] = steps / match.times().play;
  bench.counters["simulator_us"] = us_per_step(simulator);
  bench.counters["proxy_us"] = us_per_step(agents);
  bench.counters["mock_us"] = us_per_step(mock);
  bench.counters["rpc_us"] = us_per_step(cpu - simulator - agents - mock);
  bench.counters["cpu_us"] = us_per_step(cpu);
  bench.counters["peak_MB"] = peak_megabytes();
}

void whole_match(benchmark::State& bench) {
  constexpr int kThreads = 2;
  constexpr double kCeilingSeconds = 3.0;
  const protos::State state = typical_state();
  for (auto _ : bench) {
    const auto ceiling = [&] {
      return measure_rpc_ceiling(Transport::kInProcess, kThreads, Asking::kEachAgent, state,
                                 kCeilingSeconds)
          .cycles_per_second;
    };
    const double before = ceiling();

    const match::MatchOptions options;
    const std::atomic<int> no_signal{0};
    const match::TeamNames names{"mock_l", "mock_r"};
    base::StringSink game_log;
    base::StringSink text_log;
    base::StringSink event_lines;
    match::EventRecorder events(event_lines);
    match::MatchObserver observer;
    auto match =
        match::make_lockstep_match({options, names, 7, no_signal}, {&game_log, &text_log, &events});

    const double cpu = process_cpu_seconds();
    (*match)->play(observer);
    report(bench, **match, process_cpu_seconds() - cpu);
    bench.SetIterationTime((*match)->times().play);

    const double ceiling_mean = (before + ceiling()) / 2.0;
    bench.counters["ceiling"] = ceiling_mean;
    bench.counters["share"] = bench.counters["steps_per_second"] / ceiling_mean;
  }
}
BENCHMARK(whole_match)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cls::bench
