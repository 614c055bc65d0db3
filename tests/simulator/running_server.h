// A server on loopback that runs beside the test.
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <utility>

#include "base/io/byte_sink.h"
#include "simulator/server/udp_server.h"

namespace cls::simulator {

/// Two halves of 10 s, kick-off as soon as all 22 are there.
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

/// A running server. The world may be looked at only after end().
class RunningServer {
 public:
  explicit RunningServer(const UdpConfig& config) : server(std::move(*UdpServer::open(config))) {
    server->record({&game_log, &text_log});
    port = server->port();
    thread_ = std::thread([this] {
      result_ = server->run(stop_);
      ended_ = true;
    });
  }
  ~RunningServer() { end(); }

  bool ended() const { return ended_; }

  /// Asks it to stop and waits.
  UdpEnd end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return result_;
  }
  /// Waits until it ends by itself.
  UdpEnd wait() {
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
  UdpEnd result_ = UdpEnd::kStopped;
  std::thread thread_;
};

/// Cycles of 20 ms, so that a test is short.
inline UdpConfig match_in_real_time() {
  UdpConfig config = quick_match();
  config.match.server.synch_mode = false;
  config.match.server.simulator_step = 20;
  config.match.server.sense_body_step = 20;
  config.match.server.send_step = 30;
  config.match.server.half_time = 1;
  return config;
}

}  // namespace cls::simulator
