// The calls of single agents: protos.Game as a gRPC service.
#pragma once

#include "mock-server/service/raw_call.h"
#include "mock-server/service/responder.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {

/// Raw callback service with one handler for all RPCs. Handlers run on gRPC's threads, never block,
/// and may reply with any bytes.
class PlaymakerService : public protos::Game::Service {
 public:
  /// `responder` must outlive the service.
  explicit PlaymakerService(Responder& responder);

 private:
  grpc::ServerUnaryReactor* handle(proto::Rpc rpc, grpc::CallbackServerContext& context,
                                   const grpc::ByteBuffer& request, grpc::ByteBuffer& reply);

  Responder& responder_;
  WorkspacePool workspaces_{kStateMemory};
};

}  // namespace cls::mock_server
