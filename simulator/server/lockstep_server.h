// A match in memory: as fast as its clients, and the same whatever their speed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "simulator/server/udp_network.h"
#include "simulator/sessions/match_server.h"
#include "soccer/channel.h"

namespace cls::simulator {

/// Server and clients take turns in one thread: run_cycle() is the server's turn, and it finds in
/// the channels what the clients have sent in theirs. What happens depends on seed, parameters
/// and the messages only; clients are told (synch_mode 1), act on (think) and end with (done), as
/// with the real server in synch mode.
///
///     auto server = LockstepServer::create(config);
///     auto channel = (*server)->connect();   // once per client; it sends (init ...)
///     (*server)->answer_requests();          // the client finds the reply and the parameters
///     while (!(*server)->finished()) {
///       (*server)->run_cycle();              // step, senses, (think)
///       ...                                  // clients read, think, send commands and (done)
///     }
///     (*server)->finish();                   // the result goes into the logs
class LockstepServer {
 public:
  /// server.synch_mode is switched on. The error names the parameter that makes no match.
  static base::Result<std::unique_ptr<LockstepServer>> create(MatchConfig config);

  /// See MatchServer::record.
  void record(base::ByteSink* game_log, base::ByteSink* text_log) {
    match_->record(game_log, text_log);
  }

  /// The client's end of a new connection. Its first message must be an init (or a player's
  /// reconnect) as `door` wants it; a refused one is answered with an error and may try again.
  /// Destroying it means leaving.
  std::unique_ptr<soccer::Channel> connect(Door door = Door::kGame);

  /// Lets in the clients that have asked, in the order of connect(), and answers them.
  void answer_requests();

  /// See MatchServer::arrange.
  void arrange(const std::function<void(World&, Events&)>& change) { match_->arrange(change); }
  /// Lets monitors attach over UDP from now on, to watch only: what they send changes nothing. They
  /// are heard and shown once a cycle. `address` is a number; port 0 takes a free one. Returns the
  /// port.
  base::Result<int> open_to_monitors(const std::string& address, int port);

  /// Lets players come over UDP too, programs of their own, who take turns like everybody else:
  /// what happens depends on what they send, not on when it arrives. See wait_for_answers.
  base::Result<int> open_to_players(const std::string& address, int port);

  using Time = UdpNetwork::Time;
  /// Takes in what comes over UDP until nobody is awaited any more, or until `deadline`. True when
  /// nobody is.
  bool wait_for_answers(Time deadline);
  /// Takes in what comes over UDP until then.
  void receive_until(Time deadline);
  /// Drops what players have sent since the last cycle: it was about another situation.
  void forget_commands();
  /// True while the client is connected.
  bool is_connected(ClientId client) { return match_->connection(client) != nullptr; }

  /// Executes what the clients have sent, makes one step, tells everybody the new state of the
  /// world and asks them to think.
  void run_cycle();

  /// True while that client has not sent (done) since it was asked to think. Reads what has
  /// arrived.
  bool awaits(ClientId client);

  /// Cycles in which the client was asked to think and let it pass without (done).
  std::int64_t missed_cycles(ClientId client) const {
    return missed_[static_cast<std::size_t>(client)];
  }

  /// Time over, or the cycle limit is reached.
  bool finished() const { return match_->finished(); }

  /// Writes the result into the logs. Once, after the last cycle.
  void finish() { match_->finish(); }

  const World& world() const { return match_->world(); }

 private:
  explicit LockstepServer(std::unique_ptr<MatchServer> match) : match_(std::move(match)) {}

  /// A server end that is not admitted yet.
  struct Waiting {
    Door door;
    std::unique_ptr<soccer::Channel> channel;
  };

  base::Result<int> open(Door door, const std::string& address, int port);
  void collect(ClientId client);

  std::unique_ptr<UdpNetwork> network_;  ///< outlives the clients' sockets, which the match has
  std::unique_ptr<MatchServer> match_;
  std::vector<Waiting> waiting_;
  std::array<std::int64_t, kFirstMonitor> missed_ = {};
  std::string message_;
};

}  // namespace cls::simulator
