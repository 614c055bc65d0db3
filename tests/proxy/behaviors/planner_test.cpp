// The offensive planner: generated actions, and its control by the Playmaker.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/index.h"
#include "player/perception/say_message.h"
#include "player/planner/field.h"
#include "player/planner/generators.h"
#include "player/planner/planner.h"
#include "player/world/motion.h"
#include "proxy/actions/executor.h"
#include "proxy/planner/offensive_planner.h"
#include "proxy/planner/planner_messages.h"
#include "proxy/planner/playmaker_evaluation.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using protos::PlayerActions;
using soccer::PlayMode;
using soccer::Vec2;
using tests::KnownPitch;

KnownPitch with_ball(Vec2 position, double body_deg = 0.0) {
  KnownPitch pitch;
  pitch.place_self(position, body_deg);
  pitch.place_ball(position + Vec2{0.6, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {46.0, -30.0});  // keeps most players onside
  return pitch;
}

auto plan_with(const std::function<void(protos::HeliosOffensivePlanner&)>& allow) {
  return [=](PlayerActions& reply) {
    allow(*reply.add_actions()->mutable_helios_offensive_planner());
  };
}

template <typename Generator>
std::vector<player::PlanAction> generated(const KnownPitch& pitch, Generator generator) {
  const player::PlannerField field(pitch.world);
  std::vector<player::PlanAction> actions;
  generator(field, actions);
  return actions;
}

bool has(const std::vector<player::PlanAction>& actions, player::PlanTag tag) {
  return std::any_of(actions.begin(), actions.end(),
                     [tag](const player::PlanAction& action) { return action.tag == tag; });
}

TEST(Passes, GeneratesDirectLeadAndThroughPasses) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {12.0, 8.0});
  pitch.add_opponent(4, {20.0, -8.0});
  pitch.add_opponent(5, {20.0, 18.0});
  const auto passes = generated(pitch, player::add_passes);
  EXPECT_TRUE(has(passes, player::PlanTag::kStrictDirect));
  EXPECT_TRUE(has(passes, player::PlanTag::kStrictLead));
  EXPECT_TRUE(has(passes, player::PlanTag::kStrictThrough));
}

TEST(Passes, ArriveBeforeAnyOpponent) {
  int passes = 0;
  for (const Vec2 where : {Vec2{10.0, 4.0}, Vec2{8.0, 0.0}, Vec2{15.0, 10.0}, Vec2{5.0, 6.0}}) {
    KnownPitch pitch = with_ball({0.0, 0.0});
    pitch.add_teammate(9, {16.0, 9.0});
    pitch.add_opponent(4, where, 180.0);
    for (const player::PlanAction& pass : generated(pitch, player::add_passes)) {
      ++passes;
      const Vec2 ball = pitch.world.ball.position;
      const Vec2 velocity = soccer::with_length(pass.target_point - ball, pass.first_speed);
      const auto& type = pitch.world.type_of(pitch.world.opponents[2]);
      for (int cycle = 1; cycle <= pass.duration - pass.kicks; ++cycle) {
        const Vec2 there = player::coast(ball, velocity, pitch.world.server().ball_decay, cycle);
        const double run = distance(there, where) - type.kickable_area(0.085);
        // Lower bound of running time, independent of the planner's tables.
        if (run <= 0.0) ADD_FAILURE() << "through the opponent";
        const int turn =
            (soccer::AngleDeg::of(there - where) - soccer::AngleDeg(180.0)).abs() > 40 ? 1 : 0;
        EXPECT_GT(turn + player::cycles_to_run(pitch.world.server(), type, run), cycle) << cycle;
      }
    }
  }

  EXPECT_GT(passes, 10);
}

// A faulty server may send any numbers.
TEST(Passes, EndWithTypesThatRunBackwardsOrNeverRun) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {16.0, 9.0});
  pitch.add_opponent(4, {10.0, 4.0}, 180.0);
  for (const double speed : {-1e30, -20.0, -1.5, 0.0, 1e30}) {
    auto parameters = std::make_shared<player::MatchParameters>(*pitch.world.parameters);
    for (soccer::PlayerType& type : parameters->types) type.player_speed_max = speed;
    pitch.world.parameters = parameters;
    for (const player::PlanAction& pass : generated(pitch, player::add_passes))
      EXPECT_GE(pass.duration, 1);
  }
}

TEST(Passes, SkipOffsideAndStaleReceivers) {
  KnownPitch offside;
  offside.place_ball({0.6, 0.0});
  offside.add_opponent(1, {50.0, 0.0});
  offside.add_opponent(4, {10.0, -20.0});
  offside.add_teammate(9, {20.0, 8.0});
  EXPECT_TRUE(generated(offside, player::add_passes).empty());
  KnownPitch stale = with_ball({0.0, 0.0});
  stale.add_opponent(4, {40.0, -20.0});
  stale.add_teammate(9, {12.0, 8.0}, 0.0, 11);
  EXPECT_TRUE(generated(stale, player::add_passes).empty());
}

TEST(Crosses, ReachTeammateInFrontOfGoal) {
  KnownPitch pitch = with_ball({44.0, -25.0}, 90.0);
  pitch.add_opponent(4, {50.0, -16.0});
  pitch.add_teammate(11, {42.0, -6.0});
  pitch.add_opponent(5, {50.0, 10.0});
  const auto crosses = generated(pitch, player::add_crosses);
  ASSERT_EQ(crosses.size(), 1U);
  EXPECT_EQ(crosses[0].target, 11);
  EXPECT_LT(distance(crosses[0].target_point, {42.0, -6.0}), 5.0);
  KnownPitch far = with_ball({0.0, -25.0});
  far.add_teammate(11, {44.0, 0.0});
  EXPECT_TRUE(generated(far, player::add_crosses).empty());
}

TEST(Dribbles, AvoidOpponents) {
  KnownPitch open = with_ball({0.0, 0.0});
  const auto free = generated(open, player::add_short_dribbles);
  EXPECT_TRUE(has(free, player::PlanTag::kShortDribble));
  EXPECT_TRUE(has(generated(open, player::add_self_passes), player::PlanTag::kSelfPass));
  KnownPitch met = with_ball({0.0, 0.0});
  met.add_opponent(4, {4.5, 0.0});
  for (const player::PlanAction& dribble : generated(met, player::add_short_dribbles)) {
    EXPECT_GT(soccer::AngleDeg::of(dribble.target_point).abs(), 25.0)
        << dribble.target_point.x << " " << dribble.target_point.y;
  }
  EXPECT_LT(generated(met, player::add_short_dribbles).size(), free.size());
}

TEST(Dribbles, EndAtPlannedPoint) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  const auto only_dribble =
      plan_with([](protos::HeliosOffensivePlanner& planner) { planner.set_short_dribble(true); });
  const player::PlannerField field(pitch.world);
  player::PlannerOptions options;
  options.passes = options.cross = options.long_dribble = false;
  const player::Plan plan = make_plan(field, options);
  const player::PlanAction action = plan.nodes[base::index(plan.best)].action;

  ASSERT_EQ(action.category, player::PlanCategory::kDribble);

  pitch.act(only_dribble);
  ASSERT_TRUE(pitch.memory.intention.active());
  for (int cycle = 1; cycle < action.duration; ++cycle) {
    PlayerActions nothing;
    pitch.act(nothing);
    EXPECT_FALSE(pitch.touched_ball());
  }

  EXPECT_LT(distance(pitch.world.ball.position, action.target_point), 0.1);
  EXPECT_TRUE(pitch.world.self.kickable);
}

TEST(HeliosOffensivePlanner, PassesToAnnouncedPoint) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {15.0, 6.0}, 90.0);
  const auto only_direct =
      plan_with([](protos::HeliosOffensivePlanner& planner) { planner.set_direct_pass(true); });
  pitch.act(only_direct);
  while (pitch.world.self.kickable) pitch.act(only_direct);

  ASSERT_NE(pitch.sent<soccer::Say>(), nullptr);
  std::string_view text = pitch.sent<soccer::Say>()->text;
  const auto said = player::parse_say_message(text, pitch.world.server());
  ASSERT_TRUE(said);
  EXPECT_EQ(std::get<player::SayPass>(*said).receiver, 9);

  double nearest = 100.0;
  const Vec2 announced = std::get<player::SayPass>(*said).point;

  for (int i = 0; i < 30; ++i) {
    pitch.roll(1);
    nearest = std::min(nearest, distance(pitch.world.ball.position, announced));
  }
  EXPECT_LT(nearest, 1.0) << "at the announced point";
}

TEST(HeliosOffensivePlanner, HoldsBallWithoutEnabledActions) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {15.0, 6.0});
  for (int i = 0; i < 5; ++i) {
    pitch.act(plan_with([](protos::HeliosOffensivePlanner&) {}));
    EXPECT_TRUE(pitch.world.self.kickable) << i;
  }
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosOffensivePlanner).done, 5);
}

TEST(HeliosOffensivePlanner, KicksOutOfDangerBeforeOurGoal) {
  const auto kick = [](Vec2 opponent) {
    KnownPitch pitch = with_ball({-48.0, 12.0});
    pitch.add_teammate(6, {-40.0, 0.0});
    pitch.add_opponent(8, {-38.0, 1.0});
    pitch.add_opponent(11, opponent);
    pitch.act(
        plan_with([](protos::HeliosOffensivePlanner& planner) { planner.set_direct_pass(true); }));
    return pitch.world.ball.velocity;
  };

  const Vec2 away = kick({-44.0, 10.0});
  EXPECT_GT(away.y, 0.5) << "not through the middle, " << away.x << ", " << away.y;
  EXPECT_GT(away.length(), 1.5);
  EXPECT_LT(kick({-30.0, -5.0}).y, 0.5) << "no opponent near the ball";
}

TEST(HeliosOffensivePlanner, FailsWithoutBall) {
  KnownPitch pitch;
  pitch.act(plan_with(tests::allow_everything));
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosOffensivePlanner).failed, 1);
}

TEST(HeliosOffensivePlanner, RespectsMaxNodesAndMaxDepth) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  for (int unum = 8; unum <= 11; ++unum) pitch.add_teammate(unum, {10.0, 8.0 * (unum - 9)});
  const player::PlannerField field(pitch.world);
  protos::HeliosOffensivePlanner action;
  tests::allow_everything(action);
  action.set_max_nodes(20);

  EXPECT_LE(make_plan(field, planner_options(action)).nodes.size(), 20U);
  action.set_max_nodes(0);
  action.set_max_depth(1);

  for (const player::PlanNode& node : make_plan(field, planner_options(action)).nodes) {
    EXPECT_LE(node.depth, 1);
  }
  action.set_max_depth(0);
  const player::Plan deep = make_plan(field, planner_options(action));

  EXPECT_TRUE(std::any_of(deep.nodes.begin(), deep.nodes.end(),
                          [](const player::PlanNode& node) { return node.depth > 1; }));
  EXPECT_LE(deep.nodes.size(), 500U);
}

/// First action of the best plan with the Playmaker's evaluation.
player::PlanAction best_first(const KnownPitch& pitch,
                              const protos::PlannerEvaluation& evaluation) {
  const player::PlannerField field(pitch.world);
  const player::Plan plan =
      make_plan(field, player::PlannerOptions{},
                [&](const player::PlannerField& of, const player::Plan& planned, int node) {
                  return evaluate(of, planned, node, evaluation);
                });
  return plan.nodes[base::index(plan.first_of(plan.best))].action;
}

TEST(PlannerEvaluation, ExcludesActionTypesWithFactorZero) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {12.0, 8.0});
  protos::PlannerEvaluation evaluation;
  auto& types = *evaluation.mutable_effectors()->mutable_action_type_effector();
  types.set_direct_pass(1.0F);

  EXPECT_EQ(best_first(pitch, evaluation).tag, player::PlanTag::kStrictDirect);
  types.set_direct_pass(0.0F);
  types.set_long_dribble(1.0F);

  EXPECT_EQ(best_first(pitch, evaluation).tag, player::PlanTag::kSelfPass);
  types.set_long_dribble(0.0F);
  types.set_hold(1.0F);
  EXPECT_EQ(best_first(pitch, evaluation).category, player::PlanCategory::kHold);
}

TEST(PlannerEvaluation, PrefersTeammateWithHigherFactor) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {12.0, 10.0});
  pitch.add_teammate(10, {12.0, -10.0});
  protos::PlannerEvaluation evaluation;
  auto& teammates = *evaluation.mutable_effectors()->mutable_teammate_effector();
  (*teammates.mutable_coefficients())[10] = 3.0F;
  EXPECT_EQ(best_first(pitch, evaluation).target, 10);
  (*teammates.mutable_coefficients())[9] = 5.0F;
  EXPECT_EQ(best_first(pitch, evaluation).target, 9);
}

TEST(PlannerEvaluation, FollowsFieldMatrix) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {-2.0, 14.0});
  pitch.add_teammate(10, {12.0, -10.0});
  protos::PlannerEvaluation evaluation;
  auto& matrix = *evaluation.mutable_field_evaluators()->mutable_matrix_field_evaluator();
  auto& column = *matrix.add_evals();  // one column: only y matters, positive y is good
  for (int i = 0; i < 8; ++i) column.add_evals(static_cast<float>(i));
  EXPECT_EQ(best_first(pitch, evaluation).target, 9);
}

TEST(PlannerEvaluation, HoldsABallFarOutsideOfFieldMatrix) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  protos::PlannerEvaluation evaluation;
  auto& matrix = *evaluation.mutable_field_evaluators()->mutable_matrix_field_evaluator();
  matrix.add_evals()->add_evals(1.0F);
  for (const double far : {-1e30, 1e30}) {
    pitch.place_ball({far, far});
    EXPECT_EQ(best_first(pitch, evaluation).category, player::PlanCategory::kHold) << far;
  }
}

TEST(PlannerEvaluation, FollowsHeliosWeightsAndOpponentEffect) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(6, {-14.0, 5.0});
  protos::PlannerEvaluation evaluation;
  auto& helios = *evaluation.mutable_field_evaluators()->mutable_helios_field_evaluator();
  helios.set_x_coefficient(1.0F);

  EXPECT_GT(best_first(pitch, evaluation).target_point.x, 0.5);
  // Only the distance to opponents counts; one is in front.
  helios.set_x_coefficient(0.0F);
  pitch.add_opponent(4, {9.0, 0.0});
  auto& opponents = *evaluation.mutable_effectors()->mutable_opponent_effector();

  for (int i = 0; i < 25; ++i) {
    opponents.add_negetive_effect_by_distance(static_cast<float>(i - 25));
  }
  EXPECT_LT(best_first(pitch, evaluation).target_point.x, 0.0);
}

protos::PlayerActions server_side() {
  PlayerActions reply;
  reply.set_ignore_shootinpreprocess(true);
  auto& planner = *reply.add_actions()->mutable_helios_offensive_planner();
  tests::allow_everything(planner);
  planner.set_server_side_decision(true);
  reply.add_actions()->mutable_turn()->set_relative_direction(77.0F);
  return reply;
}

TEST(ServerSideDecision, RequestsChoiceAndExecutesIt) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {12.0, 8.0});
  const PlayerActions reply = server_side();
  player::PlanChoice choice;
  choice.chooser = player::PlanChoice::Chooser::kPlaymaker;
  player::ActionMemory memory = pitch.memory;
  player::CommandSlots tried(pitch.world);
  player::ActionReport report;
  execute(reply, pitch.world, memory, tried, report, choice);
  ASSERT_EQ(choice.chooser, player::PlanChoice::Chooser::kRequested);
  EXPECT_FALSE(tried.has_body());

  protos::State state;
  state.mutable_register_response()->set_client_id(5);
  protos::BestPlannerActionRequest request;
  fill_planner_request(pitch.world, choice.plan, state, request);
  EXPECT_EQ(request.register_response().client_id(), 5);
  EXPECT_EQ(request.state().register_response().client_id(), 5);
  ASSERT_EQ(static_cast<std::size_t>(request.pairs().size()), choice.plan.nodes.size());
  EXPECT_EQ(request.pairs().at(0).action().category(), protos::AC_Hold);
  EXPECT_EQ(request.pairs().at(0).action().parent_index(), -1);
  int deep = 0;

  for (const auto& [index, pair] : request.pairs()) {
    EXPECT_EQ(pair.action().index(), index);
    EXPECT_TRUE(pair.predict_state().has_ball_position());
    EXPECT_TRUE(pair.action().has_target_point());
    if (pair.action().parent_index() > 0) deep = index;
  }
  ASSERT_NE(deep, 0);

  choice.chooser = player::PlanChoice::Chooser::kReplied;
  choice.node = deep;
  player::CommandSlots slots(pitch.world);
  execute(reply, pitch.world, memory, slots, report, choice);
  EXPECT_TRUE(std::holds_alternative<soccer::Kick>(slots.body()));
  EXPECT_EQ(report.actions[PlayerAction::kTurn].done, 0);
}

TEST(ServerSideDecision, ContinuesActionListWithoutReply) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  player::PlanChoice choice;
  choice.chooser = player::PlanChoice::Chooser::kReplied;
  choice.node = -1;
  player::CommandSlots slots(pitch.world);
  execute(server_side(), pitch.world, pitch.memory, slots, pitch.report, choice);
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosOffensivePlanner).failed, 1);
  EXPECT_TRUE(std::holds_alternative<soccer::Turn>(slots.body()));
}

TEST(ServerSideDecision, UsesBestNodeForInvalidIndex) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.add_teammate(9, {12.0, 8.0});
  const player::PlannerField field(pitch.world);
  const player::Plan plan = make_plan(field, player::PlannerOptions{});
  EXPECT_EQ(first_action_of(plan, 99999), plan.first_of(plan.best));
  EXPECT_EQ(first_action_of(plan, 0), 0) << "hold";
}

TEST(ServerSideDecision, ProxyChoosesWithoutPlaymaker) {
  KnownPitch pitch = with_ball({0.0, 0.0});
  pitch.act(server_side());
  EXPECT_NE(pitch.sent<soccer::Kick>(), nullptr);
}

}  // namespace
}  // namespace cls::proxy
