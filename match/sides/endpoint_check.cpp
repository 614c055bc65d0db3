// One check per kind of side.
#include "match/sides/endpoint_check.h"

#include <filesystem>
#include <thread>

#include "match/programs/run_command_check.h"
#include "match/programs/team_folder.h"
#include "match/sides/playmaker_process.h"
#include "mock-server/mock.h"
#include "proxy/playmaker/grpc_probe.h"

namespace cls::match {
namespace {

using Kind = EndpointProblem::Kind;
using Problem = std::optional<EndpointProblem>;

Problem check_files(Endpoint endpoint) {
  const auto loaded = load_files(endpoint);
  if (loaded) return {};
  const bool exists = missing_file(endpoint).empty();
  return EndpointProblem{exists ? Kind::kBadScript : Kind::kMissing, loaded.error().message};
}

Problem check_mock(const Endpoint& endpoint) {
  if (mock_server::is_script_name(endpoint.behavior)) return {};
  const auto mock = mock_server::make_mock(endpoint.behavior);
  return mock ? Problem() : EndpointProblem{Kind::kUnknown, mock.error().message};
}

Problem check_address(const Endpoint& endpoint, std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kInterval{100};
  constexpr int kGoalie = 1;
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    const proxy::GrpcProbe probe = proxy::probe_grpc(target_of(endpoint), kGoalie);
    if (probe.problem.empty()) return {};
    if (probe.is_other_protocol) return EndpointProblem{Kind::kUnreachable, probe.problem};
    if (std::chrono::steady_clock::now() >= end) {
      return EndpointProblem{Kind::kUnreachable, probe.problem +
                                                     "; start it first, or let cls start it: "
                                                     "'run:COMMAND --port {port}'"};
    }
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace

Problem check_endpoint(const Endpoint& endpoint, std::chrono::milliseconds patience) {
  if (auto problem = check_files(endpoint)) return problem;

  switch (endpoint.kind) {
    case Endpoint::Kind::kMock:
      return check_mock(endpoint);
    case Endpoint::Kind::kAddress:
    case Endpoint::Kind::kUnixSocket:
      return check_address(endpoint, patience);
    case Endpoint::Kind::kRun: {
      std::string missing = missing_in_command(endpoint.command, std::filesystem::current_path());
      return missing.empty() ? Problem() : EndpointProblem{Kind::kMissing, std::move(missing)};
    }
    case Endpoint::Kind::kTeam: {
      const auto plan = team_plan(endpoint, {});
      return plan ? Problem() : EndpointProblem{Kind::kMissing, plan.error().message};
    }
    case Endpoint::Kind::kMixed:
      for (const Endpoint& part : endpoint.parts) {
        if (auto problem = check_endpoint(part, patience)) return problem;
      }
      return {};
  }
  return {};
}

}  // namespace cls::match
