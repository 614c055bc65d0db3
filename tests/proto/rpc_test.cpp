// The RPC table against playmaker.proto.
#include "proto/rpc.h"

#include <grpc/impl/codegen/status.h>
#include <gtest/gtest.h>

#include "proto/playmaker.pb.h"
#include "proto/status_name.h"

namespace cls::proto {
namespace {

TEST(Rpc, NamesFollowOrderOfEnumeration) {
  const std::vector<std::string_view> expected = {
      "Register",        "SendServerParams",  "SendPlayerParams",
      "SendPlayerType",  "SendInitMessage",   "GetPlayerActions",
      "GetCoachActions", "GetTrainerActions", "GetBestPlannerAction",
      "SendByeCommand"};

  EXPECT_EQ(agent_rpc_names(), expected);
  EXPECT_EQ(rpc_from_name("GetCoachActions"), Rpc::kGetCoachActions);
  EXPECT_EQ(rpc_from_name("GetCoachAction"), std::nullopt);
  EXPECT_EQ(rpc_from_name("UnregisterTeam"), Rpc::kUnregisterTeam);
  EXPECT_EQ(path(Rpc::kRegister), "/protos.Game/Register");
  EXPECT_EQ(path(Rpc::kGetTeamActions), "/cls.playmaker.v1.TeamPlaymaker/GetTeamActions");
}

TEST(StatusName, HasTheCodesOfGrpc) {
  EXPECT_EQ(kStatusOk, GRPC_STATUS_OK);
  EXPECT_EQ(kStatusCancelled, GRPC_STATUS_CANCELLED);
  EXPECT_EQ(kStatusUnknown, GRPC_STATUS_UNKNOWN);
  EXPECT_EQ(kStatusDeadlineExceeded, GRPC_STATUS_DEADLINE_EXCEEDED);
  EXPECT_EQ(kStatusUnimplemented, GRPC_STATUS_UNIMPLEMENTED);
  EXPECT_EQ(kStatusUnavailable, GRPC_STATUS_UNAVAILABLE);
  EXPECT_EQ(status_name(kStatusUnavailable), "UNAVAILABLE");
  EXPECT_EQ(status_name(99), "UNKNOWN");
}

TEST(Rpc, PrototypesHaveTypesOfInterface) {
  EXPECT_EQ(request_prototype(Rpc::kRegister).GetDescriptor(),
            protos::RegisterRequest::descriptor());
  EXPECT_EQ(reply_prototype(Rpc::kRegister).GetDescriptor(),
            protos::RegisterResponse::descriptor());
  EXPECT_EQ(request_prototype(Rpc::kGetTrainerActions).GetDescriptor(),
            protos::State::descriptor());
  EXPECT_EQ(reply_prototype(Rpc::kGetTrainerActions).GetDescriptor(),
            protos::TrainerActions::descriptor());
  EXPECT_EQ(reply_prototype(Rpc::kSendByeCommand).GetDescriptor(), protos::Empty::descriptor());
}

TEST(Rpc, IdentityIsReadFromEveryRequest) {
  protos::RegisterResponse identity;
  identity.set_client_id(7);
  identity.set_team_name("cls");
  identity.set_uniform_number(4);

  for (int i = 1; i < kAgentRpcs; ++i) {
    const auto rpc = static_cast<Rpc>(i);
    const std::unique_ptr<google::protobuf::Message> request(request_prototype(rpc).New());
    set_identity(rpc, identity, *request);
    const Caller caller = caller_of(rpc, *request);
    EXPECT_EQ(caller.client_id, 7) << name(rpc);
    EXPECT_EQ(caller.team, "cls") << name(rpc);
    EXPECT_EQ(caller.unum, 4) << name(rpc);
  }
}

TEST(Rpc, UnumOfDecisionComesFromWorldModelWithoutIdentity) {
  protos::State state;
  state.mutable_world_model()->mutable_self()->set_uniform_number(9);
  EXPECT_EQ(caller_of(Rpc::kGetPlayerActions, state).unum, 9);
}

}  // namespace
}  // namespace cls::proto
