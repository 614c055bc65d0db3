// The gRPC server of a mock Playmaker: in process, on a port, or both.
#pragma once

#include <grpcpp/grpcpp.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "mock-server/mock.h"
#include "mock-server/service/raw_service.h"

namespace cls::mock_server {

/// Owns the mock and its gRPC server; stops serving when destroyed.
class Server {
 public:
  /// Serves this process only.
  static base::Result<std::unique_ptr<Server>> start(Mock mock);

  /// Also serves HOST:PORT (port 0: a free port, see port()), with the standard health and
  /// reflection services.
  static base::Result<std::unique_ptr<Server>> start(Mock mock, const std::string& host, int port);

  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Channel to this server without a socket: same service, messages and deadlines.
  std::shared_ptr<grpc::Channel> in_process_channel();

  /// True without faults: no reply is late or fails, so handle() serves as well as a channel.
  bool faultless() const { return !mock_.faults.any(); }
  /// Fills the empty `reply`, on the caller's thread. Thread safe.
  void handle(proto::Rpc rpc, const google::protobuf::Message& request,
              google::protobuf::Message& reply) {
    handler_.handle(rpc, request, reply);
  }

  int port() const { return port_; }

  /// CPU time spent in decisions so far, in nanoseconds.
  std::int64_t decision_nanoseconds() const { return handler_.decision_nanoseconds(); }
  /// One line per failed expectation.
  std::vector<std::string> failed_expectations() const { return expectations_.failures(); }

  /// Blocks until the server is shut down by a signal handler or another thread.
  void wait() { server_->Wait(); }
  /// Cancels all calls and stops serving.
  void stop();

 private:
  explicit Server(Mock mock);
  base::Result<void> listen(const std::string& address);

  Mock mock_;
  Expectations expectations_;
  RequestHandler handler_;
  Responder responder_;
  RawService service_;       // protos.Game
  RawService team_service_;  // TeamPlaymaker
  std::unique_ptr<grpc::Server> server_;
  int port_ = 0;
};

}  // namespace cls::mock_server
