// One call per team and cycle: negotiation, replies of single agents, reconnection.
#include "proxy/playmaker/batch_playmaker.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/index.h"
#include "proto/team_playmaker.pb.h"
#include "proxy/playmaker/tensor_codec.h"

namespace cls::proxy {
namespace {

using namespace std::chrono_literals;
using google::protobuf::Message;
using proto::Rpc;
namespace wire = cls::playmaker::v1;

constexpr RpcTimeout kPatience = 10s;

/// The reply of a Playmaker to one call, made by agent or team.
struct Answer {
  RpcStatus status;
  std::unique_ptr<Message> message;
};

/// The connection below a BatchPlaymaker: replies immediately, and notes the calls.
class FakeConnection : public Playmaker {
 public:
  std::function<Answer(int agent, Rpc rpc, const Message& request)> answer;
  std::vector<std::string> calls;  ///< "0 GetTeamActions"
  bool lost = false;
  RpcTimeout timeout{};           ///< of the last call that was begun
  bool waited_for_ready = false;  ///< whether that call waits for the connection

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout call_timeout,
             bool wait_for_ready) override {
    timeout = call_timeout;
    waited_for_ready = wait_for_ready;
    replies_.push_back(call(agent, rpc, request, call_timeout));
  }
  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout) override {
    calls.push_back(std::to_string(agent) + " " + std::string(name(rpc)));
    Answer answered = answer(agent, rpc, request);
    Reply reply;
    reply.agent = agent;
    reply.rpc = rpc;
    reply.status = answered.status;
    kept_.push_back(std::move(answered.message));
    if (reply.status.ok()) reply.message = kept_.back().get();
    return reply;
  }
  bool take_connection_loss(int) override { return std::exchange(lost, false); }
  std::optional<Reply> next_reply() override {
    if (replies_.empty()) return std::nullopt;
    Reply reply = replies_.front();
    replies_.pop_front();
    return reply;
  }
  std::optional<Reply> next_reply_within(std::chrono::microseconds) override {
    return next_reply();
  }
  void cancel() override {}

 private:
  std::deque<Reply> replies_;
  std::vector<std::unique_ptr<Message>> kept_;
};

template <typename T>
Answer reply_with(T message) {
  return {{}, std::make_unique<T>(std::move(message))};
}

wire::AgentReply& add_reply(int agent, const Message& message,
                            google::protobuf::RepeatedPtrField<wire::AgentReply>& replies) {
  wire::AgentReply& reply = *replies.Add();
  reply.set_agent(agent);
  reply.set_message(message.SerializeAsString());
  return reply;
}

protos::PlayerActions dash_of(int agent) {
  protos::PlayerActions actions;
  actions.add_actions()->mutable_dash()->set_power(static_cast<float>(agent));
  return actions;
}

/// A Playmaker with both services; client ids are 100 + agent.
Answer answer_as_team(int agent, Rpc rpc, const Message& request) {
  if (rpc == Rpc::kRegisterTeam) {
    wire::RegisterTeamResponse response;
    response.set_version(1);
    for (const auto& one : static_cast<const wire::RegisterTeamRequest&>(request).agents()) {
      protos::RegisterResponse identity;
      identity.set_client_id(100 + one.agent());
      add_reply(one.agent(), identity, *response.mutable_agents());
    }
    return reply_with(response);
  }

  if (rpc == Rpc::kGetTeamActions) {
    wire::GetTeamActionsResponse response;
    for (const auto& one : static_cast<const wire::GetTeamActionsRequest&>(request).agents()) {
      add_reply(one.agent(), dash_of(one.agent()), *response.mutable_agents());
    }
    return reply_with(response);
  }

  if (rpc == Rpc::kGetBestPlannerActions) {
    wire::GetBestPlannerActionsResponse response;
    for (const auto& one :
         static_cast<const wire::GetBestPlannerActionsRequest&>(request).agents()) {
      protos::BestPlannerActionResponse choice;
      choice.set_index(one.agent());
      add_reply(one.agent(), choice, *response.mutable_agents());
    }
    return reply_with(response);
  }

  if (rpc == Rpc::kUnregisterTeam) return reply_with(wire::UnregisterTeamResponse());
  if (rpc == Rpc::kRegister) {
    protos::RegisterResponse identity;
    identity.set_client_id(agent);
    return reply_with(identity);
  }

  if (rpc == Rpc::kGetPlayerActions) return reply_with(dash_of(agent));
  return reply_with(protos::Empty());
}

RpcStatus failure(RpcOutcome outcome) { return {outcome, 0, "broken"}; }

class BatchPlaymakerTest : public testing::Test {
 protected:
  BatchPlaymakerTest() { connection_->answer = answer_as_team; }

  Playmaker& playmaker(BatchMode mode = BatchMode::kAuto) {
    if (playmaker_ == nullptr) {
      playmaker_ = make_batch_playmaker(std::move(owned_), mode);
      TeamRegistration team;
      for (const int agent : {1, 2, 12}) team.agents.emplace_back(agent, registration(agent));
      team.parameters = std::make_shared<player::MatchParameters>();
      playmaker_->announce_team(std::move(team));
    }
    return *playmaker_;
  }

  static protos::RegisterRequest registration(int agent) {
    protos::RegisterRequest request;
    request.set_uniform_number(agent);
    return request;
  }

  Reply register_agent(int agent) {
    return playmaker().call(agent, Rpc::kRegister, registration(agent), kPatience);
  }
  void register_all() {
    for (const int agent : {1, 2, 12}) ASSERT_TRUE(register_agent(agent).status.ok());
  }
  void begin_decision(int agent) {
    protos::State state;
    state.mutable_world_model()->set_cycle(7);
    playmaker().begin(agent, agent == 12 ? Rpc::kGetCoachActions : Rpc::kGetPlayerActions, state,
                      kPatience);
  }
  std::vector<Reply> replies() {
    std::vector<Reply> all;
    while (std::optional<Reply> reply = playmaker().next_reply()) all.push_back(*reply);
    return all;
  }
  /// Begins the decisions of these agents and takes the replies.
  std::vector<Reply> decide(std::initializer_list<int> agents) {
    for (const int agent : agents) begin_decision(agent);
    return replies();
  }

  /// Changes the reply to a call of the team.
  template <typename Response, typename Alter>
  void alter(Rpc altered, Alter alter_response) {
    connection_->answer = [=](int agent, Rpc rpc, const Message& request) {
      Answer answer = answer_as_team(agent, rpc, request);
      if (rpc == altered) alter_response(static_cast<Response&>(*answer.message));
      return answer;
    };
  }
  template <typename Alter>
  void alter_registration(Alter alter_response) {
    alter<wire::RegisterTeamResponse>(Rpc::kRegisterTeam, alter_response);
  }
  template <typename Alter>
  void alter_actions(Alter alter_response) {
    alter<wire::GetTeamActionsResponse>(Rpc::kGetTeamActions, alter_response);
  }
  /// Stores the latest request of this RPC.
  void capture(Rpc captured, Message& sent) {
    connection_->answer = [=, &sent](int agent, Rpc rpc, const Message& request) {
      if (rpc == captured) sent.CopyFrom(request);
      return answer_as_team(agent, rpc, request);
    };
  }
  void fail_all(RpcOutcome outcome) {
    connection_->answer = [=](int, Rpc, const Message&) {
      return Answer{failure(outcome), nullptr};
    };
  }
  /// Fails the calls of the team, but not those of its agents.
  void fail_team(RpcOutcome outcome) {
    connection_->answer = [=](int agent, Rpc rpc, const Message& request) {
      return agent == kTeamNumber ? Answer{failure(outcome), nullptr}
                                  : answer_as_team(agent, rpc, request);
    };
  }

  std::unique_ptr<FakeConnection> owned_ = std::make_unique<FakeConnection>();
  FakeConnection* connection_ = owned_.get();
  std::unique_ptr<Playmaker> playmaker_;
};

TEST_F(BatchPlaymakerTest, RegistersTeamWithOneCall) {
  for (const int agent : {1, 2, 12}) {
    const Reply reply = register_agent(agent);
    ASSERT_NE(reply.as<protos::RegisterResponse>(), nullptr);
    EXPECT_EQ(reply.as<protos::RegisterResponse>()->client_id(), 100 + agent);
    EXPECT_TRUE(playmaker()
                    .call(agent, Rpc::kSendServerParams, protos::ServerParam(), kPatience)
                    .status.ok());
    EXPECT_TRUE(playmaker()
                    .call(agent, Rpc::kSendInitMessage, protos::InitMessage(), kPatience)
                    .status.ok());
  }

  EXPECT_EQ(connection_->calls, std::vector<std::string>{"0 RegisterTeam"});
}

TEST_F(BatchPlaymakerTest, RegistrationCarriesParametersOnce) {
  wire::RegisterTeamRequest sent;
  capture(Rpc::kRegisterTeam, sent);
  auto parameters = std::make_shared<player::MatchParameters>();
  parameters->server.half_time = 77;
  parameters->types.resize(3);
  playmaker().announce_team({{{4, registration(4)}}, parameters});
  register_agent(4);

  EXPECT_EQ(sent.version(), 1);

  protos::ServerParam server;
  ASSERT_TRUE(server.ParseFromString(sent.server_params()));
  EXPECT_EQ(server.half_time(), 77);
  EXPECT_FALSE(server.has_register_response());
  EXPECT_EQ(sent.player_types_size(), 3);

  protos::RegisterRequest agent;
  ASSERT_TRUE(agent.ParseFromString(sent.agents(0).message()));
  EXPECT_EQ(agent.uniform_number(), 4);
}

TEST_F(BatchPlaymakerTest, SendsDecisionsOfCycleAsOneCall) {
  register_all();
  wire::GetTeamActionsRequest sent;
  capture(Rpc::kGetTeamActions, sent);
  for (const int agent : {1, 2, 12}) begin_decision(agent);
  playmaker().send();
  const std::vector<Reply> all = replies();

  EXPECT_EQ(connection_->calls.back(), "0 GetTeamActions");
  EXPECT_EQ(sent.cycle(), 7);
  EXPECT_EQ(sent.sequence(), 1U);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].agent, 1);
  EXPECT_EQ(all[0].rpc, Rpc::kGetPlayerActions);
  EXPECT_EQ(all[1].as<protos::PlayerActions>()->actions(0).dash().power(), 2);
  EXPECT_EQ(all[2].agent, 12);
  EXPECT_NE(all[2].as<protos::CoachActions>(), nullptr);
}

TEST_F(BatchPlaymakerTest, SendsStatesInTheEncodingThatThePlaymakerChose) {
  protos::State state;
  protos::Player& mate = *state.mutable_world_model()->add_teammates();
  mate.set_uniform_number(5);
  (*state.mutable_world_model()->mutable_our_players_dict())[5] = mate;

  for (const wire::Encoding chosen : {wire::LEAN_STATES, wire::STATES}) {
    protos::State received;
    connection_->answer = [&](int agent, Rpc rpc, const Message& request) {
      Answer answer = answer_as_team(agent, rpc, request);
      if (rpc == Rpc::kRegisterTeam) {
        const auto& offered = static_cast<const wire::RegisterTeamRequest&>(request).encodings();
        EXPECT_EQ(std::vector<int>(offered.begin(), offered.end()),
                  (std::vector<int>{wire::STATES, wire::LEAN_STATES}));
        static_cast<wire::RegisterTeamResponse&>(*answer.message).set_encoding(chosen);
      }

      if (rpc == Rpc::kGetTeamActions) {
        const auto& sent = static_cast<const wire::GetTeamActionsRequest&>(request);
        EXPECT_TRUE(received.ParseFromString(sent.agents(0).message()));
      }

      return answer;
    };
    register_all();
    playmaker().begin(1, Rpc::kGetPlayerActions, state, kPatience);
    EXPECT_EQ(replies().size(), 1U);
    EXPECT_EQ(received.world_model().teammates_size(), 1);
    EXPECT_EQ(received.world_model().our_players_dict_size(), chosen == wire::STATES ? 1 : 0);
  }
}

TEST_F(BatchPlaymakerTest, SendsPlannerChoicesOfCycleAsOneCall) {
  register_all();
  for (const int agent : {1, 2}) {
    playmaker().begin(agent, Rpc::kGetBestPlannerAction, protos::BestPlannerActionRequest(),
                      kPatience);
  }
  const std::vector<Reply> all = replies();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].as<protos::BestPlannerActionResponse>()->index(), 2);
  EXPECT_EQ(connection_->calls.size(), 2U);
}

TEST_F(BatchPlaymakerTest, OnlyAgentsThatReplyLacksMissTheirDecision) {
  register_all();
  alter_actions([](auto& response) { response.mutable_agents()->DeleteSubrange(0, 1); });
  const std::vector<Reply> all = decide({1, 2});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].agent, 1);
  EXPECT_EQ(all[0].status.outcome, RpcOutcome::kDeadline);
  EXPECT_EQ(all[0].status.message, "GetTeamActions: the reply lacks player 1");
  EXPECT_TRUE(all[1].status.ok());
}

TEST_F(BatchPlaymakerTest, ErrorOfOneAgentConcernsThatAgentOnly) {
  register_all();
  alter_actions([](auto& response) {
    response.mutable_agents(0)->set_code(2);
    response.mutable_agents(0)->set_error("my brain\nhurts");
    response.mutable_agents(1)->set_message("\xff\xff");
  });
  const std::vector<Reply> all = decide({1, 2, 12});

  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].status.outcome, RpcOutcome::kError);
  EXPECT_EQ(all[0].status.message, "GetPlayerActions: my brain hurts");
  EXPECT_EQ(all[1].status.outcome, RpcOutcome::kProtocolError);
  EXPECT_TRUE(all[2].status.ok());
}

TEST_F(BatchPlaymakerTest, IgnoresSecondRepliesAndRepliesOfOthersWithWarning) {
  register_all();
  alter_actions([](auto& response) { *response.add_agents() = response.agents(0); });
  EXPECT_EQ(decide({1}).size(), 1U);
  EXPECT_EQ(playmaker().take_warning(), "GetTeamActions: another reply for player 1, ignored");
  alter_actions([](auto& response) { response.add_agents()->set_agent(-5); });
  EXPECT_EQ(decide({1}).size(), 1U);
  EXPECT_EQ(playmaker().take_warning(), "GetTeamActions: a reply for player -5, who was not asked");
  EXPECT_EQ(playmaker().take_warning(), "");
}

TEST_F(BatchPlaymakerTest, FailureOfCallConcernsAllItsAgents) {
  register_all();
  fail_all(RpcOutcome::kDeadline);
  const std::vector<Reply> all = decide({1, 2});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].status.outcome, RpcOutcome::kDeadline);
  EXPECT_EQ(all[1].rpc, Rpc::kGetPlayerActions);
  EXPECT_EQ(all[1].status.message, "broken");
}

TEST_F(BatchPlaymakerTest, PlaymakerWithoutServiceGetsCallsOfAgentsWithoutWarning) {
  fail_team(RpcOutcome::kUnimplemented);
  register_all();
  for (const int agent : {1, 2}) begin_decision(agent);
  playmaker().send();

  EXPECT_EQ(replies().size(), 2U);
  EXPECT_EQ(playmaker().take_warning(), "");

  const std::vector<std::string> expected = {"0 RegisterTeam",     "1 Register",
                                             "2 Register",         "12 Register",
                                             "1 GetPlayerActions", "2 GetPlayerActions"};
  EXPECT_EQ(connection_->calls, expected);
}

TEST_F(BatchPlaymakerTest, OtherFailureOfRegistrationIsOneWarning) {
  fail_team(RpcOutcome::kError);
  register_all();
  EXPECT_EQ(playmaker().take_warning(), "the Playmaker decides for each agent alone: broken");
  EXPECT_EQ(connection_->calls.size(), 4U);
}

TEST_F(BatchPlaymakerTest, OtherVersionOfServiceIsOneWarning) {
  alter_registration([](auto& response) { response.set_version(2); });
  register_all();
  EXPECT_EQ(playmaker().take_warning(),
            "the Playmaker decides for each agent alone: it speaks version 2 of TeamPlaymaker, "
            "not 1");
}

TEST_F(BatchPlaymakerTest, EncodingThatWasNotOfferedIsOneWarning) {
  alter_registration([](auto& response) { response.set_encoding(wire::TENSOR); });
  register_all();
  EXPECT_EQ(playmaker().take_warning(),
            "the Playmaker decides for each agent alone: it chose encoding 2, which was not "
            "offered");
}

/// One feature, the uniform number; a row is the power of a dash.
class NumberCodec : public TensorCodec {
 public:
  std::shared_ptr<TensorCodec> clone() const override { return std::make_shared<NumberCodec>(); }
  std::vector<std::string> feature_sets() const override { return {"number/1"}; }
  std::vector<std::string> action_sets() const override { return {"dash/1"}; }
  base::Result<TensorSizes> choose(const TensorChoice&) override { return TensorSizes{1, 0, 1}; }
  void encode(const player::WorldModel& world, std::vector<float>& features,
              std::vector<std::uint8_t>&) override {
    features.push_back(static_cast<float>(world.unum));
  }
  std::optional<soccer::PlayerCommand> decode(const player::WorldModel&,
                                              const float* row) override {
    if (row[0] < 0.0F) return std::nullopt;
    return soccer::Dash{static_cast<double>(row[0]), 0.0};
  }
};

TEST_F(BatchPlaymakerTest, SendsRowsOfPlayersAndHandsOutRowsOrReplies) {
  playmaker();
  std::array<player::WorldModel, 4> worlds;
  for (std::size_t i = 0; i < worlds.size(); ++i) worlds[i].unum = static_cast<int>(i);
  TeamRegistration team;
  for (const int agent : {1, 2, 3, 12}) team.agents.emplace_back(agent, registration(agent));
  team.parameters = std::make_shared<player::MatchParameters>();
  team.codec = std::make_shared<NumberCodec>();
  team.world_of = [&](int agent) -> const player::WorldModel& {
    return worlds.at(base::index(agent));
  };
  playmaker().announce_team(std::move(team));
  wire::GetTeamActionsRequest sent;

  connection_->answer = [&](int agent, Rpc rpc, const Message& request) {
    Answer answer = answer_as_team(agent, rpc, request);
    if (rpc == Rpc::kRegisterTeam) {
      static_cast<wire::RegisterTeamResponse&>(*answer.message).set_encoding(wire::TENSOR);
    }

    if (rpc == Rpc::kGetTeamActions) {
      sent.CopyFrom(request);
      auto& response = static_cast<wire::GetTeamActionsResponse&>(*answer.message);
      response.mutable_agents()->DeleteSubrange(0, 1);  // player 1 has its row alone
      response.mutable_agents()->DeleteSubrange(1, 1);  // and so has player 3
      const std::array<float, 3> rows = {40.0F, 50.0F, -1.0F};
      response.mutable_actions()->add_shape(3);
      response.mutable_actions()->add_shape(1);
      response.mutable_actions()->set_data(
          std::string(reinterpret_cast<const char*>(rows.data()), sizeof rows));
    }

    return answer;
  };

  register_all();
  const std::vector<Reply> all = decide({1, 2, 3, 12});

  ASSERT_EQ(sent.agents_size(), 4);
  EXPECT_TRUE(sent.agents(0).message().empty());
  EXPECT_FALSE(sent.agents(3).message().empty()) << "the coach has a State";
  EXPECT_EQ(sent.features().shape(0), 3);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].as<protos::PlayerActions>()->actions(0).dash().power(), 40.0F);
  EXPECT_EQ(all[1].as<protos::PlayerActions>()->actions(0).dash().power(), 2.0F)
      << "a reply replaces the row";
  EXPECT_EQ(all[2].status.message, "GetTeamActions: the row of player 3 is not an action");
  EXPECT_NE(all[3].as<protos::CoachActions>(), nullptr);
}

TEST_F(BatchPlaymakerTest, PlaymakerThatLeavesRegistrationUnansweredIsAskedForEachAgent) {
  fail_team(RpcOutcome::kDeadline);
  register_all();
  EXPECT_EQ(playmaker().take_warning(), "the Playmaker decides for each agent alone: broken");
}

TEST_F(BatchPlaymakerTest, RequiredServiceThatIsMissingIsAnError) {
  fail_all(RpcOutcome::kUnimplemented);
  playmaker(BatchMode::kRequired);
  const Reply reply = register_agent(1);
  EXPECT_EQ(reply.status.outcome, RpcOutcome::kError);
  EXPECT_EQ(reply.status.message, "it does not implement TeamPlaymaker");
}

TEST_F(BatchPlaymakerTest, UnreachablePlaymakerIsNotAskedForAgents) {
  fail_all(RpcOutcome::kUnavailable);
  EXPECT_EQ(register_agent(1).status.outcome, RpcOutcome::kUnavailable);
  EXPECT_EQ(connection_->calls, std::vector<std::string>{"0 RegisterTeam"});
}

TEST_F(BatchPlaymakerTest, ConnectionLossConcernsAllAgentsWhoRegisterAgainTogether) {
  register_all();
  connection_->lost = true;
  for (const int agent : {1, 2, 12}) {
    EXPECT_TRUE(playmaker().take_connection_loss(agent));
    EXPECT_FALSE(playmaker().take_connection_loss(agent));
    playmaker().begin(agent, Rpc::kRegister, registration(agent), kPatience);
  }

  playmaker().send();
  const std::vector<Reply> all = replies();

  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].rpc, Rpc::kRegister);
  EXPECT_EQ(all[1].as<protos::RegisterResponse>()->client_id(), 102);
  EXPECT_EQ(connection_->calls.size(), 2U);
}

TEST_F(BatchPlaymakerTest, WaitsForConnectionOnlyAsLongAsAgentsThatWait) {
  register_all();
  const std::vector<std::pair<int, RpcTimeout>> waiting = {{1, 5ms}, {2, 20s}, {12, 3ms}};
  for (const auto& [agent, timeout] : waiting) {
    const bool wait = agent != 2;
    playmaker().begin(agent, Rpc::kRegister, registration(agent), timeout, wait);
  }
  playmaker().send();
  EXPECT_TRUE(connection_->waited_for_ready);
  EXPECT_EQ(connection_->timeout, 5ms);
}

TEST_F(BatchPlaymakerTest, PlaymakerRestartedWithoutServiceGetsCallsOfAgents) {
  register_all();
  fail_team(RpcOutcome::kUnimplemented);
  for (const int agent : {1, 2}) {
    playmaker().begin(agent, Rpc::kRegister, registration(agent), kPatience);
  }
  const std::vector<Reply> all = replies();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].as<protos::RegisterResponse>()->client_id(), 2);
}

TEST_F(BatchPlaymakerTest, SaysGoodbyeOnceWithAllIdentities) {
  register_all();
  wire::UnregisterTeamRequest sent;
  capture(Rpc::kUnregisterTeam, sent);

  for (const int agent : {1, 2, 12}) {
    EXPECT_TRUE(playmaker()
                    .call(agent, Rpc::kSendByeCommand, protos::RegisterResponse(), kPatience)
                    .status.ok());
  }
  EXPECT_EQ(connection_->calls.size(), 2U);
  ASSERT_EQ(sent.agents_size(), 3);

  protos::RegisterResponse identity;
  ASSERT_TRUE(identity.ParseFromString(sent.agents(2).message()));
  EXPECT_EQ(identity.client_id(), 112);
}

TEST(BatchMode, NamesParse) {
  EXPECT_EQ(parse_batch_mode("auto"), BatchMode::kAuto);
  EXPECT_EQ(parse_batch_mode("never"), BatchMode::kOff);
  EXPECT_EQ(parse_batch_mode("always"), BatchMode::kRequired);
  EXPECT_EQ(parse_batch_mode("Always"), std::nullopt);
}

}  // namespace
}  // namespace cls::proxy
