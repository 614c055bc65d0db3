// Cost of a cycle of the embedded server, and of its parts.
#include <benchmark/benchmark.h>

#include "bench/measure.h"
#include "gamelog/rcg/rcg_text.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/vision.h"
#include "simulator/sessions/match_recorder.h"
#include "simulator/step.h"
#include "tests/support/allocation_count.h"
#include "tests/support/bare_server.h"

namespace {

using namespace cls;

simulator::MatchConfig endless() {
  simulator::MatchConfig config;
  config.seed = 1;
  config.server.auto_mode = true;
  config.server.kick_off_wait = 5;
  config.server.half_time = -1;
  return config;
}

/// A match after 300 cycles.
struct Match : tests::BareServer {
  explicit Match(bool logs = true) : tests::BareServer(endless(), logs) {
    for (int i = 0; i < 300; ++i) {
      serve();
      act();
    }
  }
};

double thread_seconds() { return bench::cpu_seconds(CLOCK_THREAD_CPUTIME_ID); }

/// Measures time and allocations of the server only, not of its clients.
void server_cycle(benchmark::State& state, bool logs) {
  Match match(logs);
  std::int64_t allocations = 0;
  for (auto _ : state) {
    const std::int64_t allocated = tests::allocation_count();
    const double begin = thread_seconds();
    match.serve();
    state.SetIterationTime(thread_seconds() - begin);
    allocations += tests::allocation_count() - allocated;
    match.act();
  }

  state.counters["allocations"] =
      static_cast<double>(allocations) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(server_cycle, with_logs, true)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(server_cycle, without_logs, false)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

void server_step(benchmark::State& state) {
  Match match;
  simulator::World world = match.world();
  simulator::Events events;
  for (auto _ : state) {
    simulator::step(world, events);
    simulator::finish_step(world, events);
    events.clear();
  }
}
BENCHMARK(server_step)->Unit(benchmark::kMicrosecond);

void server_see(benchmark::State& state) {
  Match match;
  const simulator::World& world = match.world();
  const simulator::VisionModel model(world.params());
  soccer::See message;
  std::string text;
  simulator::Slot slot = 0;

  for (auto _ : state) {
    simulator::RandomStream noise(1, "bench");
    simulator::see(model, world, slot, noise, message);
    text.clear();
    soccer::format(message, text);
    slot = (slot + 1) % soccer::kPlayersOnPitch;
  }
  state.counters["bytes"] = static_cast<double>(text.size());
}
BENCHMARK(server_see)->Unit(benchmark::kMicrosecond);

void server_sense_body(benchmark::State& state) {
  Match match;
  std::string text;
  simulator::Slot slot = 0;
  for (auto _ : state) {
    text.clear();
    soccer::format(simulator::sense_body(match.world(), slot), 18, text);
    slot = (slot + 1) % soccer::kPlayersOnPitch;
  }
}
BENCHMARK(server_sense_body)->Unit(benchmark::kMicrosecond);

void server_log_frame(benchmark::State& state) {
  Match match;
  gamelog::Frame frame;
  std::string line;
  for (auto _ : state) {
    simulator::to_frame(match.world(), frame);
    line.clear();
    gamelog::append_show(frame, line);
  }
}
BENCHMARK(server_log_frame)->Unit(benchmark::kMicrosecond);

}  // namespace
