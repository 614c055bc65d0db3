// Situations of a book in a world without clients.
#include "match/hooks/situation_run.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "soccer/commands/player_command.h"
#include "soccer/math.h"
#include "soccer/per_side.h"

namespace cls::match {
namespace {

using simulator::Events;
using simulator::World;
using soccer::PlayMode;
using soccer::Side;

constexpr int kWarmUp = 3;
constexpr int kCycles = 20;

// One log with a situation of each class: the ball rolls to the right, players stand in a grid.
analysis::Book rolling_ball() {
  analysis::Book book;
  book.warm_up = kWarmUp;
  book.logs.push_back({"match.rcg", {"a", "b"}, std::vector<soccer::PlayerType>(2)});
  book.logs[0].types[1].player_speed_max = 0.9;

  for (std::size_t kind = 0; kind < analysis::kSituationClasses; ++kind) {
    analysis::Situation situation;
    situation.kind = static_cast<analysis::SituationClass>(kind);
    if (situation.kind == analysis::SituationClass::kSetPlay) {
      situation.mode = PlayMode::kKickInLeft;
    }
    for (std::size_t slot = 0; slot < situation.players.size(); ++slot) {
      situation.players[slot] = {slot == 4 ? 1 : 0, 3000.0 + static_cast<double>(slot), 0.9, 0.8,
                                 100'000.0};
    }

    for (int step = 0; step <= kWarmUp; ++step) {
      analysis::BookFrame frame;
      frame.ball = {static_cast<double>(step), -30.0};
      frame.ball_velocity = {1.0, 0.0};
      for (std::size_t slot = 0; slot < frame.players.size(); ++slot) {
        frame.players[slot] = {{2.0 * static_cast<double>(slot) - 20.0, 5.0}, {0.1, 0.0}, 45.0};
      }
      situation.frames.push_back(frame);
    }
    book.situations.push_back(situation);
  }
  return book;
}

World full_world(const analysis::Book& book) {
  soccer::PlayerParams player;
  player.player_types = 2;
  soccer::ServerParams server;
  server.ball_rand = server.player_rand = server.kick_rand = 0.0;
  const auto rules = simulator::make_rules(server, player, book.logs[0].types);

  EXPECT_TRUE(rules.ok());

  World world = simulator::make_world(*rules, 1);
  for (const Side side : soccer::kBothSides) {
    simulator::name_team(world, side, side == Side::kLeft ? "a" : "b");
    for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
      // The goalie of the right team is number 3.
      const bool goalie = unum == (side == Side::kLeft ? 1 : 3);
      EXPECT_TRUE(simulator::join(world, side, goalie, 19));
    }
  }
  return world;
}

void dash_all(World& world, Events& events) {
  for (simulator::Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    std::vector<soccer::PlayerCommand> commands;
    soccer::parse_player_commands("(dash 100)", commands);
    simulator::apply(world, slot, commands.front(), events);
  }
}

/// Plays situations of a book in a world without clients.
class SituationRunTest : public testing::Test {
 protected:
  void arrange(analysis::Book book, int situations) {
    book_ = std::move(book);
    world_ = full_world(book_);
    run_.emplace(book_, 5, situations, kCycles);
    run_->arrange(world_, events_);
  }
  void step() {
    simulator::step(world_, events_);
    run_->after_step(world_, events_);
  }
  // Plays up to `most` steps; returns how many there were.
  int play(int most) {
    int steps = 0;
    for (; steps < most && run_->after_cycle({}); ++steps) step();
    return steps;
  }

  analysis::Book book_;
  World world_;
  std::optional<SituationRun> run_;
  Events events_;
};

TEST_F(SituationRunTest, GivesThePlayersTheExactMomentAfterItsSteps) {
  arrange(rolling_ball(), 4);
  for (int step_number = 1; step_number <= kWarmUp; ++step_number) {
    dash_all(world_, events_);
    step();
    EXPECT_EQ(world_.ball.position, (soccer::Vec2{static_cast<double>(step_number), -30.0}));
    EXPECT_EQ(world_.players[6].command_done, step_number < kWarmUp);
  }

  EXPECT_EQ(world_.mode, analysis::situations_of(book_, 5, 4).front()->mode);
  const simulator::Player& player = world_.players[4];
  EXPECT_EQ(player.position, (soccer::Vec2{-12.0, 5.0}));
  EXPECT_EQ(player.velocity, (soccer::Vec2{0.1, 0.0}));
  EXPECT_DOUBLE_EQ(player.body, soccer::math::to_radians(45.0));
  EXPECT_EQ(player.type, 1);
  EXPECT_DOUBLE_EQ(player.stamina.value, 3004.0);
  EXPECT_DOUBLE_EQ(player.stamina.capacity, 100'000.0);

  // The goalie of the right team has the place of number 1, and number 1 that of the goalie.
  EXPECT_DOUBLE_EQ(world_.player(Side::kRight, 3).position.x, 2.0);
  EXPECT_DOUBLE_EQ(world_.player(Side::kRight, 1).position.x, 6.0);
}

TEST_F(SituationRunTest, PlaysAllSituationsWithTheirCycles) {
  arrange(rolling_ball(), 4);
  EXPECT_EQ(play(1000), 4 * (kWarmUp + kCycles));

  const BookResult result = run_->result();
  ASSERT_EQ(result.situations.size(), 4);
  double sum = 0.0;
  for (const SituationResult& one : result.situations) {
    EXPECT_EQ(one.cycles, kCycles);
    EXPECT_EQ(one.log, "match.rcg");
    sum += one.value;
  }
  EXPECT_DOUBLE_EQ(result.value, sum / 4);
}

TEST_F(SituationRunTest, PlaysAsManyCyclesWithoutWarmUp) {
  analysis::Book book = rolling_ball();
  book.warm_up = 0;
  for (analysis::Situation& situation : book.situations) situation.frames.resize(1);
  arrange(std::move(book), 2);
  EXPECT_EQ(play(1000), 2 * kCycles);
  EXPECT_EQ(run_->result().situations.at(1).cycles, kCycles);
}

TEST_F(SituationRunTest, EndsASituationWithAGoal) {
  analysis::Book book = rolling_ball();
  for (analysis::Situation& situation : book.situations) {
    situation.mode = PlayMode::kPlayOn;
    for (analysis::BookFrame& frame : situation.frames) {
      frame.ball = {50.0, 0.0};
      frame.ball_velocity = {2.5, 0.0};
    }
  }
  arrange(std::move(book), 2);
  play(2 * (kWarmUp + kCycles));

  const BookResult result = run_->result();
  ASSERT_EQ(result.situations.size(), 2);

  for (const SituationResult& one : result.situations) {
    EXPECT_DOUBLE_EQ(one.figures.at("goals"), 1.0);
    EXPECT_LT(one.cycles, kCycles);
    EXPECT_GT(one.value, 0.0);
  }
  EXPECT_EQ(world_.team(Side::kLeft).score, 2);
}

}  // namespace
}  // namespace cls::match
