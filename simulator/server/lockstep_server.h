// A soccer server in lockstep with its clients: reproducible, and independent of their speed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/result.h"
#include "simulator/server/udp_network.h"
#include "simulator/sessions/match_server.h"
#include "soccer/channel.h"

namespace cls::simulator {

/// Server and clients alternate on one thread: run_cycle() executes the commands that clients have
/// put in their channels. The match depends only on seed, parameters and messages. Clients receive
/// (synch_mode 1), act on (think) and reply with (done), as in synchronous mode of rcssserver.
///
///     auto server = LockstepServer::create(config);
///     auto channel = (*server)->connect();   // per client, which sends (init ...)
///     (*server)->accept_clients();           // sends replies and parameters
///     while (!(*server)->finished()) {
///       (*server)->run_cycle();              // step, senses, (think)
///       ...                                  // clients read, think, send commands and (done)
///     }
///     (*server)->finish();                   // writes the result to the logs
class LockstepServer {
 public:
  /// Turns server.synch_mode on. The error names the invalid parameter.
  static base::Result<std::unique_ptr<LockstepServer>> create(MatchConfig config);

  /// See MatchServer::record.
  void record(const LogSinks& sinks) { match_->record(sinks); }
  void record(base::ByteSink* game_log, base::ByteSink* text_log) {
    match_->record(game_log, text_log);
  }

  /// Returns the client's end of a new connection. The first message must be an init or reconnect
  /// for that port; after a refusal the client may try again. Destroying the channel disconnects.
  /// `rights`: see MatchServer::admit.
  std::unique_ptr<soccer::Channel> connect(ListeningPort port = ListeningPort::kPlayers,
                                           const ClientRights& rights = {});

  /// Handles pending connection requests in the order of connect() and replies to them.
  void accept_clients();

  /// See MatchServer::arrange.
  void modify_world(const std::function<void(World&, Events&)>& change) {
    match_->modify_world(change);
  }

  /// Accepts monitors over UDP. Their commands are ignored; they are served once per cycle.
  /// `address` is numeric; port 0 selects a free port. Returns the port number.
  base::Result<int> open_monitor_port(const std::string& address, int port);

  /// Accepts players over UDP in lockstep: the match depends on their messages, not on the time of
  /// arrival. See wait_for_clients().
  base::Result<int> open_player_port(const std::string& address, int port);

  /// The same for players in another network. Once per network.
  base::Result<void> open_player_port_in(const OtherNetwork& network, const std::string& address,
                                         int port);

  /// See UdpNetwork::bind_clients. After a port was opened.
  void bind_clients(UdpNetwork::RightsOf rights_of, UdpNetwork::OnIntrusion on_intrusion) {
    network_->bind_clients(std::move(rights_of), std::move(on_intrusion));
  }

  using Time = UdpNetwork::Time;
  /// Receives over UDP until no client is awaited, or until `deadline`. Returns false on timeout.
  bool wait_for_clients(Time deadline);
  /// Receives over UDP until `deadline`.
  void receive_until(Time deadline);
  /// Discards the commands that players have sent since the last cycle, after the world was
  /// changed.
  void discard_commands();
  /// True while the client is connected.
  bool is_connected(ClientId client) { return match_->connection(client) != nullptr; }

  using Change = std::function<void(World&, Events&)>;
  /// Executes received commands, runs one step, and sends senses and (think) to the clients.
  /// `after_step` may change the world before the senses.
  void run_cycle(const Change& after_step = {});

  /// True while the client has received (think) and not sent (done). Receives pending messages.
  bool awaits(ClientId client);

  /// Cycles in which the client received (think) but did not send (done) in time.
  std::int64_t missed_cycles(ClientId client) const { return missed_[base::index(client)]; }

  /// True after time_over or at the cycle limit.
  bool finished() const { return match_->finished(); }

  /// Writes the result to the logs; call once, after the last cycle.
  void finish() { match_->finish(); }

  const World& world() const { return match_->world(); }

 private:
  explicit LockstepServer(std::unique_ptr<MatchServer> match) : match_(std::move(match)) {}

  /// Server end of a connection that is not admitted yet.
  struct PendingConnection {
    ListeningPort port;
    std::unique_ptr<soccer::Channel> channel;
    ClientRights rights;
  };

  base::Result<int> open(ListeningPort role, const std::string& address, int port);
  void collect(ClientId client);

  std::unique_ptr<UdpNetwork> network_;  ///< outlives the client sockets, owned by the match
  std::unique_ptr<MatchServer> match_;
  std::vector<PendingConnection> pending_;
  std::array<std::int64_t, kFirstMonitor> missed_ = {};
  std::string message_;
};

}  // namespace cls::simulator
