// Sequence of a decision, automatic actions, and counts.
#include "proxy/actions/executor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.h"
#include "player/behaviors/automatic_play.h"
#include "proxy/actions/action_handlers.h"
#include "proxy/connection/action_names.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using protos::PlayerActions;
using soccer::PlayMode;
using tests::KnownPitch;

TEST(Executor, FirstMainActionThatSucceedsWins) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_kick()->set_power(50.0F);  // no ball
    reply.add_actions()->mutable_dash()->set_power(60.0F);
    reply.add_actions()->mutable_turn()->set_relative_direction(90.0F);
  });
  ASSERT_NE(pitch.sent<soccer::Dash>(), nullptr);
  EXPECT_EQ(pitch.sent<soccer::Turn>(), nullptr);
  EXPECT_EQ(pitch.counts(PlayerAction::kKick).failed, 1);
  EXPECT_EQ(pitch.counts(PlayerAction::kDash).done, 1);
  EXPECT_EQ(pitch.counts(PlayerAction::kTurn).skipped, 1);
}

TEST(Executor, CountsOutcomesByName) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_kick()->set_power(50.0F);  // no ball
    reply.add_actions()->mutable_dash()->set_power(60.0F);
    reply.add_actions()->mutable_turn()->set_relative_direction(90.0F);
    reply.add_actions()->mutable_turn_neck()->set_moment(std::numeric_limits<float>::infinity());
  });

  const ActionOutcomes outcomes = outcomes_by_name(pitch.report);
  EXPECT_EQ(outcomes, (ActionOutcomes{{"kick", {{"failed", 1}}},
                                      {"dash", {{"executed", 1}}},
                                      {"turn", {{"skipped", 1}}},
                                      {"turn_neck", {{"invalid", 1}}}}));
}

TEST(Executor, CountsRepliesWithoutExecutedAction) {
  KnownPitch pitch;
  pitch.act([](PlayerActions&) {});
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_kick()->set_power(50.0F);  // no ball
  });
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_dash()->set_power(60.0F); });
  EXPECT_EQ(pitch.report.lists, 3);
  EXPECT_EQ(pitch.report.empty, 1);
  EXPECT_EQ(pitch.report.useless, 2);
  EXPECT_TRUE(automatic_by_name(pitch.report).empty());
}

TEST(Executor, SideActionsAlwaysRun) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_dash()->set_power(60.0F);
    reply.add_actions()->mutable_turn_neck()->set_moment(20.0F);
    reply.add_actions()->mutable_view_wide();
    reply.add_actions()->mutable_attention_to_of();
    reply.add_actions()->mutable_say()->mutable_wait_request_message();
  });
  EXPECT_EQ(pitch.commands.size(), 6U) << "dash, turn_neck, change_view, focus, attentionto, say";
  EXPECT_TRUE(pitch.sent<soccer::Say>()->text.starts_with("w")) << "before what we add ourselves";
  EXPECT_NE(pitch.sent<soccer::AttentionToOff>(), nullptr);
}

TEST(Executor, LowLevelActionsBecomeCommands) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.act([](PlayerActions& reply) {
    auto& kick = *reply.add_actions()->mutable_kick();
    kick.set_power(40.0F);
    kick.set_relative_direction(-10.0F);
  });
  EXPECT_DOUBLE_EQ(pitch.sent<soccer::Kick>()->power, 40.0);
  EXPECT_DOUBLE_EQ(pitch.sent<soccer::Kick>()->direction, -10.0);

  pitch.place_ball({1.5, 0.0});
  pitch.act([](PlayerActions& reply) {
    auto& tackle = *reply.add_actions()->mutable_tackle();
    tackle.set_power_or_dir(30.0F);
    tackle.set_foul(true);
  });
  EXPECT_DOUBLE_EQ(pitch.sent<soccer::Tackle>()->angle_or_power, 30.0);
  EXPECT_TRUE(pitch.sent<soccer::Tackle>()->foul);

  KnownPitch goalie;
  goalie.make_goalie();
  goalie.place_ball({0.9, 0.0});
  goalie.act([](PlayerActions& reply) { reply.add_actions()->mutable_catch_(); });

  EXPECT_NE(goalie.sent<soccer::Catch>(), nullptr);
  KnownPitch waiting;
  waiting.set_mode(PlayMode::kBeforeKickOff);

  waiting.act([](PlayerActions& reply) {
    auto& move = *reply.add_actions()->mutable_move();
    move.set_x(-12.0F);
    move.set_y(3.0F);
  });

  EXPECT_DOUBLE_EQ(waiting.sent<soccer::Move>()->x, -12.0);
  waiting.act([](PlayerActions& reply) {
    auto& attention = *reply.add_actions()->mutable_attention_to();
    attention.set_side(protos::RIGHT);
    attention.set_unum(4);
  });

  ASSERT_NE(waiting.sent<soccer::AttentionTo>(), nullptr);
  EXPECT_EQ(waiting.sent<soccer::AttentionTo>()->team.kind, soccer::TeamReference::Kind::kOpponent);
}

TEST(Executor, PreprocessTakesPrecedenceUnlessDisabled) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kBeforeKickOff);
  pitch.set_time(0, 9);
  EXPECT_TRUE(needs_preprocess(pitch.world));
  PlayerActions reply;
  reply.add_actions()->mutable_dash()->set_power(60.0F);
  pitch.act(reply);

  EXPECT_NE(pitch.sent<soccer::Move>(), nullptr);
  EXPECT_EQ(pitch.report.preprocess, 1);
  EXPECT_EQ(pitch.counts(PlayerAction::kDash).done, 0);

  reply.set_ignore_preprocess(true);
  pitch.act(reply);
  EXPECT_EQ(pitch.counts(PlayerAction::kDash).done, 1);
}

TEST(Executor, PreprocessesInPlayForEachReason) {
  KnownPitch pitch;
  EXPECT_FALSE(needs_preprocess(pitch.world));
  pitch.world.ball.pos_count = 6;
  EXPECT_TRUE(needs_preprocess(pitch.world));
  pitch.world.goalie = true;
  EXPECT_FALSE(needs_preprocess(pitch.world)) << "the goalie is more patient";

  pitch.world.ball.pos_count = 0;
  pitch.world.self.pos_count = player::kSelfPositionAgeLimit;

  EXPECT_TRUE(needs_preprocess(pitch.world));
  pitch.world.self.pos_count = 0;
  pitch.knock_down(1);
  EXPECT_TRUE(needs_preprocess(pitch.world));
}

TEST(Executor, ShootsAutomaticallyWhenCertainUnlessDisabled) {
  KnownPitch pitch;
  pitch.place_self({46.0, 0.0});
  pitch.place_ball({46.6, 0.0});
  PlayerActions reply;
  reply.add_actions()->mutable_body_hold_ball();
  reply.set_ignore_shootinpreprocess(true);
  pitch.act(reply);

  EXPECT_EQ(pitch.report.sure_shot, 0);
  reply.set_ignore_shootinpreprocess(false);
  pitch.act(reply);

  EXPECT_EQ(pitch.report.sure_shot, 1);
  EXPECT_GT(pitch.world.ball.velocity.x, 1.0);
}

TEST(Executor, KicksContestedBallAutomaticallyUnlessDisabled) {
  KnownPitch pitch;
  pitch.place_ball({0.5, 0.0});
  pitch.add_opponent(4, {1.2, 0.0});
  PlayerActions reply;
  reply.add_actions()->mutable_turn()->set_relative_direction(10.0F);
  reply.set_ignore_doforcekick(true);
  pitch.act(reply);

  EXPECT_EQ(pitch.report.force_kick, 0);
  reply.set_ignore_doforcekick(false);
  pitch.act(reply);

  EXPECT_EQ(pitch.report.force_kick, 1);
  EXPECT_NE(pitch.sent<soccer::Kick>(), nullptr);
}

TEST(Executor, IntentionTakesPrecedenceUnlessDisabled) {
  PlayerActions reply;
  auto& dribble = *reply.add_actions()->mutable_body_dribble();
  dribble.mutable_target_point()->set_x(20.0F);
  dribble.set_distance_threshold(1.0F);
  dribble.set_dash_power(100.0F);
  dribble.set_dash_count(5);
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.act(reply);

  ASSERT_TRUE(pitch.memory.intention.active());
  PlayerActions turn;
  turn.add_actions()->mutable_turn()->set_relative_direction(90.0F);
  KnownPitch forbidden = pitch;
  pitch.act(turn);
  EXPECT_EQ(pitch.report.intention, 1);
  EXPECT_NE(pitch.sent<soccer::Dash>(), nullptr);

  turn.set_ignore_dointention(true);
  forbidden.act(turn);

  EXPECT_EQ(forbidden.report.intention, 0);
  EXPECT_NE(forbidden.sent<soccer::Turn>(), nullptr);
}

TEST(Executor, KeepsPlaymakersNeckActionUnlessBehaviorQueuesOne) {
  KnownPitch pitch;
  pitch.place_ball({0.0, -30.0});
  pitch.act(
      [](PlayerActions& reply) { reply.add_actions()->mutable_turn_neck()->set_moment(70.0F); });

  EXPECT_DOUBLE_EQ(pitch.sent<soccer::TurnNeck>()->moment, 70.0);
  pitch.set_neck(0.0);
  pitch.world.ball.pos_count = 2;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_helios_basic_move();
    reply.add_actions()->mutable_turn_neck()->set_moment(70.0F);
  });

  EXPECT_NE(pitch.sent<soccer::TurnNeck>()->moment, 70.0);
}

TEST(Executor, SelectsViewOnlyWithoutViewAction) {
  KnownPitch pitch;
  pitch.place_ball({-45.0, 0.0});
  pitch.act([](PlayerActions&) {});
  EXPECT_EQ(pitch.world.self.view_width, soccer::ViewWidth::kWide) << "far from play";
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_view_synch(); });
  EXPECT_EQ(pitch.world.self.view_width, soccer::ViewWidth::kNarrow);
}

TEST(Executor, EmptyReplySendsNoBodyCommand) {
  KnownPitch pitch;
  pitch.act([](PlayerActions&) {});
  ASSERT_NE(pitch.sent<soccer::Turn>(), nullptr);
  EXPECT_EQ(pitch.sent<soccer::Turn>()->moment, 0.0);
}

TEST(Executor, CountsUnknownActions) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions();  // no member set
    reply.add_actions()->mutable_say();
    reply.add_actions()->mutable_dash()->set_power(10.0F);
  });

  EXPECT_EQ(pitch.counts(PlayerAction::ACTION_NOT_SET).unimplemented, 1);
  EXPECT_EQ(pitch.report.say[0].unimplemented, 1);
  EXPECT_NE(pitch.sent<soccer::Dash>(), nullptr) << "falls through to what can be done";
  EXPECT_EQ(action_name(PlayerAction::kHeliosSetPlay), "helios_set_play");
  EXPECT_EQ(action_name(0), "unknown");
  EXPECT_EQ(say_name(protos::Say::kBallMessage), "ball_message");
}

TEST(Executor, EveryMemberHasAHandler) {
  const auto* type = PlayerAction::descriptor();
  for (int i = 0; i < type->field_count(); ++i) {
    EXPECT_NE(action_entry(type->field(i)->number()).handler, nullptr) << type->field(i)->name();
  }
}

/// The say message for the payload, without automatic communication.
std::string said(const std::function<void(protos::Say&)>& fill) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kBeforeKickOff);
  pitch.act([&](PlayerActions& reply) { fill(*reply.add_actions()->mutable_say()); });
  const auto* say = pitch.sent<soccer::Say>();
  return say == nullptr ? "" : say->text;
}

TEST(Executor, FormatsEverySayMessageAsHelios) {
  EXPECT_EQ(said([](protos::Say& say) { say.mutable_wait_request_message(); }), "w");
  const std::string ball = said(
      [](protos::Say& say) { say.mutable_ball_message()->mutable_ball_position()->set_x(10.0F); });
  EXPECT_EQ(ball.size(), 6U);
  EXPECT_EQ(ball[0], 'b');
  const std::string pass =
      said([](protos::Say& say) { say.mutable_pass_message()->set_receiver_uniform_number(9); });

  EXPECT_EQ(pass.size(), 10U);
  EXPECT_EQ(pass[0], 'p');

  struct Case {
    int field;
    char header;
    std::size_t size;
  };

  // Messages that can be formatted with zero values, with header and length.
  for (const Case& c : {Case{9, 'F', 2}, Case{10, 'h', 4}, Case{11, 's', 2}, Case{12, 'r', 2},
                        Case{13, 'c', 2}, Case{14, 'D', 4}, Case{19, 'S', 5}}) {
    const std::string text = said([&](protos::Say& say) {
      const auto* field = protos::Say::descriptor()->FindFieldByNumber(c.field);
      say.GetReflection()->MutableMessage(&say, field);
    });
    ASSERT_EQ(text.size(), c.size) << c.field;
    EXPECT_EQ(text[0], c.header) << c.field;
  }

  EXPECT_EQ(said([](protos::Say& say) {
              say.mutable_offside_line_message()->set_offside_line_x(30.0F);
            })[0],
            'o');
  EXPECT_EQ(said([](protos::Say& say) { say.mutable_one_player_message(); }), "")
      << "no player has number 0";
}

TEST(Executor, CountsTextsAndShapes) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    auto& text = *reply.add_actions()->mutable_log()->mutable_add_text();
    text.set_level(protos::TEAM);
    text.set_message("two\nlines");
    auto& circle = *reply.add_actions()->mutable_log()->mutable_add_circle();
    circle.set_level(protos::PASS);
    circle.mutable_center()->set_x(1.5F);
    circle.set_radius(2.0F);
    circle.set_color("red");
    circle.set_fill(true);
    reply.add_actions()->mutable_debug_client()->set_message("hello");
  });

  EXPECT_EQ(pitch.counts(PlayerAction::kLog).done, 2);
  EXPECT_EQ(pitch.counts(PlayerAction::kDebugClient).done, 1);

  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_log(); });
  EXPECT_EQ(pitch.counts(PlayerAction::kLog).failed, 1) << "nothing set";
}

TEST(Executor, RejectsActionsWithNonFiniteNumbers) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    auto& go = *reply.add_actions()->mutable_body_go_to_point();
    go.mutable_target_point()->set_x(std::numeric_limits<float>::quiet_NaN());
    go.set_max_dash_power(100.0F);
    reply.add_actions()->mutable_turn_neck()->set_moment(std::numeric_limits<float>::infinity());
  });
  EXPECT_EQ(pitch.counts(PlayerAction::kBodyGoToPoint).invalid, 1);
  EXPECT_EQ(pitch.counts(PlayerAction::kTurnNeck).invalid, 1);
  EXPECT_EQ(pitch.sent<soccer::Dash>(), nullptr);
}

int limited(double number, double limit) {
  return std::isnan(number) ? 0 : static_cast<int>(std::clamp(number, -limit, limit));
}

/// Fills every number of a message, including nested messages.
void fill_numbers(google::protobuf::Message& message, double number) {
  const auto& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const auto* field = message.GetDescriptor()->field(i);
    if (field->is_repeated()) continue;

    switch (field->cpp_type()) {
      case google::protobuf::FieldDescriptor::CPPTYPE_FLOAT:
        reflection.SetFloat(&message, field, static_cast<float>(number));
        break;
      case google::protobuf::FieldDescriptor::CPPTYPE_INT32:
        reflection.SetInt32(&message, field, limited(number, 2e9));
        break;
      case google::protobuf::FieldDescriptor::CPPTYPE_ENUM:
        reflection.SetEnumValue(&message, field, limited(number, 99.0));
        break;
      case google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE:
        if (field->containing_oneof() == nullptr) {
          fill_numbers(*reflection.MutableMessage(&message, field), number);
        }
        break;
      default:
        break;
    }
  }
}

TEST(Executor, EveryActionAcceptsAnyNumberInAnySituation) {
  const auto* type = PlayerAction::descriptor();
  for (int situation = 0; situation < 4; ++situation) {
    for (const double number : {0.0, 1.0, -1.0, 50.0, -7.5, 3e38, -3e38}) {
      for (int i = 0; i < type->field_count(); ++i) {
        KnownPitch pitch;
        if (situation == 1) pitch.place_ball({0.6, 0.1}, {0.3, -0.2});
        if (situation == 2)
          pitch.world.self.pos_count = pitch.world.ball.pos_count = player::kNever;
        if (situation == 3) pitch.knock_down(4);

        pitch.add_opponent(4, {1.9, 0.2});
        pitch.act([&](PlayerActions& reply) {
          PlayerAction& action = *reply.add_actions();
          const auto& reflection = *action.GetReflection();
          fill_numbers(*reflection.MutableMessage(&action, type->field(i)), number);
        });

        std::string text;
        for (const soccer::PlayerCommand& command : pitch.commands) {
          EXPECT_TRUE(soccer::format(command, text))
              << type->field(i)->name() << " " << number << " " << situation;
        }
        const player::ActionCounts& counts =
            pitch.report.actions[base::index(type->field(i)->number())];
        EXPECT_EQ(counts.done + counts.failed, 1) << type->field(i)->name();
      }
    }
  }
}

TEST(Executor, LooksForBallWithoutReply) {
  KnownPitch pitch;
  pitch.place_ball({0.0, 20.0});
  pitch.world.ball.pos_count = 3;
  player::CommandSlots slots(pitch.world);
  execute_without_reply(pitch.world, pitch.memory, slots, pitch.report);
  EXPECT_FALSE(slots.has_body());
  EXPECT_GT(slots.next_neck(), 40.0);
}

TEST(Executor, AddsReports) {
  player::ActionReport sum;
  player::ActionReport one;
  one.actions[16].done = 2;
  one.say[1].unimplemented = 3;
  one.preprocess = 1;
  add(sum, one);
  add(sum, one);
  EXPECT_EQ(sum.actions[16].done, 4);
  EXPECT_EQ(sum.say[1].unimplemented, 6);
  EXPECT_EQ(sum.preprocess, 2);
}

}  // namespace
}  // namespace cls::proxy
