// Injected faults as a client sees them.
#include "mock-server/script/faults.h"

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <chrono>

#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {
namespace {

using std::chrono::milliseconds;

class FaultyMock {
 public:
  explicit FaultyMock(const std::string& faults) {
    const base::JsonDocument json = *base::JsonDocument::parse("f.json", faults);
    Mock mock(std::move(*make_behavior("hold")));
    auto parsed = parse_faults(base::JsonValue(json));
    EXPECT_TRUE(parsed) << parsed.error().message;
    mock.faults = *parsed;
    server_ = std::move(*Server::start(std::move(mock)));
    stub_ = protos::Game::NewStub(server_->in_process_channel());
  }

  int register_agent(int unum) {
    grpc::ClientContext context;
    protos::RegisterRequest request;
    request.set_uniform_number(unum);
    protos::RegisterResponse response;
    EXPECT_TRUE(stub_->Register(&context, request, &response).ok());
    registered_unum = response.uniform_number();
    return response.client_id();
  }

  grpc::Status decide(int unum, int cycle, int client_id = 0,
                      milliseconds deadline = milliseconds(5000)) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + deadline);
    protos::State state;
    state.mutable_register_response()->set_uniform_number(unum);
    state.mutable_register_response()->set_client_id(client_id);
    state.mutable_world_model()->set_cycle(cycle);
    protos::PlayerActions actions;
    return stub_->GetPlayerActions(&context, state, &actions);
  }

  grpc::Status send_player_type() {
    grpc::ClientContext context;
    protos::Empty empty;
    return stub_->SendPlayerType(&context, {}, &empty);
  }

  int registered_unum = 0;

 private:
  std::unique_ptr<Server> server_;
  std::unique_ptr<protos::Game::Stub> stub_;
};

TEST(Faults, ErrorHasConfiguredStatus) {
  FaultyMock mock(R"({"error": 1, "status": "FAILED_PRECONDITION"})");
  EXPECT_EQ(mock.decide(1, 1).error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_TRUE(mock.send_player_type().ok());
}

TEST(Faults, ErrorHasConfiguredMessage) {
  FaultyMock mock(R"({"error": 1, "message": "my brain hurts"})");
  EXPECT_EQ(mock.decide(1, 1).error_message(), "my brain hurts");
}

TEST(Faults, DropExceedsDeadline) {
  FaultyMock mock(R"({"drop": 1})");
  EXPECT_EQ(mock.decide(1, 1, 0, milliseconds(30)).error_code(),
            grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST(Faults, DelaysReplies) {
  FaultyMock mock(R"({"delay_ms": 60, "only": {"unum": 3}})");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(mock.decide(3, 1).ok());
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(60));
  EXPECT_EQ(mock.decide(3, 1, 0, milliseconds(20)).error_code(),
            grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST(Faults, GarbageFailsToParseAndOversizeArrives) {
  FaultyMock garbage(R"({"garbage": 1})");
  EXPECT_FALSE(garbage.decide(1, 1).ok());
  FaultyMock oversize(R"({"oversize": 1})");
  EXPECT_TRUE(oversize.decide(1, 1).ok()) << "the agent refuses it: see proto::max_reply_bytes";
}

TEST(Faults, OmitsUnimplementedRpcs) {
  FaultyMock mock(R"({"unimplemented": ["SendPlayerType"]})");
  EXPECT_EQ(mock.send_player_type().error_code(), grpc::StatusCode::UNIMPLEMENTED);
  EXPECT_TRUE(mock.decide(1, 1).ok());
}

TEST(Faults, FailsAllCallsAfterCrash) {
  FaultyMock mock(R"({"crash_at_cycle": 5})");
  EXPECT_TRUE(mock.decide(1, 4).ok());
  EXPECT_EQ(mock.decide(1, 5).error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(mock.send_player_type().error_code(), grpc::StatusCode::UNAVAILABLE);
}

TEST(Faults, HandlesOtherCallsWhileHanging) {
  FaultyMock mock(R"({"hang_at_cycle": 5})");
  EXPECT_TRUE(mock.decide(1, 4).ok());
  EXPECT_EQ(mock.decide(1, 6, 0, milliseconds(30)).error_code(),
            grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_TRUE(mock.send_player_type().ok());
}

TEST(Faults, RestartedMockKnowsOnlyReregisteredAgents) {
  FaultyMock mock(R"({"restart_at_cycle": 5, "restart_cycles": 2})");
  const int before = mock.register_agent(1);
  EXPECT_TRUE(mock.decide(1, 4, before).ok());
  EXPECT_EQ(mock.decide(1, 6, before).error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(mock.decide(1, 7, before).error_code(), grpc::StatusCode::UNKNOWN);
  const int after = mock.register_agent(1);
  EXPECT_TRUE(mock.decide(1, 8, after).ok());
}

TEST(Faults, WrongClientIdIsEqualForAllAgents) {
  FaultyMock mock(R"({"wrong_client_id": true})");
  EXPECT_EQ(mock.register_agent(4), mock.register_agent(9));
  EXPECT_EQ(mock.registered_unum, 1);
}

TEST(Faults, SlowStartDelaysFirstReply) {
  FaultyMock mock(R"({"slow_start_ms": 80})");
  const auto start = std::chrono::steady_clock::now();
  mock.register_agent(1);
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(60));
}

TEST(Faults, DrawsFromSeedUnumAndCycle) {
  const auto fates = [](std::uint64_t seed) {
    Faults faults;
    faults.error = 0.3;
    faults.jitter_ms = 50;
    faults.seed = seed;

    std::string text;
    for (int cycle = 0; cycle < 200; ++cycle) {
      protos::State state;
      state.mutable_register_response()->set_uniform_number(2);
      state.mutable_world_model()->set_cycle(cycle);
      const Fault fault = draw_fault(faults, proto::Rpc::kGetPlayerActions, state);
      text += fault.what == Fault::What::kError ? 'e' : '.';
      EXPECT_LE(fault.delay_ms, 50);
    }

    return text;
  };

  EXPECT_EQ(fates(1), fates(1));
  EXPECT_NE(fates(1), fates(2));

  const std::string text = fates(1);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(text, 'e')), 60.0, 25.0);
}

TEST(Faults, ApplyOnlyToGivenCyclesAndUnums) {
  Faults faults;
  faults.drop = 1.0;
  faults.cycles = CycleRange{10, 20, 1};
  faults.unums = {4};

  const auto dropped = [&](int unum, int cycle) {
    protos::State state;
    state.mutable_register_response()->set_uniform_number(unum);
    state.mutable_world_model()->set_cycle(cycle);
    return draw_fault(faults, proto::Rpc::kGetPlayerActions, state).what == Fault::What::kHang;
  };

  EXPECT_TRUE(dropped(4, 10));
  EXPECT_TRUE(dropped(4, 20));
  EXPECT_FALSE(dropped(4, 21));
  EXPECT_FALSE(dropped(5, 10));
}

TEST(Faults, ReportsErrorsWithLocation) {
  const auto error = [](const std::string& text) {
    const base::JsonDocument json = *base::JsonDocument::parse("f.json", text);
    const auto faults = parse_faults(base::JsonValue(json));
    return faults ? "" : faults.error().message;
  };
  EXPECT_EQ(error(R"({"delay": 3})"),
            "f.json:1: /delay: unknown key 'delay'; did you mean 'delay_ms'?");
  EXPECT_EQ(error(R"({"drop": 2})"), "f.json:1: /drop: 2 is not within 0 to 1");
  EXPECT_EQ(error(R"({"status": "UNAVAILABEL"})"),
            "f.json:1: /status: unknown 'UNAVAILABEL'; did you mean 'UNAVAILABLE'?");
}

}  // namespace
}  // namespace cls::mock_server
