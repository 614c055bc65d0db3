// The same replies as the example teams in other languages: fixtures/team, written by
// examples/vectors.py.
#include "mock-server/behavior/example_team.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "proto/lean_state.h"
#include "proto/rpc.h"
#include "proto/team_playmaker.pb.h"
#include "tests/support/files.h"

namespace cls::mock_server {
namespace {

namespace wire = cls::playmaker::v1;

constexpr int kFewestStates = 50;

template <typename Message>
Message read(const std::string& name) {
  Message message;
  std::ifstream file(tests::fixture("team/" + name), std::ios::binary);
  EXPECT_TRUE(file && message.ParseFromIstream(&file)) << name;
  return message;
}

template <typename Actions>
Actions parsed(const wire::AgentReply& reply) {
  Actions actions;
  EXPECT_EQ(reply.code(), 0) << reply.error();
  EXPECT_TRUE(actions.ParseFromString(reply.message()));
  return actions;
}

protos::State state_of(const wire::AgentMessage& call) {
  protos::State state;
  EXPECT_TRUE(state.ParseFromString(call.message()));
  proto::complete(state);
  return state;
}

void expect_reply(const wire::AgentMessage& call, const wire::AgentReply& expected) {
  const protos::State state = state_of(call);
  const ExampleTeam team(ExampleTeam::Defense::kAllMark);

  switch (proto::decision_of(call.agent())) {
    case proto::Rpc::kGetCoachActions: {
      protos::CoachActions actions;
      team.decide_as_coach(state, actions);
      EXPECT_EQ(actions.DebugString(), parsed<protos::CoachActions>(expected).DebugString());
      break;
    }
    case proto::Rpc::kGetTrainerActions: {
      protos::TrainerActions actions;
      team.decide_as_trainer(state, actions);
      EXPECT_EQ(actions.DebugString(), parsed<protos::TrainerActions>(expected).DebugString());
      break;
    }
    default: {
      protos::PlayerActions actions;
      team.decide(state, actions);
      EXPECT_EQ(actions.SerializeAsString(),
                parsed<protos::PlayerActions>(expected).SerializeAsString())
          << actions.DebugString() << "expected "
          << parsed<protos::PlayerActions>(expected).DebugString();
      break;
    }
  }
}

TEST(ExampleTeam, RepliesAsInOtherLanguages) {
  const auto request = read<wire::GetTeamActionsRequest>("states.bin");
  const auto expected = read<wire::GetTeamActionsResponse>("replies.bin");
  ASSERT_GE(request.agents_size(), kFewestStates);
  ASSERT_EQ(request.agents_size(), expected.agents_size());

  for (int index = 0; index < request.agents_size(); ++index) {
    SCOPED_TRACE("State " + std::to_string(index));
    EXPECT_EQ(request.agents(index).agent(), expected.agents(index).agent());
    expect_reply(request.agents(index), expected.agents(index));
  }
}

// The default team, mock:attack, differs in one point: only one player marks.
TEST(ExampleTeam, KeepsItsShapeIfOnlyOneMarks) {
  protos::State state;
  protos::WorldModel& world = *state.mutable_world_model();
  world.set_game_mode_type(protos::PlayOn);
  world.set_kickable_opponent_existance(true);
  world.mutable_intercept_table()->set_self_reach_steps(50);
  world.mutable_intercept_table()->set_first_teammate_id(5);
  world.mutable_intercept_table()->set_first_teammate_reach_steps(30);

  const auto marks = [&state](ExampleTeam::Defense defense) {
    protos::PlayerActions actions;
    ExampleTeam(defense).decide(state, actions);
    return actions.actions(0).has_helios_basic_move();
  };

  for (int unum = 2; unum <= 11; ++unum) {
    world.mutable_self()->set_uniform_number(unum);
    EXPECT_TRUE(marks(ExampleTeam::Defense::kAllMark)) << unum;
    EXPECT_EQ(marks(ExampleTeam::Defense::kOneMarks), unum == 2) << unum;
  }
}

TEST(ExampleTeam, RepliesToEmptyState) {
  protos::PlayerActions actions;
  ExampleTeam(ExampleTeam::Defense::kAllMark).decide(protos::State(), actions);
  EXPECT_GT(actions.actions_size(), 0);
}

}  // namespace
}  // namespace cls::mock_server
