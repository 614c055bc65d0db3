// Asking a soccer server without taking part.
#include "orchestration/checks/doctor/server_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "orchestration/checks/server/started_server.h"
#include "orchestration/process/output_log.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/play_mode.h"
#include "soccer/udp_channel.h"

namespace cls::orchestration::checks {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kLook{20};
constexpr milliseconds kAskAgain{200};
// A server that answers at all tells a monitor its parameters at once, its pitch every cycle.
constexpr milliseconds kMonitorLimit{2000};

using GoOn = std::function<bool()>;

/// What a monitor is told.
struct MonitorNews {
  std::optional<soccer::ServerParams> params;
  std::string moment;  ///< "before_kick_off, cycle 0, nobody there"
};

/// What came of the first word.
struct Contact {
  std::string answer;   ///< empty: none came
  bool closed = false;  ///< the machine says that nobody listens at this port
};

// No soccer server knows the word, so each answers it with an error and does nothing. One that is
// about to start may open its port later.
Contact greet(soccer::UdpClients& clients, bool may_open_later, const GoOn& go_on) {
  Contact contact;
  std::unique_ptr<soccer::Channel> client;
  auto ask_at = steady_clock::now();
  while (go_on()) {
    if (steady_clock::now() >= ask_at) {
      if (client == nullptr) client = clients.connect();
      contact.closed = client != nullptr && !client->send("(hello)");
      if (contact.closed && !may_open_later) break;
      if (contact.closed) client.reset();
      ask_at = steady_clock::now() + kAskAgain;
    }
    clients.wait_until(std::min(ask_at, steady_clock::now() + kLook));
    if (client != nullptr && client->receive(contact.answer)) break;
  }
  return contact;
}

// "(show T (pm PM) (tm LEFT RIGHT ...": where the match is.
std::optional<std::string> moment_in(const std::string& show) {
  int time = 0;
  int mode = 0;
  std::array<char, 64> left{};
  std::array<char, 64> right{};
  if (std::sscanf(show.c_str(), "(show %d (pm %d) (tm %63s %63s", &time, &mode, left.data(),
                  right.data()) != 4) {
    return std::nullopt;
  }
  const auto known = mode > 0 && mode < soccer::kPlayModeCount;
  const std::string_view name =
      known ? soccer::name(static_cast<soccer::PlayMode>(mode)) : "unknown play mode";
  const auto team = [](const char* text) {
    return std::string_view(text) == "null" ? std::string("nobody") : process::printable(text);
  };
  return fmt::format("{}, cycle {}, {} against {}", name, time, team(left.data()),
                     team(right.data()));
}

MonitorNews watch(soccer::UdpClients& clients, const GoOn& go_on) {
  MonitorNews news;
  const std::unique_ptr<soccer::Channel> monitor = clients.connect();
  if (monitor == nullptr) return news;
  monitor->send("(dispinit version 4)");
  const auto end = steady_clock::now() + kMonitorLimit;
  std::string message;
  while (news.moment.empty() && go_on() && steady_clock::now() < end) {
    clients.wait_until(steady_clock::now() + kLook);
    while (monitor->receive(message)) {
      soccer::ServerParams params;
      if (message.starts_with("(server_param ") && soccer::parse(message, params)) {
        news.params = params;
      }
      if (const auto moment = moment_in(message)) news.moment = *moment;
    }
  }
  monitor->send("(dispbye)");
  return news;
}

std::string to_text(const MonitorNews& news) {
  if (!news.params) return "no answer to a monitor";
  const std::string mode = news.params->synch_mode ? "synchronous mode"
                                                   : fmt::format("real time, {} ms a cycle",
                                                                 news.params->simulator_step);
  const std::string moment = news.moment.empty() ? "" : "; " + news.moment;
  return fmt::format("{}, halves of {} s{}", mode, news.params->half_time, moment);
}

double seconds(milliseconds limit) { return static_cast<double>(limit.count()) / 1000.0; }

Symptom unreachable(Symptom symptom, std::string found, std::string remedy) {
  symptom.health = Health::kUnreachable;
  symptom.found = std::move(found);
  symptom.remedy = std::move(remedy);
  return symptom;
}

// What a server that answered says of itself.
void examine(Symptom& symptom, soccer::UdpClients& clients, const std::string& answer,
             const GoOn& alive) {
  if (answer.starts_with("(")) {
    symptom.found = to_text(watch(clients, alive));
    return;
  }
  symptom.health = Health::kWrong;
  symptom.found = fmt::format("answers '{}', which no soccer server says",
                              process::printable(answer.substr(0, 60)));
  symptom.remedy = "look what else has this port";
}

Symptom probe_address(Symptom symptom, const match::ServerChoice& server, milliseconds limit,
                      const std::atomic<int>& stop) {
  constexpr const char* kStartIt = "start it, or let cls do it: --server rcssserver, embedded";
  auto clients = soccer::UdpClients::create(server.host, server.port);
  if (!clients) return unreachable(std::move(symptom), clients.error().message, kStartIt);
  const auto end = steady_clock::now() + limit;
  const auto alive = [&] { return stop.load() == 0; };
  const auto go_on = [&] { return alive() && steady_clock::now() < end; };
  const Contact contact = greet(**clients, false, go_on);
  if (contact.answer.empty()) {
    const std::string why = contact.closed ? std::string("nobody listens at this UDP port")
                                           : fmt::format("no answer within {} s", seconds(limit));
    return unreachable(std::move(symptom), fmt::format("{}: {}", server.text, why), kStartIt);
  }
  examine(symptom, **clients, contact.answer, alive);
  symptom.found = fmt::format("{}: {}", server.text, symptom.found);
  return symptom;
}

// Why a server that was started did not answer.
std::string why_silent(const StartedServer& started, milliseconds limit) {
  const process::Child::Status status = started.child().status();
  const std::vector<std::string> last = started.child().last_lines(1);
  const std::string words = last.empty() ? "" : fmt::format(" ({})", last.front());
  if (process::has_ended(status) && status.exit) {
    return fmt::format("ended at its start: {}{}", to_text(*status.exit), words);
  }
  const std::vector<int> open = process::ports_of(process::Protocol::kUdp, status.pid);
  const int port = started.ports().player;
  if (std::find(open.begin(), open.end(), port) != open.end()) {
    return fmt::format("no answer at its port within {} s{}", seconds(limit), words);
  }
  const std::string but = open.empty() ? "" : fmt::format(", but {}", fmt::join(open, ", "));
  return fmt::format("did not open UDP port {}{} within {} s{}", port, but, seconds(limit), words);
}

Symptom probe_program(Symptom symptom, const match::ServerChoice& server,
                      const std::string& own_program, milliseconds limit,
                      const std::atomic<int>& stop) {
  constexpr const char* kBySelf = "start it by hand and see what it says";
  soccer::ServerParams params;
  auto started = StartedServer::start(server, own_program, params);
  if (!started) return unreachable(std::move(symptom), started.error().message, "name its PATH");
  symptom.path = started->child().plan().argv.front();
  auto clients = soccer::UdpClients::create(started->host(), started->ports().player);
  if (!clients) return unreachable(std::move(symptom), clients.error().message, kBySelf);
  const auto end = steady_clock::now() + limit;
  const auto alive = [&] {
    return stop.load() == 0 && !process::has_ended(started->child().status());
  };
  const auto go_on = [&] { return alive() && steady_clock::now() < end; };
  const Contact contact = greet(**clients, true, go_on);
  if (contact.answer.empty()) {
    return unreachable(std::move(symptom),
                       fmt::format("{}: {}", symptom.path, why_silent(*started, limit)), kBySelf);
  }
  examine(symptom, **clients, contact.answer, alive);
  symptom.version = started->news().version;
  const std::string version = symptom.version.empty() ? "tells no version" : symptom.version;
  symptom.found = fmt::format("{}, {}: starts, {}", version, symptom.path, symptom.found);
  return symptom;
}

}  // namespace

Symptom probe_server(const match::ServerChoice& server, const std::string& own_program,
                     milliseconds limit, const std::atomic<int>& stop) {
  Symptom symptom;
  symptom.name = "server";
  symptom.purpose = fmt::format("--server {}", server.text);
  symptom.needed = true;
  if (server.kind == match::ServerChoice::Kind::kAddress) {
    return probe_address(std::move(symptom), server, limit, stop);
  }
  return probe_program(std::move(symptom), server, own_program, limit, stop);
}

}  // namespace cls::orchestration::checks
