// Starting a user's Playmaker and telling how it ended.
#include "orchestration/match/sides/playmaker_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cls::orchestration::match {

using base::Result;

namespace {

std::string exit_text(const process::Child::Status& status) {
  if (!status.exit) return "running";
  return status.asked_to_end ? fmt::format("ended by cls ({})", to_text(*status.exit))
                             : to_text(*status.exit);
}

}  // namespace

ProcessFailure failure_of(const process::Child& child) {
  const process::Child::Status status = child.status();
  ProcessFailure failure;
  failure.process = child.plan().name;
  failure.exit = exit_text(status);
  failure.log = child.plan().log.filename().string();
  failure.output = child.last_lines();
  return failure;
}

ProcessResult result_of(const process::Child& child) {
  const process::Child::Status status = child.status();
  ProcessResult result;
  result.name = child.plan().name;
  result.command = process::to_shell(child.plan());
  result.log = child.plan().log.filename().string();
  result.exit = exit_text(status);
  result.cpu_seconds = child.cpu_seconds();
  return result;
}

Result<std::unique_ptr<PlaymakerProgram>> PlaymakerProgram::start(
    process::ProcessHost& host, const Endpoint& endpoint, RunValues values,
    const std::filesystem::path& folder, std::vector<int> cpus) {
  auto ports = process::ReservedPort::choose(1);
  if (!ports) return ports.error();
  std::unique_ptr<PlaymakerProgram> program(new PlaymakerProgram(std::move(ports->front())));
  values.port = program->port();
  process::CommandPlan plan = run_plan(endpoint.command, values, folder);
  plan.cpus = std::move(cpus);
  auto child = host.start(plan);
  if (!child) return child.error();
  program->child_ = std::move(*child);
  return program;
}

std::string PlaymakerProgram::port_hint() const {
  const std::vector<int> open = process::ports_of(process::Protocol::kTcp, child_->status().pid);
  if (open.empty()) return fmt::format("; it does not listen on port {}", port());
  if (std::find(open.begin(), open.end(), port()) != open.end()) return {};
  return fmt::format("; it listens on port {}, not on {}", fmt::join(open, ", "), port());
}

}  // namespace cls::orchestration::match
