// Phases, touches, owners, shots and goals in scripted matches.
#include "analysis/play/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/analysis/plays.h"
#include "tests/gamelog/recorded_match.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

TEST(Flow, FindsTouchesWithContactAndLaunch) {
  ScriptedMatch match;
  match.kick(left(5), {1.0, 0.5});
  match.steps(2);
  match.tackle(right(7), {-2.0, 0.0});
  const Flow flow = build_flow(match.record());

  ASSERT_EQ(flow.touches.size(), 2u);
  EXPECT_EQ(flow.touches[0].frame, 1u);
  EXPECT_EQ(flow.touches[0].slot, left(5));
  EXPECT_EQ(flow.touches[0].kind, TouchKind::kKick);
  EXPECT_EQ(flow.touches[0].contact, (Vec2{0, 0}));
  EXPECT_EQ(flow.touches[0].launch, (Vec2{1.0, 0.5}));
  EXPECT_EQ(flow.touches[1].slot, right(7));
  EXPECT_EQ(flow.touches[1].kind, TouchKind::kTackle);
  EXPECT_EQ(flow.owner, (std::vector<std::int8_t>{kNoPlayer, left(5), left(5), left(5), right(7)}));
}

TEST(Flow, CountsOnlyTacklesAndCatchesThatHitTheBall) {
  ScriptedMatch match;
  miss_ball(match, left(2));
  match.step();
  catch_ball(match, right(1));
  match.player(right(1)).state |= gamelog::kStateCatchFailed;
  match.step();
  catch_ball(match, right(1));
  match.step();
  const Flow flow = build_flow(match.record());
  ASSERT_EQ(flow.touches.size(), 2u);
  EXPECT_EQ(flow.touches[0].kind, TouchKind::kPunch);
  EXPECT_EQ(flow.touches[1].kind, TouchKind::kCatch);
}

TEST(Flow, AssignsTouchToNearestPlayerUnlessContested) {
  ScriptedMatch match;
  match.player(left(3)).position = {0.5, 0};
  match.player(left(4)).position = {0.2, 0};
  match.step();
  ++match.player(left(3)).counts.kick;
  match.kick(left(4), {1, 0});
  ++match.player(left(4)).counts.kick;
  match.kick(right(9), {1, 0});
  const Flow flow = build_flow(match.record());

  ASSERT_EQ(flow.touches.size(), 2u);
  EXPECT_EQ(flow.touches[0].slot, left(4));
  EXPECT_TRUE(flow.touches[1].contested());
  EXPECT_EQ(flow.touches[1].nearest[0], left(4));
  EXPECT_EQ(flow.touches[1].nearest[1], right(9));
  EXPECT_EQ(flow.owner.back(), kNoPlayer);
}

TEST(Flow, ResetsOwnerAtStoppagesAndNumbersLivePhases) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.mode(PlayMode::kKickInRight);
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.kick(right(2), {1, 0});
  match.step();
  const Flow flow = build_flow(match.record());
  EXPECT_EQ(flow.live_phase, (std::vector<std::int32_t>{0, 0, -1, 1, 1}));
  EXPECT_EQ(flow.owner,
            (std::vector<std::int8_t>{kNoPlayer, left(5), kNoPlayer, right(2), right(2)}));
  EXPECT_EQ(flow.touches[1].live_phase, 1);
}

TEST(Flow, AssignsGoalKickToFollowingLivePhase) {
  ScriptedMatch match;
  match.mode(PlayMode::kGoalKickLeft);
  match.step();
  match.kick(left(1), {1, 0});
  match.kick(left(2), {1, 0});  // still within the penalty area
  match.steps(3);
  match.mode(PlayMode::kPlayOn);
  match.step();
  match.kick(left(5), {1, 0});
  const auto [flow, shots, passes, carries, goals] = Play(match);

  ASSERT_EQ(flow.touches.size(), 3u);
  EXPECT_EQ(flow.touches[0].live_phase, -1);
  EXPECT_EQ(flow.touches[1].live_phase, 1);
  EXPECT_EQ(flow.touches[2].live_phase, 1);
  EXPECT_EQ(flow.owner[7], left(2));
  ASSERT_EQ(passes.size(), 2u);
  EXPECT_TRUE(passes[0].completed());
  EXPECT_EQ(passes[0].passer, left(2));
}

TEST(Flow, DropBallStartsNewLivePhase) {
  ScriptedMatch match;
  kick_from(match, {-51.9, 11.2}, right(9), {-0.05, 0.01});
  ++match.player(right(9)).counts.kick;  // and the referee drops the ball at the corner of the area
  match.place_ball({-36.0, 20.16});
  match.steps(3);
  match.kick(right(7), {1.0, 0.0});
  const auto [flow, shots, passes, carries, goals] = Play(match);

  ASSERT_EQ(flow.touches.size(), 3u);
  EXPECT_EQ(flow.placed, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(flow.touches[1].live_phase, 1);
  EXPECT_EQ(flow.touches[2].live_phase, 2);
  EXPECT_EQ(flow.owner[2], right(9));
  EXPECT_EQ(flow.owner[3], kNoPlayer);
  EXPECT_EQ(flow.end_of_play(flow.touches[1]), 3u);
  ASSERT_EQ(passes.size(), 1u);  // the ball did not move from the first player to the second
  EXPECT_EQ(passes[0].passer, right(7));
}

TEST(Flow, DetectsDropBallByAbruptStop) {
  ScriptedMatch match;
  match.kick(left(10), {0.06, 0.1});
  match.place_ball(match.next().ball_position);
  match.step();
  match.kick(left(10), {5e-4, 0.0});
  match.place_ball(match.next().ball_position);
  match.step();
  EXPECT_EQ(build_flow(match.record()).placed, std::vector<std::uint32_t>{2});
}

TEST(Flow, RestartsWhenAnotherMatchBegins) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.next().time = 0;
  match.kick(left(6), {1, 0});
  EXPECT_EQ(build_flow(match.record()).touches.size(), 1u);
}

TEST(Flow, UsesVelocityWhenRefereeMovedBall) {
  ScriptedMatch match;
  match.kick(left(5), {2, 0});
  match.next().ball_position = {30, 20};
  ++match.player(left(6)).counts.kick;
  match.next().ball_velocity = {0.94, 0};
  match.step();
  const Flow flow = build_flow(match.record());
  ASSERT_EQ(flow.touches.size(), 2u);
  EXPECT_NEAR(flow.touches[1].launch.x, 0.94, 1e-6);
}

// A shot from (40, 0) that crosses the line at y = 3 after six cycles.
void shoot(ScriptedMatch& match, int slot) {
  const double side = soccer::sign(soccer::side_of_slot(slot));
  kick_from(match, {40.0 * side, 0.0}, slot, {2.5 * side, 0.6 * side});
}

TEST(Shots, CreditsGoalToShooter) {
  for (const int shooter : {left(9), right(9)}) {
    ScriptedMatch match;
    shoot(match, shooter);
    match.steps(5);
    const Side side = shooter == left(9) ? Side::kLeft : Side::kRight;
    score_goal(match, side);
    const auto [flow, shots, passes, carries, goals] = Play(match);

    ASSERT_EQ(shots.size(), 1u);
    EXPECT_EQ(shots[0].slot, shooter);
    EXPECT_TRUE(shots[0].on_target);
    EXPECT_EQ(shots[0].outcome, ShotOutcome::kGoal);
    EXPECT_NEAR(shots[0].distance, 12.5, 1e-9);
    EXPECT_NEAR(shots[0].goal_y, 3.0, 1e-6);
    EXPECT_NEAR(shots[0].cycles, 5.77, 0.01);  // ln(1 - 12.5 * 0.06 / 2.5) / ln(0.94)
    ASSERT_EQ(goals.size(), 1u);
    EXPECT_EQ(goals[0].scorer, shooter);
    EXPECT_EQ(goals[0].side, side);
    EXPECT_FALSE(goals[0].own_goal);
    EXPECT_EQ(goals[0].shot, 0);
    EXPECT_EQ(goals[0].cycle, match.record().time[goals[0].frame]);
  }
}

TEST(Shots, ClassifiesSavedBlockedAndWide) {
  ScriptedMatch saved;
  shoot(saved, left(9));
  saved.step();
  catch_ball(saved, right(1));
  saved.step();

  EXPECT_EQ(Play(saved).shots.at(0).outcome, ShotOutcome::kSaved);

  ScriptedMatch blocked;
  shoot(blocked, left(9));
  blocked.step();
  blocked.kick(right(3), {-1, 0});

  EXPECT_EQ(Play(blocked).shots.at(0).outcome, ShotOutcome::kBlocked);

  ScriptedMatch wide;
  kick_from(wide, {40, 0}, left(9), {2.5, 1.6});
  wide.steps(4);
  wide.mode(PlayMode::kGoalKickRight);
  wide.step();
  const auto shots = Play(wide).shots;

  EXPECT_EQ(shots.at(0).outcome, ShotOutcome::kWide);
  EXPECT_FALSE(shots[0].on_target);
}

TEST(Shots, IsNoShotWhenTeammateOrShooterTouchesNext) {
  ScriptedMatch dribble;
  shoot(dribble, left(9));
  dribble.kick(left(9), {0.5, 0});
  dribble.steps(3);
  EXPECT_TRUE(Play(dribble).shots.empty());

  ScriptedMatch pass;
  shoot(pass, left(9));
  pass.steps(3);
  pass.kick(left(10), {-1, 0});
  EXPECT_TRUE(Play(pass).shots.empty());
}

TEST(Shots, IsNoShotWhenTooFarTooSlowOrWide) {
  using Case = std::pair<Vec2, Vec2>;
  for (const auto& [from, launch] : {Case{{10, 0}, {3, 0}}, Case{{40, 0}, {0.7, 0}},
                                     Case{{40, 0}, {2.5, 2.4}}, Case{{40, 0}, {-2.5, 0}}}) {
    ScriptedMatch match;
    kick_from(match, from, left(9), launch);
    match.steps(4);
    EXPECT_TRUE(Play(match).shots.empty()) << from.x << " " << launch.x;
  }
}

TEST(Goals, CreditsDeflectedShotToShooter) {
  ScriptedMatch match;
  shoot(match, left(9));
  match.step();
  match.tackle(right(1), {1.5, 0.4});
  match.steps(4);
  score_goal(match, Side::kLeft);
  const Play play(match);
  ASSERT_EQ(play.shots.size(), 1u);
  EXPECT_EQ(play.shots[0].outcome, ShotOutcome::kGoal);
  EXPECT_EQ(play.goals.at(0).scorer, left(9));
}

TEST(Goals, CountsOwnGoalOfLastToucher) {
  ScriptedMatch match;
  match.kick(left(9), {1, 0});
  kick_from(match, {45, 0}, right(4), {2.5, 0});
  match.steps(2);
  score_goal(match, Side::kLeft);
  const auto goals = Play(match).goals;
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_EQ(goals[0].side, Side::kLeft);
  EXPECT_EQ(goals[0].scorer, right(4));
  EXPECT_TRUE(goals[0].own_goal);
  EXPECT_EQ(goals[0].shot, -1);
}

TEST(Goals, HasNoScorerWhenTrainerSetsScore) {
  ScriptedMatch match;
  match.score(0, 2);
  match.step();
  const auto goals = Play(match).goals;
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[0].scorer, kNoPlayer);
}

TEST(Goals, MatchShotsInRcssserverLogs) {
  for (const auto& [name, expected] :
       {std::pair("helios-vs-helios-full", 4), std::pair("cyrus-vs-helios-full", 6)}) {
    const auto path = tests::data("logs/" + std::string(name) + ".rcg.gz");
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    const auto record = gamelog::read_rcg_file(path->string());

    ASSERT_TRUE(record);

    const Flow flow = build_flow(*record);
    const auto shots = find_shots(flow);
    const auto goals = find_goals(flow, shots);

    ASSERT_EQ(std::ssize(goals), expected) << name;

    std::set<int> used;
    for (const Goal& goal : goals) {
      EXPECT_GE(goal.shot, 0) << goal.cycle;
      EXPECT_TRUE(used.insert(goal.shot).second);
    }

    EXPECT_EQ(std::ranges::count(shots, ShotOutcome::kGoal, &Shot::outcome), expected) << name;
  }
}

// Every kick in the counters was sent at the clock of the frame before.
void expect_kicks_in_text_log(const gamelog::MatchRecord& record, const gamelog::RclRecord& text) {
  std::set<std::tuple<int, int, int>> asked;
  for (const gamelog::RclLine& line : text.lines) {
    if (line.source != gamelog::RclSource::kPlayer) continue;
    gamelog::CommandCursor cursor(text.text_of(line));
    gamelog::LoggedCommand command;
    while (cursor.next(command)) {
      if (command.kind == gamelog::CommandKind::kKick) {
        asked.insert({line.time, line.stopped, line.team * 11 + line.unum - 1});
      }
    }
  }
  int kicks = 0;
  for (const Touch& touch : build_flow(record).touches) {
    if (touch.kind != TouchKind::kKick || touch.contested()) continue;
    ++kicks;
    const std::size_t before = touch.frame - 1;

    ASSERT_EQ(asked.count({record.time[before], record.stopped[before], touch.slot}), 1u)
        << record.time[before];
  }

  EXPECT_GT(kicks, 10);
}

TEST(Flow, MatchesKicksInTextLog) {
  const auto text = gamelog::read_rcl_file(tests::fixture("gamelog/match-start.rcl.gz").string());
  ASSERT_TRUE(text);
  expect_kicks_in_text_log(tests::record_of("match-start"), *text);
}

}  // namespace
}  // namespace cls::analysis
