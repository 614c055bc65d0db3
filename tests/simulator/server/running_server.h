// A server on loopback that runs on a thread of the test.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "base/io/byte_sink.h"
#include "simulator/server/udp_server.h"

namespace cls::simulator {

/// Two halves of 10 s; kick-off when all 22 players are connected.
inline UdpConfig quick_match() {
  UdpConfig config;
  config.port = 0;
  config.match.seed = 7;
  config.match.server.synch_mode = true;
  config.match.server.auto_mode = true;
  config.match.server.kick_off_wait = 5;
  config.match.server.connect_wait = 1000000;
  config.match.server.half_time = 10;
  config.match.server.nr_extra_halfs = 0;
  config.match.server.penalty_shoot_outs = false;
  config.match.server.game_over_wait = 3;
  config.pause_before_start = std::chrono::milliseconds(5);
  return config;
}

/// Runs a server. Access the world only after stop().
class RunningServer {
 public:
  using Prepare = std::function<void(UdpServer&)>;
  explicit RunningServer(const UdpConfig& config, const Prepare& prepare = {})
      : server(std::move(*UdpServer::open(config))) {
    if (prepare) prepare(*server);
    server->record({&game_log, &text_log});
    port = server->port();
    thread_ = std::thread([this] {
      result_ = server->run(stop_);
      ended_ = true;
    });
  }
  ~RunningServer() { stop(); }

  bool ended() const { return ended_; }

  /// Stops the server and waits.
  UdpServerExit stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return result_;
  }
  /// Waits until the match ends.
  UdpServerExit wait() {
    if (thread_.joinable()) thread_.join();
    return result_;
  }

  std::unique_ptr<UdpServer> server;
  base::StringSink game_log;
  base::StringSink text_log;
  int port = 0;

 private:
  std::atomic<bool> stop_{false};
  std::atomic<bool> ended_{false};
  UdpServerExit result_ = UdpServerExit::kStopped;
  std::thread thread_;
};

/// Short cycles of 20 ms.
inline UdpConfig real_time_match() {
  UdpConfig config = quick_match();
  config.match.server.synch_mode = false;
  config.match.server.simulator_step = 20;
  config.match.server.sense_body_step = 20;
  config.match.server.send_step = 30;
  config.match.server.half_time = 1;
  return config;
}

}  // namespace cls::simulator
