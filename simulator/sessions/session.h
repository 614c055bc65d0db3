// One connected player as the server keeps it beside the world.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/senses/hearing.h"
#include "simulator/sessions/connection.h"
#include "soccer/commands/player_command.h"

namespace cls::simulator {

/// What a client has sent since its commands were last executed. Parsed on arrival, so that
/// (done) is known at once; memory is reused.
class Inbox {
 public:
  /// One datagram: its text, its commands as a range of `commands()`, and what was wrong with it.
  struct Datagram {
    std::string text;
    std::size_t first = 0;
    std::size_t last = 0;
    bool complete = true;         ///< no syntax error
    bool null_terminated = true;  ///< as it should be on a network
  };

  Inbox() {
    datagrams_.reserve(kUsualDatagrams);
    commands_.reserve(kUsualCommands);
  }

  /// True if (done) or (bye) is among the commands: there is nothing more to wait for.
  bool add(std::string_view text, bool null_terminated);

  std::size_t size() const { return count_; }
  const Datagram& operator[](std::size_t i) const { return datagrams_[i]; }
  const std::vector<soccer::PlayerCommand>& commands() const { return commands_; }
  void clear();

 private:
  // Room from the beginning for what players send in a cycle.
  static constexpr std::size_t kUsualSize = 512;  ///< of a datagram, in bytes
  static constexpr std::size_t kUsualDatagrams = 8;
  static constexpr std::size_t kUsualCommands = 32;

  std::vector<Datagram> datagrams_;
  std::size_t count_ = 0;
  std::vector<soccer::PlayerCommand> commands_;
};

struct Session : Connection {
  Slot slot() const { return client; }

  Inbox inbox;
  int view_rounds = 0;  ///< since the last see
  Hearing hearing;
};

}  // namespace cls::simulator
