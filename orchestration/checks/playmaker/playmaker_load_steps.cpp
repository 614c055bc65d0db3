// Steps: many at once, how fast, late answers and broken connections.
#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "orchestration/checks/playmaker/playmaker_subject.h"

namespace cls::orchestration::checks {
namespace {

using std::chrono::microseconds;

constexpr int kAgent = 7;
constexpr int kRounds = 100;

/// Latencies of a load, and what went wrong first.
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
  const auto t = static_cast<std::size_t>(team);
  protos::State state = subject.next_state(agent == proxy::kCoachNumber ? 1 : agent);
  *state.mutable_register_response() = subject.identities[t][static_cast<std::size_t>(agent)];
  if (agent == proxy::kCoachNumber) {
    subject.teams[t]->begin_coach_actions(agent, state, subject.deadline);
  } else {
    subject.teams[t]->begin_player_actions(agent, state, subject.deadline);
  }
}

void collect(PlaymakerSubject& subject, int team, Load& load) {
  while (const auto reply = subject.teams[static_cast<std::size_t>(team)]->next_reply()) {
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
  std::sort(load.latencies.begin(), load.latencies.end());
  return load;
}

Finding of_load(const Load& load) {
  if (load.failed > 0) {
    return fail(fmt::format("{} of {} calls failed: {}", load.failed,
                            load.failed + static_cast<int>(load.latencies.size()),
                            load.first_failure));
  }
  return pass(fmt::format("{} calls: p50 {:.1f}, p95 {:.1f}, p99 {:.1f}, max {:.1f} ms",
                          load.latencies.size(), load.percentile_ms(0.5), load.percentile_ms(0.95),
                          load.percentile_ms(0.99), load.percentile_ms(1.0)));
}

Finding latency_alone(PlaymakerSubject& subject) {
  Load load;
  for (int i = 0; i < kRounds; ++i) {
    begin(subject, 0, kAgent);
    collect(subject, 0, load);
  }
  std::sort(load.latencies.begin(), load.latencies.end());
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
                               ? "answered within 1 ms"
                               : "1 ms: " + std::string(name(answer.status.outcome)));
}

Finding many_deadlines(PlaymakerSubject& subject) {
  for (int round = 0; round < 20; ++round) {
    for (int agent = 1; agent <= 11; ++agent) {
      subject.left().begin_player_actions(agent, subject.next_state(agent), Milliseconds(1));
    }
    while (subject.left().next_reply()) {
    }
  }
  return survives(subject, "220 calls with a deadline of 1 ms");
}

Finding another_connection(PlaymakerSubject& subject) {
  const auto other = subject.connect();
  const Answer answer = ask(*other, kAgent, subject.next_state(kAgent), subject.start_timeout);
  return finding(answer.status, "the same agent over a second connection");
}

Finding broken_connection(PlaymakerSubject& subject) {
  {
    const auto other = subject.connect();
    ask(*other, kAgent, subject.next_state(kAgent), subject.start_timeout);
    for (int agent = 1; agent <= 11; ++agent) {
      other->begin_player_actions(agent, subject.next_state(agent), subject.deadline);
    }
    other->cancel();
    while (other->next_reply()) {
    }
  }
  return survives(subject, "11 calls cut off in flight");
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
      return fail(fmt::format("connection {}: {}", agent, to_text(answer.status)));
    }
  }
  return pass(fmt::format("{} connections at once", kConnections));
}

// True if the bytes could be sent.
bool send_bytes(const PlaymakerSubject& subject, std::string_view bytes) {
  std::string host = subject.host;
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(subject.port);
  if (::getaddrinfo(host.c_str(), port.c_str(), &hints, &found) != 0) return false;
  bool sent = false;
  for (const addrinfo* at = found; at != nullptr && !sent; at = at->ai_next) {
    const int fd = ::socket(at->ai_family, at->ai_socktype | SOCK_CLOEXEC, at->ai_protocol);
    if (fd < 0) continue;
    sent =
        ::connect(fd, at->ai_addr, at->ai_addrlen) == 0 &&
        ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
    ::close(fd);
  }
  ::freeaddrinfo(found);
  return sent;
}

Finding garbage(PlaymakerSubject& subject) {
  if (subject.host.empty()) return skip("no TCP address");
  std::string bytes = "GET / HTTP/1.1\r\nHost: soccer\r\n\r\n";
  for (int i = 0; i < 4096; ++i) bytes.push_back(static_cast<char>(i * 31));
  for (int i = 0; i < 10; ++i) {
    if (!send_bytes(subject, bytes)) return fail("the port takes no further connection");
  }
  return survives(subject, "10 connections with bytes that are no gRPC");
}

Finding idle(PlaymakerSubject& subject) {
  std::this_thread::sleep_for(std::chrono::seconds(3));
  return survives(subject, "3 s without a call");
}

}  // namespace

std::vector<PlaymakerStep> load_steps() {
  return {
      {"latency_alone", "How long a decision takes when nobody else asks.", latency_alone},
      {"eleven_at_once", "All players of a team ask at the beginning of a cycle.", eleven_at_once},
      {"both_teams_at_once", "22 players and two coaches ask one Playmaker at once.",
       both_teams_at_once},
      {"latency_under_load",
       "In real time a cycle lasts 100 ms; decisions that take longer are lost.",
       latency_under_load},
      {"deadline", "A call that is given up must not block the next one.", deadline},
      {"many_deadlines", "Answers that nobody waits for must not pile up.", many_deadlines},
      {"another_connection", "Upstream's proxy uses a connection for each agent.",
       another_connection},
      {"twelve_connections", "Upstream's proxy uses a connection for each agent.",
       many_connections},
      {"broken_connection", "Agents are killed in mid-match; the rest of the team plays on.",
       broken_connection},
      {"garbage", "Ports are scanned; what is no gRPC must not end the match.", garbage},
      {"idle", "Before kick-off and at half time nobody asks for a while.", idle},
  };
}

}  // namespace cls::orchestration::checks
