// Fouls by tackles and their consequences (docs/spec/simulation-model.md 4.15, 9.10).
#include <gtest/gtest.h>

#include "simulator/rules/foul.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::FoulCall;
using simulator::Player;
namespace state = simulator::state;

// A referee that detects every foul; a victim that dashes with the ball, the tackler right behind.
class Foul : public ::testing::Test {
 protected:
  Foul()
      : stage([](auto& server) { server.foul_detect_probability = 1.0; }),
        tackler(stage.add(Side::kLeft, {0, 10})),
        victim(stage.add(Side::kRight, {0.8, 10})) {
    stage.place_ball({1.3, 10});
    victim.dash_cycles = 0;
    stage.world.overrides.emplace().tackle.recorded[0] = true;
  }

  FoulCall detect(bool foul = false) {
    stage.world.overrides.reset();
    return simulator::detect_foul(stage.world, tackler, foul);
  }

  Stage stage;
  Player& tackler;
  Player& victim;
};

TEST_F(Foul, DetectsChargeOnDashingVictim) { EXPECT_EQ(detect(), FoulCall::kCharge); }

TEST_F(Foul, DetectsNothingWithoutDashOfVictim) {
  victim.dash_cycles = -1;
  EXPECT_EQ(detect(), FoulCall::kNone);
}

TEST_F(Foul, DetectsNothingWhenBallIsCloser) {
  stage.place_ball({0.6, 10});
  EXPECT_EQ(detect(), FoulCall::kNone);
}

TEST_F(Foul, DetectsNothingWhenVictimIsBesidePath) {
  stage.place(victim, {0.7, 10.65});
  EXPECT_EQ(detect(), FoulCall::kNone);
}

TEST_F(Foul, DetectsNothingWhenVictimFacesTackler) {
  victim.body = soccer::math::to_radians(100);
  EXPECT_EQ(detect(), FoulCall::kNone);
}

TEST_F(Foul, DetectsNothingWhenVictimCannotKick) {
  stage.place_ball({2.5, 10});
  EXPECT_EQ(detect(), FoulCall::kNone);
}

TEST_F(Foul, IntentionalFoulBlocksVictimAndIsBooked) {
  EXPECT_EQ(detect(true), FoulCall::kYellow);
  EXPECT_EQ(victim.foul_cycles, 5);
  EXPECT_TRUE(victim.command_done);
  EXPECT_TRUE(victim.has(state::kFoulCharged));
  // Without a charge it is a foul without a card.
  victim.dash_cycles = -1;
  EXPECT_EQ(detect(true), FoulCall::kCharge);
}

TEST_F(Foul, LeadsToFreeKickForOpponents) {
  stage.command(tackler, "(tackle 0)");
  EXPECT_EQ(stage.take_calls(), Calls{"10 foul_charge_l"});
  expect_near(stage.world.ball.position, {0, 10});
  EXPECT_EQ(tackler.fouls, 1);
  EXPECT_EQ(tackler.tackle_cycles, 10);
  EXPECT_EQ(stage.step_until_mode_changes(), 31);
  EXPECT_EQ(stage.world.mode, PlayMode::kFreeKickRight);
}

TEST_F(Foul, LeadsToIndirectFreeKickInOwnPenaltyArea) {
  stage.place(tackler, {-49, 5});
  stage.place(victim, {-48.2, 5});
  stage.place_ball({-47.7, 5});
  stage.command(tackler, "(tackle 0)");
  EXPECT_EQ(stage.take_calls(), Calls{"10 foul_charge_l"});
  // From the front of the goal area.
  expect_near(stage.world.ball.position, {-47, 5});
  stage.step_until_mode_changes();
  EXPECT_EQ(stage.world.mode, PlayMode::kIndirectFreeKickRight);
}

TEST_F(Foul, IntentionalFoulDoesNotBlockTackler) {
  stage.command(tackler, "(tackle 0 on)");
  EXPECT_EQ(stage.take_calls(), (Calls{"10 foul_charge_l", "10 yellow_card_l_1"}));
  EXPECT_EQ(tackler.tackle_cycles, 0);
  EXPECT_TRUE(tackler.has(state::kYellowCard));
  stage.step(40);
  EXPECT_TRUE(tackler.has(state::kYellowCard));
}

TEST_F(Foul, SecondYellowCardIsRedCard) {
  tackler.cards = 1;
  tackler.state |= state::kYellowCard;
  stage.command(tackler, "(tackle 0 on)");
  EXPECT_EQ(stage.take_calls(),
            (Calls{"10 foul_charge_l", "10 yellow_card_l_1", "10 red_card_l_1"}));
  EXPECT_FALSE(tackler.enabled);
  EXPECT_EQ(tackler.state, state::kDiscard | state::kRedCard);
  expect_near(tackler.position, {-3, -37});
}

TEST_F(Foul, RedCardSendsPlayerOffImmediately) {
  stage.world.overrides->foul.recorded[0] = FoulCall::kRed;
  stage.command(tackler, "(tackle 0 on)");
  bool sent_off = false;
  for (const auto& event : stage.events) {
    if (const auto* off = std::get_if<simulator::SentOff>(&event.what)) {
      sent_off = off->slot == tackler.slot();
    }
  }
  EXPECT_TRUE(sent_off);
  EXPECT_FALSE(tackler.enabled);
}

TEST(IllegalDefense, IsCalledForTooManyDefendersForTooLong) {
  Stage stage([](auto& server) { server.illegal_defense_number = 3; });
  Player& attacker = stage.add(Side::kLeft, {30, 0});
  for (int i = 0; i < 3; ++i) stage.add(Side::kRight, {45, -5.0 + 5 * i});
  stage.place_ball({30.5, 0});
  stage.command(attacker, "(kick 1 0)");
  stage.take_calls();
  stage.step(19);
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
  stage.step();
  EXPECT_EQ(stage.take_calls(), Calls{"30 illegal_defense_r"});
  expect_near(stage.world.ball.position, {41.5, 0});
  stage.step_until_mode_changes();
  EXPECT_EQ(stage.world.mode, PlayMode::kFreeKickLeft);
}

}  // namespace
}  // namespace cls::tests
