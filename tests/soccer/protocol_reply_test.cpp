// Short server messages and message kinds.
#include <gtest/gtest.h>

#include "soccer/messages/server_reply.h"
#include "soccer/protocol/message_kind.h"

namespace cls::soccer {
namespace {

template <typename Reply>
Reply read(std::string_view text) {
  ServerReply reply;
  const base::Result<void> done = parse(text, reply);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return std::get<Reply>(reply);
}

TEST(ServerReply, RoundTripsMessagesOfRcssserver) {
  for (const char* text : {"(init l 1 before_kick_off)",
                           "(init r 11 play_on)",
                           "(init l ok)",
                           "(init ok)",
                           "(reconnect l drop_ball)",
                           "(error illegal_command_form)",
                           "(error no team with name Nope)",
                           "(warning message_not_null_terminated)",
                           "(think)",
                           "(score 0 1 2)",
                           "(change_player_type 11 10)",
                           "(change_player_type 2)",
                           "(change_player_type l 3 goalie)",
                           "(clang (ver (p \"HELIOS_L\" 1 goalie) 7 8))",
                           "(include 5 a(b)c)",
                           "(ok synch_see)",
                           "(ok gaussian_see)",
                           "(ok clang (ver 7 8))",
                           "(ok compression 9)",
                           "(ok compression -1)",
                           "(ok eye on)",
                           "(ok eye off)",
                           "(ok ear on)",
                           "(ok ear off)",
                           "(ok team_names)\n",
                           "(ok team_names (team l HELIOS_L))\n",
                           "(ok team_names (team l LeftTeam) (team r RightTeam))\n",
                           "(ok check_ball 0 in_field)",
                           "(ok check_ball 12 goal_l)",
                           "(ok check_ball 12 goal_r)",
                           "(ok check_ball 3 out_of_field)",
                           "(ok change_player_type 1 0)",
                           "(ok change_player_type 4 goalie)",
                           "(ok change_player_type HELIOS_L 7 3)",
                           "(ok change_player_type 7 7 3)",
                           "(ok say)",
                           "(ok team_graphic 0 0)",
                           "(ok start)",
                           "(ok change_mode)",
                           "(ok move)",
                           "(ok recover)\n"}) {
    ServerReply reply;
    const base::Result<void> done = parse(text, reply);
    ASSERT_TRUE(done) << done.error().message;
    std::string again;
    format(reply, again);
    EXPECT_EQ(again, text);
  }
}

TEST(ServerReply, ParsesAllFields) {
  const auto init = read<PlayerInitReply>("(init r 7 kick_off_l)");
  EXPECT_EQ(init.side, Side::kRight);
  EXPECT_EQ(init.unum, 7);
  EXPECT_EQ(init.mode, PlayMode::kKickOffLeft);
  EXPECT_EQ(read<CoachInitReply>("(init r ok)").side, Side::kRight);
  EXPECT_EQ(read<CoachInitReply>("(init ok)").side, Side::kNeutral);
  EXPECT_EQ(read<ErrorReply>("(error no_more_team)").code, ErrorCode::kNoMoreTeam);

  const auto unknown = read<ErrorReply>("(error no team with name X)");
  EXPECT_FALSE(unknown.code);
  EXPECT_EQ(unknown.text, "no team with name X");
  EXPECT_EQ(read<WarningReply>("(warning no_subs_left)").code, WarningCode::kNoSubstitutionsLeft);

  const auto score = read<ScoreReply>("(score 10 1 2)");
  EXPECT_EQ(score.our, 1);
  EXPECT_EQ(score.opponent, 2);
  EXPECT_EQ(read<PlayerTypeChange>("(change_player_type 11 10)").type, 10);
  EXPECT_FALSE(read<PlayerTypeChange>("(change_player_type 11)").type);
  EXPECT_EQ(read<PlayerTypeChange>("(change_player_type r 3 goalie)").goalie_side, Side::kRight);
  EXPECT_EQ(read<OkChangePlayerType>("(ok change_player_type 7 7 3)").team.view(), "7");
  EXPECT_EQ(read<OkCheckBall>("(ok check_ball 12 goal_l)").place, BallPlace::kGoalLeft);
}

TEST(ServerReply, RejectsInvalidForms) {
  for (const char* text : {"",
                           "(",
                           "(init)",
                           "(init l)",
                           "(init l 12 play_on)",
                           "(init l 0 play_on)",
                           "(init l 1 playing)",
                           "(init x 1 play_on)",
                           "(reconnect l 1 play_on)",
                           "(think) ",
                           "(think",
                           "(ok)",
                           "(ok nothing)",
                           "(ok synch_see) ",
                           "(score 1 2)",
                           "(error",
                           "(change_player_type)",
                           "(change_player_type 12 1)",
                           "(change_player_type 1 goalie)",
                           "(include 7 abc)",
                           "(include -1 abc)",
                           "(ok eye maybe)",
                           "(foo)"}) {
    ServerReply reply;
    EXPECT_FALSE(parse(text, reply)) << text;
  }
}

TEST(ReplyCode, HasTextsOfRcssserver) {
  std::string text;
  format(ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion, text);
  format(WarningCode::kMovingToOpponentField, text);
  EXPECT_EQ(text,
            "(error no_more_player_or_goalie_or_illegal_client_version)"
            "(warning moving_to_opponent_field)");
  EXPECT_EQ(name(ErrorCode::kTrainerWithoutCoachMode),
            "connected_offline_coach_without_coach_mode");

  EXPECT_EQ(name(ErrorCode::kTooManyMoves), "too_many_moves");
  EXPECT_EQ(name(ErrorCode::kSaidTooManyDelete), "said_too_many_del_messages");
  EXPECT_EQ(name(WarningCode::kNoLeftOfThatType), "no_left_of_that_type");
  EXPECT_FALSE(parse_error_code("nonsense"));
}

TEST(MessageKind, DependsOnFirstToken) {
  EXPECT_EQ(message_kind("(see 0)"), MessageKind::kSee);
  EXPECT_EQ(message_kind("(see_global 0 "), MessageKind::kGlobalView);
  EXPECT_EQ(message_kind("(ok look 0 "), MessageKind::kGlobalView);
  EXPECT_EQ(message_kind("(ok say)"), MessageKind::kReply);
  EXPECT_EQ(message_kind("(sense_body 0 "), MessageKind::kSenseBody);
  EXPECT_EQ(message_kind("(hear 0 self \"a\")"), MessageKind::kHear);

  EXPECT_EQ(message_kind("(server_param (goal_width 14.02))"), MessageKind::kServerParam);
  EXPECT_EQ(message_kind("(player_param "), MessageKind::kPlayerParam);
  EXPECT_EQ(message_kind("(player_type "), MessageKind::kPlayerType);
  EXPECT_EQ(message_kind("(think)"), MessageKind::kReply);
  EXPECT_EQ(message_kind("(show 1 "), MessageKind::kUnknown);
  EXPECT_EQ(message_kind(""), MessageKind::kUnknown);
}

}  // namespace
}  // namespace cls::soccer
