// Expectations about the calls that a mock receives.
#include "mock-server/script/expectations.h"

#include <gtest/gtest.h>

#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

Expectations expecting(const std::string& text) {
  const base::JsonDocument json = *base::JsonDocument::parse("s.json", text);
  auto list = parse_expectations(base::JsonValue(json));
  EXPECT_TRUE(list) << list.error().message;
  return Expectations(list ? *list : std::vector<Expectation>());
}

protos::State state(int unum, int cycle) {
  protos::State state;
  state.mutable_register_response()->set_team_name("Reds");
  state.mutable_register_response()->set_uniform_number(unum);
  state.mutable_world_model()->set_cycle(cycle);
  return state;
}

protos::PlayerType type_for(int unum) {
  protos::PlayerType type;
  type.mutable_register_response()->set_team_name("Reds");
  type.mutable_register_response()->set_uniform_number(unum);
  return type;
}

using Lines = std::vector<std::string>;

TEST(Expectations, CountsCallsInTotalAndPerAgent) {
  Expectations all = expecting(
      "[{\"rpc\": \"SendPlayerType\", \"count\": 3},\n"
      " {\"rpc\": \"SendPlayerType\", \"count_per_agent\": {\">=\": 2}, \"name\": \"types\"}]");
  for (const int unum : {1, 1, 2}) all.add(proto::Rpc::kSendPlayerType, type_for(unum));
  EXPECT_EQ(all.failures(),
            Lines{"expected (types): 1 calls of SendPlayerType by Reds player 2, not >= 2"});
  all.add(proto::Rpc::kSendPlayerType, type_for(2));
  EXPECT_EQ(all.failures(), Lines{"expected (line 1): 4 calls of SendPlayerType, not == 3"});
}

TEST(Expectations, CountsZeroForAgentsWithoutTheCall) {
  Expectations types = expecting(R"([{"rpc": "SendPlayerType", "count_per_agent": 18}])");
  EXPECT_EQ(types.failures(), Lines{"expected (line 1): no agent called"});
  types.add(proto::Rpc::kGetPlayerActions, state(4, 1));
  EXPECT_EQ(types.failures(),
            Lines{"expected (line 1): 0 calls of SendPlayerType by Reds player 4, not == 18"});
}

TEST(Expectations, FiltersByWhen) {
  Expectations late = expecting(
      R"([{"rpc": "GetPlayerActions", "when": {"cycle": [10, 20], "unum": 7}, "count": 1}])");
  late.add(proto::Rpc::kGetPlayerActions, state(7, 9));
  late.add(proto::Rpc::kGetPlayerActions, state(8, 10));
  EXPECT_EQ(late.failures().size(), 1u);
  late.add(proto::Rpc::kGetPlayerActions, state(7, 10));
  EXPECT_TRUE(late.failures().empty());
}

TEST(Expectations, ReportsEarliestFailingCall) {
  Expectations always =
      expecting(R"([{"rpc": "GetPlayerActions", "always": {"world_model.cycle": {"<": 5}}}])");
  for (const auto& [unum, cycle] : {std::pair{3, 9}, {2, 7}, {1, 7}, {1, 4}}) {
    always.add(proto::Rpc::kGetPlayerActions, state(unum, cycle));
  }
  EXPECT_EQ(always.failures(),
            Lines{"expected (line 1): GetPlayerActions of Reds player 1 at cycle 7: "
                  "world_model.cycle is 7, not < 5 (3 calls in all)"});
}

TEST(Expectations, ChecksOrderPerAgent) {
  Expectations order =
      expecting(R"([{"order": ["Register", "SendPlayerType", "GetPlayerActions"]}])");
  protos::RegisterRequest hello;
  hello.set_team_name("Reds");
  hello.set_uniform_number(1);
  order.add(proto::Rpc::kRegister, hello);
  for (int i = 0; i < 18; ++i) order.add(proto::Rpc::kSendPlayerType, type_for(1));
  order.add(proto::Rpc::kGetPlayerActions, state(1, 0));

  EXPECT_TRUE(order.failures().empty());

  order.add(proto::Rpc::kGetPlayerActions, state(2, 0));
  EXPECT_EQ(order.failures(),
            Lines{"expected (line 1): Reds player 2 called GetPlayerActions, not Register, "
                  "SendPlayerType, GetPlayerActions"});
}

TEST(Expectations, ReportsErrorsWithLocation) {
  const auto error = [](const std::string& text) {
    const base::JsonDocument json = *base::JsonDocument::parse("s.json", text);
    const auto list = parse_expectations(base::JsonValue(json));
    return list ? "" : list.error().message;
  };
  EXPECT_EQ(error(R"([{"rpc": "GetPlayerAction", "count": 1}])"),
            "s.json:1: /0/rpc: unknown 'GetPlayerAction'; did you mean 'GetPlayerActions'?");
  EXPECT_EQ(error(R"([{"rpc": "Register"}])"),
            "s.json:1: /0: needs \"count\", \"count_per_agent\" or \"always\"");
  EXPECT_EQ(error(R"([{"rpc": "Register", "when": {"cycle": 1}, "count": 1}])"),
            "s.json:1: /0/when/cycle: Register has no cycle");
}

}  // namespace
}  // namespace cls::mock_server
