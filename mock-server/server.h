// A running mock Playmaker: in this process, on a port, or both.
#pragma once

#include <grpcpp/grpcpp.h>

#include <memory>
#include <string>

#include "mock-server/behaviour.h"
#include "mock-server/game_service.h"
#include "soccer/result.h"

namespace cls::mock_server {

/// Owns behaviour, service and gRPC server; stops serving when destroyed.
class Server {
 public:
  /// Serves in-process channels only.
  static soccer::Result<std::unique_ptr<Server>> start(std::unique_ptr<Behaviour> behaviour);

  /// Serves HOST:PORT too (port 0: a free one, see `port()`), with the standard health service.
  static soccer::Result<std::unique_ptr<Server>> start(std::unique_ptr<Behaviour> behaviour,
                                                       const std::string& host, int port);

  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// A channel that reaches this server without a socket: the same service, messages, deadlines.
  std::shared_ptr<grpc::Channel> in_process_channel();

  int port() const { return port_; }
  const GameService& service() const { return service_; }

  /// Blocks until the server is shut down by a signal handler or another thread.
  void wait() { server_->Wait(); }
  /// Ends all calls at once.
  void stop();

 private:
  explicit Server(std::unique_ptr<Behaviour> behaviour);
  soccer::Result<void> listen(const std::string& address);

  std::unique_ptr<Behaviour> behaviour_;
  GameService service_;
  std::unique_ptr<grpc::Server> server_;
  int port_ = 0;
};

}  // namespace cls::mock_server
