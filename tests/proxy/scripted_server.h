// The soccer server's end of a team's channels: lets players in, lets them see, notes what they
// say.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "soccer/channel.h"

namespace cls::tests {

/// Speaks as rcssserver does in synchronous mode, with a world that stands still: everybody is at
/// (-24.99, 0.02) or so and sees the same.
class ScriptedServer {
 public:
  int player_types = 18;
  bool synchronous = true;
  std::string refusal;  ///< what the next init is answered with, if not empty

  /// A client's end of a new connection.
  std::unique_ptr<soccer::Channel> open();
  /// Answers what waits: init with number, parameters and types.
  void serve();
  /// sense_body and see of the cycle for everybody; `think` asks for decisions.
  void send_cycle(int cycle, bool think = true);
  void send(int unum, const std::string& message) { client(unum).send(message); }
  /// Everything that the player has said since the last call, but init.
  std::vector<std::string> take(int unum);

 private:
  soccer::Channel& client(int unum) { return *clients_.at(static_cast<std::size_t>(unum - 1)); }
  void let_in(soccer::Channel& client, int unum);

  std::vector<std::unique_ptr<soccer::Channel>> clients_;
  std::vector<std::vector<std::string>> said_;
};

}  // namespace cls::tests
