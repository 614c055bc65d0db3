// A scripted soccer server: accepts players, sends senses and stores the commands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/index.h"
#include "proxy/agent/team.h"
#include "soccer/channel.h"

namespace cls::tests {

/// Sends messages as rcssserver does in synchronous mode, with a static world: all players are at
/// about (-24.99, 0.02) and get the same see message.
class ScriptedServer {
 public:
  int player_types = 18;
  bool synchronous = true;
  int version = 18;     ///< newest known; clients of newer ones are refused
  int only_unum = 0;    ///< not 0: every player gets this number
  std::string refusal;  ///< reply to the next init, if not empty

  /// Client side of a new connection.
  std::unique_ptr<soccer::Channel> open();
  /// Connects and registers a team of eleven, as the test expects, and takes what they have sent.
  void admit(proxy::Team& team);
  /// Handles received init commands: sends uniform number, parameters and types.
  void serve();
  /// Sends sense_body and see of the cycle to all players; `think` makes decisions due.
  void send_cycle(int cycle, bool think = true);
  void send(int unum, const std::string& message) { client(unum).send(message); }
  /// Datagrams of the player since the last call, except init.
  std::vector<std::string> take(int unum);

 private:
  soccer::Channel& client(int unum) { return *clients_.at(base::index(unum - 1)); }
  void accept(soccer::Channel& client, int unum);

  std::vector<std::unique_ptr<soccer::Channel>> clients_;
  std::vector<std::vector<std::string>> said_;
};

}  // namespace cls::tests
