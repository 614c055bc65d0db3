// Status lines of `cls server`, as rcssserver prints them; start scripts wait for them.
#pragma once

#include <bitset>

#include "simulator/server/udp_server.h"

namespace cls::cli {

/// Prints to stdout, missed cycles to stderr. Call on the thread of UdpServer::run.
class ServerLines {
 public:
  explicit ServerLines(const simulator::UdpServer& server) : server_(server) {}

  void event(const simulator::UdpServerEvent& event);

  /// Call after every step: prints kick-offs and the waits of auto mode.
  void step(const simulator::World& world);

 private:
  void connected(const simulator::UdpServerEvent& event);
  void disconnected(simulator::ClientId client);

  const simulator::UdpServer& server_;
  std::bitset<soccer::kPlayersOnPitch> known_;  ///< players that have connected before
  soccer::PlayMode mode_ = soccer::PlayMode::kBeforeKickOff;
  simulator::AutoMode waits_;
};

}  // namespace cls::cli
