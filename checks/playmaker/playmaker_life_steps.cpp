// Steps: disconnect, second matches, memory growth.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "checks/playmaker/playmaker_subject.h"
#include "process/process_tree.h"

namespace cls::checks {
namespace {

using proto::Rpc;

// Resident memory of a process and its descendants, in MB.
double resident_mb(int pid) {
  const auto of_one = [](int one) {
    std::ifstream file(fmt::format("/proc/{}/status", one));
    for (std::string line; std::getline(file, line);) {
      double kilobytes = 0.0;
      if (std::sscanf(line.c_str(), "VmRSS: %lf", &kilobytes) == 1) return kilobytes / 1024.0;
    }
    return 0.0;
  };

  double sum = of_one(pid);
  for (const process::ProcessEntry& child : process::descendants_of(pid)) sum += of_one(child.pid);
  return sum;
}

// Requests `calls` decisions of a whole team; stops at the first error.
proxy::RpcStatus ask_many(PlaymakerSubject& subject, int calls) {
  for (int made = 0; made < calls; made += 11) {
    for (int agent = 1; agent <= 11; ++agent) {
      subject.left().begin(agent, Rpc::kGetPlayerActions, subject.next_state(agent),
                           subject.deadline);
    }

    proxy::RpcStatus worst;
    while (const auto reply = subject.left().next_reply()) {
      if (!reply->status.ok()) worst = reply->status;
    }
    if (!worst.ok()) return worst;
  }
  return {};
}

Finding memory(PlaymakerSubject& subject) {
  constexpr double kMaxGrowthMb = 20.0;
  const int warm_up = subject.calls / 5;
  proxy::RpcStatus status = ask_many(subject, warm_up);

  const auto pid = subject.pid();
  const double before = pid ? resident_mb(*pid) : 0.0;
  if (status.ok()) status = ask_many(subject, subject.calls - warm_up);

  if (!status.ok()) return fail(to_text(status));
  if (!pid) return pass("{} calls replied; memory is known only for run: sides", subject.calls);

  const double after = resident_mb(*pid);
  const std::string evidence = fmt::format("{:.1f} MB after {} calls, {:.1f} MB after {}", before,
                                           warm_up, after, subject.calls);
  if (after - before <= kMaxGrowthMb) return pass(evidence);

  // The heap of a garbage collector grows in steps, and comes to rest; a leak grows on.
  status = ask_many(subject, subject.calls - warm_up);
  if (!status.ok()) return fail(to_text(status));
  const double last = resident_mb(*pid);
  const int calls = subject.calls + subject.calls - warm_up;
  const std::string more = fmt::format("{}, {:.1f} MB after {}", evidence, last, calls);
  return last - after <= kMaxGrowthMb ? pass(more) : fail(more);
}

Finding bye(PlaymakerSubject& subject) {
  for (int agent = 1; agent <= proxy::kCoachNumber; ++agent) {
    const auto status = call(subject, agent, Rpc::kSendByeCommand, subject.identity(agent));
    if (!status.ok()) return fail("agent {}: {}", agent, to_text(status));
  }
  return pass("11 players and the coach");
}

Finding bye_again(PlaymakerSubject& subject) {
  const auto status = call(subject, kAgent, Rpc::kSendByeCommand, subject.identity(kAgent));
  const std::string before = status.ok() ? "accepted" : "refused: " + to_text(status);
  const auto other = subject.connect();
  protos::RegisterRequest request;
  request.set_team_name(team_name(0));
  request.set_uniform_number(kAgent);
  const auto alive = other->call(kAgent, Rpc::kRegister, request, subject.start_timeout);
  return finding(alive.status, before);
}

Finding second_match(PlaymakerSubject& subject) {
  subject.cycle = 0;
  const proxy::RpcStatus status = complete_handshake(subject, 0);
  if (!status.ok()) return fail(to_text(status));
  for (int agent = 1; agent <= 11; ++agent) {
    const Answer answer = ask(subject, agent, subject.next_state(agent));
    if (!answer.status.ok()) return fail("player {}: {}", agent, to_text(answer.status));
  }
  return pass("handshake and decisions of 11 players after the bye");
}

Finding fresh_connection(PlaymakerSubject& subject) {
  subject.teams[0] = subject.connect();
  const proxy::RpcStatus status = complete_handshake(subject, 0);
  if (!status.ok()) return fail(to_text(status));
  return survives(subject, "third match over a new connection");
}

Finding still_there(PlaymakerSubject& subject) { return survives(subject, "all steps done"); }

}  // namespace

std::vector<PlaymakerStep> life_steps() {
  return {
      {"memory", "A match has 66000 calls per team: a leak of 1 KB per call grows to 66 MB.",
       memory},
      {"bye", "Every agent sends bye at the end.", bye},
      {"bye_again", "A disconnected agent may send bye twice.", bye_again},
      {"second_match", "Tournaments require several matches without a restart.", second_match},
      {"new_connection", "Agents of the next match are new processes.", fresh_connection},
      {"still_there", "It must continue to serve after all steps.", still_there},
  };
}

}  // namespace cls::checks
