// Moments of a recorded match, played again.
#include "review/playouts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "base/index.h"
#include "gamelog/rcl/rcl_reader.h"
#include "review/alternatives.h"
#include "review/moment.h"
#include "tests/review/recorded_start.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"

namespace cls::review {
namespace {

using soccer::Side;
using testing::HasSubstr;
using tests::error_of;

class Playouts : public RecordedStart {
 protected:
  Playouts() {
    text_ = *gamelog::read_rcl_file(tests::fixture("gamelog/match-start.rcl.gz").string());
    setup_ = *setup_of(record_, {training::Driver::kPlanner, training::Driver::kPlanner});
    terms_.seeds = 4;
    terms_.cycles = 15;
  }

  // The decision of the left team at a cycle.
  Decision at(int cycle) const {
    for (const Decision& one : find_decisions(statistics_, Side::kLeft)) {
      if (one.cycle == cycle) return one;
    }
    ADD_FAILURE() << "no decision at " << cycle;
    return {};
  }

  simulator::TextLogIndex sent() const { return {text_, record_.final_teams()}; }

  base::Result<PlayedDecision> play(const Decision& decision) const {
    return play_again(setup_, statistics_.flow, sent(), decision, terms_);
  }

  gamelog::RclRecord text_;
  std::shared_ptr<const training::Setup> setup_;
  PlayoutTerms terms_;
};

TEST_F(Playouts, AreTheSameAgain) {
  const auto first = play(at(49));
  const auto second = play(at(49));
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_EQ(first->recorded, second->recorded);
  EXPECT_EQ(first->worths, second->worths);
  ASSERT_EQ(first->recorded.size(), 4U);
  ASSERT_EQ(first->worths.size(), first->alternatives.size());

  terms_.seed = 100;
  const auto other = play(at(49));
  ASSERT_TRUE(other);
  EXPECT_NE(first->recorded, other->recorded);
}

TEST_F(Playouts, HaveTheAlternativesThatThePlannerSees) {
  const auto played = play(at(49));
  ASSERT_TRUE(played);
  std::vector<std::string> texts;
  int planned = 0;
  for (const Alternative& one : played->alternatives) {
    texts.push_back(one.text);
    planned += one.planned ? 1 : 0;
  }
  EXPECT_THAT(texts, testing::IsSupersetOf({"hold", "clear"}));
  EXPECT_THAT(texts, testing::Contains(testing::StartsWith("pass to ")));
  EXPECT_EQ(planned, 1);
}

// Between the post and the goalie, where nobody else is in the way.
TEST_F(Playouts, ShootBesideTheGoalie) {
  const Decision shot = at(166);
  training::Start start = start_at(statistics_.flow, shot.frame);
  for (training::StartFrame& frame : start.frames) {
    frame.ball = {42.0, 0.0};
    frame.ball_velocity = {};
    training::StartPlayer& shooter = frame.players[base::index(shot.slot)];
    shooter.position = {41.5, 0.0};
    shooter.velocity = {};
    shooter.body = 0.0;
    frame.players[11].position = {51.0, 1.0};
    for (std::size_t slot = 12; slot < frame.players.size(); ++slot) {
      frame.players[slot].position.x = std::min(frame.players[slot].position.x, 20.0);
    }
  }

  training::Episode episode(setup_);
  episode.reset_at(1, setup_->options, start);
  const std::vector<Alternative> alternatives =
      alternatives_of(*episode.match_player(shot.slot), 9);
  const auto into_gap = std::ranges::find(alternatives, "shot", &Alternative::text);
  ASSERT_NE(into_gap, alternatives.end());
  EXPECT_LT(into_gap->target.y, -4.0);
  EXPECT_GT(into_gap->target.y, -record_.server.goal_width / 2.0);
}

// The noise of the server differs, the kick is that of the match.
TEST_F(Playouts, RepeatTheRecordedCommands) {
  const Decision shot = at(166);
  ASSERT_EQ(shot.kind, DecisionKind::kShot);
  EXPECT_TRUE(commands_sent(sent(), shot.slot, 100'000).empty());

  training::Episode episode(setup_);
  episode.reset_at(1, setup_->options, start_at(statistics_.flow, shot.frame));
  const std::function<void(training::MatchPlayer&)> as_recorded =
      [&](training::MatchPlayer& player) {
        player.senses.commands = commands_sent(sent(), shot.slot, shot.cycle);
      };
  episode.step_with({shot.slot, as_recorded});

  const soccer::Vec2 recorded = record_.ball_position[shot.end];
  EXPECT_GT(soccer::distance(record_.ball_position[shot.frame], recorded), 2.0);
  EXPECT_LT(soccer::distance(episode.world().ball.position, recorded), 0.3);
}

TEST_F(Playouts, SayWhyTheyCannot) {
  Decision early;
  early.frame = 3;
  EXPECT_THAT(error_of(play(early)), HasSubstr("play had just begun"));

  Decision without_ball = at(100);
  without_ball.slot = 1;
  EXPECT_THAT(error_of(play(without_ball)),
              HasSubstr("the player does not know that it has the ball"));

  gamelog::MatchRecord old = record_;
  old.version = gamelog::RcgVersion::kV3;
  EXPECT_THAT(why_not_played(old), HasSubstr("versions 1 to 3 lack the stamina"));
  EXPECT_EQ(why_not_played(record_), "");
}

}  // namespace
}  // namespace cls::review
