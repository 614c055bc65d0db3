// Decisions of a recorded match, and the moments that mattered.
#include "review/decisions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/review/recorded_start.h"

namespace cls::review {
namespace {

using soccer::Side;

using Decisions = RecordedStart;

TEST_F(Decisions, AreOfOneSideAndInOrder) {
  for (const Side side : soccer::kBothSides) {
    const std::vector<Decision> decisions = find_decisions(statistics_, side);
    ASSERT_GT(decisions.size(), 5U);
    for (std::size_t i = 0; i < decisions.size(); ++i) {
      EXPECT_EQ(soccer::side_of_slot(decisions[i].slot), side);
      EXPECT_GT(decisions[i].end, decisions[i].frame);
      EXPECT_EQ(decisions[i].cycle, record_.time[decisions[i].frame]);
      if (i == 0) continue;
      EXPECT_GE(decisions[i].frame, decisions[i - 1].end - 1);
    }
  }
}

TEST_F(Decisions, BeginBeforeTheKickAndEndWithIt) {
  for (const Decision& decision : find_decisions(statistics_, Side::kLeft)) {
    const auto slot = static_cast<std::size_t>(decision.slot);
    const auto kicks = [&](std::size_t frame) {
      return record_.players
          .counters[analysis::entry_of(frame, slot)][base::index(gamelog::Counter::kKick)];
    };
    EXPECT_GT(kicks(decision.frame + 1), kicks(decision.frame)) << decision.cycle;
    EXPECT_GT(kicks(decision.end), kicks(decision.end - 1)) << decision.cycle;
  }
}

TEST_F(Decisions, OfAGoalAreWorthOne) {
  bool found = false;
  for (const Decision& decision : find_decisions(statistics_, Side::kLeft)) {
    if (decision.kind != DecisionKind::kShot) continue;
    found = true;
    EXPECT_EQ(decision.after, 1.0);
    EXPECT_EQ(text_of(decision), "shot");
  }
  EXPECT_TRUE(found);
}

TEST_F(Decisions, ThatMatteredAreApart) {
  const std::vector<Decision> all = find_decisions(statistics_, Side::kRight);
  const std::vector<Decision> chosen = costliest(all, 3);
  ASSERT_FALSE(chosen.empty());
  for (const Decision& one : all) EXPECT_GE(chosen.front().lost(), one.lost());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(std::abs(chosen[i].cycle - chosen[k].cycle), kDecisionHorizon);
      EXPECT_LE(chosen[i].lost(), chosen[k].lost());
    }
  }
  EXPECT_TRUE(costliest(all, 0).empty());
}

TEST(DecisionText, NamesTheReceiverAndItsSide) {
  Decision pass{.slot = 3, .kind = DecisionKind::kPass, .receiver = 8};
  EXPECT_EQ(text_of(pass), "pass to 9");
  pass.receiver = 11;
  EXPECT_EQ(text_of(pass), "pass to their 1");
  pass.receiver = soccer::kNoPlayer;
  EXPECT_EQ(text_of(pass), "pass");
}

}  // namespace
}  // namespace cls::review
