// The action set "options": what an agent may choose, and that choices of the planner are its play.
#include "player/options/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/index.h"
#include "tests/support/known_pitch.h"
#include "tests/training/stage.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

std::string config_with(const std::string& more) {
  return R"({"task": "Match", "obs": "world_model", "actions": "options", "features": "team",)"
         R"( "expert": "planner", "opponent": "planner")" +
         more + "}";
}

/// A match of the option agents.
class OptionMatch : public BoundPool {
 public:
  explicit OptionMatch(const std::string& more = "") : BoundPool(config_with(more), 7) {}

  bool legal(std::size_t agent, int id) const {
    return action_masks[agent * ids + base::index(id)] != 0;
  }
  bool chooses_with_ball(std::size_t agent) const { return !legal(agent, player::kAutoOption); }

  /// The expert's choice where it has one, with the ball or everywhere.
  void follow_expert(bool everywhere) {
    for (std::size_t agent = 0; agent < agents; ++agent) {
      const bool follows = expert[agent] >= 0 && (everywhere || chooses_with_ball(agent));
      action_ids[agent] = follows ? expert[agent] : player::kAutoOption;
    }
  }
  void step_once() { ASSERT_EQ(step(), CLS_TRAINING_OK) << cls_training_error(); }
};

TEST(Options, KeepTheirNumbers) {
  const std::vector<training::Action>& actions = training::option_actions().actions;
  ASSERT_EQ(actions.size(), 84U);
  for (const auto& [id, name] : {std::pair{0, "auto"},
                                 {1, "shoot"},
                                 {5, "dribble_0"},
                                 {21, "pass_1_feet"},
                                 {60, "pass_10_cross"},
                                 {61, "tackle"},
                                 {67, "home"},
                                 {68, "home_4_0"},
                                 {83, "home_10_7"}}) {
    EXPECT_EQ(actions[base::index(id)].name, name);
  }
}

TEST(Options, HaveTextsForReaders) {
  EXPECT_EQ(player::option_text(player::kLayOffOption), "lay off");
  EXPECT_EQ(player::option_text(player::kDribbleOption), "dribble -180 deg");
  EXPECT_EQ(player::option_text(player::kDribbleOption + 9), "dribble 22.5 deg");
  EXPECT_EQ(player::option_text(player::pass_option(7, player::PassKind::kThrough)),
            "through pass");
  EXPECT_EQ(player::option_text(player::move_option(player::MoveKind::kSupport)), "support");
  EXPECT_EQ(player::option_text(player::kOptionCount - 1), "home 10 m at 135 deg");
}

TEST(Options, LeadToTheirTargets) {
  KnownPitch pitch;
  pitch.place_self({0.0, 0.0});
  pitch.place_ball({0.4, 0.0});
  pitch.add_teammate(9, {12.0, 8.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {46.0, -30.0});
  player::OptionTable table;
  find_options(pitch.world, pitch.memory, table);
  ASSERT_EQ(table.choice, player::OptionTable::Choice::kWithBall);

  const auto to_9 = std::ranges::find_if(table.targets, [](const player::OptionTarget& target) {
    return target.action.target == 9 && target.id >= player::kPassOption;
  });
  ASSERT_NE(to_9, table.targets.end());
  const player::OptionAim pass = aim_of(pitch.world, table, to_9->id);
  EXPECT_EQ(pass.receiver, 9);
  EXPECT_EQ(pass.target, to_9->action.target_point);
  EXPECT_EQ(pass.room, to_9->room);

  const player::OptionAim ahead = aim_of(pitch.world, table, player::kDribbleOption + 8);
  EXPECT_EQ(ahead.receiver, 0);
  ASSERT_TRUE(ahead.target);
  EXPECT_GT(ahead.target->x, 1.0);
  EXPECT_FALSE(aim_of(pitch.world, table, player::kHoldOption).target);
}

TEST(Options, LeadWithoutTheBallToPlaces) {
  KnownPitch pitch;
  player::OptionTable table;
  find_options(pitch.world, pitch.memory, table);
  ASSERT_EQ(table.choice, player::OptionTable::Choice::kWithoutBall);
  const auto target = [&](int id) { return *aim_of(pitch.world, table, id).target; };
  EXPECT_EQ(target(player::kHomeOption), table.moves.home);
  EXPECT_NEAR(target(player::kShiftedHomeOption).x, table.moves.home.x - 4.0, 1e-9);
  EXPECT_FALSE(aim_of(pitch.world, table, player::kAutoOption).target);
}

TEST(Options, TheExpertChoosesWhatIsLegal) {
  OptionMatch match;
  std::set<int> chosen;
  std::size_t with_ball = 0;

  for (int cycle = 0; cycle < 600; ++cycle) {
    for (std::size_t agent = 0; agent < match.agents; ++agent) {
      const int expert = match.expert[agent];
      if (expert < 0) {
        const auto* mask = &match.action_masks[agent * match.ids];
        EXPECT_TRUE(match.legal(agent, player::kAutoOption));
        EXPECT_EQ(std::count(mask, mask + match.ids, 1), 1) << "nothing to choose";
        continue;
      }
      EXPECT_TRUE(match.legal(agent, expert)) << player::option_name(expert);
      EXPECT_EQ(match.chooses_with_ball(agent), expert < player::kMoveOption);
      with_ball += match.chooses_with_ball(agent) ? 1 : 0;
      chosen.insert(expert);
    }
    match.follow_expert(true);
    match.step_once();
  }
  EXPECT_GT(with_ball, 10U);
  EXPECT_GT(chosen.size(), 10U);
  EXPECT_EQ(std::ranges::count(match.illegal, 0), std::ssize(match.illegal));
}

// So a choice of a move is the same play as the skill that makes it.
TEST(Options, WithoutTheBallTheExpertIsBasicMove) {
  OptionMatch everywhere;
  OptionMatch with_ball;
  for (int cycle = 0; cycle < 300; ++cycle) {
    everywhere.follow_expert(true);
    with_ball.follow_expert(false);
    everywhere.step_once();
    with_ball.step_once();
    ASSERT_EQ(everywhere.outputs(), with_ball.outputs()) << "cycle " << cycle;
  }
}

TEST(Options, AChoiceThatIsNotLegalCountsOnce) {
  OptionMatch match(R"(, "frame_skip": 5)");
  std::fill(match.action_ids.begin(), match.action_ids.end(), player::kShootOption);
  match.step_once();
  for (const int illegal : match.illegal) EXPECT_EQ(illegal, 1);
}

TEST(Options, AStepUntilADecisionEndsAtAChoiceWithTheBall) {
  OptionMatch match(R"(, "frame_skip": 50, "until": "decision")");
  int choices = 0;
  for (int i = 0; i < 60; ++i) {
    match.follow_expert(false);
    const int before = match.cycles[0];
    match.step_once();
    bool any = false;
    for (std::size_t agent = 0; agent < match.agents; ++agent) {
      any = any || match.chooses_with_ball(agent);
    }
    choices += any && match.cycles[0] - before < 50 ? 1 : 0;
  }
  EXPECT_GT(choices, 5);
  EXPECT_EQ(std::ranges::count(match.illegal, 0), std::ssize(match.illegal));
}

TEST(Options, AForkContinuesWithTheSameBits) {
  OptionMatch match(R"(, "num_envs": 2)");
  const auto follow = [&match] {
    for (std::size_t row = 0; row < match.expert.size(); ++row) {
      match.action_ids[row] = std::max(0, match.expert[row]);
    }
    match.step_once();
  };
  for (int cycle = 0; cycle < 100; ++cycle) follow();
  ASSERT_EQ(cls_training_fork(match.handle, 0, 1), CLS_TRAINING_OK);
  for (int cycle = 0; cycle < 100; ++cycle) follow();
  const std::size_t half = match.observations.size() / 2;
  EXPECT_TRUE(std::equal(match.observations.begin(),
                         match.observations.begin() + std::ssize(match.observations) / 2,
                         match.observations.begin() + static_cast<std::ptrdiff_t>(half)));
}

TEST(Options, RefuseWhatTheyCannotBe) {
  const auto error_of = [](const std::string& config) {
    const auto parsed = training::parse_pool_config(config);
    return parsed ? std::string() : parsed.error().message;
  };
  EXPECT_THAT(error_of(R"({"task": "Match", "actions": "options"})"), HasSubstr("'world_model'"));
  EXPECT_THAT(error_of(R"({"task": "Match", "features": "team", "actions": "skills"})"),
              HasSubstr("needs the actions 'options'"));
  EXPECT_THAT(error_of(R"({"task": "Match", "expert": "planner", "actions": "skills"})"),
              HasSubstr("needs the actions 'options'"));
  EXPECT_THAT(error_of(config_with(R"(, "say": true)")), HasSubstr("by themselves"));
}

}  // namespace
}  // namespace cls::tests
