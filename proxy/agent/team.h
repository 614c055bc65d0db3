// A team of players, with coach or trainer, and their Playmaker, in one process.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "proxy/agent/decision_listener.h"
#include "proxy/agent/player_agent.h"
#include "proxy/coach/coach_agent.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/playmaker/playmaker_client.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "soccer/channel.h"
#include "soccer/side.h"

namespace cls::proxy {

struct TeamOptions : PlayerOptions {
  soccer::TeamName name;
  int players = soccer::kPlayersPerTeam;
  RpcTimeout decision_timeout{10'000};  ///< kNoTimeout: none
  RpcTimeout start_timeout{20'000};     ///< for the Playmaker to start and answer Register
  RpcTimeout reconnect_within{3'000};   ///< see DecisionLimits
  bool shared_playmaker = true;         ///< by all agents; otherwise (port_step) one per agent
  int first_unum = 1;                   ///< first player to take over with `reconnect`
  bool reconnect = false;               ///< take over disconnected players
  bool goalie = true;                   ///< the first player is the goalie
  std::shared_ptr<const TeamGraphic> graphic;  ///< that the coach shows; null: none
  std::shared_ptr<TensorCodec> codec;          ///< null: the form TENSOR is not offered
  bool rated = false;                          ///< a match of a tournament or comparison
};

/// Time of a team by phase, summed over all cycles.
struct TeamTimes {
  std::chrono::nanoseconds perceive{0};  ///< parsing and world model
  std::chrono::nanoseconds state{0};     ///< completing the world and filling the State
  std::chrono::nanoseconds begin{0};     ///< serializing and passing to gRPC
  std::chrono::nanoseconds wait{0};      ///< for replies, including parsing
  std::chrono::nanoseconds act{0};       ///< skills and commands
  std::chrono::nanoseconds turns{0};     ///< from the first decision begun to the last command sent
  LatencySamples turn_us;                ///< of each such turn
};

/// The agent with most consecutive missed decisions now.
struct MissedDecisions {
  int unum = 0;  ///< 0: none; also kCoachNumber, kTrainerNumber
  int consecutive = 0;
  RpcStatus last;  ///< reason of the latest miss
};

/// Used by one thread (except Playmaker::cancel()). Commands do not depend on the order of replies.
class Team {
 public:
  /// `playmaker` must outlive the team.
  Team(TeamOptions options, Playmaker& playmaker);

  /// Replaces the Playmaker; before register_agents() only.
  void set_playmaker(Playmaker& playmaker) { playmaker_ = &playmaker; }

  /// Adds a listener, which must outlive the team.
  void listen_to_decisions(DecisionListener& listener) { decision_listeners_.push_back(&listener); }

  /// Opens a new connection to the server.
  using OpenChannel = std::function<std::unique_ptr<soccer::Channel>()>;

  /// Connects the players sequentially, goalie first, each until it has its uniform number, the
  /// parameters and all player types.
  base::Result<void> connect(const OpenChannel& open, const Serve& serve);

  /// Connects the team's coach, after its players, or a trainer, in a team without players. `open`
  /// connects to the coach or trainer port.
  base::Result<void> connect_coach(soccer::CoachRole role, const OpenChannel& open,
                                   const Serve& serve);

  /// Performs the handshake of each agent: Register, parameters, player types, init message. Works
  /// with a Playmaker of the first interface, without Register. Not ok when the Playmaker is
  /// unreachable or does not implement the interface; the message names the player and the call.
  RpcStatus register_agents();

  /// Handles the server's messages and requests all due decisions; returns their number.
  int begin_cycle();
  /// Waits for the replies, executes each on arrival, sends commands and (done).
  void finish_cycle();
  int run_cycle();

  // A cycle in smaller steps, for real time: begin_decisions() whenever messages arrive or
  // next_due() is reached, handle_reply() while replies are outstanding.

  /// begin_cycle() at the time `now`; may be repeated while replies are outstanding.
  int begin_decisions(Instant now);
  /// Executes one reply; false when none arrives within `timeout`.
  bool handle_reply(std::chrono::microseconds timeout);
  /// Perceives what has come; true once per cycle, when the first player's decision is due.
  bool begins_turn(Instant now);
  int outstanding() const { return outstanding_; }
  /// Time of the next decision due by the clock; the far future when only a message can make one
  /// due.
  Instant next_due() const;

  /// Disconnects: SendByeCommand to the Playmaker, (bye) to the server. Waits at most 1 s in all
  /// for a Playmaker that does not respond.
  void leave();

  const std::string& name() const { return name_; }
  soccer::Side side() const;
  const std::vector<std::unique_ptr<PlayerAgent>>& players() const { return players_; }
  /// World model of the first player, otherwise of coach or trainer. Valid after connecting.
  const player::WorldModel& world() const;
  /// True when the server runs in synchronous mode.
  bool synchronous() const { return world().server().synch_mode; }
  /// The coach or trainer; null: none.
  const CoachAgent* coach() const { return coach_.get(); }
  /// Arrival of the latest message to a player that was perceived; of a trainer, to the trainer.
  Instant heard_at() const;
  const TeamTimes& times() const { return times_; }
  MissedDecisions missed_decisions() const;
  /// Calls that the Playmaker answered with an error so far.
  const PlaymakerErrors& errors() const { return errors_; }
  /// Adds a warning unless it is empty or was added before.
  void warn_once(const std::string& line);
  /// Warnings since the last call, each once per team.
  std::vector<std::string> take_warnings();

 private:
  /// Warnings given about one kind of action.
  struct ActionWarnings {
    bool unimplemented = false;
    bool invalid = false;
  };

  base::Result<void> connect_one(const OpenChannel& open, const Serve& serve, bool goalie);
  void warn_of_shared_identity();
  PlaymakerClient& client_of(int number);
  /// `who` names the agent in the message of a failure.
  RpcStatus register_agent(Agent& agent, int number, proto::Rpc decision,
                           protos::RegisterRequest request, const std::string& who);
  void request_decision(Agent& agent, int number, RpcTimeout timeout, bool server_waits);
  /// True when the reply is the result of a decision, not a part of the handshake.
  bool decides(Reply& reply);
  TeamRegistration registration() const;
  protos::RegisterRequest coach_registration() const;
  RpcStatus register_coach();
  int begin_coach_decision(Instant now);
  RpcTimeout coach_timeout(Instant now) const;
  void handle_coach_reply(const Reply& reply);
  RpcTimeout decision_timeout(const PlayerAgent& agent, Instant now) const;
  void end_turn();
  PlayerAgent* find_player(int unum) const;
  PlayerAgent& player(int unum) const;
  void execute(Reply reply);
  void count_reply(PlayerAgent& agent, const Reply& reply);
  void handle_planner_reply(PlayerAgent& agent, const Reply& reply);
  void request_planner_choice(PlayerAgent& agent, const Reply& reply);
  void report_decision(const PlayerAgent& agent, const protos::PlayerActions* actions,
                       const RpcStatus& status, std::chrono::microseconds latency) const;
  void count_error(const Reply& reply, const Agent& agent,
                   const google::protobuf::Message& request);
  RpcStatus send_bye(int number, const Agent& agent);
  void warn_of_actions(const PlayerAgent& agent);
  void warn_of_coach_actions();
  void warn_of_server(const ServerErrors& trouble);

  TeamOptions options_;
  std::string name_;
  Playmaker* playmaker_;
  std::vector<DecisionListener*> decision_listeners_;
  /// The latency of the first call of agents that await the Playmaker's choice of a plan.
  std::array<std::chrono::microseconds, kAgentNumbers> first_latency_{};
  std::vector<std::unique_ptr<PlayerAgent>> players_;
  std::array<std::optional<PlaymakerClient>, kAgentNumbers> clients_;  // by agent number
  std::unique_ptr<CoachAgent> coach_;
  int outstanding_ = 0;
  Instant turn_began_;
  std::int64_t turn_ = 0;  ///< most decisions of any player, one that is due included
  TeamTimes times_;
  std::array<ActionWarnings, player::kActionKinds> warned_actions_{};
  std::array<ActionWarnings, player::kSayKinds> warned_say_{};
  PlaymakerErrors errors_;
  bool warned_of_error_ = false;
  std::vector<std::string> warnings_;
  std::size_t warnings_taken_ = 0;
};

}  // namespace cls::proxy
