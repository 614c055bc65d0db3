// One player: server messages, world model, Playmaker's decision, commands.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/commands/command_slots.h"
#include "player/formation/formation_set.h"
#include "player/perception/perception.h"
#include "player/planner/action_context.h"
#include "proto/playmaker.pb.h"
#include "proxy/actions/executor.h"
#include "proxy/agent/full_state_use.h"
#include "proxy/agent/on_late.h"
#include "proxy/connection/agent.h"
#include "proxy/connection/decision_timer.h"
#include "soccer/channel.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/protocol/protocol_version.h"
#include "soccer/protocol/team_name.h"

namespace cls::proxy {

/// Options that all players of a team share.
struct PlayerOptions {
  /// Version of the text protocol, 14 to 19; 19 becomes 18 on servers that do not know it.
  int protocol = soccer::kDefaultProtocolVersion;
  OnLate on_late = OnLate::kHold;
  std::shared_ptr<const player::FormationSet> formations;    ///< null: built-in
  std::shared_ptr<const player::PlannerParameters> planner;  ///< null: the defaults
  FullStateUse full_state = FullStateUse::kReference;
  /// Makes the play of one player, which replaces the lists of the Playmaker. Empty: the lists.
  std::function<OwnPlay()> make_own_play;
};

struct AgentOptions : PlayerOptions {
  soccer::TeamName team_name;
  bool goalie = false;
  int reconnect_unum = 0;  ///< not 0: take over this disconnected player
};

/// Communicates with the server through its channel only. Sequence: connect(); perceive() until
/// ready(); then per cycle perceive() and, when a decision is due, state() and one of the act
/// functions. One decision per cycle: see decision_timer.h.
class PlayerAgent : public Agent {
 public:
  PlayerAgent(std::unique_ptr<soccer::Channel> channel, AgentOptions options);

  /// Sends the init command; again after a temporary refusal. False when the connection is closed.
  bool connect();
  /// Handles all received messages; none while a decision is pending.
  void perceive();

  /// `now` is used in real time only.
  bool decision_due(Instant now = {}) const { return !deciding() && timer_.due(now); }
  const DecisionTimer& timer() const { return timer_; }
  /// True if lists of the Playmaker are not executed.
  bool has_own_play() const { return own_play_ != nullptr; }
  bool deciding() const { return phase_ != Phase::kIdle; }
  /// Completes the world model for the due decision and returns the world of the decision, which
  /// is rotated in a shoot-out, and exact with FullStateUse::kOverride. Once per decision; valid
  /// until the next call.
  const player::WorldModel& begin_decision(Instant now = {});
  /// begin_decision(), and its world as a State. Valid until the next call.
  const protos::State& state(Instant now = {});
  /// Executes the reply, sends the commands and (done). False when the Playmaker must choose among
  /// planned actions first: send planner_request(), then call act_on_planner_choice().
  bool act(const protos::PlayerActions& actions);
  /// Valid after act() returned false, until act_on_planner_choice().
  bool awaits_planner_choice() const { return phase_ == Phase::kAwaitingChoice; }
  const protos::BestPlannerActionRequest& planner_request() const { return planner_request_; }
  /// Continues with the index of the chosen node; nullopt: no reply.
  void act_on_planner_choice(std::optional<int> node);
  /// Acts without a reply, as AgentOptions::on_late says.
  void act_without_reply();
  /// Sends (bye).
  void leave();

  /// What the player remembers: during a decision from those before it.
  const player::ActionMemory& memory() const { return memory_; }
  /// How the latest decision was executed, the plan that it needed (empty: none), and what was
  /// sent.
  const player::DecisionTrace& trace() const { return memory_.trace; }
  const player::PlanChoice& plan() const { return choice_; }
  /// The list that needed a choice among planned actions.
  const protos::PlayerActions& chosen_from() const { return chosen_from_; }
  const std::string& sent_commands() const { return server_.datagram; }

  int unum() const { return world_.unum; }
  /// The world that begin_decision() returned.
  const player::WorldModel& decision_world() const { return view_ ? *view_ : world_; }
  const AgentOptions& options() const { return options_; }

 private:
  enum class Phase : std::uint8_t {
    kIdle,            ///< no decision pending
    kAwaitingReply,   ///< begin_decision() was called
    kAwaitingChoice,  ///< act() needs the Playmaker's choice of a planned action
  };

  void handle_message();
  void use_version_19();
  bool retry_with_older_version(const soccer::ErrorReply& error);
  void handle_server_reply();
  void handle_sense_body();
  void count_lost_commands();
  void on_connected(const soccer::PlayerInitReply& init);
  void send(const player::CommandSlots& slots);
  bool has_full_state() const;

  AgentOptions options_;
  OwnPlay own_play_;  ///< may be empty
  player::ActionMemory memory_;
  DecisionTimer timer_;
  Phase phase_ = Phase::kIdle;
  bool awaits_count_ = false;           ///< sent a command that the next sense_body must count
  protos::PlayerActions last_actions_;  // kLast, kDefault
  std::unique_ptr<player::WorldModel> view_;  // rotated for a shoot-out, or exact
  player::PlanChoice choice_;
  protos::PlayerActions chosen_from_;  // the action list that needs a choice
  protos::BestPlannerActionRequest planner_request_;
  soccer::FullState full_state_;  // the latest
  protos::State full_view_;       // reused

  // Reused to avoid allocation.
  soccer::SenseBody sense_;
  soccer::See see_;
  soccer::Hear hear_;
  std::vector<soccer::PlayerCommand> commands_;
};

}  // namespace cls::proxy
