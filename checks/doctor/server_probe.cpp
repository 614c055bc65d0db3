// Probes a soccer server without connecting a player.
#include "checks/doctor/server_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/system/version.h"
#include "base/text/printable.h"
#include "checks/server/started_server.h"
#include "process/scratch_folder.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/play_mode.h"
#include "soccer/udp_channel.h"

namespace cls::checks {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPollInterval{20};
constexpr milliseconds kRetryInterval{200};
// A server sends a monitor its parameters immediately and the pitch every cycle.
constexpr milliseconds kMonitorLimit{2000};

using ShouldContinue = std::function<bool()>;

/// Messages received as a monitor.
struct MonitorReport {
  std::optional<soccer::ServerParams> params;
  std::string state;  ///< "before_kick_off, cycle 0, no teams"
};

/// Result of the first message.
struct Contact {
  std::string reply;    ///< empty: none
  bool closed = false;  ///< ICMP port unreachable
};

// Sends an unknown message: every soccer server replies with an error and does nothing else. A
// starting server may open its port later.
Contact contact_server(soccer::UdpClients& clients, bool may_open_later,
                       const ShouldContinue& proceed) {
  Contact contact;
  std::unique_ptr<soccer::Channel> client;
  auto ask_at = steady_clock::now();

  while (proceed()) {
    if (steady_clock::now() >= ask_at) {
      if (client == nullptr) client = clients.connect();
      contact.closed = client != nullptr && !client->send("(hello)");
      if (contact.closed && !may_open_later) break;
      if (contact.closed) client.reset();
      ask_at = steady_clock::now() + kRetryInterval;
    }

    clients.wait_until(std::min(ask_at, steady_clock::now() + kPollInterval));
    if (client != nullptr && client->receive(contact.reply)) break;
  }
  return contact;
}

// "(show T (pm PM) (tm LEFT RIGHT ...": state of the match.
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
    return std::string_view(text) == "null" ? std::string("no team") : base::printable(text);
  };

  if (team(left.data()) == "no team" && team(right.data()) == "no team") {
    return fmt::format("{}, cycle {}, no teams", name, time);
  }
  return fmt::format("{}, cycle {}, {} against {}", name, time, team(left.data()),
                     team(right.data()));
}

MonitorReport watch(soccer::UdpClients& clients, const ShouldContinue& proceed) {
  MonitorReport news;
  const std::unique_ptr<soccer::Channel> monitor = clients.connect();
  if (monitor == nullptr) return news;

  monitor->send("(dispinit version 4)");
  const auto end = steady_clock::now() + kMonitorLimit;
  std::string message;

  while (news.state.empty() && proceed() && steady_clock::now() < end) {
    clients.wait_until(steady_clock::now() + kPollInterval);
    while (monitor->receive(message)) {
      soccer::ServerParams params;
      if (message.starts_with("(server_param ") && soccer::parse(message, params)) {
        news.params = params;
      }
      if (const auto moment = moment_in(message)) news.state = *moment;
    }
  }

  monitor->send("(dispbye)");
  return news;
}

std::string monitor_text(const MonitorReport& news) {
  if (!news.params) return "no reply to a monitor";
  const std::string mode = news.params->synch_mode ? "synchronous mode"
                                                   : fmt::format("real time, {} ms per cycle",
                                                                 news.params->simulator_step);
  const std::string state = news.state.empty() ? "" : "; " + news.state;
  return fmt::format("{}, halves of {} s{}", mode, news.params->half_time, state);
}

double seconds(milliseconds limit) { return static_cast<double>(limit.count()) / 1000.0; }

DoctorCheck unreachable(DoctorCheck check, std::string found, std::string hint) {
  check.status = DoctorStatus::kUnreachable;
  check.found = std::move(found);
  check.hint = std::move(hint);
  return check;
}

// Describes a server that replied.
void examine(DoctorCheck& check, soccer::UdpClients& clients, const std::string& answer,
             const ShouldContinue& alive) {
  if (answer.starts_with("(")) {
    check.found = monitor_text(watch(clients, alive));
    return;
  }
  check.status = DoctorStatus::kWrong;
  check.found =
      fmt::format("not a soccer server: replies '{}'", base::printable(answer.substr(0, 60)));
  check.hint = "find the process that uses this port";
}

DoctorCheck probe_address(DoctorCheck check, const match::ServerChoice& server, milliseconds limit,
                          const std::atomic<int>& stop) {
  constexpr const char* kStartHint =
      "start it, or let cls start one: --server rcssserver or embedded";

  auto clients = soccer::UdpClients::create(server.host, server.port);
  if (!clients) return unreachable(std::move(check), clients.error().message, kStartHint);

  const auto end = steady_clock::now() + limit;
  const auto alive = [&] { return stop.load() == 0; };
  const auto proceed = [&] { return alive() && steady_clock::now() < end; };
  const Contact contact = contact_server(**clients, false, proceed);

  if (contact.reply.empty()) {
    const std::string why = contact.closed ? std::string("no listener at this UDP port")
                                           : fmt::format("no reply within {} s", seconds(limit));
    return unreachable(std::move(check), fmt::format("{}: {}", server.text, why), kStartHint);
  }

  examine(check, **clients, contact.reply, alive);
  check.found = fmt::format("{}: {}", server.text, check.found);
  return check;
}

// Why a started server did not reply.
std::string describe_no_reply(const StartedServer& started, milliseconds limit) {
  const process::Child::Status status = started.child().status();
  const std::vector<std::string> last = started.child().last_lines(1);
  const std::string last_line = last.empty() ? "" : fmt::format(" ({})", last.front());

  if (process::has_ended(status) && status.exit) {
    return fmt::format("exited at start: {}{}", to_text(*status.exit), last_line);
  }

  const std::vector<int> open = process::ports_of(process::Protocol::kUdp, status.pid);
  const int port = started.ports().player;
  if (std::ranges::find(open, port) != open.end()) {
    return fmt::format("no reply at its port within {} s{}", seconds(limit), last_line);
  }

  const std::string but = open.empty() ? "" : fmt::format(", but {}", fmt::join(open, ", "));
  return fmt::format("did not open UDP port {}{} within {} s{}", port, but, seconds(limit),
                     last_line);
}

DoctorCheck probe_program(DoctorCheck check, const match::ServerChoice& server,
                          const std::string& own_program, milliseconds limit,
                          const std::atomic<int>& stop) {
  constexpr const char* kManualHint = "start it by hand and read its output";

  const auto scratch = process::ScratchFolder::create();
  if (!scratch) return unreachable(std::move(check), scratch.error().message, "");

  soccer::ServerParams params;
  auto started = StartedServer::start(server, own_program, params, scratch->path());
  if (!started) return unreachable(std::move(check), started.error().message, "give its PATH");
  check.path = started->child().plan().argv.front();

  auto clients = soccer::UdpClients::create(started->host(), started->ports().player);
  if (!clients) return unreachable(std::move(check), clients.error().message, kManualHint);

  const auto end = steady_clock::now() + limit;
  const auto alive = [&] {
    return stop.load() == 0 && !process::has_ended(started->child().status());
  };
  const auto proceed = [&] { return alive() && steady_clock::now() < end; };

  const Contact contact = contact_server(**clients, true, proceed);
  if (contact.reply.empty()) {
    return unreachable(std::move(check),
                       fmt::format("{}: {}", check.path, describe_no_reply(*started, limit)),
                       kManualHint);
  }

  examine(check, **clients, contact.reply, alive);
  check.version = started->status().version;
  if (server.kind == match::ServerChoice::Kind::kEmbedded) check.version = base::kVersion;
  const std::string version = check.version.empty() ? "unknown version" : check.version;
  check.found = fmt::format("{}, {}: starts, {}", version, check.path, check.found);
  return check;
}

}  // namespace

DoctorCheck probe_server(const match::ServerChoice& server, const std::string& own_program,
                         milliseconds limit, const std::atomic<int>& stop) {
  DoctorCheck check;
  check.name = "server";
  check.purpose = fmt::format("--server {}", server.text);
  check.needed = true;
  if (server.kind == match::ServerChoice::Kind::kAddress) {
    return probe_address(std::move(check), server, limit, stop);
  }
  return probe_program(std::move(check), server, own_program, limit, stop);
}

}  // namespace cls::checks
