// Starting and probing Playmakers.
#include "match/sides/playmaker_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/system/tcp_connect.h"
#include "match/sides/side_sandbox.h"
#include "proxy/playmaker/grpc_probe.h"

namespace cls::match {

using base::Result;

namespace {

std::string hint_at(const proxy::GrpcTarget& target) {
  constexpr int kGoalie = 1;
  const std::string problem = proxy::probe_grpc(target, kGoalie).problem;
  return problem.empty() ? problem : "; " + problem;
}

}  // namespace

proxy::GrpcTarget target_of(const Endpoint& endpoint) {
  proxy::GrpcTarget target;
  target.host = endpoint.host;
  target.port = endpoint.port;
  target.port_step = endpoint.port_step;
  target.unix_path = endpoint.path;
  target.tls = endpoint.tls;
  return target;
}

std::string unreachable_hint(const Endpoint& endpoint) {
  const bool runs_already =
      endpoint.kind == Endpoint::Kind::kAddress || endpoint.kind == Endpoint::Kind::kUnixSocket;
  return runs_already ? hint_at(target_of(endpoint)) : std::string();
}

Result<std::unique_ptr<mock_server::Server>> start_mock(const Endpoint& endpoint) {
  if (endpoint.script != nullptr) {
    return mock_server::Server::start(mock_server::Mock(endpoint.script));
  }
  TRY_INIT(auto mock, mock_server::make_mock(endpoint.behavior));
  return mock_server::Server::start(std::move(mock));
}

Result<std::unique_ptr<PlaymakerProcess>> PlaymakerProcess::start(
    process::ProcessHost& host, const Endpoint& endpoint, RunValues values,
    const std::filesystem::path& folder, std::vector<int> cpus, process::ResourceLimits limits,
    const PlaymakerSandbox* sandbox) {
  TRY_INIT(auto ports, process::ReservedPort::choose(1));
  std::unique_ptr<PlaymakerProcess> created(new PlaymakerProcess(std::move(ports.front())));
  values.port = created->port();

  process::CommandPlan plan = run_plan(endpoint.command, values, folder);
  plan.cpus = std::move(cpus);
  plan.limits = limits;
  if (sandbox != nullptr) {
    sandbox->enclose(plan, endpoint.command);
    created->sockets_ = sandbox->sockets();
  }

  TRY_INIT(auto child, host.start(plan));
  created->child_ = std::move(child);
  return created;
}

proxy::GrpcTarget PlaymakerProcess::target() const {
  proxy::GrpcTarget target;
  target.host = process::loopback_host();
  target.port = port();
  target.make_socket = sockets_;
  return target;
}

bool PlaymakerProcess::answers(std::chrono::milliseconds limit) const {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  return static_cast<bool>(base::connect_tcp(process::loopback_host(), port(), deadline, sockets_));
}

std::string PlaymakerProcess::port_hint() const {
  const std::vector<int> open = process::ports_of(process::Protocol::kTcp, child_->status().pid);
  if (open.empty()) return fmt::format("; it did not listen on port {} in time", port());
  if (std::ranges::find(open, port()) != open.end()) return hint_at(target());
  return fmt::format("; it listens on port {}, not on {}", fmt::join(open, ", "), port());
}

}  // namespace cls::match
