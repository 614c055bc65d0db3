// Taking the steps.
#include "orchestration/checks/server_check.h"

#include <optional>
#include <utility>

#include "orchestration/checks/server_subject.h"
#include "orchestration/checks/started_server.h"

namespace cls::orchestration {
namespace {

soccer::Result<void> prepare(const ServerCheckOptions& options,
                             std::optional<StartedServer>& server, ServerSubject& subject) {
  subject.start_timeout = options.start_timeout;
  if (options.server.kind == ServerChoice::Kind::kAddress) {
    subject.host = options.server.host;
    const int port = options.server.port;
    subject.ports = {port, port + 1, port + 2};
  } else {
    soccer::ServerParams params;
    params.coach = true;
    params.coach_w_referee = true;
    auto started = StartedServer::start(options.server, options.own_program, params);
    if (!started) return started.error();
    server.emplace(*std::move(started));
    subject.host = server->host();
    subject.ports = server->ports();
  }
  struct Door {
    std::unique_ptr<soccer::UdpClients>& clients;
    int port;
  };
  for (const Door& door : {Door{subject.player_door, subject.ports.player},
                           Door{subject.trainer_door, subject.ports.trainer},
                           Door{subject.coach_door, subject.ports.coach}}) {
    auto created = soccer::UdpClients::create(subject.host, door.port);
    if (!created) return created.error();
    door.clients = *std::move(created);
  }
  return {};
}

// Why it is of no use to go on; empty if it is.
std::string hopeless(const std::optional<StartedServer>& server, const CheckReport& report,
                     const std::atomic<int>& stop) {
  if (stop != 0) return "interrupted";
  if (server && has_ended(server->child().status())) {
    std::string why = "the server has ended";
    const auto lines = server->child().last_lines(1);
    if (!lines.empty()) why += "; its last words: " + lines.front();
    return why;
  }
  const bool unreachable =
      report.steps.size() > 1 && report.steps.front().result != StepResult::kPass;
  return unreachable ? "the server was not reached" : "";
}

}  // namespace

soccer::Result<CheckReport> check_server(const ServerCheckOptions& options,
                                         const std::function<void(const CheckStep&)>& on_step,
                                         const std::atomic<int>& stop) {
  std::optional<StartedServer> server;
  ServerSubject subject;
  if (const auto prepared = prepare(options, server, subject); !prepared) return prepared.error();
  CheckReport report;
  report.schema = "cls.check/1";
  report.command = "cls check server";
  report.subject = options.server.text;
  std::vector<ServerStep> steps = server_connection_steps();
  for (const ServerStep& step : server_play_steps()) steps.push_back(step);
  for (const ServerStep& step : steps) {
    CheckStep& taken = report.steps.emplace_back();
    taken.name = step.name;
    taken.why = step.why;
    const std::string why_not = hopeless(server, report, stop);
    take(taken, [&] { return why_not.empty() ? step.run(subject) : skip(why_not); });
    on_step(taken);
  }
  return report;
}

}  // namespace cls::orchestration
