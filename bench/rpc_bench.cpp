// Cost of the wire: serializing States, and calls.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>

#include "bench/rpc_ceiling.h"
#include "proto/state_writer.h"

namespace cls::bench {
namespace {

void serialize_state(benchmark::State& bench) {
  const protos::State state = typical_state();
  proto::StateWriter writer;
  std::size_t bytes = 0;
  for (auto _ : bench) bytes = writer.write(state, proto::StateForm::kWhole).size();
  bench.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(serialize_state)->Unit(benchmark::kMicrosecond);

void parse_state(benchmark::State& bench) {
  const std::string bytes = typical_state().SerializeAsString();
  protos::State state;
  for (auto _ : bench) {
    state.ParseFromString(bytes);
    benchmark::DoNotOptimize(state);
  }
}
BENCHMARK(parse_state)->Unit(benchmark::kMicrosecond);

void rpc_ceiling(benchmark::State& bench) {
  const auto transport = static_cast<Transport>(bench.range(0));
  const auto threads = static_cast<int>(bench.range(1));
  const auto asking = static_cast<Asking>(bench.range(2));
  RpcCeiling ceiling;
  for (auto _ : bench) {
    ceiling = measure_rpc_ceiling(transport, threads, asking, typical_state(), 3.0);
  }
  bench.counters["cycles_per_second"] = ceiling.cycles_per_second;
  bench.counters["cpu_us_per_cycle"] = ceiling.cpu_us_per_cycle;
}
BENCHMARK(rpc_ceiling)
    ->ArgNames({"transport", "threads", "asking"})
    ->ArgsProduct({{static_cast<long>(Transport::kInProcess), static_cast<long>(Transport::kTcp),
                    static_cast<long>(Transport::kUnixSocket)},
                   {1, 2},
                   {static_cast<long>(Asking::kEachAgent), static_cast<long>(Asking::kTeam),
                    static_cast<long>(Asking::kTeamLean)}})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cls::bench
