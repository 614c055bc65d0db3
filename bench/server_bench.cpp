// What a cycle of the embedded server costs, and its parts.
#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>
#include <vector>

#include "bench/allocation_count.h"
#include "gamelog/byte_sink.h"
#include "gamelog/rcg_text.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/vision.h"
#include "simulator/server/lockstep_server.h"
#include "simulator/server/match_recorder.h"
#include "simulator/step.h"
#include "tests/support/scripted_player.h"

namespace {

using namespace cls;
using simulator::LockstepServer;

class NullSink : public gamelog::ByteSink {
 public:
  void write(std::string_view bytes) override { bytes_ += bytes.size(); }
  soccer::Result<void> close() override { return {}; }

 private:
  std::size_t bytes_ = 0;
};

/// 22 scripted players in the middle of an endless match.
struct Match {
  explicit Match(bool logs = true) {
    simulator::MatchConfig config;
    config.seed = 1;
    config.server.auto_mode = true;
    config.server.kick_off_wait = 5;
    config.server.half_time = -1;
    server = std::move(*LockstepServer::create(config));
    if (logs) server->record(&game_log, &text_log);
    const auto places = tests::formation(true);
    for (const char* team : {"Left", "Right"}) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        players.push_back(std::make_unique<tests::ScriptedPlayer>(server->connect(), team));
        players.back()->stand_at(places[i]);
        players.back()->join(i == 0);
        server->answer_requests();
      }
    }
    for (int i = 0; i < 300; ++i) run_cycle();
  }

  void run_cycle() {
    server->run_cycle();
    for (auto& player : players) player->act();
  }

  NullSink game_log;
  NullSink text_log;
  std::unique_ptr<LockstepServer> server;
  std::vector<std::unique_ptr<tests::ScriptedPlayer>> players;
};

/// CPU time of this thread, which other work on the machine does not lengthen.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Only the server's turns are timed, and only its allocations are counted.
void server_cycle(benchmark::State& state, bool logs) {
  Match match(logs);
  std::int64_t allocations = 0;
  for (auto _ : state) {
    const std::int64_t allocated = bench::allocation_count();
    const double begin = thread_seconds();
    match.server->run_cycle();
    state.SetIterationTime(thread_seconds() - begin);
    allocations += bench::allocation_count() - allocated;
    for (auto& player : match.players) player->act();
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
  simulator::World world = match.server->world();
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
  const simulator::World& world = match.server->world();
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
    soccer::format(simulator::sense_body(match.server->world(), slot), 18, text);
    slot = (slot + 1) % soccer::kPlayersOnPitch;
  }
}
BENCHMARK(server_sense_body)->Unit(benchmark::kMicrosecond);

void server_log_frame(benchmark::State& state) {
  Match match;
  gamelog::Frame frame;
  std::string line;
  for (auto _ : state) {
    simulator::describe(match.server->world(), frame);
    line.clear();
    gamelog::append_show(frame, line);
  }
}
BENCHMARK(server_log_frame)->Unit(benchmark::kMicrosecond);

}  // namespace
