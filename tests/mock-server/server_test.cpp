// The mock Playmaker as a gRPC server, in process and on a port.
#include "mock-server/server.h"

#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include "mock-server/script/named_behaviors.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {
namespace {

using testing::HasSubstr;

std::unique_ptr<Server> running(std::string_view behavior) {
  auto made = make_behavior(behavior);
  return std::move(*Server::start(std::move(*made)));
}

protos::RegisterResponse register_with(protos::Game::Stub& stub, int unum) {
  grpc::ClientContext context;
  protos::RegisterRequest request;
  request.set_team_name("mock");
  request.set_uniform_number(unum);
  protos::RegisterResponse response;
  EXPECT_TRUE(stub.Register(&context, request, &response).ok());
  return response;
}

TEST(MockServer, AssignsConsecutiveClientIds) {
  const auto server = running("");
  const auto stub = protos::Game::NewStub(server->in_process_channel());
  EXPECT_EQ(register_with(*stub, 1).client_id(), 1);
  const auto second = register_with(*stub, 7);
  EXPECT_EQ(second.client_id(), 2);
  EXPECT_EQ(second.uniform_number(), 7);
  EXPECT_EQ(second.team_name(), "mock");
}

TEST(MockServer, RepliesToEveryRpc) {
  const auto server = running("hold");
  const auto stub = protos::Game::NewStub(server->in_process_channel());
  protos::Empty empty;
  const auto ok = [](const grpc::Status& status) { return status.ok(); };
  const auto context = [] { return std::make_unique<grpc::ClientContext>(); };

  EXPECT_TRUE(ok(stub->SendServerParams(context().get(), {}, &empty)));
  EXPECT_TRUE(ok(stub->SendPlayerParams(context().get(), {}, &empty)));
  EXPECT_TRUE(ok(stub->SendPlayerType(context().get(), {}, &empty)));
  EXPECT_TRUE(ok(stub->SendInitMessage(context().get(), {}, &empty)));
  EXPECT_TRUE(ok(stub->SendByeCommand(context().get(), {}, &empty)));

  protos::PlayerActions player;
  EXPECT_TRUE(ok(stub->GetPlayerActions(context().get(), {}, &player)));
  EXPECT_GT(player.actions_size(), 0);
  protos::CoachActions coach;
  EXPECT_TRUE(ok(stub->GetCoachActions(context().get(), {}, &coach)));

  protos::TrainerActions trainer;
  EXPECT_TRUE(ok(stub->GetTrainerActions(context().get(), {}, &trainer)));
}

TEST(MockServer, ChoosesHighestEvaluationThenLowestIndex) {
  const auto server = running("");
  const auto stub = protos::Game::NewStub(server->in_process_channel());
  protos::BestPlannerActionRequest request;
  (*request.mutable_pairs())[3].set_evaluation(-2.0);
  (*request.mutable_pairs())[9].set_evaluation(-1.0);
  (*request.mutable_pairs())[5].set_evaluation(-1.0);
  grpc::ClientContext context;
  protos::BestPlannerActionResponse response;
  ASSERT_TRUE(stub->GetBestPlannerAction(&context, request, &response).ok());
  EXPECT_EQ(response.index(), 5);
}

TEST(MockServer, ListensOnFreePortAndReportsPortInUse) {
  auto first = Server::start(std::move(*make_behavior("simple")), "127.0.0.1", 0);
  ASSERT_TRUE(first);
  EXPECT_GT((*first)->port(), 0);
  const auto stub = protos::Game::NewStub(grpc::CreateChannel(
      "127.0.0.1:" + std::to_string((*first)->port()), grpc::InsecureChannelCredentials()));
  EXPECT_EQ(register_with(*stub, 1).client_id(), 1);
  const auto second =
      Server::start(std::move(*make_behavior("simple")), "127.0.0.1", (*first)->port());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            "the mock Playmaker cannot listen on 127.0.0.1:" + std::to_string((*first)->port()));
}

// First reply of a call to a standard service, as raw bytes, so that its .proto file is not needed.
std::string ask(const Server& server, const std::string& method, const std::string& request) {
  void* const tag = &const_cast<Server&>(server);
  grpc::GenericStub stub(grpc::CreateChannel("127.0.0.1:" + std::to_string(server.port()),
                                             grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  grpc::CompletionQueue queue;

  const auto next = [&queue] {
    void* got = nullptr;
    bool ok = false;
    return queue.Next(&got, &ok) && ok;
  };

  const grpc::Slice slice(request);
  const grpc::ByteBuffer message(&slice, 1);
  grpc::ByteBuffer answer;
  grpc::Status status;
  const auto call = stub.PrepareCall(&context, method, &queue);
  call->StartCall(tag);
  EXPECT_TRUE(next());
  call->WriteLast(message, {}, tag);
  EXPECT_TRUE(next());
  call->Read(&answer, tag);
  EXPECT_TRUE(next()) << method;

  call->Finish(&status, tag);
  EXPECT_TRUE(next());

  grpc::Slice bytes;
  EXPECT_TRUE(answer.DumpToSingleSlice(&bytes).ok());
  return {reinterpret_cast<const char*>(bytes.begin()), bytes.size()};
}

TEST(MockServer, ServesHealthAndReflectionOnPort) {
  const auto server = Server::start(std::move(*make_behavior("simple")), "127.0.0.1", 0);
  ASSERT_TRUE(server);
  const std::string serving = "\x08\x01";  // status: SERVING
  EXPECT_EQ(ask(**server, "/grpc.health.v1.Health/Check", ""), serving);
  const std::string list_services("\x3a\x00", 2);
  EXPECT_THAT(ask(**server, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
                  list_services),
              HasSubstr("protos.Game"));
}

TEST(Behaviors, ReportsUnknownNameWithSuggestion) {
  EXPECT_EQ(make_behavior("hodl").error().message,
            "unknown mock behavior 'hodl'; did you mean 'hold'?");
  EXPECT_EQ(make_behavior("zzz").error().message,
            "unknown mock behavior 'zzz' (known: attack, simple, example, planner, hold, random)");
}

}  // namespace
}  // namespace cls::mock_server
