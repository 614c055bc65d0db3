// Events of matches on their way to the command of the user.
#include "tournament/run/event_feed.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/store/event_file.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

// Programs of another host may write to the file.
TEST(EventFeed, PassesByLinesThatAreNotEvents) {
  const tests::TemporaryFolder folder;
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.execution.on_event = "cat >> events";
  const auto matches = play_all(config.competition, better_wins);
  process::HookRunner hooks(folder.path(), folder.path());
  EventFeed feed(config, folder.path());
  const auto append = [&folder](const std::string& line) {
    std::ofstream(folder.path() / kMatchEvents, std::ios::app) << line << '\n';
  };

  append(R"({"schema":"cls.event/1","event":"goal","folder":5})");
  append(R"({"schema":["cls.event/1"],"event":"goal","folder":"000001-A-vs-B"})");
  append(R"({"schema":"cls.event/1","event":"goal","folder":"999999-A-vs-B"})");
  append("[1");
  feed.poll(matches, hooks);

  EXPECT_TRUE(hooks.idle());

  append(R"({"schema":"cls.event/1","event":{},"folder":"000001-A-vs-B"})");
  feed.poll(matches, hooks);

  EXPECT_FALSE(hooks.idle()) << "of a match that there is";

  const std::atomic<int> signal{0};
  EXPECT_EQ(hooks.finish(signal), std::vector<std::string>());
}

TEST(EventFile, TellsOfALineThatWasNotWritten) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / kMatchEvents;
  ASSERT_TRUE(append_line(file, "one"));
  ASSERT_TRUE(append_line(file, "two"));
  EXPECT_EQ(tests::read_file(file), "one\ntwo\n");

  const auto full = append_line("/dev/full", "three");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().message, "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace cls::tournament
