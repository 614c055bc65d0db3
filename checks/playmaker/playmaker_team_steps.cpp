// Steps: the calls of a whole team, as a match makes them. Skipped where they are not implemented.
#include <fmt/format.h>
#include <grpc/impl/codegen/status.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/index.h"
#include "checks/playmaker/playmaker_subject.h"
#include "checks/playmaker/sample_states.h"
#include "proto/team_playmaker.pb.h"
#include "proxy/playmaker/batch_playmaker.h"

namespace cls::checks {
namespace {

namespace wire = cls::playmaker::v1;
using proto::Rpc;

constexpr int kPlayers = 11;

Finding not_implemented() { return skip("not implemented: each agent is asked alone"); }

// Registers players and coach in one call over a connection of its own.
Finding handshake(PlaymakerSubject& subject) {
  subject.together = proxy::make_batch_playmaker(subject.connect(), proxy::BatchMode::kRequired);
  const proxy::TeamRegistration team = registration_of_team(0);
  subject.together->announce_team(team);

  for (const auto& [agent, request] : team.agents) {
    const proxy::Reply reply =
        subject.together->call(agent, Rpc::kRegister, request, subject.start_timeout);
    const auto* identity = reply.as<protos::RegisterResponse>();
    if (reply.status.code == GRPC_STATUS_UNIMPLEMENTED) {
      if (agent != proxy::kCoachNumber) subject.together.reset();
      return agent == proxy::kCoachNumber ? pass("11 players, no coach") : not_implemented();
    }
    if (identity == nullptr) {
      subject.together.reset();
      return fail("agent {}: {}", agent, to_text(reply.status));
    }
    subject.identities[0][base::index(agent)] = *identity;
  }
  return pass("11 players and the coach");
}

// Asks for the players' decisions in one call; the first thing that is wrong, or nothing.
std::string ask_together(PlaymakerSubject& subject, int first, int last) {
  for (int agent = first; agent <= last; ++agent) {
    subject.together->begin(agent, Rpc::kGetPlayerActions, subject.next_state(agent),
                            subject.deadline);
  }
  subject.together->send();

  std::string wrong;
  while (const auto reply = subject.together->next_reply()) {
    if (reply->status.ok() || !wrong.empty()) continue;
    wrong = fmt::format("player {}: {}", reply->agent, to_text(reply->status));
  }

  const std::string warning = subject.together->take_warning();
  return wrong.empty() ? warning : wrong;
}

Finding decisions(PlaymakerSubject& subject, int first, int last) {
  if (subject.together == nullptr) return not_implemented();
  const auto began = std::chrono::steady_clock::now();
  const std::string wrong = ask_together(subject, first, last);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
  if (!wrong.empty()) return fail(wrong);
  return pass("{} {}, {:.1f} ms", last - first + 1, first == last ? "reply" : "replies",
              took.count());
}

Finding all_players(PlaymakerSubject& subject) { return decisions(subject, 1, kPlayers); }
Finding one_player(PlaymakerSubject& subject) { return decisions(subject, 7, 7); }

Finding unreadable_state(PlaymakerSubject& subject) {
  if (subject.together == nullptr) return not_implemented();

  wire::GetTeamActionsRequest request;
  for (const int agent : {6, 7}) {
    wire::AgentMessage& one = *request.add_agents();
    one.set_agent(agent);
    one.set_message(agent == 6 ? std::string(40, '\xff')
                               : subject.next_state(agent).SerializeAsString());
  }

  const proxy::Reply reply =
      subject.left().call(proxy::kTeamNumber, Rpc::kGetTeamActions, request, subject.deadline);
  std::string before = "refused: " + to_text(reply.status);
  if (const auto* answered = reply.as<wire::GetTeamActionsResponse>()) {
    const auto& agents = answered->agents();
    const auto decided =
        std::ranges::count_if(agents, [](const auto& agent) { return agent.code() == 0; });
    before = fmt::format("actions for {} of 2 players", decided);
  }

  const std::string wrong = ask_together(subject, 1, kPlayers);
  if (!wrong.empty()) return fail(before + "; then an ordinary call: " + wrong);
  return pass(before + "; replies to the next ordinary call");
}

Finding choices(PlaymakerSubject& subject) {
  constexpr int kCandidates = 20;
  if (subject.together == nullptr) return not_implemented();

  for (const int agent : {7, 9}) {
    subject.together->begin(agent, Rpc::kGetBestPlannerAction,
                            planner_request(subject.next_state(agent), kCandidates),
                            subject.deadline);
  }
  subject.together->send();

  std::string chosen;
  std::optional<Finding> wrong;
  while (const auto reply = subject.together->next_reply()) {
    if (reply->status.outcome == proxy::RpcOutcome::kUnimplemented) {
      wrong = skip("not implemented: the agents choose");
    } else if (!reply->status.ok()) {
      wrong = fail("player {}: {}", reply->agent, to_text(reply->status));
    } else {
      chosen += fmt::format("{}{}", chosen.empty() ? "" : ", ",
                            reply->as<protos::BestPlannerActionResponse>()->index());
    }
  }

  return wrong ? *wrong : pass("chose " + chosen);
}

Finding goodbye(PlaymakerSubject& subject) {
  if (subject.together == nullptr) return not_implemented();
  const auto bye =
      subject.together->call(1, Rpc::kSendByeCommand, subject.identity(1), subject.deadline);
  if (!bye.status.ok()) return fail(to_text(bye.status));
  return handshake(subject);
}

}  // namespace

std::vector<PlaymakerStep> team_steps() {
  return {
      {"together_handshake", "One call registers the team, with its parameters.", handshake},
      {"together_actions", "One call per cycle has a State and a reply for each player.",
       all_players},
      {"together_one_player", "A call holds the players that are due, perhaps one alone.",
       one_player},
      {"together_unreadable_state", "A State that does not parse may be refused, not crash.",
       unreadable_state},
      {"together_planner", "Choices of a cycle come in one call too.", choices},
      {"together_bye", "Tournaments require several matches without a restart.", goodbye},
  };
}

}  // namespace cls::checks
