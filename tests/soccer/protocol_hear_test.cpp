// hear messages of rcssserver for all senders and recipients.
#include <gtest/gtest.h>

#include "soccer/messages/hear.h"

namespace cls::soccer {
namespace {

using Sender = Hear::Sender;

struct Case {
  const char* text;
  Recipient recipient;
  Sender sender;
  int time;
  const char* said;
};

constexpr Case kRecorded[] = {
    {"(hear 0 referee kick_off_l)", Recipient::kPlayer, Sender::kReferee, 0, "kick_off_l"},
    {"(hear 36 referee goal_l_1)", Recipient::kPlayer, Sender::kReferee, 36, "goal_l_1"},
    {"(hear 0 self \"hello\")", Recipient::kPlayer, Sender::kSelf, 0, "hello"},
    {"(hear 0 180 our 3 \"x2\")", Recipient::kPlayer, Sender::kTeammate, 0, "x2"},
    {"(hear 30 106 opp \"one\")", Recipient::kPlayer, Sender::kOpponent, 30, "one"},
    {"(hear 36 our 1)", Recipient::kPlayer, Sender::kTeammate, 36, ""},
    {"(hear 36 opp)", Recipient::kPlayer, Sender::kOpponent, 36, ""},
    {"(hear 10 coach \"hello_everyone\")", Recipient::kPlayer, Sender::kTrainer, 10,
     "hello_everyone"},
    {"(hear 0 online_coach_left (freeform \"hello world\"))", Recipient::kPlayer,
     Sender::kOnlineCoachLeft, 0, "(freeform \"hello world\")"},
    {"(hear 0 online_coach_right (unsupported_clang))", Recipient::kPlayer,
     Sender::kOnlineCoachRight, 0, "(unsupported_clang)"},
    {"(hear 9 referee hello_everyone)", Recipient::kOnlineCoach, Sender::kReferee, 9,
     "hello_everyone"},
    {"(hear 0 referee (freeform )", Recipient::kOnlineCoach, Sender::kReferee, 0, "(freeform "},
    {"(hear referee 0 free_kick_l)", Recipient::kTrainer, Sender::kReferee, 0, "free_kick_l"},
    {"(hear 0 referee \"hello world\")", Recipient::kTrainer, Sender::kTrainer, 0, "hello world"},
    {"(hear 29 (p \"TB\" 1) \"three\")", Recipient::kTrainer, Sender::kPlayer, 29, "three"},
    {"(hear 6 (p \"HELIOS_R\" 1 goalie) \"BybAr6rnqC\")", Recipient::kOnlineCoach, Sender::kPlayer,
     6, "BybAr6rnqC"},
    {"(hear 5 online_coach_left \"(freeform \"hi\")\")", Recipient::kTrainer,
     Sender::kOnlineCoachLeft, 5, "(freeform \"hi\")"},
};

TEST(Hear, ParsesAndFormatsAllForms) {
  Hear hear;

  for (const Case& one : kRecorded) {
    const base::Result<void> done = parse(one.text, hear);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(hear.sender, one.sender) << one.text;
    EXPECT_EQ(hear.time, one.time) << one.text;
    EXPECT_EQ(hear.text, one.said) << one.text;
    std::string text;
    format(hear, one.recipient, text);
    EXPECT_EQ(text, one.text);
  }
}

TEST(Hear, ParsesSenderAndDirection) {
  Hear hear;

  ASSERT_TRUE(parse("(hear 36 -89 our 1 \"p2\")", hear));
  EXPECT_EQ(hear.direction, -89);
  EXPECT_EQ(hear.unum, 1);
  EXPECT_FALSE(hear.partial);
  ASSERT_TRUE(parse("(hear 36 our 11)", hear));
  EXPECT_TRUE(hear.partial);
  EXPECT_EQ(hear.unum, 11);
  ASSERT_TRUE(parse("(hear 6 (p \"HELIOS_R\" 1 goalie) \"BybAr6rnqC\")", hear));
  EXPECT_EQ(hear.team.view(), "HELIOS_R");
  EXPECT_TRUE(hear.goalie);
  EXPECT_FALSE(hear.partial);
}

TEST(Hear, SendsTrainerAsRefereeToOnlineCoaches) {
  Hear hear;
  hear.time = 9;
  hear.sender = Sender::kTrainer;
  hear.text = "hello_everyone";
  std::string text;
  format(hear, Recipient::kOnlineCoach, text);
  EXPECT_EQ(text, "(hear 9 referee hello_everyone)");
}

TEST(Hear, RejectsInvalidForms) {
  for (const char* text :
       {"", "(hear", "(hear )", "(hear x referee a)", "(hear 1 referee )", "(hear 1 referee a",
        "(hear 1 nobody \"a\")", "(hear 1 self a)", "(hear 1 self \"a)", "(hear 1 self \"\")",
        "(hear 1 20 our \"a\")", "(hear 1 20 our 12 \"a\")", "(hear 1 20 opp 3 \"a\")",
        "(hear 1 our)", "(hear 1 opp \"a\")", "(hear 1 (p TB 1) \"a\")", "(hear 1 20 \"a\")"}) {
    Hear hear;
    EXPECT_FALSE(parse(text, hear)) << text;
  }

  Hear hear;
  EXPECT_EQ(parse("(hear 1 nobody \"a\")", hear).error().message,
            "hear: byte 8: expected 'an integer', found 'nobody \"a\")'");
}

}  // namespace
}  // namespace cls::soccer
