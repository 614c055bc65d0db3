// Calls of a Playmaker in the same process.
#include "proxy/playmaker/direct_playmaker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "proto/status_name.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

/// Answers a State with a message to each agent that names its uniform number.
void echo(Rpc rpc, const Message& request, Message& reply) {
  if (rpc != Rpc::kGetPlayerActions) return;
  const auto& state = static_cast<const protos::State&>(request);
  static_cast<protos::PlayerActions&>(reply).add_actions()->mutable_dash()->set_power(
      static_cast<float>(state.register_response().uniform_number()));
}

protos::State state_of(int agent) {
  protos::State state;
  state.mutable_register_response()->set_uniform_number(agent);
  return state;
}

float dash_power(const Reply& reply) {
  const auto* actions = reply.as<protos::PlayerActions>();
  return actions == nullptr ? -1.0F : actions->actions(0).dash().power();
}

TEST(DirectPlaymaker, RepliesToRequestsAsTheyWereInTheOrderOfTheCalls) {
  const auto playmaker = make_direct_playmaker(echo);
  protos::State state = state_of(7);
  playmaker->begin(7, Rpc::kGetPlayerActions, state, kNoTimeout);
  state = state_of(3);  // the caller reuses its message
  playmaker->begin(3, Rpc::kGetPlayerActions, state, kNoTimeout);

  const std::optional<Reply> first = playmaker->next_reply();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->agent, 7);
  EXPECT_EQ(first->rpc, Rpc::kGetPlayerActions);
  EXPECT_TRUE(first->status.ok());
  EXPECT_EQ(dash_power(*first), 7.0F);

  // An agent may call again while the replies of others wait; their messages stay as they are.
  playmaker->begin(7, Rpc::kGetPlayerActions, state_of(70), kNoTimeout);
  const std::optional<Reply> second = playmaker->next_reply_within(std::chrono::microseconds(0));
  const std::optional<Reply> third = playmaker->next_reply();
  ASSERT_TRUE(second && third);
  EXPECT_EQ(second->agent, 3);
  EXPECT_EQ(dash_power(*second), 3.0F);
  EXPECT_EQ(third->agent, 7);
  EXPECT_EQ(dash_power(*third), 70.0F);
  EXPECT_FALSE(playmaker->next_reply());
  EXPECT_FALSE(playmaker->take_connection_loss(7));
}

TEST(DirectPlaymaker, RepliesWithTheStatusOfAHandlerThatFails) {
  const auto playmaker =
      make_fallible_playmaker([](Rpc rpc, const Message& request, Message& reply) -> RpcStatus {
        echo(rpc, request, reply);
        const int number =
            static_cast<const protos::State&>(request).register_response().uniform_number();
        return number == 3 ? rpc_status(rpc, proto::kStatusUnknown, "division by zero")
                           : RpcStatus{};
      });
  for (const int agent : {3, 4}) {
    playmaker->begin(agent, Rpc::kGetPlayerActions, state_of(agent), kNoTimeout);
  }

  const std::optional<Reply> failed = playmaker->next_reply();
  const std::optional<Reply> good = playmaker->next_reply();
  ASSERT_TRUE(failed && good);
  EXPECT_EQ(failed->status.outcome, RpcOutcome::kError);
  EXPECT_EQ(failed->status.message, "GetPlayerActions: division by zero");
  EXPECT_EQ(failed->message, nullptr);
  EXPECT_EQ(dash_power(*good), 4.0F);
}

TEST(DirectPlaymaker, FailsCallsAfterCancelExceptBye) {
  const auto playmaker = make_direct_playmaker(echo);
  playmaker->begin(1, Rpc::kGetPlayerActions, state_of(1), kNoTimeout);
  playmaker->cancel();
  EXPECT_TRUE(playmaker->next_reply()->status.ok());
  playmaker->begin(1, Rpc::kGetPlayerActions, state_of(1), kNoTimeout);
  const std::optional<Reply> cancelled = playmaker->next_reply();

  ASSERT_TRUE(cancelled);
  EXPECT_EQ(cancelled->status.outcome, RpcOutcome::kCancelled);
  EXPECT_EQ(cancelled->message, nullptr);

  const protos::RegisterResponse identity;
  EXPECT_EQ(
      playmaker->call(1, Rpc::kSendPlayerType, protos::PlayerType(), kNoTimeout).status.outcome,
      RpcOutcome::kCancelled);
  EXPECT_TRUE(playmaker->call(1, Rpc::kSendByeCommand, identity, kNoTimeout).status.ok());
}

}  // namespace
}  // namespace cls::proxy
