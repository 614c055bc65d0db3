// A soccer server over UDP, in real time or synchronous mode.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "simulator/server/step_timer.h"
#include "simulator/server/udp_network.h"
#include "simulator/sessions/match_server.h"

namespace cls::simulator {

/// Ports for the players and the coach of one side in a network of its own.
struct OtherPorts {
  OtherNetwork network;
  int player = 6000;
  int coach = 6002;
};

struct UdpConfig {
  MatchConfig match;  ///< server.synch_mode selects the mode

  std::string address = "127.0.0.1";  ///< numeric address to listen on
  int port = 6000;                    ///< of players and monitors; 0 selects a free port
  int trainer_port = 0;
  int coach_port = 0;  ///< of online coaches
  /// Opened before those of this network.
  std::vector<OtherPorts> others = {};

  // Synchronous mode only:

  /// Timeout per cycle for (done) of all clients that received (think).
  std::chrono::milliseconds max_wait{1250};
  /// Maximum number of consecutive cycles with a missing (done) after the start; more end the
  /// match.
  int max_missed = 20;
  /// Pause before each cycle until the clock starts, so that clients have time to connect.
  std::chrono::milliseconds pause_before_start{50};
};

class UdpNetwork;

/// Reason why UdpServer::run() returned.
enum class UdpServerExit : std::uint8_t {
  kFinished,             ///< time over in auto mode, or the cycle limit
  kStopped,              ///< `stop` was set
  kUnresponsiveClients,  ///< more than max_missed cycles with a missing (done)
};

/// An event for the user interface of the server.
struct UdpServerEvent {
  enum class Kind : std::uint8_t {
    kConnected,  ///< or reconnected
    kDisconnected,
    kMissedCycle,  ///< a client sent (done) too late, or not at all; after the start only
  };

  Kind kind = Kind::kConnected;
  ClientId client = kNoClient;
  int version = 0;  ///< kConnected: client version
};

/// Serves each client from a port of its own, like rcssserver (docs/spec/server-protocol.md 1.1).
///
/// In synchronous mode, the commands of a cycle are executed in an order drawn from the seed after
/// all clients have sent (done); what needs no order is answered on receipt
/// (MatchServer::answer_on_receipt). Coaches and trainer receive (think) with the players, or, in a
/// few cycles drawn from the seed, after the players' commands. The match depends on when clients
/// connect and what they send, not on their speed.
///
/// In real time, a step is made every simulator_step times slow_down_factor ms. Received commands
/// are executed every recv_step ms, the last time right before the step
/// (docs/spec/server-protocol.md 8.1). Sockets are used on the calling thread only.
class UdpServer {
 public:
  /// The error names the address that cannot be used, or the invalid parameter.
  static base::Result<std::unique_ptr<UdpServer>> open(UdpConfig config);
  ~UdpServer();

  /// See UdpNetwork::bind_clients and MatchServer::make_monitors_read_only. Before run().
  using RightsOf = std::function<ClientRights(const base::SocketAddress&)>;
  using OnIntrusion = std::function<void(const base::SocketAddress&, std::string_view request)>;
  void bind_clients(RightsOf rights_of, OnIntrusion on_intrusion);
  void make_monitors_read_only() { match_->make_monitors_read_only(); }

  /// Number of a listening port.
  int port(ListeningPort role = ListeningPort::kPlayers) const;

  /// Name that the online coach of the side sent in its init; may be empty.
  const std::string& coach_name(Side side) const { return match_->coaches().name(side); }

  /// See MatchServer::record.
  void record(const LogSinks& sinks) { match_->record(sinks); }

  // Callbacks run on the thread of run() and must return quickly. on_step is called after every
  // step, before its senses are sent.
  using OnEvent = std::function<void(const UdpServerEvent&)>;
  using OnStep = std::function<void(const World&)>;
  void on_event(OnEvent callback) { on_event_ = std::move(callback); }
  void on_step(OnStep callback) { on_step_ = std::move(callback); }

  /// Runs the match to its end and writes the result to the logs. After time_over in auto mode,
  /// clients have game_over_wait cycles to disconnect. Without auto mode only `stop` or the cycle
  /// limit end the match. `stop` may be set by another
  /// thread or a signal handler.
  UdpServerExit run(const std::atomic<bool>& stop);

  /// Sends the referee's time_over, for a server that exits at its cycle limit: clients would wait
  /// for it. After run().
  void announce_end();

  /// Lateness of the steps in real time. Call only when run() has returned.
  StepTimer::Lateness lateness() const { return lateness_; }

  /// Cycles after the start in which some client sent (done) too late or not at all.
  std::int64_t missed_cycles() const;

  /// For how long the server has waited in synchronous mode for the players and the coach of a
  /// side; sides are awaited concurrently.
  std::chrono::nanoseconds awaited(Side side) const {
    return side == Side::kLeft ? awaited_[0] : awaited_[1];
  }

  const World& world() const;

 private:
  UdpServer(UdpConfig config, std::unique_ptr<MatchServer> match);

  UdpServerExit run_synchronous(const std::atomic<bool>& stop);
  UdpServerExit run_in_real_time(const std::atomic<bool>& stop);
  bool run_cycle(const std::atomic<bool>& stop);
  bool wait_for_clients(const std::atomic<bool>& stop, const std::function<bool()>& enough);
  bool awaits_side(Side side) const;
  void receive_until(StepTimer::Time next_step, int step_ms, const std::atomic<bool>& stop);
  void make_step();
  void execute();
  bool is_over() const;
  void report_connections();
  void report(UdpServerEvent::Kind kind, ClientId client, int version = 0) {
    if (on_event_) on_event_({kind, client, version});
  }

  UdpConfig config_;
  std::unique_ptr<MatchServer> match_;
  std::unique_ptr<UdpNetwork> network_;
  OnEvent on_event_;
  OnStep on_step_;
  std::array<const Connection*, MatchServer::kMaxClients> reported_{};  ///< by report_connections()
  std::int64_t missed_cycles_ = 0;
  int missed_in_a_row_ = 0;
  std::array<std::chrono::nanoseconds, 2> awaited_{};  ///< left, right
  StepTimer::Lateness lateness_;
};

}  // namespace cls::simulator
