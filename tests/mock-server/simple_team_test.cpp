// The simple team's decisions in plain situations.
#include "mock-server/behavior/simple_team.h"

#include <gtest/gtest.h>

#include "player/simple_team/play.h"
#include "player/simple_team/situation.h"

namespace cls::mock_server {
namespace {

using Case = protos::PlayerAction::ActionCase;

void place(protos::RpcVector2D& vector, double x, double y) {
  vector.set_x(static_cast<float>(x));
  vector.set_y(static_cast<float>(y));
}

// Player `unum` at a point, ball at another, no other player.
protos::State state_of(int unum, soccer::Vec2 self, soccer::Vec2 ball) {
  protos::State state;
  auto& world = *state.mutable_world_model();
  world.set_game_mode_type(protos::PlayOn);
  world.mutable_self()->set_uniform_number(unum);
  world.mutable_self()->set_is_goalie(unum == 1);
  world.mutable_self()->set_stamina(8000);
  place(*world.mutable_self()->mutable_position(), self.x, self.y);
  place(*world.mutable_ball()->mutable_position(), ball.x, ball.y);
  world.mutable_intercept_table()->set_self_reach_steps(10);
  world.set_offside_line_x(30.0F);
  return state;
}

protos::PlayerActions decide(const protos::State& state) {
  protos::PlayerActions actions;
  SimpleTeam().decide(state, actions);
  return actions;
}

const protos::PlayerAction* find(const protos::PlayerActions& actions, Case kind) {
  for (const auto& action : actions.actions()) {
    if (action.action_case() == kind) return &action;
  }
  return nullptr;
}

TEST(SimpleTeam, ShootsPastGoalieInFrontOfGoal) {
  protos::State state = state_of(11, {40, 0}, {40.4, 0});
  state.mutable_world_model()->mutable_self()->set_is_kickable(true);
  auto& goalie = *state.mutable_world_model()->add_opponents();
  place(*goalie.mutable_position(), 51, 1);
  const auto actions = decide(state);
  ASSERT_GT(actions.actions_size(), 0);
  ASSERT_EQ(actions.actions(0).action_case(), Case::kBodySmartKick);
  const auto& kick = actions.actions(0).body_smart_kick();
  EXPECT_FLOAT_EQ(kick.target_point().x(), 52.5F);
  EXPECT_LT(kick.target_point().y(), 0.0F);
  EXPECT_GT(kick.target_point().y(), -7.0F);
}

TEST(SimpleTeam, PassesToFreeTeammateWhenPressed) {
  protos::State state = state_of(6, {0, 0}, {0.4, 0});
  auto& world = *state.mutable_world_model();
  world.mutable_self()->set_is_kickable(true);
  auto& teammate = *world.add_teammates();
  teammate.set_uniform_number(9);
  place(*teammate.mutable_position(), 12, -10);
  auto& opponent = *world.add_opponents();
  place(*opponent.mutable_position(), 2, 1);
  const auto actions = decide(state);
  ASSERT_EQ(actions.actions(0).action_case(), Case::kBodySmartKick);
  EXPECT_NEAR(actions.actions(0).body_smart_kick().target_point().y(), -10.0, 0.5);
}

TEST(SimpleTeam, DoesNotPassThroughAnOpponent) {
  protos::State state = state_of(6, {0, 0}, {0.4, 0});
  auto& world = *state.mutable_world_model();
  world.mutable_self()->set_is_kickable(true);
  auto& teammate = *world.add_teammates();
  place(*teammate.mutable_position(), 12, -10);
  auto& opponent = *world.add_opponents();
  place(*opponent.mutable_position(), 3, -2.4);
  const auto actions = decide(state);
  EXPECT_EQ(find(actions, Case::kBodySmartKick), nullptr);
  EXPECT_NE(find(actions, Case::kBodyDribble), nullptr);
}

TEST(SimpleTeam, OnlyFastestPlayerIntercepts) {
  protos::State state = state_of(7, {0, -10}, {5, -5});
  EXPECT_NE(find(decide(state), Case::kBodyIntercept), nullptr);
  auto& table = *state.mutable_world_model()->mutable_intercept_table();
  table.set_first_teammate_reach_steps(4);
  table.set_first_teammate_id(3);
  const auto actions = decide(state);
  EXPECT_EQ(find(actions, Case::kBodyIntercept), nullptr);
  EXPECT_NE(find(actions, Case::kBodyGoToPoint), nullptr);
}

TEST(SimpleTeam, GoalieCatchesWhenCertain) {
  protos::State state = state_of(1, {-50, 0}, {-49, 0});
  state.mutable_world_model()->mutable_self()->set_catch_probability(1.0F);
  EXPECT_EQ(decide(state).actions(0).action_case(), Case::kCatch);
}

TEST(SimpleTeam, SearchesLostBall) {
  protos::State state = state_of(5, {0, 0}, {0, 0});
  state.mutable_world_model()->mutable_ball()->set_pos_count(1000);
  EXPECT_EQ(decide(state).actions(0).action_case(), Case::kBhvNeckBodyToBall);
}

TEST(SimpleTeam, NearestPlayerTakesSetPlayOthersStayAway) {
  protos::State state = state_of(8, {3, 20}, {5, 34});
  auto& world = *state.mutable_world_model();
  world.set_game_mode_type(protos::KickIn_);
  world.set_is_our_set_play(true);
  auto& teammate = *world.add_teammates();
  teammate.set_uniform_number(5);
  place(*teammate.mutable_position(), -10, 20);
  auto actions = decide(state);
  const auto* go = find(actions, Case::kBodyGoToPoint);
  ASSERT_NE(go, nullptr);
  EXPECT_NEAR(go->body_go_to_point().target_point().y(), 34.0, 1.0);

  place(*teammate.mutable_position(), 5, 33);
  actions = decide(state);
  go = find(actions, Case::kBodyGoToPoint);

  ASSERT_NE(go, nullptr);
  EXPECT_LT(go->body_go_to_point().target_point().y(), 25.0);
}

TEST(SimpleTeam, HomePositionIsOnsideAndOnPitch) {
  for (int unum = 1; unum <= 11; ++unum) {
    for (double x = -52; x <= 52; x += 8) {
      for (double y = -34; y <= 34; y += 8) {
        const protos::State state = state_of(unum, {0, 0}, {x, y});
        const soccer::Vec2 home = home_position(situation_of(state));
        EXPECT_LE(home.x, 30.0);
        EXPECT_LE(std::fabs(home.x), 52.5);
        EXPECT_LE(std::fabs(home.y), 34.0);
      }
    }
  }
}

TEST(SimpleTeam, GivesSameReplyForSameState) {
  protos::State state = state_of(6, {0, 0}, {0.4, 0});
  state.mutable_world_model()->mutable_self()->set_is_kickable(true);
  auto& teammate = *state.mutable_world_model()->add_teammates();
  place(*teammate.mutable_position(), 12, -10);
  EXPECT_EQ(decide(state).SerializeAsString(), decide(state).SerializeAsString());
}

TEST(SimpleTeam, RepliesToEmptyState) { EXPECT_GT(decide(protos::State()).actions_size(), 0); }

}  // namespace
}  // namespace cls::mock_server
