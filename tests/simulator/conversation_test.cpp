// Conversations with rcssserver 19, word for word, held with our server.
#include "tests/simulator/conversation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/simulator/real_host.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/real_server.h"

namespace cls::tests {
namespace {

class Conversations : public testing::TestWithParam<const char*> {
 protected:
  static Conversation conversation() {
    auto path = fixture("protocol/conversations/" + std::string(GetParam()) + ".txt");
    if (!std::filesystem::exists(path)) path += ".gz";
    return read_conversation(read_file(path));
  }
};

TEST_P(Conversations, AreHeldByOurServer) {
  const Conversation written = conversation();
  ASSERT_FALSE(written.turns.empty());
  hold(written, *make_memory_host(written.settings));
}

TEST_P(Conversations, AreThoseOfTheRealServer) {
  if (real_server().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const Conversation written = conversation();
  ASSERT_FALSE(written.turns.empty());
  hold(written, *make_real_host({real_server()}, written.settings));
}

TEST(ConversationOverUdp, OnlineCoachesTalkToTheProgramAlike) {
  const Conversation written =
      read_conversation(read_file(fixture("protocol/conversations/online-coach.txt")));
  hold(written, *make_real_host({cls_binary(), "server"}, written.settings));
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
