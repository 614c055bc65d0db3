// An online coach or a trainer: server messages, exact State, Playmaker's decision, commands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "player/world/planner_parameters.h"
#include "proto/playmaker.pb.h"
#include "proxy/coach/coach_actions.h"
#include "proxy/coach/coach_memory.h"
#include "proxy/coach/team_graphic.h"
#include "proxy/connection/agent.h"
#include "proxy/playmaker/playmaker.h"
#include "soccer/channel.h"
#include "soccer/commands/coach_command.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/protocol_version.h"
#include "soccer/protocol/team_name.h"

namespace cls::proxy {

struct CoachOptions {
  soccer::CoachRole role = soccer::CoachRole::kOnlineCoach;
  soccer::TeamName team_name;  ///< of an online coach; a trainer receives the left team's
  int protocol = soccer::kDefaultProtocolVersion;
  std::shared_ptr<const TeamGraphic> graphic = nullptr;                ///< null: none
  std::shared_ptr<const player::PlannerParameters> planner = nullptr;  ///< null: the defaults
};

/// Communicates with the server through its channel only. Sequence: connect(); perceive() until
/// ready(); then per cycle perceive() and, when a decision is due, either state() and act() or
/// act_without_reply(). A decision is due on (think) in synchronous mode, otherwise with each view.
class CoachAgent : public Agent {
 public:
  CoachAgent(std::unique_ptr<soccer::Channel> channel, CoachOptions options);

  /// Sends the init command. False when the connection is closed.
  bool connect();
  /// Handles all received messages; none while a decision is pending.
  void perceive();

  bool decision_due() const { return due_ && !deciding_; }
  /// True when the due decision is to be requested: the Playmaker implements the RPC, and the team
  /// is known.
  bool requests_decisions() const { return requests_enabled_ && !world_.our_team_name.empty(); }
  /// The Playmaker does not implement the RPC: request no more decisions.
  void disable_requests() { requests_enabled_ = false; }
  /// Completes the world model and returns the State for the due decision. Once per decision.
  const protos::State& state();
  /// Executes the reply: sends the commands, one per datagram, and (done).
  void act(const protos::CoachActions& actions);
  void act(const protos::TrainerActions& actions);
  void act_without_reply();
  /// Disconnects from the server.
  void leave();

  bool is_trainer() const { return options_.role == soccer::CoachRole::kTrainer; }
  /// Agent number at the Playmaker.
  int number() const { return is_trainer() ? kTrainerNumber : kCoachNumber; }
  const char* role_name() const { return is_trainer() ? "trainer" : "coach"; }
  const CoachMemory& memory() const { return memory_; }
  const CoachActionReport& report() const { return report_; }
  /// Sent commands by protocol name, without zeros; (done) is not counted.
  const std::map<std::string, std::int64_t>& commands() const { return sent_; }

 private:
  void handle_message();
  void handle_server_reply();
  void confirm_type(const soccer::OkChangePlayerType& change);
  void set_names(const soccer::OkTeamNames& names);
  void change_type(const soccer::PlayerTypeChange& change);
  void handle_error(const soccer::ErrorReply& error);
  void send(const soccer::CoachCommand& command);
  void send_commands();
  void show_graphic();

  CoachOptions options_;
  CoachMemory memory_;
  CoachActionReport report_;
  bool due_ = false;
  bool deciding_ = false;
  bool requests_enabled_ = true;
  bool names_complete_ = false;  ///< a trainer has received both
  std::map<std::string, std::int64_t> sent_;
  std::size_t tiles_sent_ = 0;  ///< of the graphic

  // Reused from cycle to cycle.
  soccer::GlobalView view_;
  soccer::Hear hear_;
  std::vector<soccer::CoachCommand> commands_;
};

}  // namespace cls::proxy
