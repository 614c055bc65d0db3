// A match and its clients, independent of transport and wall clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "simulator/sessions/coach_registry.h"
#include "simulator/sessions/connection.h"
#include "simulator/sessions/match_recorder.h"
#include "simulator/sessions/monitor_registry.h"
#include "simulator/sessions/player_registry.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/channel.h"

namespace cls::simulator {

struct MatchConfig {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::uint64_t seed = 0;

  /// Player types of a recorded match; empty: drawn from the seed.
  std::vector<soccer::PlayerType> types = {};

  /// Game time at which the match ends; otherwise it ends with time_over.
  std::optional<int> cycle_limit;

  /// Goals of a lead with which the match ends; otherwise no lead ends it.
  std::optional<int> decisive_lead;
};

/// The soccer server without its network: world, clients and logs. A driver (LockstepServer,
/// UdpServer) calls in every cycle receive() for each datagram, then execute(), step(), sense() and
/// think(). Random draws of the server use clock_stream(), so that a client that connects or leaves
/// changes no draws of others.
class MatchServer {
 public:
  static constexpr std::size_t kMaxClients =
      static_cast<std::size_t>(kFirstMonitor) + MonitorRegistry::kMaxMonitors;

  /// The error names the invalid parameter.
  static base::Result<std::unique_ptr<MatchServer>> create(const MatchConfig& config);

  /// Starts writing logs. Call before any client connects. The sinks must outlive the server.
  void record(const LogSinks& sinks);
  void record(base::ByteSink* game_log, base::ByteSink* text_log) {
    record(LogSinks{.game = game_log, .text = text_log});
  }

  // Handshake and disconnection of clients.

  /// Handles a connection request; returns an error to reply with if it is refused. An accepted
  /// client belongs to the match, and complete_handshake() or cancel() must follow.
  AdmissionResult admit(ListeningPort port, std::string_view datagram,
                        const ClientRights& rights = {});

  /// Connects the admitted client and sends the reply and the parameters
  /// (docs/spec/server-protocol.md 2.1).
  void complete_handshake(const Admission& admission, std::unique_ptr<soccer::Channel> channel,
                          std::string_view request);

  /// Undoes admit() if the client cannot be reached.
  void cancel(const Admission& admission);

  /// Marks a client as disconnected: a player leaves the pitch in the next execute().
  void mark_lost(ClientId id);

  /// Drops all connections immediately without notifying clients; the world stays unchanged.
  void disconnect_all();

  /// Number of connected players.
  int connected() const { return players_.connected(); }

  // Clients; null if not connected.
  PlayerSession* session(Slot slot) { return players_.session(slot); }
  Connection* connection(ClientId client);
  const CoachRegistry& coaches() const { return coaches_; }

  // Input.

  /// True when a datagram of the client exceeded its ReceiveQuota since the last step.
  bool has_used_quota(ClientId id) {
    const Connection* client = connection(id);
    return client != nullptr && client->quota.exceeded();
  }
  /// Stores a datagram of a player, coach or trainer until execute(); executes one of a monitor
  /// immediately. Drops what exceeds the client's ReceiveQuota.
  ///
  /// After answer_on_receipt(), players and coaches do not wait for replies that need no order
  /// among the clients: (clang), questions, settings of messages, errors. The logs have all
  /// commands in the order of execute().
  void receive(ClientId id, std::string_view datagram, bool null_terminated = true);

  /// Handles a datagram that a connected client sent to the listening port. Old versions may do so;
  /// others receive an error.
  void receive_on_listening_port(ClientId id, std::string_view datagram, bool null_terminated);

  /// For clients that wait for a reply before they send (done). In lockstep a reply would change
  /// its place among the messages of a cycle.
  void answer_on_receipt() { answers_on_receipt_ = true; }

  /// Ignores commands of monitors from now on, so that the match stays reproducible.
  void make_monitors_read_only() { monitors_.make_read_only(); }

  /// Changes the world between cycles, as a trainer may, and sends the resulting events.
  void modify_world(const std::function<void(World&, Events&)>& change);

  // The parts of a cycle, in this order.

  /// Executes the received commands: clients in an order drawn for this cycle, datagrams in order
  /// of arrival. Replies and messages to other clients are sent immediately.
  void execute();

  // The two halves of execute(), for a driver that sends (think) to coaches in between.
  void execute_players();
  void execute_coaches();

  /// Runs and logs one simulation step and sends the referee messages.
  void step();

  /// Sends sense_body, fullstate, hear, see and see_global messages that are due at the step.
  void sense();

  /// Sends the see messages that are due until `ms` after the step, in match time.
  void see(int ms);

  /// In synchronous mode: sends (think), after the see messages that are due before it. Coaches and
  /// trainer receive it if eye is on.
  void think();
  void think_players();
  void think_coaches();

  /// True if coaches and trainer receive (think) in this cycle only after the players' commands
  /// were executed. Drawn from the seed: on rcssserver the race between clients has this result at
  /// times.
  bool coaches_are_late() const;

  /// True while the client has received (think) and not sent (done).
  bool awaits(ClientId client) const;
  bool awaits_any_client() const;
  bool awaits_coaches() const;  ///< online coaches or trainer

  /// True after time_over or at the cycle limit.
  bool finished() const;

  /// Sends the referee's time_over to all clients, for a match that ends at the cycle limit. The
  /// logs do not record it: the game is not over.
  void announce_end();

  /// Writes the result to the game log; call once, after the last step.
  void finish() { recorder_.finish(world_); }

  const World& world() const { return world_; }

 private:
  explicit MatchServer(std::shared_ptr<const Rules> rules, const MatchConfig& config);

  AdmissionResult admit_monitor(const soccer::MonitorInit& init, const ClientRights& rights);
  void connect_coach(const Admission& admission, std::unique_ptr<soccer::Channel> channel);

  void execute(PlayerSession& session);
  void answer(PlayerSession& session, const PlayerInbox::Datagram& datagram);
  void execute(PlayerSession& session, const soccer::PlayerCommand& command);
  void execute(CoachSession& coach);
  void answer(CoachSession& coach, const CoachInbox::Datagram& datagram);
  template <typename Session>
  void answer_on_receipt(Session& session);
  void declare_clang_versions(PlayerSession& session, const soccer::Clang& versions);
  void remove_lost();

  // Events and messages (match_events.cpp).
  void dispatch_events();
  void dispatch(const Event& event);
  void send_referee_message(Clock clock, const RefereeMessage& message);
  void send_say(Clock clock, const PlayerSaid& said);
  void send_coach_message(const CoachMessage& message);
  void send_type_change(Clock clock, const TypeChanged& change);
  void send_goalie_change(Clock clock, const GoalieAppointed& change);
  void send_clang_versions(CoachSession& coach, Slot player);
  void record_substitution(Clock clock, Side side, int unum, const std::string& what);
  bool monitors_hear() const;
  void record_message(Clock clock, std::string_view speaker, std::string_view text);

  World world_;
  MatchRecorder recorder_;
  PlayerRegistry players_;
  CoachRegistry coaches_;
  MonitorRegistry monitors_;
  std::optional<int> cycle_limit_;
  std::optional<int> decisive_lead_;
  bool answers_on_receipt_ = false;

  // Reused, so that a cycle does not allocate.
  Events events_;
  soccer::Hear referee_message_;
  std::vector<CoachMessage> coach_messages_;
};

}  // namespace cls::simulator
