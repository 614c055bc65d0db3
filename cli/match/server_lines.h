// What `cls server` prints while it runs: the lines that scripts of rcssserver wait for.
#pragma once

#include <bitset>

#include "simulator/server/udp_server.h"

namespace cls::cli {

/// Prints to stdout (missed cycles to stderr) as rcssserver does. Used on the thread of
/// UdpServer::run.
class ServerLines {
 public:
  explicit ServerLines(const simulator::UdpServer& server) : server_(server) {}

  void notice(const simulator::UdpNotice& notice);

  /// After every step: kick-offs, and what auto mode waits for.
  void step(const simulator::World& world);

 private:
  void joined(const simulator::UdpNotice& notice);
  void left(simulator::ClientId client);

  const simulator::UdpServer& server_;
  std::bitset<soccer::kPlayersOnPitch> known_;  ///< players who were here before
  soccer::PlayMode mode_ = soccer::PlayMode::kBeforeKickOff;
  simulator::AutoMode waits_;
};

}  // namespace cls::cli
