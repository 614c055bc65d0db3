// One player: server messages in, beliefs, a Playmaker's decision, commands out.
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/commands/command_slots.h"
#include "proxy/connection/agent_statistics.h"
#include "proxy/connection/decision_timer.h"
#include "proxy/connection/server_connection.h"
#include "proxy/formation/formation_set.h"
#include "proxy/perception/perception.h"
#include "proxy/planner/action_context.h"
#include "proxy/planner/action_memory.h"
#include "proxy/world/world_model.h"
#include "soccer/channel.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/protocol/protocol_version.h"
#include "soccer/protocol/team_name.h"

namespace cls::proxy {

/// What a player does in a cycle for which its Playmaker gave no usable answer.
enum class OnLate : std::uint8_t {
  kHold,     ///< stands and looks at the ball
  kLast,     ///< does once more what the last answer said
  kDefault,  ///< plays by itself: see fallback.h
};

/// "hold", "last" and "default".
std::optional<OnLate> on_late_from_name(std::string_view name);

struct AgentOptions {
  soccer::TeamName team_name;
  bool goalie = false;
  int protocol = soccer::kDefaultProtocolVersion;  ///< version of the text protocol, 14 to 19
  OnLate on_late = OnLate::kHold;
  int reconnect_unum = 0;  ///< not 0: takes over this player, who lost his connection
  std::shared_ptr<const FormationSet> formations;  ///< null: the built-in ones
  std::string debug_log;  ///< folder for what Playmakers log; empty: nowhere
};

/// Meets the server through its channel only. Order: connect(); perceive() until ready(); then per
/// cycle perceive() and, when a decision is due, state() and one of the act functions. It decides
/// once per cycle: see decision_timer.h.
class PlayerAgent {
 public:
  PlayerAgent(std::unique_ptr<soccer::Channel> channel, AgentOptions options);

  /// Asks the server to take part; again when a refusal was for the moment only. False when the
  /// connection is gone.
  bool connect();
  /// Takes in all messages that wait; none while an answer of the Playmaker is awaited.
  void perceive();
  /// True when number, parameters and all player types are known.
  bool ready() const { return proxy::ready(server_, world_); }
  const ServerConnection& server() const { return server_; }

  /// `now` counts in real time only.
  bool decision_due(Instant now = {}) const { return !deciding_ && timer_.due(now); }
  const DecisionTimer& timer() const { return timer_; }
  bool deciding() const { return deciding_; }
  /// The State for the decision that is due; completes the world model. Once per decision. Lives
  /// until the next call.
  const protos::State& state(Instant now = {});
  /// The same State again; its register_response is the caller's to keep.
  protos::State& question() { return state_; }
  /// Carries out the answer, sends the commands and (done). False when the Playmaker has to choose
  /// among planned actions first: ask it with planner_request(), then act_on_choice().
  bool act(const protos::PlayerActions& actions);
  /// Valid after act() returned false, until act_on_choice().
  bool awaits_choice() const { return awaits_choice_; }
  const protos::BestPlannerActionRequest& planner_request() const { return planner_request_; }
  /// Goes on with the chosen node's index; nothing: the Playmaker did not answer.
  void act_on_choice(std::optional<int> node);
  /// The same without an answer, as the options say.
  void act_without_reply();
  /// Takes leave of the server.
  void leave();

  /// What the Playmaker gave this agent as its identity; part of every State.
  const protos::RegisterResponse& identity() const { return state_.register_response(); }
  bool has_identity() const { return state_.has_register_response(); }

  int unum() const { return world_.unum; }
  const WorldModel& world() const { return world_; }
  const AgentOptions& options() const { return options_; }
  AgentStatistics& statistics() { return statistics_; }
  const AgentStatistics& statistics() const { return statistics_; }

 private:
  void take_in_message();
  void take_in_reply();
  void take_in_sense_body();
  void note_lost_commands();
  void begin_part(const soccer::PlayerInitReply& init);
  void send(const CommandSlots& slots);
  const WorldModel& decision_world() const { return view_ ? *view_ : world_; }
  void write_debug_log();

  ServerConnection server_;
  AgentOptions options_;
  WorldModel world_;
  ActionMemory memory_;
  AgentStatistics statistics_;
  DecisionTimer timer_;
  bool deciding_ = false;      ///< state() was asked for, the answer not carried out yet
  bool awaits_count_ = false;  ///< sent a command that the next sense_body must count
  protos::State state_;
  protos::PlayerActions last_actions_;  // kLast, kDefault
  std::unique_ptr<WorldModel> view_;    // in a shoot-out the other way round
  bool awaits_choice_ = false;
  PlanChoice choice_;
  protos::PlayerActions chosen_from_;  // the list that waits for a choice
  protos::BestPlannerActionRequest planner_request_;
  std::ofstream debug_log_;

  // Reused, so that a steady match does not allocate.
  soccer::SenseBody sense_;
  soccer::See see_;
  soccer::Hear hear_;
  std::vector<soccer::PlayerCommand> commands_;
};

}  // namespace cls::proxy
