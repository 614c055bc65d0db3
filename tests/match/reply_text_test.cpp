// What the decision debugger shows of a policy.
#include "match/hooks/reply_text.h"

#include <gtest/gtest.h>

#include "player/options/option_ids.h"
#include "viewer/decisions/decision_plan.h"

namespace cls::match {
namespace {

TEST(PlanText, HasALineForEachOptionOfAPolicy) {
  player::PlanChoice choice;
  choice.weighed = {
      {player::kHoldOption, 0.25, false, {}},
      {player::kDribbleOption + 9, 0.00049, false, {0, soccer::Vec2{-12.345, 6.0}, 4.25}},
      {player::pass_option(3, player::PassKind::kCross),
       0.7495,
       true,
       {5, soccer::Vec2{40.0, -1.0}, 0.5}}};
  const std::string text = plan_text(choice);
  EXPECT_EQ(text,
            "- hold 25%\n"
            "- dribble 22.5 deg (-12.3, 6) 0% room 4.25\n"
            "* cross 5 (40, -1) 75% room 0.5\n");

  const auto read = viewer::considered_actions(text);
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].name, "cross");
  EXPECT_EQ(read[0].unum, 5);
  EXPECT_TRUE(read[0].chosen);
  EXPECT_EQ(read[2].room, 4.25);
}

TEST(PlanText, IsEmptyWithoutAChoice) { EXPECT_EQ(plan_text({}), ""); }

}  // namespace
}  // namespace cls::match
