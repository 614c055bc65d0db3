// Text log lines as rcssserver 19 wrote them.
#include "gamelog/rcl_writer.h"

#include <gtest/gtest.h>

namespace cls::gamelog {
namespace {

class RclWriterTest : public testing::Test {
 protected:
  StringSink sink_;
  RclWriter writer_{sink_};
};

TEST_F(RclWriterTest, WritesRealLines) {
  writer_.player_command({0, 0}, "HELIOS_L", 1, "(init HELIOS_L (version 18) (goalie))");
  writer_.coach_command({0, 10}, "HELIOS_L", "(eye on)");
  writer_.player_command({13, 0}, "HELIOS_R", 11,
                         "(dash 65.276)(turn_neck -3)(attentionto off)(done)(say \"R<yPPpzYy2\")");
  writer_.referee({177, 31}, "free_kick_l");
  writer_.trainer_command({0, 0}, "(init (version 15))");
  EXPECT_EQ(sink_.bytes(),
            "0,0\tRecv HELIOS_L_1: (init HELIOS_L (version 18) (goalie))\n"
            "0,10\tRecv HELIOS_L_Coach: (eye on)\n"
            "13,0\tRecv HELIOS_R_11: (dash 65.276)(turn_neck -3)(attentionto off)(done)(say "
            "\"R<yPPpzYy2\")\n"
            "177,31\t(referee free_kick_l)\n"
            "0,0\tRecv Coach: (init (version 15))\n");
}

TEST_F(RclWriterTest, LogsTextUpToANulByteAndKeepsLineFeeds) {
  writer_.player_command({1, 0}, "A", 2, std::string_view("(turn 1)\n\0(turn 2)", 18));
  EXPECT_EQ(sink_.bytes(), "1,0\tRecv A_2: (turn 1)\n\n");
}

TEST_F(RclWriterTest, CutsEndlessText) {
  writer_.player_command({1, 0}, "A", 2, std::string(9000, 'x'));
  EXPECT_EQ(sink_.bytes(), "1,0\tRecv A_2: " + std::string(8191 - 10, 'x') + "\n");
}

}  // namespace
}  // namespace cls::gamelog
