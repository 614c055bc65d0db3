// Replies of the mock to the calls of a whole team: TeamPlaymaker.
#pragma once

#include "mock-server/service/responder.h"
#include "mock-server/service/workspace.h"

namespace cls::mock_server {

/// Memory of a call with the States of a team.
constexpr std::size_t kTeamMemory = 12 * kStateMemory;

/// Answers for each agent as `responder` does; for a RawService. A fault of one agent concerns its
/// part of the reply; a delay and a crash concern the whole. A mock whose faults make it an older
/// Playmaker does not implement TeamPlaymaker.
Response respond_to_team(Responder& responder, proto::Rpc rpc,
                         const google::protobuf::Message& request, google::protobuf::Message& reply,
                         Workspace& workspace);

}  // namespace cls::mock_server
