// A running mock Playmaker: in this process, on a port, or both.
#pragma once

#include <grpcpp/grpcpp.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "mock-server/game_logic.h"
#include "mock-server/mock.h"

namespace cls::mock_server {

/// Owns the mock and its gRPC server; stops serving when destroyed.
class Server {
 public:
  /// Serves in-process channels only.
  static base::Result<std::unique_ptr<Server>> start(Mock mock);

  /// Serves HOST:PORT too (port 0: a free one, see `port()`), with the standard health and
  /// reflection services.
  static base::Result<std::unique_ptr<Server>> start(Mock mock, const std::string& host, int port);

  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// A channel that reaches this server without a socket: the same service, messages, deadlines.
  std::shared_ptr<grpc::Channel> in_process_channel();

  int port() const { return port_; }

  /// CPU time spent in decisions so far, in nanoseconds.
  std::int64_t decision_nanoseconds() const { return logic_.decision_nanoseconds(); }
  /// What the mock should have been told or asked by now and was not; one line each.
  std::vector<std::string> failed_expectations() const { return expectations_.failures(); }

  /// Blocks until the server is shut down by a signal handler or another thread.
  void wait() { server_->Wait(); }
  /// Ends all calls at once.
  void stop();

 private:
  explicit Server(Mock mock);
  base::Result<void> listen(const std::string& address);

  Mock mock_;
  Expectations expectations_;
  GameLogic logic_;
  std::unique_ptr<grpc::Service> service_;
  std::unique_ptr<grpc::Server> server_;
  int port_ = 0;
};

}  // namespace cls::mock_server
