// A gRPC server inside the test, with replies defined by each test.
#pragma once

#include <grpcpp/grpcpp.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "proto/playmaker.grpc.pb.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::tests {

/// Replies to every RPC and records the calls. Handlers run on gRPC threads.
class GameService : public protos::Game::Service {
 public:
  /// Called for GetPlayerActions; default: an empty list.
  std::function<grpc::Status(const protos::State&, protos::PlayerActions&)> on_player;
  /// Called for Register; default: numbers agents from 1 and copies the rest.
  std::function<grpc::Status(const protos::RegisterRequest&, protos::RegisterResponse&)>
      on_register;

  /// One line per call: "METHOD AGENT".
  std::vector<std::string> calls() const;

  grpc::Status Register(grpc::ServerContext* context, const protos::RegisterRequest* request,
                        protos::RegisterResponse* response) override;
  grpc::Status SendServerParams(grpc::ServerContext* context, const protos::ServerParam* request,
                                protos::Empty* response) override;
  grpc::Status SendPlayerParams(grpc::ServerContext* context, const protos::PlayerParam* request,
                                protos::Empty* response) override;
  grpc::Status SendPlayerType(grpc::ServerContext* context, const protos::PlayerType* request,
                              protos::Empty* response) override;
  grpc::Status SendInitMessage(grpc::ServerContext* context, const protos::InitMessage* request,
                               protos::Empty* response) override;
  grpc::Status GetPlayerActions(grpc::ServerContext* context, const protos::State* request,
                                protos::PlayerActions* response) override;
  grpc::Status GetCoachActions(grpc::ServerContext* context, const protos::State* request,
                               protos::CoachActions* response) override;
  grpc::Status SendByeCommand(grpc::ServerContext* context, const protos::RegisterResponse* request,
                              protos::Empty* response) override;

 private:
  grpc::Status note(const char* method, int agent);

  mutable std::mutex mutex_;
  std::vector<std::string> calls_;
  std::atomic<int> last_client_id_{0};
};

/// A Playmaker at that port of this host.
inline proxy::GrpcTarget loopback(int port) {
  proxy::GrpcTarget target;
  target.host = "127.0.0.1";
  target.port = port;
  return target;
}

/// Serves on a loopback port; port 0 selects a free port.
class PlaymakerServer {
 public:
  explicit PlaymakerServer(
      grpc::Service& service, int port = 0,
      std::shared_ptr<grpc::ServerCredentials> credentials = grpc::InsecureServerCredentials());
  /// For replies that do not parse: one handler for every method.
  explicit PlaymakerServer(grpc::CallbackGenericService& service);
  ~PlaymakerServer() { stop(); }

  int port() const { return port_; }
  std::shared_ptr<grpc::Channel> in_process_channel();
  /// Cancels all calls and stops serving.
  void stop();

 private:
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace cls::tests
