// Steps: parallel calls, latency, exceeded deadlines, broken connections.
#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <thread>

#include "base/index.h"
#include "base/system/tcp_connect.h"
#include "checks/playmaker/playmaker_subject.h"

namespace cls::checks {
namespace {

using proto::Rpc;
using std::chrono::microseconds;

constexpr int kRounds = 100;

/// Latencies under load, and the first error.
struct Load {
  std::vector<microseconds> latencies;
  int failed = 0;
  std::string first_failure;

  double percentile_ms(double share) const {
    if (latencies.empty()) return 0.0;
    const auto index = static_cast<std::size_t>(share * static_cast<double>(latencies.size() - 1));
    return static_cast<double>(latencies[index].count()) / 1000.0;
  }
};

void begin(PlaymakerSubject& subject, int team, int agent) {
  const auto t = base::index(team);
  protos::State state = subject.next_state(agent == proxy::kCoachNumber ? 1 : agent);
  *state.mutable_register_response() = subject.identities[t][base::index(agent)];
  subject.teams[t]->begin(agent, proto::decision_of(agent), state, subject.deadline);
}

void collect(PlaymakerSubject& subject, int team, Load& load) {
  while (const auto reply = subject.teams[base::index(team)]->next_reply()) {
    if (reply->status.ok()) {
      load.latencies.push_back(reply->latency);
    } else {
      ++load.failed;
      if (load.first_failure.empty()) load.first_failure = to_text(reply->status);
    }
  }
}

Load ask_all(PlaymakerSubject& subject, int teams, int last_agent, int rounds) {
  Load load;
  for (int round = 0; round < rounds && load.failed == 0; ++round) {
    for (int team = 0; team < teams; ++team) {
      for (int agent = 1; agent <= last_agent; ++agent) begin(subject, team, agent);
    }
    for (int team = 0; team < teams; ++team) collect(subject, team, load);
  }
  std::ranges::sort(load.latencies);
  return load;
}

Finding of_load(const Load& load) {
  if (load.failed > 0) {
    return fail("{} of {} calls failed: {}", load.failed,
                load.failed + static_cast<int>(load.latencies.size()), load.first_failure);
  }
  return pass("{} calls: p50 {:.1f}, p95 {:.1f}, p99 {:.1f}, max {:.1f} ms", load.latencies.size(),
              load.percentile_ms(0.5), load.percentile_ms(0.95), load.percentile_ms(0.99),
              load.percentile_ms(1.0));
}

Finding latency_alone(PlaymakerSubject& subject) {
  Load load;
  for (int i = 0; i < kRounds; ++i) {
    begin(subject, 0, kAgent);
    collect(subject, 0, load);
  }
  std::ranges::sort(load.latencies);
  return of_load(load);
}

Finding eleven_at_once(PlaymakerSubject& subject) { return of_load(ask_all(subject, 1, 11, 1)); }

Finding both_teams_at_once(PlaymakerSubject& subject) {
  return of_load(ask_all(subject, 2, subject.has_coach ? proxy::kCoachNumber : 11, 1));
}

Finding latency_under_load(PlaymakerSubject& subject) {
  const Load load = ask_all(subject, 2, 11, kRounds);
  const Finding found = of_load(load);
  const bool in_time =
      load.percentile_ms(0.99) < static_cast<double>(subject.latency_limit.count());
  return found.result == StepResult::kPass && !in_time ? fail(found.evidence) : found;
}

Finding deadline(PlaymakerSubject& subject) {
  const auto answer = ask(subject.left(), kAgent, subject.next_state(kAgent), Milliseconds(1));
  return survives(subject, answer.status.ok()
                               ? "replied within 1 ms"
                               : "1 ms: " + std::string(name(answer.status.outcome)));
}

Finding many_deadlines(PlaymakerSubject& subject) {
  for (int round = 0; round < 20; ++round) {
    for (int agent = 1; agent <= 11; ++agent) {
      subject.left().begin(agent, Rpc::kGetPlayerActions, subject.next_state(agent),
                           Milliseconds(1));
    }
    while (subject.left().next_reply()) {
    }
  }
  const std::string before = "220 calls with a deadline of 1 ms";
  const Answer next = ask(subject, kAgent, subject.next_state(kAgent));
  if (next.status.outcome != proxy::RpcOutcome::kUnavailable) {
    return finding(next.status, before + "; replies to the next ordinary request");
  }
  // Some servers close a connection on which many calls were cancelled; agents then connect again.
  return survives(subject, before + "; then " + to_text(next.status));
}

Finding another_connection(PlaymakerSubject& subject) {
  const auto other = subject.connect();
  const Answer answer = ask(*other, kAgent, subject.next_state(kAgent), subject.start_timeout);
  return finding(answer.status, "same agent over a second connection");
}

Finding broken_connection(PlaymakerSubject& subject) {
  {
    const auto other = subject.connect();
    ask(*other, kAgent, subject.next_state(kAgent), subject.start_timeout);
    for (int agent = 1; agent <= 11; ++agent) {
      other->begin(agent, Rpc::kGetPlayerActions, subject.next_state(agent), subject.deadline);
    }
    other->cancel();
    while (other->next_reply()) {
    }
  }
  return survives(subject, "11 calls aborted in flight");
}

Finding many_connections(PlaymakerSubject& subject) {
  constexpr int kConnections = 12;
  std::vector<std::unique_ptr<proxy::Playmaker>> agents;
  for (int agent = 1; agent <= kConnections; ++agent) {
    agents.push_back(subject.connect());
    const int asked = std::min(agent, 11);
    const Answer answer =
        ask(*agents.back(), asked, subject.next_state(asked), subject.start_timeout);
    if (!answer.status.ok()) {
      return fail("connection {}: {}", agent, to_text(answer.status));
    }
  }

  return pass("{} parallel connections", kConnections);
}

// Returns true if the bytes were sent.
bool send_bytes(const PlaymakerSubject& subject, std::string_view bytes) {
  constexpr std::chrono::seconds kConnectTimeout(5);
  const auto deadline = std::chrono::steady_clock::now() + kConnectTimeout;
  const base::UniqueFd socket = base::connect_tcp(subject.host, subject.port, deadline);
  return socket && ::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
                       static_cast<ssize_t>(bytes.size());
}

Finding garbage(PlaymakerSubject& subject) {
  if (subject.host.empty()) return skip("no TCP address");
  std::string bytes = "GET / HTTP/1.1\r\nHost: soccer\r\n\r\n";
  for (int i = 0; i < 4096; ++i) bytes.push_back(static_cast<char>(i * 31));
  for (int i = 0; i < 10; ++i) {
    if (!send_bytes(subject, bytes)) return fail("the port accepts no further connection");
  }
  return survives(subject, "10 connections with bytes that are not gRPC");
}

Finding idle(PlaymakerSubject& subject) {
  std::this_thread::sleep_for(std::chrono::seconds(3));
  return survives(subject, "3 s without a call");
}

}  // namespace

std::vector<PlaymakerStep> load_steps() {
  return {
      {"latency_alone", "Latency of a decision without load.", latency_alone},
      {"eleven_at_once", "All players of a team send requests at the start of a cycle.",
       eleven_at_once},
      {"both_teams_at_once", "22 players and two coaches use one Playmaker concurrently.",
       both_teams_at_once},
      {"latency_under_load", "In real time a cycle lasts 100 ms; later decisions are lost.",
       latency_under_load},
      {"deadline", "A cancelled call must not block the next one.", deadline},
      {"many_deadlines", "Replies after the deadline must not accumulate.", many_deadlines},
      {"another_connection", "Upstream's proxy uses a connection for each agent.",
       another_connection},
      {"twelve_connections", "Upstream's proxy uses a connection for each agent.",
       many_connections},
      {"broken_connection",
       "An agent may be killed during the match; the rest of the team continues.",
       broken_connection},
      {"garbage", "Ports are scanned; bytes that are not gRPC must not end the match.", garbage},
      {"idle", "Before kick-off and at half time there are no requests for a while.", idle},
  };
}

}  // namespace cls::checks
