// Every action of coach and trainer, with its effect in a match.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "base/index.h"
#include "player/world/planner_parameters.h"
#include "proxy/coach/coach_actions.h"
#include "proxy/coach/global_perception.h"
#include "proxy/messages/state_message.h"
#include "tests/proxy/coach/coached_match.h"

namespace cls::tests {
namespace {

using protos::CoachActions;
using protos::TrainerActions;
using soccer::CoachRole;
using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;

std::function<void(CoachActions&)> change(int unum, int type) {
  return [=](CoachActions& actions) {
    auto& wish = *actions.add_actions()->mutable_change_player_types();
    wish.set_uniform_number(unum);
    wish.set_type(type);
  };
}

void substitute(CoachActions& actions) { actions.add_actions()->mutable_do_helios_substitute(); }
void say_types(CoachActions& actions) {
  actions.add_actions()->mutable_do_helios_say_player_types();
}

const protos::Player& numbered(const google::protobuf::RepeatedPtrField<protos::Player>& players,
                               int unum) {
  static const protos::Player no_player;
  const auto found = std::ranges::find(players, unum, &protos::Player::uniform_number);
  return found == players.end() ? no_player : *found;
}

TEST(ChangePlayerTypes, SetsTypeAndNotifiesBothTeams) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    CoachedMatch match(CoachRole::kOnlineCoach, side);
    match.step_as_coach(change(7, 5));
    match.steps(3);
    EXPECT_EQ(match.world().player(side, 7).type, 5);
    EXPECT_EQ(match.world_model(side, 7).self().type_id(), 5) << "he knows it himself";
    EXPECT_EQ(numbered(match.state().world_model().teammates(), 7).type_id(), 5);
    EXPECT_EQ(match.player(side, 2).world().our_types[6], 5);
    EXPECT_EQ(match.player(soccer::opponent(side), 2).world().their_types[6], -1)
        << "they know that, not to what";
    EXPECT_EQ(match.world().team(side).substitutions, 0) << "free before the kick-off";
  }
}

TEST(ChangePlayerTypes, SubstitutesWithFullStaminaAfterKickOff) {
  CoachedMatch match(CoachRole::kOnlineCoach);
  match.steps_until(PlayMode::kKickOffLeft);
  match.steps(2);
  match.set_mode(PlayMode::kFreeKickLeft);
  match.arrange([](simulator::World& world) {
    world.player(Side::kLeft, 7).stamina = {1000.0, 0.6, 0.5, 10000.0};
  });

  const int free_type = [&] {
    std::set<int> taken;
    for (int unum = 1; unum <= 11; ++unum) {
      taken.insert(match.world().player(Side::kLeft, unum).type);
    }
    int type = 0;
    while (taken.contains(type)) ++type;
    return type;
  }();

  match.step_as_coach(change(7, free_type));
  match.steps(1);

  EXPECT_EQ(match.world().player(Side::kLeft, 7).type, free_type);
  EXPECT_EQ(match.world().team(Side::kLeft).substitutions, 1);
  EXPECT_EQ(match.world().player(Side::kLeft, 7).stamina.recovery, 1.0);
  EXPECT_EQ(match.coach().memory().substitutions, 1);
}

TEST(ChangePlayerTypes, IgnoresUnknownPlayersAndTypes) {
  CoachedMatch match(CoachRole::kOnlineCoach);
  for (const auto& [unum, type] : {std::pair{0, 5}, {12, 5}, {7, -1}, {7, 18}}) {
    match.step_as_coach(change(unum, type));
  }
  match.step_as_coach([](CoachActions& actions) { actions.add_actions(); });
  EXPECT_EQ(match.coach().report().invalid[1], 4);
  EXPECT_EQ(match.coach().report().unknown, 1);
  EXPECT_EQ(match.coach().commands().count("change_player_type"), 0u);
  EXPECT_EQ(match.coach().server().errors.errors, 0);
}

TEST(DoHeliosSubstitute, AssignsDistinctFastTypesBeforeKickOff) {
  CoachedMatch match(CoachRole::kOnlineCoach, Side::kRight);
  for (int i = 0; i < 15; ++i) match.step_as_coach(substitute);
  const auto& world = match.world();
  std::set<int> types;
  const auto speed_of = [&](int unum) {
    const soccer::PlayerType& type = world.type_of(world.player(Side::kRight, unum));
    return std::min(type.player_speed_max, type.real_speed_max(world.params().max_dash_power));
  };
  for (int unum = 1; unum <= 11; ++unum) types.insert(world.player(Side::kRight, unum).type);

  EXPECT_EQ(types.size(), 11u) << "all different";
  EXPECT_EQ(world.player(Side::kRight, 1).type, 0) << "the goalie";
  EXPECT_GE(speed_of(11), speed_of(8)) << "forwards are quicker than midfielders";
  EXPECT_EQ(match.coach().commands().at("change_player_type"), 11) << "once";
  EXPECT_EQ(match.coach().server().errors.warnings, 0)
      << match.coach().server().errors.first_warning;
}

TEST(DoHeliosSubstitute, GivesSideBacksTheFastestTypesIfTheParameterSaysSo) {
  player::PlannerParameters parameters;
  parameters.fast_backs = 1;
  CoachedMatch match(CoachRole::kOnlineCoach, Side::kLeft, false, -1,
                     std::make_shared<const player::PlannerParameters>(parameters));
  for (int i = 0; i < 15; ++i) match.step_as_coach(substitute);
  const auto& world = match.world();
  const auto speed_of = [&](int unum) {
    const soccer::PlayerType& type = world.type_of(world.player(Side::kLeft, unum));
    return std::min(type.player_speed_max, type.real_speed_max(world.params().max_dash_power));
  };

  constexpr double kAlike = 0.01;  // meters per cycle
  for (int unum : {2, 3, 6, 7, 8, 9, 10, 11}) {
    EXPECT_GE(std::min(speed_of(4), speed_of(5)), speed_of(unum) - kAlike) << unum;
  }
}

TEST(DoHeliosSubstitute, ReplacesTiredPlayersDuringStoppage) {
  // 600 cycles in all, so that the last 500 begin soon.
  CoachedMatch match(CoachRole::kOnlineCoach, Side::kLeft, false, 30);
  // Three players run up and down all the time, below the stamina at which recovery falls.
  const std::set<int> runners = {4, 7, 10, 11};

  match.play = [&](const proxy::PlayerAgent& player, protos::PlayerActions& actions) {
    const player::WorldModel& world = player.world();
    if (world.our_side != Side::kLeft || runners.count(player.unum()) == 0) return;
    auto& dash = *actions.add_actions()->mutable_dash();
    dash.set_power(100.0F);
    dash.set_relative_direction(world.game.time.cycle / 15 % 2 == 0 ? 0.0F : 180.0F);
  };

  match.steps_until(PlayMode::kKickOffLeft);
  match.set_mode(PlayMode::kPlayOn);
  match.arrange([](simulator::World& world) {
    for (int unum = 1; unum <= 11; ++unum) {
      world.player(Side::kLeft, unum).position = {-20.0, 5.0 * unum - 30.0};
    }
  });
  for (int i = 0; i < 250; ++i) match.step_as_coach(substitute);
  EXPECT_EQ(match.coach().commands().count("change_player_type"), 0u) << "not while the ball runs";

  std::set<int> tired;
  for (int unum = 1; unum <= 11; ++unum) {
    const double truth = match.world().player(Side::kLeft, unum).stamina.recovery;
    EXPECT_NEAR(match.coach().memory().stamina.of(unum).recovery, truth, 0.02) << unum;
    if (truth < 0.99) tired.insert(unum);
  }
  EXPECT_EQ(tired, runners);
  match.set_mode(PlayMode::kFreeKickLeft);
  for (int i = 0; i < 5; ++i) match.step_as_coach(substitute);

  int fresh = 0;
  for (const int unum : runners) {
    if (match.world().player(Side::kLeft, unum).stamina.recovery > 0.99) ++fresh;
  }

  EXPECT_EQ(fresh, 3) << "as many as the rules allow";
  EXPECT_EQ(match.world().team(Side::kLeft).substitutions, 3);
  EXPECT_EQ(match.coach().server().errors.warnings, 0)
      << match.coach().server().errors.first_warning;
}

// The coach identifies the opponents' types from their movement and sends them to the players,
// whose States contain them.
TEST(DoHeliosSayPlayerTypes, SendsOpponentTypesToPlayers) {
  CoachedMatch match(CoachRole::kOnlineCoach, Side::kRight, true);
  match.play = [](const proxy::PlayerAgent& player, protos::PlayerActions& actions) {
    auto& dash = *actions.add_actions()->mutable_dash();
    dash.set_power(100.0F);
    dash.set_relative_direction(player.world().game.time.cycle / 7 % 2 == 0 ? 0.0F : 180.0F);
  };

  match.steps_until(PlayMode::kKickOffLeft);
  match.set_mode(PlayMode::kPlayOn);
  for (int i = 0; i < 60; ++i) match.step_as_coach(say_types);

  EXPECT_EQ(match.coach().commands().count("say"), 0u) << "the server would not take it in play";
  match.set_mode(PlayMode::kFreeKickLeft);
  for (int i = 0; i < 4; ++i) match.step_as_coach(say_types);
  EXPECT_EQ(match.coach().commands().at("say"), 1) << "nothing new, nothing said";
  EXPECT_EQ(match.coach().server().errors.errors, 0) << match.coach().server().errors.first_error;

  for (int unum = 1; unum <= 11; ++unum) {
    const int type = match.world().player(Side::kLeft, unum).type;
    EXPECT_EQ(numbered(match.state().world_model().opponents(), unum).type_id(), type) << unum;
    EXPECT_EQ(match.player(Side::kRight, 6).world().their_types[base::index(unum - 1)], type)
        << unum;
  }

  for (const protos::Player& seen : match.world_model(Side::kRight, 6).opponents()) {
    EXPECT_EQ(seen.type_id(), match.world().player(Side::kLeft, seen.uniform_number()).type);
  }
}

// A kick that starts play in the cycle of the message makes the server refuse it. The players have
// not heard the types then, so the coach repeats them in the next stoppage.
TEST(DoHeliosSayPlayerTypes, RepeatsWhatTheServerRefused) {
  CoachedMatch match(CoachRole::kOnlineCoach, Side::kRight, true);
  bool is_at_ball = false;
  bool kicks = false;
  match.play = [&](const proxy::PlayerAgent& player, protos::PlayerActions& actions) {
    if (is_at_ball && player.unum() == 9) {
      if (kicks) actions.add_actions()->mutable_kick()->set_power(50.0F);
      return;
    }
    auto& dash = *actions.add_actions()->mutable_dash();
    dash.set_power(100.0F);
    dash.set_relative_direction(player.world().game.time.cycle / 7 % 2 == 0 ? 0.0F : 180.0F);
  };

  match.steps_until(PlayMode::kKickOffLeft);
  match.set_mode(PlayMode::kPlayOn);
  match.steps(60);
  match.set_mode(PlayMode::kFreeKickLeft);

  match.arrange([](simulator::World& world) {
    simulator::Player& kicker = world.player(Side::kLeft, 9);
    kicker.position = {-10.0, 20.0};
    kicker.velocity = world.ball.velocity = {};
    world.ball.position = {-9.4, 20.0};
  });

  is_at_ball = true;
  match.steps(10);  // the kicker looks for the ball
  kicks = true;
  match.step_as_coach(say_types);
  kicks = false;
  ASSERT_EQ(match.coach().commands().at("say"), 1);

  match.step_as_coach(say_types);
  ASSERT_EQ(match.world().mode, PlayMode::kPlayOn);
  const auto type_heard_of = [&](int unum) {
    return match.player(Side::kRight, 6).world().their_types[base::index(unum - 1)];
  };
  for (int i = 0; i < 60; ++i) match.step_as_coach(say_types);
  ASSERT_NE(type_heard_of(5), match.world().player(Side::kLeft, 5).type);
  EXPECT_EQ(match.coach().memory().freeforms_sent, 0) << "the server does not count it";
  EXPECT_EQ(match.coach().commands().at("say"), 1);

  match.set_mode(PlayMode::kFreeKickLeft);
  match.arrange([](simulator::World& world) { world.ball.velocity = {}; });
  for (int i = 0; i < 4; ++i) match.step_as_coach(say_types);

  EXPECT_EQ(match.coach().commands().at("say"), 2) << "once again";
  EXPECT_EQ(type_heard_of(5), match.world().player(Side::kLeft, 5).type);
  EXPECT_EQ(match.coach().server().errors.errors, 0) << match.coach().server().errors.first_error;
}

// The server does not send the play mode to a late coach.
TEST(CoachState, HasPlayOnWhenConnectedDuringMatch) {
  player::WorldModel world;
  proxy::on_coach_init(world, Side::kLeft, "left");
  soccer::GlobalView view;
  proxy::on_global_view(world, view);
  EXPECT_EQ(world.game.mode, PlayMode::kBeforeKickOff);
  view.time = 70;
  proxy::on_global_view(world, view);
  EXPECT_EQ(world.game.mode, PlayMode::kPlayOn);
}

TEST(CoachState, IsExactInCoordinatesOfTeam) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    CoachedMatch match(CoachRole::kOnlineCoach, side, true);
    match.steps_until(PlayMode::kKickOffLeft);
    match.arrange([](simulator::World& world) { world.ball = {{10.0, -5.0}, {1.0, 0.5}, {}}; });
    match.steps(1);
    const protos::WorldModel& model = match.state().world_model();
    const double sign = side == Side::kLeft ? 1.0 : -1.0;

    EXPECT_FALSE(model.has_self());
    EXPECT_EQ(model.our_side(), side == Side::kLeft ? protos::LEFT : protos::RIGHT);
    EXPECT_NEAR(model.ball().position().x(), sign * match.world().ball.position.x, 1e-4);
    EXPECT_NEAR(model.ball().velocity().y(), sign * match.world().ball.velocity.y, 1e-4);
    EXPECT_EQ(model.ball().pos_count(), 0);
    EXPECT_EQ(model.teammates_size(), 11);
    EXPECT_EQ(model.opponents_size(), 11);
    EXPECT_EQ(model.our_players_dict_size(), 11);

    for (const protos::Player& player : model.opponents()) {
      const auto& truth = match.world().player(soccer::opponent(side), player.uniform_number());
      EXPECT_NEAR(player.position().x(), sign * truth.position.x, 1e-4);
      EXPECT_NEAR(player.position().y(), sign * truth.position.y, 1e-4);
      EXPECT_EQ(player.pos_count(), 0);
      EXPECT_EQ(player.is_goalie(), player.uniform_number() == 1);
    }

    EXPECT_EQ(model.cycle(), match.world().clock.time);
    EXPECT_EQ(model.our_goalie_uniform_number(), 1);
  }
}

/// A running match with a trainer.
struct Trained : CoachedMatch {
  Trained() : CoachedMatch(CoachRole::kTrainer) {
    steps_until(PlayMode::kKickOffLeft);
    set_mode(PlayMode::kPlayOn);
    steps(1);
  }
  /// Sends the action and runs the step that executes it.
  void wish(const std::function<void(TrainerActions&)>& fill) {
    step_as_trainer(fill);
    steps(1);
  }
};

void set(protos::RpcVector2D* out, Vec2 v) {
  out->set_x(static_cast<float>(v.x));
  out->set_y(static_cast<float>(v.y));
}

TEST(DoMoveBall, SetsPositionAndVelocity) {
  Trained match;
  match.wish([](TrainerActions& actions) {
    auto& move = *actions.add_actions()->mutable_do_move_ball();
    set(move.mutable_position(), {12.0, -20.0});
    set(move.mutable_velocity(), {1.0, 0.5});
  });

  // Moved before the step, which it then rolled.
  EXPECT_NEAR(match.world().ball.position.x, 13.0, 1e-6);
  EXPECT_NEAR(match.world().ball.position.y, -19.5, 1e-6);
  EXPECT_NEAR(match.world().ball.velocity.x, 0.94, 1e-6);

  match.wish([](TrainerActions& actions) {
    set(actions.add_actions()->mutable_do_move_ball()->mutable_position(), {-3.0, 4.0});
  });
  EXPECT_NEAR(match.world().ball.position.x, -3.0, 1e-6);
  EXPECT_EQ(match.world().ball.velocity.length(), 0.0) << "at rest when no velocity is given";
}

TEST(DoMovePlayer, SetsPositionOfPlayersOfBothTeamsWithoutVelocity) {
  Trained match;
  match.arrange([](simulator::World& world) {
    world.player(Side::kLeft, 4).velocity = {0.4, 0.0};
    world.player(Side::kRight, 9).velocity = {0.0, 0.4};
  });

  match.wish([](TrainerActions& actions) {
    for (const bool ours : {true, false}) {
      auto& move = *actions.add_actions()->mutable_do_move_player();
      move.set_our_side(ours);
      move.set_uniform_number(ours ? 4 : 9);
      set(move.mutable_position(), {ours ? -15.0 : 22.0, 11.0});
      move.set_body_direction(ours ? 60.0F : -120.0F);
    }
  });

  const auto& ours = match.world().player(Side::kLeft, 4);
  const auto& theirs = match.world().player(Side::kRight, 9);

  EXPECT_NEAR(ours.position.x, -15.0, 1e-6);
  EXPECT_NEAR(ours.position.y, 11.0, 1e-6);
  EXPECT_NEAR(ours.body, soccer::math::to_radians(60.0), 1e-6);
  EXPECT_EQ(ours.velocity.length(), 0.0);
  EXPECT_NEAR(theirs.position.x, 22.0, 1e-6) << "in the axes of the left team";
  EXPECT_NEAR(theirs.body, soccer::math::to_radians(-120.0), 1e-6);
  EXPECT_EQ(theirs.velocity.length(), 0.0);
}

TEST(DoRecover, RestoresStaminaOfAllPlayers) {
  Trained match;
  match.arrange([](simulator::World& world) {
    for (simulator::Player& player : world.players) player.stamina = {100.0, 0.6, 0.5, 50.0};
  });
  match.wish([](TrainerActions& actions) { actions.add_actions()->mutable_do_recover(); });
  for (const simulator::Player& player : match.world().players) {
    EXPECT_EQ(player.stamina.recovery, 1.0);
    EXPECT_EQ(player.stamina.value, match.world().params().stamina_max);
  }
}

TEST(DoChangePlayerType, ChangesPlayersOfBothTeamsWithoutLimit) {
  Trained match;
  match.wish([](TrainerActions& actions) {
    for (int unum = 2; unum <= 6; ++unum) {
      for (const bool ours : {true, false}) {
        auto& change = *actions.add_actions()->mutable_do_change_player_type();
        change.set_our_side(ours);
        change.set_uniform_number(unum);
        change.set_type(17);
      }
    }
  });

  for (int unum = 2; unum <= 6; ++unum) {
    EXPECT_EQ(match.world().player(Side::kLeft, unum).type, 17);
    EXPECT_EQ(match.world().player(Side::kRight, unum).type, 17);
  }

  EXPECT_EQ(match.world_model(Side::kLeft, 3).self().type_id(), 17);

  match.steps(1);
  EXPECT_EQ(numbered(match.state().world_model().opponents(), 3).type_id(), 17);
}

TEST(DoKickOff, StartsMatchImmediately) {
  CoachedMatch match(CoachRole::kTrainer);
  match.steps(3);
  ASSERT_EQ(match.world().mode, PlayMode::kBeforeKickOff);
  match.step_as_trainer(
      [](TrainerActions& actions) { actions.add_actions()->mutable_do_kick_off(); });
  match.steps(1);
  EXPECT_EQ(match.world().mode, PlayMode::kKickOffLeft);
}

struct ModeCase {
  protos::GameModeType mode;
  PlayMode left;
  PlayMode right;
};

void PrintTo(const ModeCase& one, std::ostream* out) {
  *out << protos::GameModeType_Name(one.mode);
}

class DoChangeMode : public testing::TestWithParam<ModeCase> {};

TEST_P(DoChangeMode, SetsPlayMode) {
  const ModeCase& c = GetParam();
  for (const protos::Side side : {protos::LEFT, protos::RIGHT}) {
    CoachedMatch match(CoachRole::kTrainer);
    match.steps(2);
    if (c.mode == protos::GoalKick_) {  // otherwise it ends immediately
      match.arrange([](simulator::World& world) { world.ball = {{50.0, 9.0}, {}, {}}; });
      if (side == protos::LEFT) {
        match.arrange([](simulator::World& world) { world.ball.position.x = -50.0; });
      }
    }

    match.step_as_trainer([&](TrainerActions& actions) {
      auto& change = *actions.add_actions()->mutable_do_change_mode();
      change.set_game_mode_type(c.mode);
      change.set_side(side);
    });
    match.steps(1);

    EXPECT_EQ(match.coach().commands().at("change_mode"), 1);
    EXPECT_EQ(match.world().mode, side == protos::LEFT ? c.left : c.right);
    EXPECT_EQ(match.coach().world().game.mode, match.world().mode) << "as all clients hear";
    EXPECT_EQ(match.coach().server().errors.errors, 0);
  }
}

constexpr ModeCase kModes[] = {
    {protos::BeforeKickOff, PlayMode::kBeforeKickOff, PlayMode::kBeforeKickOff},
    {protos::TimeOver, PlayMode::kTimeOver, PlayMode::kTimeOver},
    {protos::PlayOn, PlayMode::kPlayOn, PlayMode::kPlayOn},
    {protos::KickOff_, PlayMode::kKickOffLeft, PlayMode::kKickOffRight},
    {protos::KickIn_, PlayMode::kKickInLeft, PlayMode::kKickInRight},
    {protos::FreeKick_, PlayMode::kFreeKickLeft, PlayMode::kFreeKickRight},
    {protos::CornerKick_, PlayMode::kCornerKickLeft, PlayMode::kCornerKickRight},
    {protos::GoalKick_, PlayMode::kGoalKickLeft, PlayMode::kGoalKickRight},
    {protos::OffSide_, PlayMode::kOffsideLeft, PlayMode::kOffsideRight},
    {protos::FirstHalfOver, PlayMode::kFirstHalfOver, PlayMode::kFirstHalfOver},
    {protos::Pause, PlayMode::kPause, PlayMode::kPause},
    {protos::Human, PlayMode::kHumanJudge, PlayMode::kHumanJudge},
    {protos::FoulCharge_, PlayMode::kFoulChargeLeft, PlayMode::kFoulChargeRight},
    {protos::FoulPush_, PlayMode::kFoulPushLeft, PlayMode::kFoulPushRight},
    {protos::BackPass_, PlayMode::kBackPassLeft, PlayMode::kBackPassRight},
    {protos::FreeKickFault_, PlayMode::kFreeKickFaultLeft, PlayMode::kFreeKickFaultRight},
    {protos::CatchFault_, PlayMode::kCatchFaultLeft, PlayMode::kCatchFaultRight},
    {protos::IndFreeKick_, PlayMode::kIndirectFreeKickLeft, PlayMode::kIndirectFreeKickRight},
    {protos::IllegalDefense_, PlayMode::kIllegalDefenseLeft, PlayMode::kIllegalDefenseRight},
};

INSTANTIATE_TEST_SUITE_P(Modes, DoChangeMode, testing::ValuesIn(kModes), [](const auto& one) {
  std::string name = protos::GameModeType_Name(one.param.mode);
  std::erase(name, '_');
  return name;
});

TEST(DoChangeMode, SupportsEveryPlayModeOfServer) {
  const player::WorldModel world;
  for (int i = 1; i < soccer::kPlayModeCount; ++i) {
    const auto mode = static_cast<PlayMode>(i);
    const bool is_said_so = proxy::wire_mode(mode) != protos::PenaltyKick_ &&
                            mode != PlayMode::kDropBall;  // PlayOn means play_on
    TrainerActions actions;
    auto& change = *actions.add_actions()->mutable_do_change_mode();
    change.set_game_mode_type(proxy::wire_mode(mode));
    change.set_side(soccer::side(mode) == Side::kLeft ? protos::LEFT : protos::RIGHT);
    proxy::CoachActionReport report;
    std::vector<soccer::CoachCommand> commands;
    proxy::execute(actions, world, report, commands);
    if (!is_said_so) continue;
    ASSERT_EQ(commands.size(), 1u) << soccer::name(mode);
    EXPECT_EQ(std::get<soccer::ChangeMode>(commands[0]).mode, mode) << soccer::name(mode);
  }
}

TEST(TrainerActions, IgnoresInvalidActions) {
  Trained match;
  const Vec2 ball = match.world().ball.position;
  match.wish([](TrainerActions& actions) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    actions.add_actions()->mutable_do_move_ball()->mutable_position()->set_x(nan);
    auto& player = *actions.add_actions()->mutable_do_move_player();
    player.set_uniform_number(12);
    auto& type = *actions.add_actions()->mutable_do_change_player_type();
    type.set_uniform_number(3);
    type.set_type(99);

    for (const auto mode : {protos::PenaltyKick_, protos::PenaltyOnfield_, protos::PenaltyFoul_,
                            protos::GoalieCatch_, protos::ExtendHalf, protos::MODE_MAX}) {
      actions.add_actions()->mutable_do_change_mode()->set_game_mode_type(mode);
    }

    actions.add_actions();
  });

  const proxy::CoachActionReport& report = match.coach().report();
  EXPECT_EQ(report.invalid[protos::TrainerAction::kDoMoveBall], 1);
  EXPECT_EQ(report.invalid[protos::TrainerAction::kDoMovePlayer], 1);
  EXPECT_EQ(report.invalid[protos::TrainerAction::kDoChangePlayerType], 1);
  EXPECT_EQ(report.invalid[protos::TrainerAction::kDoChangeMode], 6);
  EXPECT_EQ(report.unknown, 1);

  const proxy::ActionOutcomes outcomes = outcomes_by_name(report, true);
  EXPECT_EQ(outcomes.at("do_change_mode").at("invalid"), 6);
  EXPECT_EQ(outcomes.at("unknown").at("unimplemented"), 1);
  EXPECT_EQ(match.world().mode, PlayMode::kPlayOn);
  EXPECT_EQ(match.world().ball.position, ball);
  EXPECT_EQ(match.coach().server().errors.errors, 0) << match.coach().server().errors.first_error;
}

TEST(TrainerState, IsExactInCoordinatesOfLeftTeam) {
  Trained match;
  match.steps(1);
  const protos::WorldModel& model = match.state().world_model();

  EXPECT_EQ(model.our_side(), protos::UNKNOWN);
  EXPECT_EQ(model.our_team_name(), "left");
  EXPECT_EQ(model.their_team_name(), "right");
  EXPECT_FALSE(model.has_self());
  ASSERT_EQ(model.teammates_size(), 11);

  for (const protos::Player& player : model.teammates()) {
    const auto& truth = match.world().player(Side::kLeft, player.uniform_number());
    EXPECT_NEAR(player.position().x(), truth.position.x, 1e-4);
    EXPECT_EQ(player.side(), protos::LEFT);
  }
}

}  // namespace
}  // namespace cls::tests
