// What a cycle costs the server when its clients are programs of their own.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "simulator/server/udp_server.h"
#include "tests/support/scripted_player.h"
#include "tests/support/udp_client.h"

namespace {

using namespace cls;

constexpr int kCycles = 500;

double thread_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

simulator::UdpConfig short_match() {
  simulator::UdpConfig config;
  config.port = 0;
  config.match.seed = 1;
  config.match.cycle_limit = kCycles;
  config.match.server.synch_mode = true;
  config.match.server.auto_mode = true;
  config.match.server.kick_off_wait = 5;
  config.match.server.connect_wait = 1'000'000;
  config.pause_before_start = std::chrono::milliseconds(1);
  return config;
}

/// 22 scripted clients on loopback; the time is the processor's that the server's thread takes for
/// a cycle, its share of the network included.
void server_cycle_over_udp(benchmark::State& state) {
  for (auto _ : state) {
    auto server = std::move(*simulator::UdpServer::open(short_match()));
    std::atomic<bool> stop{false};
    std::atomic<bool> ended{false};
    double cpu = 0.0;
    std::thread thread([&] {
      server->run(stop);
      cpu = thread_cpu_seconds();
      ended = true;
    });
    std::vector<std::unique_ptr<tests::ScriptedPlayer>> players;
    const auto places = tests::formation(true);
    for (const char* team : {"Left", "Right"}) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        auto& player = *players.emplace_back(std::make_unique<tests::ScriptedPlayer>(
            std::make_unique<tests::UdpClient>(server->port()), team));
        player.stand_at(places[i]);
        player.join(i == 0);
        while (player.unum() == 0) player.act();
      }
    }
    while (!ended) {
      for (auto& player : players) player->act();
    }
    thread.join();
    state.SetIterationTime(cpu / kCycles);
  }
}
BENCHMARK(server_cycle_over_udp)->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);

}  // namespace
