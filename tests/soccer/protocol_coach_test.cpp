// Commands of online coaches and trainers, and the error replies of rcssserver.
#include <gtest/gtest.h>

#include <cmath>

#include "soccer/commands/coach_command.h"

namespace cls::soccer {
namespace {

std::string read(CoachRole role, std::string_view datagram) {
  CoachCommand command;
  if (const std::optional<ErrorCode> error = parse(datagram, role, command)) {
    return std::string(name(*error));
  }
  std::string text;
  EXPECT_TRUE(format(command, text)) << datagram;
  return text;
}

std::string coach(std::string_view datagram) { return read(CoachRole::kOnlineCoach, datagram); }
std::string trainer(std::string_view datagram) { return read(CoachRole::kTrainer, datagram); }

constexpr std::string_view kGraphic =
    "(team_graphic (0 0 \"8 8 2 1\" \"a c #FFFFFF\" \"b c #000000\" \"aaaaaaaa\" \"aaaaaaaa\" "
    "\"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"abababab\"))";

TEST(CoachCommand, ParsesRecordedOnlineCoachCommands) {
  for (const std::string_view text :
       {std::string_view("(look)"), std::string_view("(eye on)"), std::string_view("(eye off)"),
        std::string_view("(team_names)"), std::string_view("(check_ball)"),
        std::string_view("(change_player_type 11 10)"),
        std::string_view("(change_player_type 1 goalie)"),
        std::string_view("(say (freeform \"hello world\"))"),
        std::string_view("(say (advice (10 (true) (do our {1} (hold)))))"),
        std::string_view("(done)"), std::string_view("(bye)"), std::string_view("(compression 6)"),
        kGraphic}) {
    EXPECT_EQ(coach(text), text);
  }
}

TEST(CoachCommand, ParsesRecordedTrainerCommands) {
  for (const char* text :
       {"(look)", "(eye on)", "(ear on)", "(ear off)", "(team_names)", "(check_ball)", "(start)",
        "(change_player_type HELIOS_L 7 3)", "(say hello_everyone)", "(say hello world)",
        "(change_mode free_kick_l)", "(move (ball) 10 5)", "(move (ball) 10 5 0 1 0)",
        "(move (player TA 1) -48 0 0)", "(move (player TA 2) 0 20)",
        "(move (player HELIOS_L 9) 5 5 0 0 0)", "(recover)", "(done)", "(compression -1)"}) {
    EXPECT_EQ(trainer(text), text);
  }
}

TEST(CoachCommand, ReturnsErrorsOfRcssserver) {
  EXPECT_EQ(coach("(foo)"), "unknown_command");
  EXPECT_EQ(coach("(ear on)"), "unknown_command");
  EXPECT_EQ(coach("(eye maybe)"), "illegal_command_form");
  EXPECT_EQ(coach("foo"), "illegal_command_form");
  EXPECT_EQ(coach("()"), "illegal_command_form");
  EXPECT_EQ(coach(""), "illegal_command_form");
  EXPECT_EQ(coach("(change_player_type x y)"), "illegal_command_form");
  EXPECT_EQ(coach("(say hello)"), "could_not_parse_say");
  EXPECT_EQ(coach("(say (advice (10 (true) (do our {1} (hold)))))(eye on)"), "could_not_parse_say");

  EXPECT_EQ(trainer("(move (player LeftTeam 1) -5 5 30 0.1)"), "illegal_command_form");
  EXPECT_EQ(trainer("(move (ball))"), "illegal_object_form");
  EXPECT_EQ(trainer("(move (player TA 12) 1 2)"), "illegal_object_form");
  EXPECT_EQ(trainer("(move (goal) 1 2)"), "illegal_object_form");
  EXPECT_EQ(trainer("(change_mode nonsense)"), "illegal_mode");
  EXPECT_EQ(trainer("(change_mode)"), "illegal_command_form");
  EXPECT_EQ(trainer("(bye)"), "unknown_command");
  EXPECT_EQ(trainer("(team_graphic (0 0 \"1 1 1 1\" \"a c #FFFFFF\" \"a\"))"), "unknown_command");
  EXPECT_EQ(trainer("(say )"), "illegal_command_form");
}

TEST(CoachCommand, ParsesOnlyFirstCommandOfDatagram) {
  EXPECT_EQ(trainer("(eye on)(ear on)"), "(eye on)");
  EXPECT_EQ(coach("(change_player_type 3 4)(done)"), "(change_player_type 3 4)");
  EXPECT_EQ(trainer("  ( start"), "(start)");
}

TEST(CoachCommand, TrainerSayEndsAtFirstInvalidCharacter) {
  CoachCommand command;
  ASSERT_FALSE(parse("(say (freeform \"hello\"))", CoachRole::kTrainer, command));
  EXPECT_EQ(std::get<TrainerSay>(command).text, "(freeform ");
}

TEST(CoachCommand, FreeformReturnsTextBetweenQuotes) {
  CoachCommand command;
  ASSERT_FALSE(parse("(say (freeform \"a b(c)\"))", CoachRole::kOnlineCoach, command));
  EXPECT_EQ(std::get<CoachSay>(command).kind, ClangKind::kFreeform);
  EXPECT_EQ(std::get<CoachSay>(command).freeform(), "a b(c)");

  for (const char* text :
       {"(say (freeform \"\"))", "(say (freeform \"a!\"))", "(say (freeform a))",
        "(say (freeform \"a\" \"b\"))", "(say (freeform \"a\")", "(say (freeform \"a)",
        "(say (nonsense 1))", "(say (info (1)", "(say)", "(say ())"}) {
    EXPECT_EQ(coach(text), "could_not_parse_say") << text;
  }
}

TEST(CoachCommand, InvalidXpmKeepsTileLocation) {
  CoachCommand command;

  EXPECT_EQ(parse("(team_graphic (3 4 \"8 8 1 1\"))", CoachRole::kOnlineCoach, command),
            ErrorCode::kInvalidXpmData);
  EXPECT_EQ(std::get<TeamGraphic>(command).x, 3);
  EXPECT_EQ(std::get<TeamGraphic>(command).y, 4);
  EXPECT_EQ(coach("(team_graphic (3))"), "illegal_command_form");
  EXPECT_EQ(coach("(team_graphic (0 0 \"2 1 1 1\" \"a c #FFFFFF\" \"aaa\"))"), "invalid_xpm_data");
  EXPECT_EQ(coach("(team_graphic (0 0 \"-1 1 1 1\" \"a\" \"a\"))"), "invalid_xpm_data");
  EXPECT_EQ(coach("(team_graphic (0 0 \"1 2147483647 1 1\" \"a\" \"a\"))"), "invalid_xpm_data");
}

TEST(CoachCommand, DoesNotFormatWhatServerRejects) {
  std::string text = "before";

  for (const CoachCommand& command : std::vector<CoachCommand>{
           MoveBall{{std::nan(""), 0}, {}, {}}, MoveBall{{0, 0}, {}, Vec2{1, 1}},
           MovePlayer{"a b", 1, {0, 0}, {}, {}},
           MovePlayer{std::string(kMaxMoveObjectSize, 'a'), 1, {0, 0}, {}, {}}, TrainerSay{""},
           TrainerSay{"a\"b"}, CoachSay{ClangKind::kFreeform, "(freeform \"a!\")"},
           CoachSay{ClangKind::kInfo, "(freeform \"a\")"}, ChangeMode{PlayMode::kNull},
           TrainerChangePlayerType{"", 1, 2}, TeamGraphic{0, 0, {"a\"b"}}}) {
    EXPECT_FALSE(format(command, text));
    EXPECT_EQ(text, "before");
  }
}

}  // namespace
}  // namespace cls::soccer
