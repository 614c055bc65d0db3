// A match and the clients connected to it, whatever carries their messages and drives the clock.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "simulator/senses/vision.h"
#include "simulator/sessions/coaches.h"
#include "simulator/sessions/connection.h"
#include "simulator/sessions/match_recorder.h"
#include "simulator/sessions/monitor_desk.h"
#include "simulator/sessions/session.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/channel.h"
#include "soccer/commands/connection_request.h"
#include "soccer/commands/monitor_command.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/reply_code.h"

namespace cls::simulator {

struct MatchConfig {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::uint64_t seed = 0;

  /// Ends the match when game time reaches this; otherwise it ends with time_over.
  std::optional<int> cycle_limit;
};

/// The server without its network: who plays, what they sent, what they are told, what is logged.
/// A driver calls, for every cycle: receive() for each datagram, then execute(), step(), sense(),
/// think(). Draws of its own (order of execution, senses) come from streams keyed by seed, clock
/// and player, so that a client that joins or leaves changes nothing for the others.
class MatchServer {
 public:
  static constexpr std::size_t kMostClients =
      static_cast<std::size_t>(kFirstMonitor) + MonitorDesk::kMostMonitors;

  /// The error names the parameter that makes no match.
  static base::Result<std::unique_ptr<MatchServer>> create(const MatchConfig& config);

  /// Writes logs from now on. Call before anybody connects. The sinks must live until the server is
  /// gone.
  void record(const LogSinks& sinks);
  void record(base::ByteSink* game_log, base::ByteSink* text_log) {
    record(LogSinks{.game = game_log, .text = text_log});
  }

  /// Reads a connection request. On success the client takes part from now on, and greet() must
  /// follow; else the error to answer with.
  std::variant<Admission, soccer::ErrorCode> admit(Door door, std::string_view datagram);

  /// Gives the admitted client its channel and sends all that follows an init (protocol 2.1).
  void greet(const Admission& admission, std::unique_ptr<soccer::Channel> channel,
             std::string_view request);

  /// Instead of greet(), when the admitted client cannot be reached after all.
  void withdraw(const Admission& admission);

  /// Changes the world as a trainer may, between cycles; what happens by it is told to everybody.
  void arrange(const std::function<void(World&, Events&)>& change);

  /// Keeps what a player, coach or trainer sent until execute(); obeys a monitor at once. What is
  /// beyond the client's Allowance is dropped.
  void receive(ClientId id, std::string_view datagram, bool null_terminated = true);

  /// A client that is in has sent this to the door again. Old versions may; others are told that
  /// it is for requests only.
  void receive_at_door(ClientId id, std::string_view datagram, bool null_terminated);

  /// What monitors send has no effect on the match from now on, so that it stays repeatable.
  void let_monitors_only_watch() { monitors_only_watch_ = true; }

  /// The client is gone: a player leaves the pitch at the next execute().
  void lose(ClientId id);

  /// Drops all connections at once, without a word; the world stays as it is.
  void disconnect_all();

  /// Players with a connection.
  int connected() const;

  /// The session of a connected player, else null.
  Session* session(Slot slot) { return sessions_[static_cast<std::size_t>(slot)].get(); }

  /// A client of any kind, else null.
  Connection* connection(ClientId client);

  const Coaches& coaches() const { return coaches_; }

  /// Executes what was received: clients in an order drawn for this cycle, the datagrams of each
  /// in order of arrival. Replies, and what others hear of it, go out at once.
  void execute();

  // The two halves of it, for a driver that asks coaches in between.
  void execute_players();
  void execute_coaches();

  /// One simulation step, logged; the referee's words go out.
  void step();

  /// sense_body, fullstate, what was heard, see and see_global, to everybody who is due at the step
  /// itself.
  void sense();

  /// The see messages that fall due until `ms` after the step, in the time of the match.
  void see(int ms);

  /// In synchronous mode: (think), and the see messages that fall before it. Coaches and the
  /// trainer are asked if their eyes are open.
  void think();
  void think_players();
  void think_coaches();

  /// Whether coaches and trainer come to think in this cycle only after what players say and do in
  /// it, drawn from the seed. With programs that race each other that happens now and then.
  bool coaches_are_late() const;

  /// True while a client who was asked to think has not sent (done).
  bool awaits(ClientId client) const;
  bool awaits_anybody() const;
  bool awaits_coaches() const;  ///< or the trainer

  /// Time over, or the cycle limit is reached.
  bool finished() const;

  /// Writes the result into the game log. Once, when no step will follow.
  void finish();

  const World& world() const { return world_; }

 private:
  explicit MatchServer(std::shared_ptr<const Rules> rules, const MatchConfig& config);

  std::variant<Admission, soccer::ErrorCode> admit_player(const soccer::PlayerInit& init);
  std::variant<Admission, soccer::ErrorCode> readmit_player(const soccer::PlayerReconnect& request);
  std::optional<Side> side_for(std::string_view name);
  void greet_player(const Admission& admission, std::unique_ptr<soccer::Channel> channel);
  void greet_coach(const Admission& admission, std::unique_ptr<soccer::Channel> channel);
  std::variant<Admission, soccer::ErrorCode> admit_monitor(const soccer::MonitorInit& init);

  void obey_monitor(ClientId id, std::string_view datagram, bool null_terminated);
  void obey_as_trainer(ClientId id, std::string_view datagram);
  void compress_monitor(Connection& monitor, int level);
  void execute(Session& session);
  void execute(Session& session, const soccer::PlayerCommand& command);
  void execute(CoachSession& coach);
  void declare(Session& session, const soccer::Clang& versions);
  void tell_coach(CoachSession& coach, Slot player);
  void remove_lost();
  void dispatch_events();
  void dispatch(const Event& event);
  void tell_referee(Clock clock, const RefereeSaid& said);
  void tell_said(Clock clock, const PlayerSaid& said);
  void tell_words(const CoachWords& words);
  void tell_substitution(Clock clock, Side side, int unum, const std::string& what);
  void tell_type(Clock clock, const TypeChanged& change);
  void tell_goalie(Clock clock, const GoalieAppointed& change);
  std::string speaker_name(Slot slot) const;
  bool monitors_hear() const;
  bool audience_hears() const { return monitors_hear() || recorder_.hears(); }
  void tell_audience(Clock clock, std::string_view speaker, std::string_view words);
  void tell_audience(Clock clock, const CoachWords& words);
  void broadcast(std::string_view message);

  void send_sense_body(Session& session);
  void send_full_state(Session& session);
  void send_hearing(Session& session);
  void send_see(Session& session);
  void view_round(bool synchronous);
  void asynchronous_rounds(int until_ms);

  /// A stream for one player's draws at this clock.
  RandomStream stream(std::string_view purpose, Slot slot) const;

  World world_;
  VisionModel vision_;
  MatchRecorder recorder_;
  std::array<std::unique_ptr<Session>, soccer::kPlayersOnPitch> sessions_;
  /// Coach language versions that the players have declared.
  std::array<soccer::Clang, soccer::kPlayersOnPitch> clang_versions_ = {};
  Coaches coaches_;
  MonitorDesk monitors_;
  bool monitors_only_watch_ = false;
  std::optional<int> cycle_limit_;
  std::int64_t steps_ = 0;
  std::int64_t asynchronous_rounds_ = 0;
  bool saw_ = true;  ///< since the last step, those with synch_see

  // Reused, so that a cycle does not allocate.
  Events events_;
  std::string text_;
  soccer::See see_;
  soccer::Hear referee_;  ///< its last words
  soccer::FullState full_state_;
  std::vector<soccer::Hear> heard_;
  std::vector<CoachWords> coach_words_;
};

}  // namespace cls::simulator
