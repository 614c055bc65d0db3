// A team on a soccer server over UDP: waits for what comes and lets everybody decide in time.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "base/result.h"
#include "proxy/agent/team.h"
#include "soccer/udp_channel.h"

namespace cls::proxy {

/// Looked at every 50 ms or more often; false ends what is going on.
using GoOn = std::function<bool()>;

/// Waits until something answers at the server's port, however it answers. False when `go_on`
/// ended the waiting. It does not join the match.
bool wait_for_server(soccer::UdpClients& clients, const GoOn& go_on);

/// Why a team stopped playing.
enum class DriveEnd {
  kStopped,       ///< it was told to
  kTimeOver,      ///< the match has ended
  kServerSilent,  ///< no message for as long as the options allow
};

struct DriverOptions {
  bool leave_at_time_over = true;  ///< else play on until the server falls silent
  std::chrono::milliseconds silence{5000};
  int coach_port = 0;    ///< of the server; 0: the team has no coach
  int trainer_port = 0;  ///< the same for a trainer
};

/// Plays in the way that the server asks for: in synchronous mode by (think), else in real time.
/// Use: connect, introduce the team to its Playmaker, run, let the team leave. All on one thread.
class TeamDriver {
 public:
  /// Both must outlive the driver.
  TeamDriver(Team& team, soccer::UdpClients& clients, DriverOptions options = {})
      : team_(team), clients_(clients), options_(options) {}

  /// See Team::connect. A team that the server gives no coach plays without one.
  base::Result<void> connect(const GoOn& go_on);

  /// `go_on` is asked after every round too, in which decisions may have been carried out.
  DriveEnd run(const GoOn& go_on);

 private:
  base::Result<void> connect_all(const GoOn& go_on);
  base::Result<void> connect_coach(const Serve& serve);
  void finish_answers();
  bool time_over() const;

  Team& team_;
  soccer::UdpClients& clients_;
  DriverOptions options_;
};

}  // namespace cls::proxy
