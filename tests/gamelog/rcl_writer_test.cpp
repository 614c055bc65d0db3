// Text log lines as rcssserver 19 wrote them.
#include "gamelog/rcl/rcl_writer.h"

#include <gtest/gtest.h>

namespace cls::gamelog {
namespace {

std::string of_player(std::string_view team, int unum, std::string_view text) {
  std::string line;
  append_player_command(team, unum, text, line);
  return line;
}

std::string of_coach(std::string_view team, std::string_view text) {
  std::string line;
  append_coach_command(team, text, line);
  return line;
}

std::string of_trainer(std::string_view text) {
  std::string line;
  append_trainer_command(text, line);
  return line;
}

class RclWriterTest : public testing::Test {
 protected:
  base::StringSink sink_;
  RclWriter writer_{sink_};
};

TEST_F(RclWriterTest, MatchesRcssserverLines) {
  writer_.write_command({0, 0}, of_player("HELIOS_L", 1, "(init HELIOS_L (version 18) (goalie))"));
  writer_.write_command({0, 10}, of_coach("HELIOS_L", "(eye on)"));
  writer_.write_command(
      {13, 0}, of_player("HELIOS_R", 11,
                         "(dash 65.276)(turn_neck -3)(attentionto off)(done)(say \"R<yPPpzYy2\")"));

  writer_.write_referee({177, 31}, "free_kick_l");
  writer_.write_command({0, 0}, of_trainer("(init (version 15))"));

  EXPECT_EQ(sink_.bytes(),
            "0,0\tRecv HELIOS_L_1: (init HELIOS_L (version 18) (goalie))\n"
            "0,10\tRecv HELIOS_L_Coach: (eye on)\n"
            "13,0\tRecv HELIOS_R_11: (dash 65.276)(turn_neck -3)(attentionto off)(done)(say "
            "\"R<yPPpzYy2\")\n"
            "177,31\t(referee free_kick_l)\n"
            "0,0\tRecv Coach: (init (version 15))\n");
}

TEST_F(RclWriterTest, StopsAtNulByteAndPreservesLineFeeds) {
  writer_.write_command({1, 0}, of_player("A", 2, std::string_view("(turn 1)\n\0(turn 2)", 18)));
  EXPECT_EQ(sink_.bytes(), "1,0\tRecv A_2: (turn 1)\n\n");
}

TEST_F(RclWriterTest, TruncatesLongText) {
  writer_.write_command({1, 0}, of_player("A", 2, std::string(9000, 'x')));
  EXPECT_EQ(sink_.bytes(), "1,0\tRecv A_2: " + std::string(8191 - 10, 'x') + "\n");
}

}  // namespace
}  // namespace cls::gamelog
