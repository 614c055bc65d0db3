// Runs a team on a soccer server over UDP: waits for messages and replies, begins due decisions.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "base/result.h"
#include "proxy/agent/team.h"
#include "soccer/udp_channel.h"

namespace cls::proxy {

/// Called at least every 50 ms; false stops the operation.
using ShouldContinue = std::function<bool()>;

/// Waits until any process replies at the server's port, without joining the match. False when
/// `should_continue` stopped it.
bool wait_for_server(soccer::UdpClients& clients, const ShouldContinue& should_continue);

/// Reason why run() returned.
enum class DriveResult {
  kStopped,             ///< should_continue returned false
  kTimeOver,            ///< the match has ended
  kServerUnresponsive,  ///< no message within server_timeout
  kPlayersUnheard,      ///< the same for the players alone: the coach still gets messages
};

struct DriverOptions {
  bool leave_at_time_over = true;  ///< otherwise until the server stops sending
  std::chrono::milliseconds server_timeout{5000};
  std::chrono::milliseconds timeout_after_end{2000};  ///< the same once the match is over
  int coach_port = 0;                                 ///< of the server; 0: no coach
  int trainer_port = 0;                               ///< the same for a trainer
  /// Called once per cycle, before the first player's decision is requested; may block, may be
  /// empty.
  std::function<void()> before_decisions;
  /// Makes the channel of a player another one, such as one that records; may be empty.
  std::function<std::unique_ptr<soccer::Channel>(std::unique_ptr<soccer::Channel>)> wrap;
};

/// Plays in synchronous mode by (think), otherwise in real time, as the server's parameters say.
/// Sequence: connect(), Team::register_agents(), run(), Team::leave(), all on one thread.
class TeamDriver {
 public:
  /// Both must outlive the driver.
  TeamDriver(Team& team, soccer::UdpClients& clients, DriverOptions options = {})
      : team_(team), clients_(clients), options_(options) {}

  /// See Team::connect(). Continues without a coach when the server accepts none.
  base::Result<void> connect(const ShouldContinue& should_continue);

  /// `should_continue` is also called after every iteration, in which decisions may have been
  /// executed.
  DriveResult run(const ShouldContinue& should_continue);

 private:
  base::Result<void> connect_all(const ShouldContinue& should_continue);
  base::Result<void> connect_coach(const Serve& serve);
  bool time_over() const;
  /// The reason to leave now, while no reply is outstanding.
  std::optional<DriveResult> end_of_run(Instant now, Instant last_message) const;

  Team& team_;
  soccer::UdpClients& clients_;
  DriverOptions options_;
};

}  // namespace cls::proxy
