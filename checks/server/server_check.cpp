// Runs the steps of `cls check server`.
#include "checks/server/server_check.h"

#include <optional>
#include <utility>

#include "checks/checked_program.h"
#include "checks/server/server_subject.h"
#include "checks/server/started_server.h"

namespace cls::checks {
namespace {

base::Result<void> prepare(const ServerCheckOptions& options, std::optional<StartedServer>& server,
                           ServerSubject& subject, const std::atomic<int>& stop) {
  subject.start_timeout = options.start_timeout;
  subject.failure_reason = [&server, &stop]() -> std::string {
    if (stop != 0) return "interrupted";
    return server ? describe_exit("the server", server->child()) : "";
  };

  if (options.server.kind == match::ServerChoice::Kind::kAddress) {
    subject.host = options.server.host;
    const int port = options.server.port;
    subject.ports = {port, port + 1, port + 2};
  } else {
    soccer::ServerParams params;
    params.coach = true;
    params.coach_w_referee = true;
    TRY_INIT(auto started,
             StartedServer::start(options.server, options.own_program, params, options.folder));
    server.emplace(std::move(started));
    subject.host = server->host();
    subject.ports = server->ports();
  }

  struct Door {
    std::unique_ptr<soccer::UdpClients>& clients;
    int port;
  };

  for (const Door& door : {Door{subject.player_port, subject.ports.player},
                           Door{subject.trainer_port, subject.ports.trainer},
                           Door{subject.coach_port, subject.ports.coach}}) {
    TRY_INIT(door.clients, soccer::UdpClients::create(subject.host, door.port));
  }

  return {};
}

// Why the remaining steps are skipped; empty if not.
std::string why_not(const ServerSubject& subject, const CheckReport& report) {
  if (std::string reason = subject.failure_reason(); !reason.empty()) return reason;
  const bool unreachable =
      report.steps.size() > 1 && report.steps.front().result != StepResult::kPass;
  return unreachable ? "server unreachable" : "";
}

}  // namespace

base::Result<CheckReport> check_server(const ServerCheckOptions& options,
                                       const std::function<void(const CheckStep&)>& on_step,
                                       const std::atomic<int>& stop) {
  std::optional<StartedServer> server;
  ServerSubject subject;
  TRY(prepare(options, server, subject, stop));

  CheckReport report{"cls.check/1", "cls check server", options.server.text, {}};
  std::vector<ServerStep> steps = server_connection_steps();
  for (const ServerStep& step : server_play_steps()) steps.push_back(step);

  for (const ServerStep& step : steps) {
    on_step(run_step(report, step.name, step.why, [&] {
      const std::string reason = why_not(subject, report);
      return reason.empty() ? step.run(subject) : skip(reason);
    }));
  }
  return report;
}

}  // namespace cls::checks
