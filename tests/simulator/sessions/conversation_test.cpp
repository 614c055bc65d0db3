// Replays recorded conversations with rcssserver 19 against cls server and rcssserver.
#include "tests/simulator/sessions/conversation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/simulator/sessions/process_host.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/rcssserver.h"

namespace cls::tests {
namespace {

class Conversations : public testing::TestWithParam<const char*> {
 protected:
  static Conversation conversation() {
    auto path = fixture("protocol/conversations/" + std::string(GetParam()) + ".txt");
    if (!std::filesystem::exists(path)) path += ".gz";
    return parse_conversation(read_file(path));
  }
};

TEST_P(Conversations, MatchClsServer) {
  const Conversation written = conversation();
  ASSERT_FALSE(written.turns.empty());
  replay_conversation(written, *make_memory_host(written.settings));
}

TEST_P(Conversations, MatchRcssserver) {
  if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const Conversation written = conversation();
  ASSERT_FALSE(written.turns.empty());
  replay_conversation(written, *make_process_host({rcssserver_program()}, written.settings));
}

TEST(ConversationOverUdp, OnlineCoachMatchesClsServerProcess) {
  const Conversation written =
      parse_conversation(read_file(fixture("protocol/conversations/online-coach.txt")));
  replay_conversation(written, *make_process_host({cls_binary(), "server"}, written.settings));
}

INSTANTIATE_TEST_SUITE_P(Recorded, Conversations,
                         testing::Values("versions", "players", "trainer", "online-coach",
                                         "coach-language", "referee", "referee-time", "keepaway",
                                         "sight", "shoot-out-draw", "shoot-out-coin", "unexpected"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace cls::tests
