// Steps: registration of agents and parameters of the match.
#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>

#include "base/index.h"
#include "checks/playmaker/playmaker_subject.h"
#include "checks/playmaker/sample_states.h"

namespace cls::checks {
namespace {

using proto::Rpc;

Finding reach(PlaymakerSubject& subject) {
  const auto start = std::chrono::steady_clock::now();
  const proxy::RpcStatus status = register_agent(subject, 0, 1);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return finding(status, fmt::format("Register replied after {:.2f} s", took.count()));
}

Finding identity(PlaymakerSubject& subject) {
  const proxy::RpcStatus status = register_agent(subject, 0, kAgent);
  if (!status.ok()) return fail(to_text(status));
  const protos::RegisterResponse& received = subject.identity(kAgent);
  const std::string evidence = fmt::format(
      "sent player {} of {}, received player {} of {}, agent type {}", kAgent, team_name(0),
      received.uniform_number(), received.team_name(), static_cast<int>(received.agent_type()));
  const bool same = received.uniform_number() == kAgent && received.team_name() == team_name(0) &&
                    received.agent_type() == protos::PlayerT;
  return same ? pass(evidence) : fail(evidence);
}

Finding language(PlaymakerSubject& subject) {
  const int language = static_cast<int>(subject.identity(kAgent).rpc_server_language_type());
  if (!protos::RpcServerLanguageType_IsValid(language)) {
    return fail("language {} is not in the interface", language);
  }
  return pass(
      protos::RpcServerLanguageType_Name(subject.identity(kAgent).rpc_server_language_type()));
}

Finding whole_team(PlaymakerSubject& subject) {
  std::set<int> ids;
  for (int agent = 1; agent <= 11; ++agent) {
    const proxy::RpcStatus status = register_agent(subject, 0, agent);
    if (!status.ok()) return fail("player {}: {}", agent, to_text(status));
    ids.insert(subject.identity(agent).client_id());
  }
  const std::string evidence = fmt::format("11 players got {} different client ids", ids.size());
  return ids.size() == 11 ? pass(evidence) : fail(evidence);
}

Finding other_agent(PlaymakerSubject& subject, int agent, protos::AgentType type,
                    const char* evidence) {
  const proxy::RpcStatus status = register_agent(subject, 0, agent);
  if (!status.ok()) return fail(to_text(status));
  return subject.identity(agent).agent_type() == type ? pass(evidence)
                                                      : fail("registered as another agent type");
}

Finding coach(PlaymakerSubject& subject) {
  return other_agent(subject, proxy::kCoachNumber, protos::CoachT, "registered as a coach");
}

Finding trainer(PlaymakerSubject& subject) {
  return other_agent(subject, proxy::kTrainerNumber, protos::TrainerT, "registered as a trainer");
}

Finding second_team(PlaymakerSubject& subject) {
  using Key = std::pair<int, std::string>;
  std::set<Key> keys;
  const auto note = [&](const protos::RegisterResponse& received) {
    keys.insert({received.client_id(), received.team_name()});
  };

  for (int agent = 1; agent <= 11; ++agent) note(subject.identity(agent));
  for (int agent = 1; agent <= proxy::kCoachNumber; ++agent) {
    const proxy::RpcStatus status = register_agent(subject, 1, agent);
    if (!status.ok()) return fail("agent {}: {}", agent, to_text(status));
  }
  for (int agent = 1; agent <= 11; ++agent) {
    note(subject.identities[1][base::index(agent)]);
  }

  const std::string evidence =
      fmt::format("22 players have {} different pairs of client id and team", keys.size());
  return keys.size() == 22 ? pass(evidence) : fail(evidence);
}

Finding again(PlaymakerSubject& subject) {
  const int before = subject.identity(kAgent).client_id();
  const proxy::RpcStatus status = register_agent(subject, 0, kAgent);
  return finding(status, fmt::format("client id {} the first time, {} the second", before,
                                     subject.identity(kAgent).client_id()));
}

// Registers a player; version 0: it is not set.
Finding register_as(PlaymakerSubject& subject, const std::string& team, int unum, int version,
                    const std::string& evidence) {
  protos::RegisterRequest request;
  request.set_team_name(team);
  request.set_uniform_number(unum);
  request.set_rpc_version(version);
  const proxy::Reply reply =
      subject.left().call(request.uniform_number(), Rpc::kRegister, request, subject.deadline);
  if (!reply.status.ok()) return fail(evidence + ": " + to_text(reply.status));
  const protos::RegisterResponse& answer = *reply.as<protos::RegisterResponse>();
  if (answer.team_name() != request.team_name()) {
    return fail("{}: reply for team '{}'", evidence, answer.team_name());
  }
  return pass(evidence);
}

Finding without_version(PlaymakerSubject& subject) {
  return register_as(subject, team_name(0), kAgent, 0, "rpc_version not set");
}

Finding later_version(PlaymakerSubject& subject) {
  return register_as(subject, team_name(0), kAgent, 99, "rpc_version 99");
}

Finding longest_name(PlaymakerSubject& subject) {
  return register_as(subject, "A_Team-15_chars", 3, 1, "team A_Team-15_chars");
}

Finding server_params(PlaymakerSubject& subject) {
  protos::ServerParam message;
  *message.mutable_register_response() = subject.identity(kAgent);
  message.set_half_time(300);
  return finding(call(subject, kAgent, Rpc::kSendServerParams, message));
}

Finding player_params(PlaymakerSubject& subject) {
  protos::PlayerParam message;
  *message.mutable_register_response() = subject.identity(kAgent);
  message.set_player_types(18);
  return finding(call(subject, kAgent, Rpc::kSendPlayerParams, message));
}

Finding all_parameters(PlaymakerSubject& subject) {
  return finding(send_parameters(subject, 0, kAgent), "server, players, 18 types, in this order");
}

Finding init_message(PlaymakerSubject& subject) {
  protos::InitMessage message;
  *message.mutable_register_response() = subject.identity(kAgent);
  message.set_debug_mode(true);
  return finding(call(subject, kAgent, Rpc::kSendInitMessage, message));
}

Finding init_first(PlaymakerSubject& subject) {
  constexpr int kOther = 8;
  const proxy::RpcStatus registered = register_agent(subject, 0, kOther);
  if (!registered.ok()) return fail(to_text(registered));
  protos::InitMessage message;
  *message.mutable_register_response() = subject.identity(kOther);
  const auto status = call(subject, kOther, Rpc::kSendInitMessage, message);
  if (!status.ok()) return fail(to_text(status));
  return finding(send_parameters(subject, 0, kOther), "init before parameters");
}

Finding decision_before_parameters(PlaymakerSubject& subject) {
  constexpr int kOther = 9;
  const proxy::RpcStatus registered = register_agent(subject, 0, kOther);
  if (!registered.ok()) return fail(to_text(registered));
  const Answer answer = ask(subject, kOther, subject.next_state(kOther));
  const std::string before = answer.status.ok() ? "accepted" : "refused: " + to_text(answer.status);
  return survives(subject, before);
}

Finding both_teams(PlaymakerSubject& subject) {
  for (const int team : {0, 1}) {
    const proxy::RpcStatus status = complete_handshake(subject, team);
    if (!status.ok()) return fail(to_text(status));
  }
  return pass("complete handshake of 22 players and two coaches");
}

}  // namespace

std::vector<PlaymakerStep> handshake_steps() {
  return {
      {"reach", "Nothing works before the first reply to Register.", reach},
      {"register_identity",
       "The proxy sends this identity with every call: a wrong one mixes up the players.",
       identity},
      {"register_language",
       "Tools show the language; a value outside the enum is an invalid message.", language},
      {"register_team", "Client ids identify the players that share one Playmaker.", whole_team},
      {"register_coach", "A team without its coach cannot substitute.", coach},
      {"register_trainer", "Training sessions and scenarios need the trainer.", trainer},
      {"register_second_team",
       "Both sides of a match may use the same Playmaker, which must keep them separate.",
       second_team},
      {"register_again", "An agent that lost its connection registers again during the match.",
       again},
      {"register_without_version", "Older proxies do not send their version.", without_version},
      {"register_later_version", "A newer proxy must not be rejected.", later_version},
      {"register_longest_name", "Team names have up to 15 letters, digits, - and _.", longest_name},
      {"server_params", "An error here aborts the handshake of an agent.", server_params},
      {"player_params", "An error here aborts the handshake of an agent.", player_params},
      {"all_parameters", "Every agent sends all parameters and all 18 types.", all_parameters},
      {"init_message", "Completes the handshake; upstream's proxy calls it last.", init_message},
      {"init_before_parameters",
       "The order differs between proxies; the documentation shows this one.", init_first},
      {"decision_before_parameters",
       "An agent that connects late may request decisions first: an error is allowed, a crash is "
       "not.",
       decision_before_parameters},
      {"handshake_of_both_teams", "A match starts with 24 complete handshakes.", both_teams},
  };
}

}  // namespace cls::checks
