// Starting the server, and taking the steps.
#include "orchestration/checks/server_check.h"

#include <optional>
#include <utility>

#include "orchestration/checks/scratch_folder.h"
#include "orchestration/checks/server_subject.h"
#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration {
namespace {

/// What a started server needs to live.
struct Surroundings {
  ScratchFolder folder;
  std::vector<ReservedPort> ports;
  std::optional<ProcessHost> host;
  std::shared_ptr<Child> child;
};

soccer::Result<void> start(const ServerCheckOptions& options, Surroundings& around,
                           ServerSubject& subject) {
  if (around.folder.path().empty()) return soccer::Error{"no folder for its logs can be created"};
  auto ports = ReservedPort::choose(3);
  if (!ports) return ports.error();
  around.ports = *std::move(ports);
  subject.host = "127.0.0.1";
  subject.ports = {around.ports[0].number(), around.ports[1].number(), around.ports[2].number()};
  ServerSetup setup;
  if (options.server.kind == ServerChoice::Kind::kEmbedded) {
    setup.program = {options.own_program, "server"};
  } else {
    const auto program = find_program(options.server.program);
    if (!program) return program.error();
    setup.program = {program->string()};
  }
  setup.folder = around.folder.path();
  setup.ports = subject.ports;
  setup.server.coach = true;
  setup.server.coach_w_referee = true;
  auto host = ProcessHost::create();
  if (!host) return host.error();
  around.host.emplace(*std::move(host));
  auto child = around.host->start(server_plan(setup));
  if (!child) return child.error();
  around.child = *std::move(child);
  return {};
}

soccer::Result<void> prepare(const ServerCheckOptions& options, Surroundings& around,
                             ServerSubject& subject) {
  subject.start_timeout = options.start_timeout;
  if (options.server.kind == ServerChoice::Kind::kAddress) {
    subject.host = options.server.host;
    const int port = options.server.port;
    subject.ports = {port, port + 1, port + 2};
  } else if (auto started = start(options, around, subject); !started) {
    return started;
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
std::string hopeless(const Surroundings& around, const CheckReport& report,
                     const std::atomic<int>& stop) {
  if (stop != 0) return "interrupted";
  if (around.child != nullptr && has_ended(around.child->status())) {
    std::string why = "the server has ended";
    const auto lines = around.child->last_lines(1);
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
  Surroundings around;
  ServerSubject subject;
  if (const auto prepared = prepare(options, around, subject); !prepared) return prepared.error();
  CheckReport report;
  report.schema = "cls.check/1";
  report.subject = options.server.text;
  std::vector<ServerStep> steps = server_connection_steps();
  for (const ServerStep& step : server_play_steps()) steps.push_back(step);
  for (const ServerStep& step : steps) {
    CheckStep& taken = report.steps.emplace_back();
    taken.name = step.name;
    taken.why = step.why;
    const std::string why_not = hopeless(around, report, stop);
    Finding found = why_not.empty() ? step.run(subject) : skip(why_not);
    taken.result = found.result;
    taken.evidence = std::move(found.evidence);
    on_step(taken);
  }
  return report;
}

}  // namespace cls::orchestration
