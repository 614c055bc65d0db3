// Text logs: literal lines with special cases, and whole rcssserver logs compared with the
// protocol's parser.
#include "gamelog/rcl/rcl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "gamelog/rcl/logged_commands.h"
#include "soccer/commands/player_command.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"

namespace cls::gamelog {
namespace {

using testing::ElementsAre;
using testing::Pair;

RclRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcl(source);
}

TEST(ReadRcl, ReadsPlayersCoachesTrainerAndReferee) {
  const RclRecord record = read(
      "0,0\tRecv HELIOS_L_1: (init HELIOS_L (version 18) (goalie))\n"
      "0,10\tRecv HELIOS_R_Coach: (eye on)\n"
      "0,11\tRecv Coach: (init (version 15))\n"
      "177,31\t(referee free_kick_l)\n"
      "178,0\tSIM: 2.5e-05\n"
      "13,0\tRecv HELIOS_R_11: (dash 65.276)(done)\n");

  ASSERT_TRUE(record.errors.empty());
  ASSERT_EQ(record.lines.size(), 6u);
  EXPECT_EQ(record.teams, (std::vector<std::string>{"HELIOS_L", "HELIOS_R"}));

  const RclSource sources[] = {RclSource::kPlayer,  RclSource::kCoach, RclSource::kTrainer,
                               RclSource::kReferee, RclSource::kOther, RclSource::kPlayer};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(record.lines[i].source, sources[i]) << i;
  EXPECT_EQ(record.lines[1].stopped, 10);
  EXPECT_EQ(record.lines[1].team, 1);
  EXPECT_EQ(record.text_of(record.lines[1]), "(eye on)");
  EXPECT_EQ(record.lines[3].time, 177);
  EXPECT_EQ(record.text_of(record.lines[3]), "free_kick_l");
  EXPECT_EQ(record.lines[5].unum, 11);
  EXPECT_EQ(record.text_of(record.lines[5]), "(dash 65.276)(done)");
}

TEST(ReadRcl, ReadsLinesThatEndWithCarriageReturns) {
  const RclRecord record = read(
      "0,0\tRecv HELIOS_L_1: (init HELIOS_L (version 18) (goalie))\r\n"
      "177,31\t(referee free_kick_l)\r\n"
      "13,0\tRecv HELIOS_R_11: (dash 65.276)(done)\r\n");

  ASSERT_TRUE(record.errors.empty());
  ASSERT_EQ(record.lines.size(), 3u);
  EXPECT_EQ(record.text_of(record.lines[0]), "(init HELIOS_L (version 18) (goalie))");
  EXPECT_EQ(record.text_of(record.lines[1]), "free_kick_l");
  EXPECT_EQ(record.text_of(record.lines[2]), "(dash 65.276)(done)");
}

TEST(ReadRcl, SplitsSenderAtLastUnderscore) {
  const RclRecord record = read(
      "1,0\tRecv T,1:2_3_4: (turn 1)\n"
      "1,0\tRecv Coach_7: (say \"a: b\")\n"
      "1,0\tRecv a-vs-b_Coach: (done)\n"
      "1,0\tRecv \xc3\xbc_5: (done)\n"
      "1,0\tRecv A_12: (done)\n"
      "1,0\tRecv A: (done)\n"
      "1,0\tRecv A_1 (done)\n");

  EXPECT_EQ(record.teams, (std::vector<std::string>{"T,1:2_3", "Coach", "a-vs-b", "\xc3\xbc"}));
  EXPECT_EQ(record.lines[0].unum, 4);
  EXPECT_EQ(record.lines[1].unum, 7);
  EXPECT_EQ(record.text_of(record.lines[1]), "(say \"a: b\")");
  EXPECT_EQ(record.lines[2].source, RclSource::kCoach);
  EXPECT_EQ(record.lines[3].unum, 5);

  for (std::size_t i = 4; i < 7; ++i) EXPECT_EQ(record.lines[i].source, RclSource::kOther) << i;
}

TEST(ReadRcl, JoinsDatagramsWithLineFeeds) {
  const RclRecord record = read("5,0\tRecv A_2: (turn 1)\n(dash 2)\n\n6,0\t(referee play_on)\n");
  ASSERT_EQ(record.lines.size(), 2u);
  EXPECT_EQ(record.text_of(record.lines[0]), "(turn 1)\n(dash 2)\n");
  EXPECT_EQ(record.text_of(record.lines[1]), "play_on");
}

TEST(ReadRcl, ReadsTimesWithoutStoppedClock) {
  const RclRecord record = read("5\tRecv A_2: (turn 1)\n");
  ASSERT_EQ(record.lines.size(), 1u);
  EXPECT_EQ(record.lines[0].time, 5);
}

TEST(ReadRcl, ReportsOtherFilesAndTruncation) {
  EXPECT_EQ(read("ULG6\n(show\n").errors.first.at(0).message, "not a text log (rcl)");
  EXPECT_EQ(read("").errors.first.at(0).message, "the log is empty");
  const RclRecord cut = read("5,0\tRecv A_2: (turn 1)\n6,0\tRecv A_2: (tu");
  ASSERT_EQ(cut.lines.size(), 2u);
  ASSERT_EQ(cut.errors.count, 1u);
  EXPECT_EQ(format_error("a.rcl", cut.errors.first[0]),
            "a.rcl: line 2, byte 23, cycle 6: truncated log");
}

std::vector<std::pair<CommandKind, std::string>> commands(std::string_view datagram) {
  std::vector<std::pair<CommandKind, std::string>> result;
  CommandCursor cursor(datagram);
  LoggedCommand command;
  while (cursor.next(command)) result.emplace_back(command.kind, std::string(command.arguments));
  return result;
}

TEST(CommandCursor, FindsCommandsAndArguments) {
  using Kind = CommandKind;
  const auto found = commands(
      "(dash (l 50 10)(r 40))(turn_neck 44)(attentionto our 5)(pointto off) (done)(chase ball)");

  EXPECT_THAT(found, ElementsAre(Pair(Kind::kDash, "(l 50 10)(r 40)"), Pair(Kind::kTurnNeck, "44"),
                                 Pair(Kind::kAttentionto, "our 5"), Pair(Kind::kPointto, "off"),
                                 Pair(Kind::kDone, ""), Pair(Kind::kOther, "ball")));
}

TEST(CommandCursor, FindsNoCommandsInSayText) {
  const auto quoted = commands("(say \"he(kick 1 2)o)1\")(kick 10 0)");
  ASSERT_EQ(quoted.size(), 2u);
  EXPECT_EQ(quoted[0].second, "\"he(kick 1 2)o)1\"");
  EXPECT_EQ(quoted[1].first, CommandKind::kKick);
  // Without quotes the server consumes as much as it can.
  const auto unquoted = commands("(turn 1)(say a(b)c)(turn 5)");
  ASSERT_EQ(unquoted.size(), 2u);
  EXPECT_EQ(unquoted[1].second, "a(b)c)(turn 5");
}

TEST(CommandCursor, StopsAtUnclosedExpression) {
  EXPECT_TRUE(commands("").empty());
  EXPECT_TRUE(commands("(dash 100").empty());
  EXPECT_EQ(commands("(done)(say \"a").size(), 1u);
  EXPECT_EQ(commands(")))((done)").size(), 0u);
}

/// Number of commands of each kind, by the protocol's parser.
std::map<std::string, int> sorts_by_parser(const std::vector<soccer::PlayerCommand>& parsed) {
  static const char* const kSorts[] = {
      "turn",        "dash",        "dash",         "turn_neck", "change_focus",
      "kick",        "long_kick",   "catch",        "tackle",    "move",
      "change_view", "synch_see",   "gaussian_see", "say",       "pointto",
      "pointto",     "attentionto", "attentionto",  "ear",       "clang",
      "sense_body",  "score",       "done",         "bye",       "compression"};

  std::map<std::string, int> result;
  for (const auto& command : parsed) ++result[kSorts[command.index()]];
  return result;
}

void expect_same_commands_as_the_protocol(const RclRecord& record) {
  std::vector<soccer::PlayerCommand> parsed;
  std::size_t compared = 0;

  for (const RclLine& line : record.lines) {
    if (line.source != RclSource::kPlayer) continue;
    const std::string_view datagram = record.text_of(line);
    parsed.clear();
    if (soccer::parse_player_commands(datagram, parsed)) continue;  // init, reconnect
    std::map<std::string, int> found;
    CommandCursor cursor(datagram);
    LoggedCommand command;
    while (cursor.next(command)) ++found[std::string(name(command.kind))];
    ASSERT_EQ(found, sorts_by_parser(parsed)) << datagram;
    ++compared;
  }

  EXPECT_GT(compared + 100, record.lines.size() * 4 / 5);
}

TEST(ReadRcl, ReadsStartOfRcssserverMatch) {
  const std::string log = tests::read_file(tests::fixture("gamelog/match-start.rcl.gz"));
  const RclRecord record = read(log);
  EXPECT_TRUE(record.errors.empty());
  EXPECT_EQ(record.lines.size(), tests::split_lines(log).size());
  EXPECT_EQ(record.teams, (std::vector<std::string>{"HELIOS_L", "HELIOS_R"}));
  expect_same_commands_as_the_protocol(record);
}

TEST(ReadRcl, MatchesProtocolParserOnWholeMatches) {
  for (const char* name : {"helios-vs-helios-full", "cyrus-vs-helios-full", "recorded-messages"}) {
    const auto path = tests::data("logs/" + std::string(name) + ".rcl.gz");
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    const auto record = read_rcl_file(path->string());
    ASSERT_TRUE(record);
    EXPECT_TRUE(record->errors.empty());
    if (std::string(name) != "recorded-messages") expect_same_commands_as_the_protocol(*record);
  }
}

}  // namespace
}  // namespace cls::gamelog
