// An online coach or a trainer: server messages in, the whole truth as a State, orders out.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/coach/coach_notes.h"
#include "proxy/coach/coach_orders.h"
#include "proxy/connection/agent_statistics.h"
#include "proxy/connection/server_connection.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/world/world_model.h"
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
  soccer::TeamName team_name;  ///< an online coach's; a trainer learns the left team's
  int protocol = soccer::kDefaultProtocolVersion;
};

/// Meets the server through its channel only. Order: connect(); perceive() until ready(); then per
/// cycle perceive() and, when a decision is due, either state() and act() or act_without_reply().
/// A decision is due on (think) in synchronous mode, else with each view.
class CoachAgent {
 public:
  CoachAgent(std::unique_ptr<soccer::Channel> channel, CoachOptions options);

  /// Asks the server to take part. False when the connection is gone.
  bool connect();
  /// Takes in all messages that wait; none while an answer of the Playmaker is awaited.
  void perceive();
  /// True when parameters and all player types are known.
  bool ready() const { return proxy::ready(server_, world_); }
  const ServerConnection& server() const { return server_; }

  bool decision_due() const { return due_ && !deciding_; }
  /// The decision that is due is the Playmaker's: it has the call, and there is something to tell.
  bool asks() const { return asks_ && !world_.our_team_name.empty(); }
  /// Never ask again: the Playmaker does not have the call.
  void stop_asking() { asks_ = false; }
  bool deciding() const { return deciding_; }

  /// The State for the decision that is due; completes the world model. Once per decision.
  const protos::State& state();
  /// The same State again; its register_response is the caller's to keep.
  protos::State& question() { return state_; }
  /// Carries out the answer: sends the commands, each in a datagram of its own, and (done).
  void act(const protos::CoachActions& actions);
  void act(const protos::TrainerActions& actions);
  void act_without_reply();
  /// Takes leave of the server.
  void leave();

  const protos::RegisterResponse& identity() const { return state_.register_response(); }
  bool has_identity() const { return state_.has_register_response(); }

  bool is_trainer() const { return options_.role == soccer::CoachRole::kTrainer; }
  /// Among the agents of a Playmaker.
  int number() const { return is_trainer() ? kTrainerNumber : kCoachNumber; }
  const char* word() const { return is_trainer() ? "trainer" : "coach"; }
  const WorldModel& world() const { return world_; }
  const CoachNotes& notes() const { return notes_; }
  AgentStatistics& statistics() { return statistics_; }
  const AgentStatistics& statistics() const { return statistics_; }
  const CoachReport& report() const { return report_; }
  /// Sent, by protocol word, without zeros; (done) is not counted.
  const std::map<std::string, std::int64_t>& commands() const { return sent_; }

 private:
  void take_in_message();
  void take_in_reply();
  void change_type(const soccer::PlayerTypeChange& change);
  void send(const soccer::CoachCommand& command);
  void send_orders();

  ServerConnection server_;
  CoachOptions options_;
  WorldModel world_;
  CoachNotes notes_;
  AgentStatistics statistics_;
  CoachReport report_;
  bool due_ = false;
  bool deciding_ = false;
  bool asks_ = true;
  bool names_complete_ = false;  ///< a trainer has learnt both
  protos::State state_;
  std::map<std::string, std::int64_t> sent_;

  // Reused from cycle to cycle.
  soccer::GlobalView view_;
  soccer::Hear hear_;
  std::vector<soccer::CoachCommand> orders_;
};

}  // namespace cls::proxy
