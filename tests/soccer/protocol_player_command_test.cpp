// Player commands by the grammar of rcssserver.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "soccer/commands/player_command.h"

namespace cls::soccer {
namespace {

std::string text_of(const std::vector<PlayerCommand>& commands) {
  std::string text;
  for (const PlayerCommand& command : commands) EXPECT_TRUE(format(command, text));
  return text;
}

// The commands of a datagram, formatted again, then " !" and the byte of a syntax error.
std::string read(std::string_view datagram) {
  std::vector<PlayerCommand> commands;
  const std::optional<std::size_t> error = parse_player_commands(datagram, commands);
  return text_of(commands) + (error ? " !" + std::to_string(*error) : "");
}

template <typename Command>
Command only(std::string_view datagram) {
  std::vector<PlayerCommand> commands;
  EXPECT_FALSE(parse_player_commands(datagram, commands)) << datagram;
  EXPECT_EQ(commands.size(), 1u);
  return std::get<Command>(commands.at(0));
}

TEST(PlayerCommand, ParsesRecordedDatagrams) {
  const Dash dash = only<Dash>("(dash 100 -30)");

  EXPECT_EQ(dash.power, 100);
  EXPECT_EQ(dash.direction, -30);

  for (const char* datagram : {"(turn 0)(turn_neck 0)(change_view wide)(done)",
                               "(move -25 -5)(turn_neck 0)(done)",
                               "(ear (off opp))(clang (ver 7 8))",
                               "(say \"hello\")",
                               "(attentionto our 2)",
                               "(pointto 10 20)",
                               "(change_focus 10 20)",
                               "(dash (l 50 10) (r 50 10))",
                               "(synch_see)",
                               "(gaussian_see)",
                               "(tackle 30 on)",
                               "(catch 1000)",
                               "(compression 10)",
                               "(score)",
                               "(sense_body)",
                               "(bye)",
                               "(attentionto off)",
                               "(pointto off)",
                               "(ear (on our partial))",
                               "(attentionto T-B 1)",
                               "(change_view narrow low)",
                               "(kick 63.4028 -117.2)"}) {
    EXPECT_EQ(read(datagram), datagram);
  }
}

TEST(PlayerCommand, ParsesAlternativeSpellings) {
  EXPECT_EQ(read("(turn  -.5 )"), "(turn -0.5)");
  EXPECT_EQ(read("(turn .5)"), "(turn 0.5)");
  EXPECT_EQ(read("(turn 1e2)"), "(turn 100)");
  EXPECT_EQ(read("(dash 1e2 -1.5)"), "(dash 100 -1.5)");
  EXPECT_EQ(read(" ( turn\t10 )\n(done)\n"), "(turn 10)(done)");
  EXPECT_EQ(read("(turn+10)"), "(turn 10)");
  EXPECT_EQ(read("(kick 10+5)"), "(kick 10 5)");

  EXPECT_EQ(read("(kick 1.5.5)"), "(kick 1.5 0.5)");
  EXPECT_EQ(read("(dash (right 10 0)(left 20 0))"), "(dash (l 20 0) (r 10 0))");
  EXPECT_EQ(read("(dash (left 10 0))"), "(dash (l 10 0))");
  EXPECT_EQ(read("(tackle 20 true)(tackle 1 false)(tackle 2 off)"),
            "(tackle 20 on)(tackle 1)(tackle 2)");
  EXPECT_EQ(read("(ear (on left c))(ear (off p))(ear (on))(ear (off Nope complete))"),
            "(ear (on l complete))(ear (off partial))(ear (on))(ear (off Nope complete))");
  EXPECT_EQ(read("(attentionto right -3)(attentionto opp 99)"),
            "(attentionto r -3)(attentionto opp 99)");
  EXPECT_EQ(read("(change_view normal high)(long_kick 1 2)"),
            "(change_view normal high)(long_kick 1 2)");
}

TEST(PlayerCommand, UnquotedSayExtendsToLastParenthesis) {
  EXPECT_EQ(only<Say>("(say hello)").text, "hello");
  EXPECT_EQ(only<Say>("(say hello)(turn 10)(dash 5)").text, "hello)(turn 10)(dash 5");
  EXPECT_EQ(only<Say>("(say  two words)").text, " two words");
  EXPECT_EQ(only<Say>("( say hello)").text, "hello");
  EXPECT_EQ(only<Say>("( say \"a b\")").text, "a b");
  EXPECT_EQ(only<Say>("(say turn)").text, "turn");
  EXPECT_EQ(only<Say>("(say ())").text, "()");
  EXPECT_EQ(read("(say hello)(say \"x\")"), "(say \"hello\")(say \"x\")");
}

TEST(PlayerCommand, KeepsCommandsBeforeSyntaxError) {
  EXPECT_EQ(read("(turn 10)(foo)(turn_neck 5)"), "(turn 10) !10");
  EXPECT_EQ(read("(turn 10)("), "(turn 10) !10");
  EXPECT_EQ(read("(turn 10)x"), "(turn 10) !9");
  EXPECT_EQ(read("(turn 10"), " !8");
}

TEST(PlayerCommand, KeepsLegBeforeSyntaxError) {
  EXPECT_EQ(read("(dash (l 50 10)(x 50 10))"), "(dash (l 50 10)) !16");
  EXPECT_EQ(read("(dash (l 50 10)(l 50 10))"), "(dash (l 50 10)) !16");
  EXPECT_EQ(read("(dash (l 50 10) foo"), "(dash (l 50 10)) !16");
  EXPECT_EQ(read("(dash (l 50))"), " !11");
}

TEST(PlayerCommand, RejectsWhatRcssserverRejected) {
  EXPECT_EQ(read("(turn abc)"), " !6");
  EXPECT_EQ(read("(turn 5.)"), " !7");
  EXPECT_EQ(read("(dash 10 nan)"), " !9");
  EXPECT_EQ(read("(foo)"), " !1");
  EXPECT_EQ(read("(dash)"), " !5");
  EXPECT_EQ(read("(say \"\")"), " !5");
  EXPECT_EQ(read(""), " !0");
  EXPECT_EQ(read(" "), " !1");
}

TEST(PlayerCommand, RejectsOtherInvalidForms) {
  for (const char* datagram : {"turn 10",
                               "(turn)",
                               "(turn 1 2)",
                               "(turn10)",
                               "(turn-10)",
                               "(kick 10-5)",
                               "(turn --5)",
                               "(turn inf)",
                               "(turn 0x10)",
                               "(turn 1e)",
                               "(kick 1)",
                               "(move 1)",
                               "(catch)",
                               "(compression 1.0)",
                               "(compression 1e1)",
                               "(attentionto our 1.0)",
                               "(attentionto our)",
                               "(attentionto turn 3)",
                               "(pointto 1)",
                               "(pointto on)",
                               "(change_view)",
                               "(change_view huge)",
                               "(change_view wide middle)",
                               "(tackle 1 yes)",
                               "(tackle on)",
                               "(clang (ver 7))",
                               "(clang ver 7 8)",
                               "(clang (ver 7 8)",
                               "(ear on)",
                               "(ear ())",
                               "(ear (our))",
                               "(ear (on our left))",
                               "(done 1)",
                               "(say)",
                               "(say )",
                               "(say hello",
                               "(say \"a)",
                               "(say \"a!\")",
                               "( say turn)",
                               "( say 5)",
                               "(turn 10)\r\n",
                               "(turn 10)\x01",
                               "(turn \xc3\xa9)",
                               "()",
                               "(())",
                               ")"}) {
    std::vector<PlayerCommand> commands;
    EXPECT_TRUE(parse_player_commands(datagram, commands)) << datagram;
  }
}

TEST(PlayerCommand, AppendsToExistingCommands) {
  std::vector<PlayerCommand> commands = {Done{}};
  EXPECT_FALSE(parse_player_commands("(turn 1)", commands));
  EXPECT_EQ(text_of(commands), "(done)(turn 1)");
}

TEST(PlayerCommand, DoesNotFormatWhatGrammarCannotExpress) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto named = [](std::string name) {
    return TeamReference{TeamReference::Kind::kNamed, std::move(name)};
  };
  std::string text = "before";

  for (const PlayerCommand& command : std::vector<PlayerCommand>{
           Turn{std::nan("")}, Dash{infinity, 0}, Dash{100, -infinity}, Kick{1, std::nan("")},
           LegDash{}, LegDash{Dash{1, 2}, Dash{infinity, 0}}, Tackle{infinity, true}, Say{""},
           Say{"a\"b"}, Say{"a!"}, Say{"\n"}, AttentionTo{named("a b"), 1},
           AttentionTo{named("turn"), 1}, AttentionTo{named("our"), 1}, AttentionTo{named("7"), 1},
           AttentionTo{named(""), 1}, Ear{true, named("x)"), std::nullopt}}) {
    EXPECT_FALSE(format(command, text));
    EXPECT_EQ(text, "before");
  }
}

TEST(PlayerCommand, FormatsNumbersInShortestForm) {
  std::string text;
  EXPECT_TRUE(format(Dash{100, 0}, text));
  EXPECT_TRUE(format(Turn{0.1 + 0.2}, text));
  EXPECT_TRUE(format(Kick{1e-7, -1e22}, text));
  EXPECT_EQ(text, "(dash 100)(turn 0.30000000000000004)(kick 1e-07 -1e+22)");
  EXPECT_EQ(read(text), text);
}

}  // namespace
}  // namespace cls::soccer
