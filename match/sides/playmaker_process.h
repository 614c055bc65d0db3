// The Playmaker that an endpoint names: where it listens, the bundled mock, a `run:` process.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/terms/endpoint.h"
#include "match/terms/run_command.h"
#include "mock-server/server.h"
#include "process/ports.h"
#include "process/process_host.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::match {

class PlaymakerSandbox;

/// Calls to a crashed program fail before its exit is known.
inline constexpr std::chrono::milliseconds kProgramExitDelay{500};

/// The address of a running Playmaker; for kAddress and kUnixSocket.
proxy::GrpcTarget target_of(const Endpoint& endpoint);

/// Why a Playmaker may not have replied in time: "; nothing listens at localhost:50051", or empty.
/// See proxy::probe_grpc().
std::string unreachable_hint(const Endpoint& endpoint);

/// The bundled Playmaker with the endpoint's script or behavior; for kMock. The error names an
/// unknown behavior.
base::Result<std::unique_ptr<mock_server::Server>> start_mock(const Endpoint& endpoint);

/// The Playmaker of a `run:` side: a process that listens on a port chosen for it.
class PlaymakerProcess {
 public:
  /// Chooses `values.port` itself. The log goes into `folder`. Null `sandbox`: none.
  static base::Result<std::unique_ptr<PlaymakerProcess>> start(
      process::ProcessHost& host, const Endpoint& endpoint, RunValues values,
      const std::filesystem::path& folder, std::vector<int> cpus = {},
      process::ResourceLimits limits = {}, const PlaymakerSandbox* sandbox = nullptr);

  int port() const { return port_.number(); }
  /// Its address.
  proxy::GrpcTarget target() const;
  const process::Child& child() const { return *child_; }
  bool ended() const { return process::has_ended(child_->status()); }

  /// True when it accepts a connection within `limit`.
  bool answers(std::chrono::milliseconds limit) const;

  /// Compares its open ports with the port it was given, and probes that: "" or "; it listens on
  /// port 50051, not on 21234".
  std::string port_hint() const;

 private:
  explicit PlaymakerProcess(process::ReservedPort port) : port_(std::move(port)) {}

  process::ReservedPort port_;
  base::TcpSocketMaker sockets_;  ///< in its network; empty: that of cls
  std::shared_ptr<process::Child> child_;
};

}  // namespace cls::match
