// A Playmaker under test, the identities of its agents, and calls shared by the steps.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/index.h"
#include "checks/check_report.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::checks {

using Milliseconds = std::chrono::milliseconds;

/// The player of most requests.
inline constexpr int kAgent = 7;

struct PlaymakerSubject {
  // Connection.
  std::function<std::unique_ptr<proxy::Playmaker>()> connect;  ///< opens a new connection
  std::string host;                                            ///< empty: no TCP address
  int port = 0;
  std::function<std::optional<int>()> pid;  ///< of a Playmaker started by the check, while it runs
  Milliseconds start_timeout{20'000};
  Milliseconds deadline{3'000};     ///< of a decision, as in upstream's proxy
  int calls = 10'000;               ///< number of calls of the memory step
  Milliseconds latency_limit{100};  ///< maximum p99 of decisions under load: a cycle in real time

  // Shared by the steps. Two teams, as in a match.
  std::array<std::unique_ptr<proxy::Playmaker>, 2> teams;
  std::array<std::array<protos::RegisterResponse, proxy::kAgentNumbers>, 2> identities;
  int cycle = 1;
  bool has_coach = true;  ///< false after a reply of UNIMPLEMENTED

  /// Asks the Playmaker for the left team in one call; null: it does not implement that.
  std::unique_ptr<proxy::Playmaker> together;

  proxy::Playmaker& left() { return *teams[0]; }
  const protos::RegisterResponse& identity(int agent) const {
    return identities[0][base::index(agent)];
  }

  /// An ordinary State of the agent; each call is one cycle later.
  protos::State next_state(int agent);
};

std::string team_name(int team);

/// Register of one agent.
protos::RegisterRequest registration_request(int team, int agent);

/// Players and coach of a team, with the parameters that all steps send.
proxy::TeamRegistration registration_of_team(int team);

/// Registers one agent and stores its identity.
proxy::RpcStatus register_agent(PlaymakerSubject& subject, int team, int agent);

/// Complete handshake of every agent of a team: Register, parameters, player types, init.
proxy::RpcStatus complete_handshake(PlaymakerSubject& subject, int team);
proxy::RpcStatus send_parameters(PlaymakerSubject& subject, int team, int agent);

/// One blocking call by an agent of the left team.
proxy::RpcStatus call(PlaymakerSubject& subject, int agent, proto::Rpc rpc,
                      const google::protobuf::Message& request);

/// One blocking decision request.
struct Answer {
  proxy::RpcStatus status;
  protos::PlayerActions actions;  ///< a copy
  std::chrono::microseconds latency{0};
};
Answer ask(PlaymakerSubject& subject, int agent, const protos::State& state);
Answer ask(proxy::Playmaker& playmaker, int agent, const protos::State& state,
           Milliseconds deadline);

/// "unavailable: connection refused".
std::string to_text(const proxy::RpcStatus& status);

/// Passes if the call succeeded.
Finding finding(const proxy::RpcStatus& status, std::string evidence = {});

/// Passes if an ordinary request succeeds after one that a Playmaker may refuse but must survive.
/// `before` describes that one.
Finding survives(PlaymakerSubject& subject, const std::string& before);

/// A step: name, why it matters, function.
struct PlaymakerStep {
  const char* name;
  const char* why;
  Finding (*run)(PlaymakerSubject&);
};

// The steps in the order of execution.
std::vector<PlaymakerStep> handshake_steps();
std::vector<PlaymakerStep> decision_steps();
std::vector<PlaymakerStep> state_steps();
std::vector<PlaymakerStep> load_steps();
std::vector<PlaymakerStep> play_steps();
std::vector<PlaymakerStep> life_steps();
std::vector<PlaymakerStep> team_steps();

}  // namespace cls::checks
