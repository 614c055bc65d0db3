// A server in memory with two teams of scripted players.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "base/io/byte_sink.h"
#include "simulator/server/lockstep_server.h"
#include "tests/support/scripted_player.h"

namespace cls::tests {

/// A log that is discarded.
class NullSink : public base::ByteSink {
 public:
  void write(std::string_view) override {}
  base::Result<void> close() override { return {}; }
};

class BareServer {
 public:
  /// Connects 22 players, before kick-off.
  explicit BareServer(const simulator::MatchConfig& config, bool logs = true);
  BareServer(const BareServer&) = delete;
  BareServer& operator=(const BareServer&) = delete;

  /// The part of the server in a cycle.
  void serve() { server_->run_cycle(); }
  /// The part of the players.
  void act();

  const simulator::World& world() const { return server_->world(); }

 private:
  NullSink game_log_;
  NullSink text_log_;
  std::unique_ptr<simulator::LockstepServer> server_;
  std::vector<std::unique_ptr<ScriptedPlayer>> players_;
};

}  // namespace cls::tests
