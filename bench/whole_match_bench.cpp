// A whole match as `cls match mock mock` plays it, beside the ceiling that gRPC sets in the same
// run.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <atomic>
#include <ctime>
#include <memory>

#include "base/io/byte_sink.h"
#include "bench/rpc_ceiling.h"
#include "orchestration/match/hooks/match_chronicle.h"
#include "orchestration/match/lockstep_match.h"

namespace cls::bench {
namespace {

double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

double agent_seconds(const proxy::TeamTimes& times) {
  return seconds(times.perceive) + seconds(times.state) + seconds(times.act);
}

// The times of the sides run side by side on two cores, so those of both teams add up to CPU time
// as long as nothing else runs. What neither simulator, agents nor mock account for is RPC:
// serialising, gRPC's client and server, its threads.
void report(benchmark::State& bench, const orchestration::match::LockstepMatch& match, double cpu) {
  const orchestration::match::MatchResult result = match.result();
  const auto steps = static_cast<double>(result.steps);
  const double agents =
      agent_seconds(match.left().team().times()) + agent_seconds(match.right().team().times());
  const double mock = match.left().mock_cpu_seconds() + match.right().mock_cpu_seconds();
  const double simulator = match.times().simulator;
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
  const protos::State state = usual_state();
  for (auto _ : bench) {
    const auto ceiling = [&] {
      return measure_rpc_ceiling(Transport::kInProcess, kThreads, state, kCeilingSeconds)
          .cycles_per_second;
    };
    const double before = ceiling();
    const orchestration::match::MatchOptions options;
    const std::atomic<int> no_signal{0};
    auto match =
        orchestration::match::LockstepMatch::create(options, {"mock_l", "mock_r"}, 7, no_signal);
    base::StringSink game_log;
    base::StringSink text_log;
    base::StringSink event_lines;
    orchestration::match::EventLog events(event_lines);
    orchestration::match::MatchChronicle chronicle(events);
    orchestration::match::MatchObserver nobody;
    (*match)->record(game_log, text_log);
    const double cpu = process_cpu_seconds();
    (*match)->play(nobody, chronicle);
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
