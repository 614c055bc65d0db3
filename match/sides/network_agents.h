// A cls team on a soccer server over UDP, from its first message to its goodbye.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/programs/server_plan.h"
#include "match/sides/agent_side.h"
#include "match/sides/turn_gate.h"
#include "proxy/agent/team_driver.h"
#include "soccer/udp_channel.h"

namespace cls::match {

struct NetworkSettings {
  std::string server_host = "127.0.0.1";
  int server_port = 6000;
  int coach_port = 0;    ///< 0: no coach
  int trainer_port = 0;  ///< 0: no trainer
  /// For servers without a cycle limit of their own: the team plays up to this cycle, and sends
  /// nothing in it.
  std::optional<int> cycle_limit;
  bool leave_at_time_over = true;  ///< otherwise play until the server stops responding
  bool hold_turns = false;  ///< from the kick-off on each cycle waits for begin_turn(), for --step
  std::optional<double> speed;  ///< limit in multiples of real time; synch mode only
  /// Another Playmaker for a team on the right; may be empty.
  std::function<std::unique_ptr<proxy::Playmaker>()> right_playmaker;
  /// Called once, when the players are on the pitch and registered; may be empty.
  std::function<void(const proxy::Team&)> on_ready;
  /// See proxy::DriverOptions.
  std::function<std::unique_ptr<soccer::Channel>(std::unique_ptr<soccer::Channel>)> wrap;
};

/// Lives on its worker's thread from join() on. The match's thread polls.
class NetworkAgents : public AgentSide, private TurnTaker {
 public:
  /// The error says that the server's host is unknown. Nothing is sent yet.
  static base::Result<std::unique_ptr<NetworkAgents>> create(AgentParts parts,
                                                             NetworkSettings settings);
  /// Stops the team and waits until it has left: 1 s if its Playmaker does not respond.
  ~NetworkAgents() override;

  bool prepared() override;
  std::optional<MatchEnd> join(const ServerStatus& server,
                               const std::vector<std::string>& others) override;
  bool joined() const override { return stage_ > Stage::kJoining; }
  bool wait_handshake(std::chrono::milliseconds /*limit*/) override {
    return stage_ > Stage::kHandshake;
  }
  std::string waiting_for() const override;
  std::string timeout_hint() const override;
  void begin_play() override;
  void end_play() override;
  TurnTaker* turns() override { return playing_ && gate_.is_closed() ? this : nullptr; }
  TurnTimes turn_times() const override;
  std::optional<SeenMatch> seen() const override;
  /// A team that missed too many decisions: the server may reach its end without it.
  std::optional<MatchEnd> final_failure(const MatchMoment& moment) override;
  std::vector<std::string> take_warnings() override;
  void leave() override;
  void terminate() override;

 private:
  enum class Stage {
    kIdle,
    kJoining,    ///< players ask the server to take part
    kHandshake,  ///< they are on the pitch, and register with the Playmaker
    kPlaying,
    kOver,  ///< the team has left, whatever the reason
  };
  /// The knowledge of the agents after a round; the match reads it from its own thread.
  struct Snapshot {
    SourceProgress progress;
    std::optional<soccer::Vec2> ball;
    TurnTimes turns;
  };

  NetworkAgents(AgentParts parts, NetworkSettings settings)
      : AgentSide(std::move(parts)), settings_(std::move(settings)), gate_(settings_.hold_turns) {}

  bool at_turn() const override { return gate_.has_waiting(); }
  void begin_turn(int /*cycle*/) override { gate_.let_pass(); }

  std::optional<MatchEnd> agent_failure(const MatchMoment& moment) override;
  bool has_finished() const;
  void stop();
  void live();
  bool join_server();
  bool register_agents();
  void play();
  void before_decisions();
  void throttle();
  bool keep_playing();
  void update_snapshot();
  bool near_cycle_limit() const;
  bool has_kicked_off() const;
  void wait_for_cycle_limit();
  void fail(MatchEnd end);

  NetworkSettings settings_;
  std::unique_ptr<soccer::UdpClients> clients_;
  std::unique_ptr<proxy::TeamDriver> driver_;
  TurnGate gate_;
  std::atomic<Stage> stage_{Stage::kIdle};
  std::atomic<bool> stop_{false};
  std::atomic<bool> reached_limit_{false};
  std::atomic<MatchMode> mode_{MatchMode::kSynch};
  bool near_limit_ = false;
  std::atomic<bool> playing_{false};  ///< the match has begun
  bool holds_turns_ = false;
  std::int64_t turns_ = 0;
  std::chrono::steady_clock::time_point first_turn_;
  mutable std::mutex mutex_;  ///< of what follows
  Snapshot snapshot_;
  std::optional<MatchEnd> end_;
  std::vector<std::string> warnings_;
};

}  // namespace cls::match
