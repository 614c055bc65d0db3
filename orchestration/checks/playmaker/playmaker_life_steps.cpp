// Steps: ends, second matches, and what thousands of calls cost.
#include <fmt/format.h>

#include <fstream>

#include "orchestration/checks/playmaker/playmaker_subject.h"
#include "orchestration/process/process_tree.h"

namespace cls::orchestration::checks {
namespace {

constexpr int kAgent = 7;

// Resident memory of a process and its descendants, in MB.
double resident_mb(int pid) {
  const auto of_one = [](int one) {
    std::ifstream file(fmt::format("/proc/{}/status", one));
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
    }
    return 0.0;
  };
  double sum = of_one(pid);
  for (const process::ProcessEntry& child : process::descendants_of(pid)) sum += of_one(child.pid);
  return sum;
}

// Decisions of a whole team until so many were made; the first error ends it.
proxy::RpcStatus ask_many(PlaymakerSubject& subject, int calls) {
  for (int made = 0; made < calls; made += 11) {
    for (int agent = 1; agent <= 11; ++agent) {
      subject.left().begin_player_actions(agent, subject.next_state(agent), subject.deadline);
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
  constexpr double kMostGrowthMb = 20.0;
  const int warm_up = subject.calls / 5;
  proxy::RpcStatus status = ask_many(subject, warm_up);
  const auto pid = subject.pid();
  const double before = pid ? resident_mb(*pid) : 0.0;
  if (status.ok()) status = ask_many(subject, subject.calls - warm_up);
  if (!status.ok()) return fail(to_text(status));
  if (!pid)
    return pass(
        fmt::format("{} calls answered; memory is known only of run: sides", subject.calls));
  const double after = resident_mb(*pid);
  const std::string evidence = fmt::format("{:.1f} MB after {} calls, {:.1f} MB after {}", before,
                                           warm_up, after, subject.calls);
  return after - before <= kMostGrowthMb ? pass(evidence) : fail(evidence);
}

Finding bye(PlaymakerSubject& subject) {
  for (int agent = 1; agent <= proxy::kCoachNumber; ++agent) {
    const auto status = subject.left().send_bye(agent, subject.identity(agent), subject.deadline);
    if (!status.ok()) return fail(fmt::format("agent {}: {}", agent, to_text(status)));
  }
  return pass("11 players and the coach");
}

Finding bye_again(PlaymakerSubject& subject) {
  const auto status = subject.left().send_bye(kAgent, subject.identity(kAgent), subject.deadline);
  const std::string before = status.ok() ? "answered" : "refused: " + to_text(status);
  const auto other = subject.connect();
  protos::RegisterResponse answer;
  protos::RegisterRequest request;
  request.set_team_name(team_name(0));
  request.set_uniform_number(kAgent);
  const auto alive = other->register_agent(kAgent, request, subject.start_timeout, answer);
  return finding(alive, before);
}

Finding second_match(PlaymakerSubject& subject) {
  subject.cycle = 0;
  const proxy::RpcStatus status = shake_hands(subject, 0);
  if (!status.ok()) return fail(to_text(status));
  for (int agent = 1; agent <= 11; ++agent) {
    const Answer answer = ask(subject, agent, subject.next_state(agent));
    if (!answer.status.ok())
      return fail(fmt::format("player {}: {}", agent, to_text(answer.status)));
  }
  return pass("handshake and decisions of 11 players after the bye");
}

Finding fresh_connection(PlaymakerSubject& subject) {
  subject.teams[0] = subject.connect();
  const proxy::RpcStatus status = shake_hands(subject, 0);
  if (!status.ok()) return fail(to_text(status));
  return survives(subject, "a third match over a new connection");
}

Finding still_there(PlaymakerSubject& subject) { return survives(subject, "after all of this"); }

}  // namespace

std::vector<PlaymakerStep> life_steps() {
  return {
      {"memory", "A match is 66000 calls a team: what leaks a kilobyte a call grows by 66 MB.",
       memory},
      {"bye", "Every agent says good-bye at the end.", bye},
      {"bye_again", "An agent that is gone already may say so twice.", bye_again},
      {"second_match", "A Playmaker that must be restarted for each match spoils tournaments.",
       second_match},
      {"new_connection", "Agents of the next match are new processes.", fresh_connection},
      {"still_there", "What has taken all steps must serve on.", still_there},
  };
}

}  // namespace cls::orchestration::checks
