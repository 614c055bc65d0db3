// The mock Playmaker as a gRPC service: one handler for all RPCs, with injected faults.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "mock-server/script/faults.h"
#include "mock-server/service/request_handler.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {

/// Raw callback service: handlers run on gRPC's threads, never block, and may reply with any bytes.
/// Crash and restart are simulated (calls fail as they would, a restarted Playmaker knows no
/// agent) unless `die` is given.
class PlaymakerService : public protos::Game::Service {
 public:
  /// `handler` must outlive the service. `die` is called on a gRPC thread when a crash is due; it
  /// should not return.
  PlaymakerService(RequestHandler& handler, Faults faults, std::function<void()> die);
  ~PlaymakerService() override;

 private:
  class Workspace;

  grpc::ServerUnaryReactor* handle(proto::Rpc rpc, grpc::CallbackServerContext& context,
                                   const grpc::ByteBuffer& request, grpc::ByteBuffer& reply);
  grpc::ServerUnaryReactor* handle_with_faults(proto::Rpc rpc,
                                               const google::protobuf::Message& request,
                                               google::protobuf::Message& message,
                                               grpc::ByteBuffer& reply);
  Fault choose_fault(proto::Rpc rpc, const google::protobuf::Message& request);
  void alter_identity(protos::RegisterResponse& identity);
  std::unique_ptr<Workspace> acquire_workspace();
  void release_workspace(std::unique_ptr<Workspace> workspace);

  RequestHandler& handler_;
  Faults faults_;
  bool faulty_;
  std::function<void()> die_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

  std::mutex mutex_;
  bool dead_ = false;
  bool restarting_;        ///< the restart has begun or is complete
  std::set<int> clients_;  ///< registered since the restart began
  std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace cls::mock_server
