// A gRPC service with one handler for all its RPCs.
#pragma once

#include <grpcpp/grpcpp.h>
#include <grpcpp/impl/codegen/service_type.h>

#include <cstddef>
#include <functional>

#include "mock-server/service/responder.h"
#include "mock-server/service/workspace.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Raw callback service: the handler runs on gRPC's threads, must not block, and may reply with any
/// bytes.
class RawService : public grpc::Service {
 public:
  /// Fills the empty `reply`, unless the call fails; more memory of the call comes from
  /// `workspace`.
  using Respond = std::function<Response(proto::Rpc rpc, const google::protobuf::Message& request,
                                         google::protobuf::Message& reply, Workspace& workspace)>;

  /// Serves the RPCs from `first` up to `end`, which is not one of them. `memory`: bytes of a usual
  /// call.
  RawService(int first, int end, std::size_t memory, Respond respond);

 private:
  grpc::ServerUnaryReactor* handle(proto::Rpc rpc, grpc::CallbackServerContext& context,
                                   const grpc::ByteBuffer& request, grpc::ByteBuffer& reply);

  Respond respond_;
  WorkspacePool workspaces_;
};

}  // namespace cls::mock_server
