// Situations of a book in a world without clients.
#include "match/hooks/situation_run.h"

#include <gtest/gtest.h>

#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "soccer/commands/player_command.h"
#include "soccer/math.h"

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
    if (situation.kind == analysis::SituationClass::kSetPlay)
      situation.mode = PlayMode::kKickInLeft;
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
  for (const Side side : {Side::kLeft, Side::kRight}) {
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

TEST(SituationRun, GivesThePlayersTheExactMomentAfterItsSteps) {
  const analysis::Book book = rolling_ball();
  World world = full_world(book);
  SituationRun run(book, 5, 4, kCycles);
  Events events;
  run.arrange(world, events);
  const auto situations = analysis::situations_of(book, 5, 4);
  for (int step = 1; step <= kWarmUp; ++step) {
    dash_all(world, events);
    simulator::step(world, events);
    run.after_step(world, events);
    EXPECT_EQ(world.ball.position, (soccer::Vec2{static_cast<double>(step), -30.0}));
    EXPECT_EQ(world.players[6].command_done, step < kWarmUp);
  }
  EXPECT_EQ(world.mode, situations.front()->mode);
  const simulator::Player& player = world.players[4];
  EXPECT_EQ(player.position, (soccer::Vec2{-12.0, 5.0}));
  EXPECT_EQ(player.velocity, (soccer::Vec2{0.1, 0.0}));
  EXPECT_DOUBLE_EQ(player.body, soccer::math::to_radians(45.0));
  EXPECT_EQ(player.type, 1);
  EXPECT_DOUBLE_EQ(player.stamina.value, 3004.0);
  EXPECT_DOUBLE_EQ(player.stamina.capacity, 100'000.0);
  // The goalie of the right team has the place of number 1, and number 1 that of the goalie.
  EXPECT_DOUBLE_EQ(world.player(Side::kRight, 3).position.x, 2.0);
  EXPECT_DOUBLE_EQ(world.player(Side::kRight, 1).position.x, 6.0);
}

TEST(SituationRun, PlaysAllSituationsWithTheirCycles) {
  const analysis::Book book = rolling_ball();
  World world = full_world(book);
  SituationRun run(book, 5, 4, kCycles);
  Events events;
  run.arrange(world, events);
  int steps = 0;
  constexpr int kTooMany = 1000;
  while (run.after_cycle({}) && ++steps < kTooMany) {
    simulator::step(world, events);
    run.after_step(world, events);
    events.clear();
  }
  EXPECT_EQ(steps, 4 * (kWarmUp + kCycles));
  const BookResult result = run.result();
  ASSERT_EQ(result.situations.size(), 4);
  double sum = 0.0;
  for (const SituationResult& one : result.situations) {
    EXPECT_EQ(one.cycles, kCycles);
    EXPECT_EQ(one.log, "match.rcg");
    sum += one.value;
  }
  EXPECT_DOUBLE_EQ(result.value, sum / 4);
}

TEST(SituationRun, EndsASituationWithAGoal) {
  analysis::Book book = rolling_ball();
  for (analysis::Situation& situation : book.situations) {
    situation.mode = PlayMode::kPlayOn;
    for (analysis::BookFrame& frame : situation.frames) {
      frame.ball = {50.0, 0.0};
      frame.ball_velocity = {2.5, 0.0};
    }
  }
  World world = full_world(book);
  SituationRun run(book, 5, 2, kCycles);
  Events events;
  run.arrange(world, events);
  for (int step = 0; step < 2 * (kWarmUp + kCycles) && run.after_cycle({}); ++step) {
    simulator::step(world, events);
    run.after_step(world, events);
  }
  const BookResult result = run.result();
  ASSERT_EQ(result.situations.size(), 2);
  for (const SituationResult& one : result.situations) {
    EXPECT_DOUBLE_EQ(one.figures.at("goals"), 1.0);
    EXPECT_LT(one.cycles, kCycles);
    EXPECT_GT(one.value, 0.0);
  }
  EXPECT_EQ(world.team(Side::kLeft).score, 2);
}

}  // namespace
}  // namespace cls::match
