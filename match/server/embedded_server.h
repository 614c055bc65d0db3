// The embedded server in this process: it advances when the match says so.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"
#include "match/programs/server_plan.h"
#include "match/server/client_binding.h"
#include "match/server/match_server.h"
#include "process/namespaces.h"
#include "simulator/server/lockstep_server.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/per_side.h"

namespace cls::match {

/// Players of cls teams connect through channels in memory, players of external teams over UDP.
class EmbeddedServer : public Server {
 public:
  /// The error names the parameter that is wrong.
  static base::Result<std::unique_ptr<EmbeddedServer>> create(const MatchOptions& options,
                                                              std::uint64_t seed);

  /// Writes game log (of server::game_log_version), text log and events from now on; null: none.
  /// All must outlive the server.
  void record(base::ByteSink* game_log, base::ByteSink* text_log, EventRecorder* events);

  /// For the agents of cls teams.
  simulator::LockstepServer& simulator() { return *server_; }

  /// Accepts players over UDP, for an external team on `side`. With `free_port` at a free port,
  /// otherwise at 6000. The error names the owner of the port.
  base::Result<ServerPorts> open_player_port(bool free_port);
  /// The same for the external team on `side`, in its own network, where the ports are the usual
  /// ones.
  base::Result<ServerPorts> open_player_port_in(
      std::shared_ptr<const process::Namespaces> namespaces, soccer::Side side);
  /// `name`: of a team whose programs have names of their own; see BoundSides.
  void expect_external_team(soccer::Side side, const std::string& name) {
    external_[side] = true;
    names_[side] = name;
  }

  /// All sides have joined: the match begins, in a world that `arrange` has changed.
  using Arrange = std::function<void(simulator::World&, simulator::Events&)>;
  void begin_play(const std::vector<Arrange>& arrange);
  /// Advances by one step, after all sides have ended their turn. `after_step` may change the world
  /// before players perceive it.
  void step(const Arrange& after_step = {});
  /// True when all external clients have ended their turn; waits for them up to `limit`.
  bool wait_for_commands(std::chrono::milliseconds limit);
  /// Counts a step for whose commands nobody waited any longer.
  void count_missed_cycle() { ++missed_cycles_; }
  /// The world after the last step.
  const simulator::World& world() const { return server_->world(); }
  /// Completes the logs.
  void finish() { server_->finish(); }

  /// After `steps` steps all random draws come from `seed`.
  void branch(std::int64_t steps, std::uint64_t seed) { branch_ = {steps, seed}; }

  std::optional<MatchEnd> start(const std::function<bool()>& keep_waiting) override;
  std::string waiting_for() const override { return {}; }
  std::string monitor_address() const override { return monitor_address_; }
  void wait_for_clients() override;
  ServerStatus status() const override;
  std::optional<int> lost_player(soccer::Side side) override;
  std::vector<std::string> take_warnings() override { return std::exchange(warnings_, {}); }
  bool reports_lost_players() const override { return true; }
  bool binds_clients() const override { return true; }
  SourceProgress progress() const override;
  bool finished() const override { return server_->finished(); }
  std::optional<MatchEnd> failure(bool) override { return std::nullopt; }
  void add_result(MatchResult& result, const std::vector<AgentProgress>& agents) const override;

 private:
  explicit EmbeddedServer(const MatchOptions& options) : options_(options) {}

  void bind_clients();
  BoundSides bound_sides() const { return {external_, options_.trainer.has_value(), names_}; }
  bool has_external_team() const { return external_.left || external_.right; }
  void set_kick_off_wait(int cycles);
  void drain_late_commands();

  const MatchOptions& options_;
  soccer::PerSide<std::shared_ptr<const process::Namespaces>> namespaces_;  ///< with open ports
  std::unique_ptr<simulator::LockstepServer> server_;
  EventRecorder* events_ = nullptr;
  std::string monitor_address_;
  soccer::PerSide<bool> external_;
  soccer::PerSide<std::string> names_ = {};
  std::array<bool, soccer::kPlayersOnPitch> must_stay_{};  ///< external players on the pitch
  std::optional<ClientBinding> binding_;                   ///< of a server with an open port
  std::optional<ClientBinding> side_binding_;  ///< of one with ports in networks of sides
  std::vector<std::string> warnings_;
  bool playing_ = false;
  std::int64_t steps_ = 0;
  std::int64_t missed_cycles_ = 0;
  struct Branch {
    std::int64_t steps;
    std::uint64_t seed;
  };
  std::optional<Branch> branch_;
};

}  // namespace cls::match
