// Keepaway logs (kwy).
#include "gamelog/rcl/keepaway_log.h"

#include <gtest/gtest.h>

namespace cls::gamelog {
namespace {

TEST(KeepawayLog, WritesHeaderAndOneLinePerEpisode) {
  base::StringSink sink;
  KeepawayLogWriter writer(sink);
  writer.write_header(3, 2, 20, 17.5);
  writer.write_episode(1, 0, 93, KeepawayLoss::kOutOfBounds);
  writer.write_episode(2, 93, 120, KeepawayLoss::kTaken);

  EXPECT_EQ(sink.bytes(),
            "# Keepers: 3\n# Takers:  2\n# Region:  20 x 17.5\n#\n# Description of Fields:\n"
            "# 1) Episode number\n# 2) Start time in simulator steps (100ms)\n"
            "# 3) End time in simulator steps (100ms)\n# 4) Duration in simulator steps (100ms)\n"
            "# 5) (o)ut of bounds / (t)aken away\n#\n"
            "1\t0\t93\t93\to\n2\t93\t120\t27\tt\n");
}

}  // namespace
}  // namespace cls::gamelog
