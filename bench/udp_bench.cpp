// CPU time of a match over UDP on the embedded server and on rcssserver.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "tests/support/command.h"
#include "tests/support/rcssserver.h"
#include "tests/support/scripted_player.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace {

using namespace cls;

constexpr int kHalfTimeSeconds = 300;
constexpr int kMaxRequests = 50;  // init requests per player, five per second

/// Starts a program with rcssserver's arguments and both logs.
std::unique_ptr<tests::Command> start_server(std::vector<std::string> arguments, int port,
                                             const std::string& folder) {
  const std::vector<std::string> settings = {
      "synch_mode=on",
      "auto_mode=on",
      "kick_off_wait=5",
      "connect_wait=1000000",
      "game_over_wait=5",
      "nr_extra_halfs=0",
      "penalty_shoot_outs=off",
      "half_time=" + std::to_string(kHalfTimeSeconds),
      "port=" + std::to_string(port),
      "coach_port=" + std::to_string(tests::free_udp_port()),
      "olcoach_port=" + std::to_string(tests::free_udp_port())};

  for (const std::string& setting : settings) {
    arguments.push_back("server::" + setting);
  }

  return std::make_unique<tests::Command>(
      arguments, std::vector<std::string>{"RCSS_CONF_DIR=" + folder + "/conf", "USER=nobody"},
      folder);
}

/// Two teams that sleep until a message arrives, as real teams do.
class Teams {
 public:
  /// Returns when all players are connected.
  explicit Teams(int port) {
    const auto positions = tests::formation(true);
    for (const char* team : {"Left", "Right"}) {
      for (std::size_t i = 0; i < positions.size(); ++i) {
        auto channel = std::make_unique<tests::UdpClient>(port);
        sockets_.push_back({channel->descriptor(), POLLIN, 0});
        players_.push_back(std::make_unique<tests::ScriptedPlayer>(std::move(channel), team));
        players_.back()->stand_at(positions[i]);

        for (int asked = 0; players_.back()->unum() == 0; ++asked) {
          if (asked == kMaxRequests) throw std::runtime_error("the server does not reply");
          players_.back()->join(i == 0);  // repeated until the server listens
          ::poll(&sockets_.back(), 1, 200);
          players_.back()->act();
        }
      }
    }
  }

  void play() {
    while (!is_over()) {
      ::poll(sockets_.data(), sockets_.size(), 1000);
      for (std::size_t i = 0; i < sockets_.size(); ++i) {
        if (sockets_[i].revents != 0) players_[i]->act();
      }
    }
    for (auto& player : players_) player->send("(bye)");
  }

 private:
  bool is_over() const {
    return std::ranges::any_of(players_,
                               [](const auto& player) { return player->heard_time_over(); });
  }

  std::vector<pollfd> sockets_;
  std::vector<std::unique_ptr<tests::ScriptedPlayer>> players_;
};

/// A match of 6000 cycles with 22 scripted clients on loopback. Measures the CPU time of the
/// server, including the kernel's time for its messages.
void match_over_udp(benchmark::State& state, const std::string& program) {
  if (program.empty()) {
    return state.SkipWithError("rcssserver is neither on PATH nor in CLS_RCSSSERVER");
  }

  std::vector<std::string> arguments = {program};
  if (program == tests::cls_binary()) arguments.push_back("server");

  for (auto _ : state) {
    const tests::TemporaryFolder folder;
    const int port = tests::free_udp_port();
    const double before = bench::children_cpu_seconds();
    const auto server = start_server(arguments, port, folder.path());
    Teams(port).play();
    server->send_signal(SIGINT);
    server->finish();
    state.SetIterationTime(bench::children_cpu_seconds() - before);
  }
}
BENCHMARK_CAPTURE(match_over_udp, cls, tests::cls_binary().string())
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(match_over_udp, rcssserver, tests::rcssserver_program())
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
