// A Playmaker under test, with its agents' identities and what the steps of a check ask it.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "orchestration/checks/check_report.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::orchestration::checks {

using Milliseconds = std::chrono::milliseconds;

struct PlaymakerSubject {
  // How to reach it.
  std::function<std::unique_ptr<proxy::Playmaker>()> connect;  ///< a connection of its own
  std::string host;                                            ///< empty: no TCP address
  int port = 0;
  std::function<std::optional<int>()> pid;  ///< of a Playmaker that we started, while it lives
  Milliseconds start_timeout{20'000};
  Milliseconds deadline{3'000};     ///< of a decision: what upstream's proxy grants
  int calls = 10'000;               ///< of the memory step
  Milliseconds latency_limit{100};  ///< of 99 in 100 decisions under load: a cycle in real time

  // What steps share. Two teams: a match has two.
  std::array<std::unique_ptr<proxy::Playmaker>, 2> teams;
  std::array<std::array<protos::RegisterResponse, proxy::kAgentNumbers>, 2> identities;
  int cycle = 1;
  bool has_coach = true;  ///< false once it said that it knows no coach

  proxy::Playmaker& left() { return *teams[0]; }
  const protos::RegisterResponse& identity(int agent) const {
    return identities[0][static_cast<std::size_t>(agent)];
  }

  /// An ordinary State of the agent, a cycle later each time.
  protos::State next_state(int agent);
};

std::string team_name(int team);

/// Registers one agent and keeps its identity.
proxy::RpcStatus register_agent(PlaymakerSubject& subject, int team, int agent);

/// The whole handshake of every agent of a team: Register, parameters, types, init.
proxy::RpcStatus shake_hands(PlaymakerSubject& subject, int team);
proxy::RpcStatus send_parameters(PlaymakerSubject& subject, int team, int agent);

/// One decision, waited for.
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

/// Pass if the call succeeded.
Finding finding(const proxy::RpcStatus& status, std::string evidence = {});

/// Pass if an ordinary question is answered: after something that a Playmaker may refuse but must
/// survive. `before` is what that was.
Finding survives(PlaymakerSubject& subject, const std::string& before);

/// A step: its name, why it matters, what it does.
struct PlaymakerStep {
  const char* name;
  const char* why;
  Finding (*run)(PlaymakerSubject&);
};

// The steps in the order in which they are taken.
std::vector<PlaymakerStep> handshake_steps();
std::vector<PlaymakerStep> decision_steps();
std::vector<PlaymakerStep> state_steps();
std::vector<PlaymakerStep> load_steps();
std::vector<PlaymakerStep> life_steps();

}  // namespace cls::orchestration::checks
