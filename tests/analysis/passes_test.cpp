// Passes, carries, chains, assists, threat and the pass network in scripted matches.
#include "analysis/play/passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/measures/expected_goals.h"
#include "analysis/measures/pass_network.h"
#include "analysis/measures/threat.h"
#include "analysis/play/chains.h"
#include "tests/analysis/plays.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

std::vector<Pass> passes_in(const ScriptedMatch& match) { return Play(match).passes; }

TEST(Passes, MeasuresCompletedPassBetweenContacts) {
  for (const bool from_left : {true, false}) {
    ScriptedMatch match;
    const auto own = [&](int unum) { return from_left ? left(unum) : right(unum); };
    const double sign = from_left ? 1.0 : -1.0;
    match.kick(own(5), Vec2{1.0, 0.5} * sign);
    match.steps(3);
    match.kick(own(7), {0, 0});
    const auto passes = passes_in(match);

    ASSERT_GE(passes.size(), 1u);

    const Pass& pass = passes[0];
    EXPECT_TRUE(pass.completed());
    EXPECT_EQ(pass.passer, own(5));
    EXPECT_EQ(pass.receiver, own(7));
    EXPECT_EQ(pass.frames, 4u);

    const double way = 1.0 + 0.94 + 0.94 * 0.94 + 0.94 * 0.94 * 0.94;
    EXPECT_NEAR(pass.to.x, way, 1e-5);
    EXPECT_NEAR(pass.length(), way * std::sqrt(1.25), 1e-5);
    EXPECT_NEAR(pass.gain(), way, 1e-5);
    EXPECT_NEAR(pass.speed, std::sqrt(1.25), 1e-6);
    EXPECT_EQ(pass.direction, PassDirection::kForward);
  }
}

TEST(Passes, ClassifiesDirectionsFromTeamView) {
  using Case = std::pair<Vec2, PassDirection>;
  for (const auto& [launch, direction] :
       {Case{{1, 0.9}, PassDirection::kForward}, Case{{-1, 0.9}, PassDirection::kBack},
        Case{{0.1, -1}, PassDirection::kLeft}, Case{{0.1, 1}, PassDirection::kRight}}) {
    ScriptedMatch l;
    l.kick(left(5), launch);
    l.kick(left(6), {0, 0});
    EXPECT_EQ(passes_in(l).at(0).direction, direction);
    ScriptedMatch r;
    r.kick(right(5), launch * -1.0);
    r.kick(right(6), {0, 0});
    EXPECT_EQ(passes_in(r).at(0).direction, direction);
  }
}

TEST(Passes, ClassifiesIncompletePasses) {
  const auto outcome = [](auto follow) {
    ScriptedMatch match;
    match.kick(left(5), {1.5, 0});
    match.step();
    follow(match);
    match.step();
    const auto passes = passes_in(match);

    EXPECT_EQ(passes.size(), 1u);

    return passes.empty() ? PassOutcome::kCompleted : passes[0].outcome;
  };

  EXPECT_EQ(outcome([](ScriptedMatch& m) {
              m.tackle(right(5), {0, 0});
            }),
            PassOutcome::kIntercepted);
  EXPECT_EQ(outcome([](ScriptedMatch& m) {
              ++m.player(left(6)).counts.kick;
              m.kick(right(5), {0, 0});
            }),
            PassOutcome::kContested);
  EXPECT_EQ(outcome([](ScriptedMatch& m) { m.mode(PlayMode::kKickInRight); }), PassOutcome::kOut);
  EXPECT_EQ(outcome([](ScriptedMatch& m) { m.mode(PlayMode::kOffsideLeft); }),
            PassOutcome::kOffside);
  EXPECT_EQ(outcome([](ScriptedMatch& m) { m.mode(PlayMode::kFoulChargeLeft); }),
            PassOutcome::kStopped);
}

TEST(Passes, IgnoresReceptionFromOffsidePosition) {
  ScriptedMatch match;
  match.kick(left(5), {1.5, 0});
  match.mode(PlayMode::kOffsideLeft);
  match.kick(left(9), {0.5, 0});
  EXPECT_EQ(passes_in(match).at(0).outcome, PassOutcome::kOffside);
}

// As at a kick-off where two players stand at the ball.
TEST(Passes, IgnoresTeammatesWhoKickInTurn) {
  const auto passes = [](Vec2 mate, Vec2 launch, int steps) {
    ScriptedMatch match;
    match.player(left(6)).position = mate;
    match.step();
    match.kick(left(5), launch);
    match.steps(steps);
    match.kick(left(6), {0, 0});
    return passes_in(match).size();
  };

  EXPECT_EQ(passes({0.5, 0}, {0.1, 0}, 0), 0U);
  EXPECT_EQ(passes({0.5, 0}, {1.5, 0}, 3), 1U) << "moved further";
  EXPECT_EQ(passes({2.5, 0}, {0.8, 0}, 2), 1U) << "to a teammate who could not kick before";
}

TEST(Passes, IgnoresSoftTouchThatIsLost) {
  ScriptedMatch soft;
  soft.kick(left(5), {0.3, 0});
  soft.kick(right(5), {0, 0});
  EXPECT_TRUE(passes_in(soft).empty());
  ScriptedMatch far;
  far.kick(left(5), {0.5, 0});
  far.steps(10);  // 3.8 m
  far.kick(right(5), {0, 0});
  EXPECT_EQ(passes_in(far).size(), 1u);
}

TEST(Passes, EndsAtStoppage) {
  ScriptedMatch match;
  match.kick(left(5), {1.5, 0});
  match.mode(PlayMode::kKickInLeft);
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.kick(left(6), {1, 0});
  const auto passes = passes_in(match);
  ASSERT_EQ(passes.size(), 2u);
  EXPECT_EQ(passes[0].outcome, PassOutcome::kOut);
}

TEST(OffsideLine, UsesSecondLastOpponentBallOrHalfLine) {
  ScriptedMatch match;
  EXPECT_EQ(offside_line(match.record(), 0, 0), 40.0);

  match.place_ball({45, 0});
  match.step();
  EXPECT_EQ(offside_line(match.record(), 1, 0), 45.0);
  EXPECT_EQ(offside_line(match.record(), 1, 1), 40.0);

  for (int unum = 2; unum <= 11; ++unum) match.player(right(unum)).position.x = -5;
  match.place_ball({-30, 0});
  match.step();

  EXPECT_EQ(offside_line(match.record(), 2, 0), 0.0);

  // Disconnected players do not count.
  match.player(left(3)).state = 0;
  match.player(left(3)).position.x = -52;
  match.step();

  EXPECT_EQ(offside_line(match.record(), 3, 1), 40.0);
}

TEST(Passes, DetectsThroughPassBeyondOffsideLine) {
  const auto through = [](double receiver_x) {
    ScriptedMatch match;
    match.player(left(9)).position = {receiver_x, 0};
    kick_from(match, {30, 0}, left(8), {2.3, 2.2});
    match.steps(6);
    match.kick(left(9), {0, 0});
    return passes_in(match).at(0).through;
  };
  EXPECT_TRUE(through(39));
  EXPECT_FALSE(through(42));  // the receiver was offside
}

TEST(Passes, DetectsCrossesSwitchesAndCutbacks) {
  ScriptedMatch cross;
  kick_from(cross, {45, 30}, left(7), {-0.2, -2.8});
  cross.steps(7);
  cross.kick(left(9), {0, 0});
  const Pass pass = passes_in(cross).at(0);

  EXPECT_TRUE(pass.cross);
  EXPECT_TRUE(pass.cutback);
  EXPECT_FALSE(pass.switched);

  ScriptedMatch switched;
  kick_from(switched, {0, 25}, left(7), {0.5, -2.8});
  switched.steps(14);
  switched.kick(left(9), {0, 0});

  EXPECT_TRUE(passes_in(switched).at(0).switched);
}

TEST(Passes, CountsOvertakenOpponentsAndPressureOnReceiver) {
  ScriptedMatch match;
  match.player(right(5)).position = {3, 0};
  match.player(right(6)).position = {5, 1};
  match.player(left(9)).position = {10, 0};
  match.step();
  match.kick(left(5), {2, 0});
  match.steps(6);
  match.kick(left(9), {0, 0});
  const Pass pass = passes_in(match).at(0);
  EXPECT_EQ(pass.overtaken, 2);
  EXPECT_NEAR(pass.nearest_opponent, std::sqrt(26.0), 1e-5);
}

TEST(Passes, FindsOneTwos) {
  ScriptedMatch match;
  match.kick(left(5), {2, 0});
  match.steps(2);
  match.kick(left(6), {1.5, 0});
  match.steps(2);
  match.kick(left(5), {0, 0});
  const Play play(match);
  EXPECT_EQ(one_twos(play.flow, play.passes), (PerTeam<int>{1, 0}));
}

TEST(Carries, RequiresDashAndOneMeterForDribble) {
  const auto carry = [](bool dash, double speed) {
    ScriptedMatch match;
    match.kick(left(5), {speed, 0});
    if (dash) ++match.player(left(5)).counts.dash;
    match.step();
    match.kick(left(5), {0, 0});
    return Play(match).carries.at(0);
  };
  EXPECT_TRUE(carry(true, 0.6).dribble);
  EXPECT_NEAR(carry(true, 0.6).distance(), 0.6 * 1.94, 1e-6);
  EXPECT_FALSE(carry(false, 0.6).dribble);
  EXPECT_FALSE(carry(true, 0.4).dribble);
}

TEST(Carries, CountsTakeOns) {
  ScriptedMatch match;
  match.player(right(5)).position = {2, 0.5};
  match.player(right(6)).position = {2.5, 2.5};  // more than 3 m away
  match.player(right(7)).position = {2, -0.5};
  match.step();
  match.kick(left(5), {2, 0});
  match.step();
  match.player(right(7)).position = {8, 0};  // still ahead
  match.step();
  match.kick(left(5), {0, 0});
  EXPECT_EQ(Play(match).carries.at(0).passed, 1);
}

TEST(Chains, EndAtLastTouchWithBestOutcome) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.kick(left(6), {1, 0});
  match.kick(right(5), {0.5, 0});
  match.mode(PlayMode::kKickInLeft);
  match.place_ball({40, 0});
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.kick(left(9), {2.5, 0.6});
  match.steps(4);
  score_goal(match, Side::kLeft);
  const Play play(match);
  const auto chains = find_chains(play.flow, play.passes, play.shots);

  ASSERT_EQ(chains.size(), 3u);
  EXPECT_EQ(chains[0].passes, 1);
  EXPECT_EQ(chains[0].result, ChainResult::kLost);
  EXPECT_EQ(chains[1].team, 1u);
  EXPECT_EQ(chains[1].result, ChainResult::kOut);
  EXPECT_EQ(chains[2].result, ChainResult::kGoal);
  EXPECT_TRUE(chains[2].from_set_play);
  EXPECT_FALSE(chains[0].from_set_play);
}

TEST(Assists, CreditLastTwoPassersOfChain) {
  ScriptedMatch match;
  kick_from(match, {30, 0}, left(6), {1.5, 0});
  match.kick(left(7), {1.5, 0});
  match.steps(2);
  match.kick(left(9), {0.3, 0});
  match.steps(4);
  match.kick(left(9), {2.6, 0.3});
  match.steps(4);
  score_goal(match, Side::kLeft);
  const Play play(match);

  ASSERT_EQ(play.shots.size(), 1u);

  const Assist assist = find_assist(play.flow, play.passes, play.shots[0]);
  EXPECT_EQ(assist.passer, left(7));
  EXPECT_EQ(assist.second, left(6));
}

TEST(Assists, EndAtOpponentTouch) {
  ScriptedMatch match;
  kick_from(match, {35, 0}, left(7), {0.7, 0});
  match.kick(left(9), {0.2, 0});
  match.kick(right(4), {-0.1, 0});
  match.steps(4);
  match.kick(left(9), {2.6, 0.3});
  match.steps(6);
  const Play play(match);
  ASSERT_EQ(play.shots.size(), 1u);
  EXPECT_EQ(find_assist(play.flow, play.passes, play.shots[0]).passer, kNoPlayer);
}

TEST(ExpectedGoals, FollowDocumentedFunction) {
  ShotSituation situation{.distance = 10, .opening = 1.0, .cycles = 4, .goalie_margin = -1};
  EXPECT_NEAR(goal_probability(situation), 1 / (1 + std::exp(-(1.2 - 1.2 + 1.0 - 1.4))), 1e-12);
  situation.goalie_margin = 1;
  EXPECT_NEAR(goal_probability(situation), 1 / (1 + std::exp(-0.2)), 1e-12);
}

TEST(ExpectedGoals, MeasureOpeningOpponentsAndGoalie) {
  ScriptedMatch match;
  match.player(right(5)).position = {47, 0.2};
  match.player(right(6)).position = {47, 9};
  kick_from(match, {42.5, 0}, left(9), {2.5, 0.6});
  match.steps(3);
  const Play play(match);

  ASSERT_EQ(play.shots.size(), 1u);

  const ShotSituation situation = situation_of(play.flow, play.shots[0]);
  EXPECT_NEAR(situation.distance, 10, 1e-9);
  EXPECT_NEAR(situation.opening, 2 * std::atan(0.701), 1e-9);
  EXPECT_EQ(situation.opponents_between, 1);
  // The goalie stands 1.75 m off the path and has 3.5 cycles: it reaches the ball.
  EXPECT_LT(situation.goalie_margin, 0);
}

TEST(Threat, RewardsMovesTowardShots) {
  ScriptedMatch match;
  kick_from(match, {10, 0}, left(7), {2.7, 0});
  match.steps(12);
  match.kick(left(9), {1.2, 0});
  match.steps(8);
  match.kick(left(9), {2.5, 0.6});
  match.steps(6);
  const Play play(match);

  ASSERT_EQ(play.shots.size(), 1u);

  const ThreatGrid grid = threat_grid(play.flow, play.passes, play.carries, play.shots, {0.5});
  EXPECT_EQ(grid[threat_cell({-40, 0})], 0.0);
  EXPECT_DOUBLE_EQ(grid[threat_cell({45, 0})], 0.5);

  const auto added = threat_added(grid, play.passes, play.carries);
  EXPECT_NEAR(std::accumulate(added.begin(), added.end(), 0.0), 0.0,
              1e-9);  // every move led to the position of the shot: equal value
  EXPECT_DOUBLE_EQ(grid[threat_cell({10, 0})], 0.5);
}

TEST(Threat, MapsEveryPointToACell) {
  EXPECT_EQ(threat_cell({-60, -40}), 0u);
  EXPECT_EQ(threat_cell({60, 40}), kThreatColumns * kThreatRows - 1);
  EXPECT_EQ(threat_cell({1e9, 0}) % kThreatColumns, kThreatColumns - 1);
}

Pass completed(int passer, int receiver) {
  return {.passer = static_cast<std::int8_t>(passer),
          .receiver = static_cast<std::int8_t>(receiver),
          .outcome = PassOutcome::kCompleted,
          .to = {3, 4}};
}

TEST(PassNetwork, MeasuresChainOfThree) {
  // 1 -> 2 -> 3, twice each, and 2 -> 1 once.
  const std::vector<Pass> passes = {completed(left(1), left(2)), completed(left(1), left(2)),
                                    completed(left(2), left(3)), completed(left(2), left(3)),
                                    completed(left(2), left(1)), completed(right(1), right(2))};
  const PassNetwork network = pass_network(passes, ThreatGrid{}, 0);

  EXPECT_EQ(network.passes, 5);
  EXPECT_EQ(network.edges[0][1].passes, 2);
  EXPECT_EQ(network.edges[0][1].length, 5.0);
  EXPECT_EQ(network.edges[0][1].gain, 3.0);
  EXPECT_NEAR(network.density, 3.0 / 110, 1e-12);
  EXPECT_NEAR(network.top_edge, 0.4, 1e-12);
  EXPECT_NEAR(network.entropy, 0.4 * 2 * std::log2(2.5) + 0.2 * std::log2(5), 1e-9);
  EXPECT_EQ(network.nodes[1].given, 3);
  EXPECT_EQ(network.nodes[1].received, 2);
  EXPECT_EQ(network.nodes[1].partners, 2);
  EXPECT_NEAR(network.nodes[1].betweenness, 1.0 / 90, 1e-12);  // only 1 -> 3 passes through 2
  EXPECT_EQ(network.nodes[0].betweenness, 0.0);
  EXPECT_EQ(network.nodes[1].clustering, 0.0);

  double ranks = 0.0;
  for (const PassNode& node : network.nodes) ranks += node.page_rank;
  EXPECT_NEAR(ranks, 1.0, 1e-9);
  EXPECT_GT(network.nodes[1].page_rank, network.nodes[3].page_rank);
}

TEST(PassNetwork, ComputesStationaryPageRank) {
  // In a cycle of three all have the same rank, and so do the eight without passes.
  const std::vector<Pass> passes = {completed(left(1), left(2)), completed(left(2), left(3)),
                                    completed(left(3), left(1))};
  const PassNetwork network = pass_network(passes, ThreatGrid{}, 0);
  // r = (0.15 + 0.85 * 8 s) / 11 + 0.85 r and s = (0.15 + 0.85 * 8 s) / 11
  const double s = 0.15 / (11 - 6.8);
  EXPECT_NEAR(network.nodes[5].page_rank, s, 1e-4);
  EXPECT_NEAR(network.nodes[0].page_rank, s / 0.15, 1e-3);
  EXPECT_EQ(network.nodes[0].clustering, 1.0);
}

}  // namespace
}  // namespace cls::analysis
