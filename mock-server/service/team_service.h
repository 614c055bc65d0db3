// The calls of a whole team: TeamPlaymaker as a gRPC service.
#pragma once

#include "mock-server/service/raw_call.h"
#include "mock-server/service/responder.h"
#include "proto/team_playmaker.grpc.pb.h"

namespace cls::mock_server {

/// Answers for each agent as PlaymakerService does. A fault of one agent concerns its part of the
/// reply; a delay and a crash concern the whole. A mock whose faults make it an older Playmaker
/// does not implement this service.
class TeamService : public playmaker::v1::TeamPlaymaker::Service {
 public:
  /// `responder` must outlive the service.
  explicit TeamService(Responder& responder);

 private:
  grpc::ServerUnaryReactor* handle(proto::Rpc rpc, grpc::CallbackServerContext& context,
                                   const grpc::ByteBuffer& request, grpc::ByteBuffer& reply);

  Responder& responder_;
  WorkspacePool workspaces_{12 * kStateMemory};
};

}  // namespace cls::mock_server
