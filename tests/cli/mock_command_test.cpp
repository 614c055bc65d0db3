// `cls mock`: a Playmaker of its own process that a match can name by address.
#include <gtest/gtest.h>
#include <signal.h>

#include <string>

#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::Command;

TEST(MockCommand, ServesAMatchOnAFreePortAndEndsOnASignal) {
  Command mock({cls::tests::cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  ASSERT_EQ(line.rfind("listening on 127.0.0.1:", 0), 0u) << line;
  const std::string address = line.substr(13, line.find('\n') - 13);

  cls::tests::TemporaryFolder folder;
  const auto played =
      cls::tests::run({cls::tests::cls_binary(), "match", address, "mock:hold", "--cycles", "50",
                       "--set", "server::kick_off_wait=3", "--dir", folder.path()});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  mock.send_signal(SIGTERM);
  EXPECT_EQ(mock.finish().exit_code, 143);
}

TEST(MockCommand, UnknownBehavioursAndTakenPortsAreTold) {
  const auto unknown = cls::tests::run({cls::tests::cls_binary(), "mock", "hodl"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "cls: unknown mock behaviour 'hodl'; did you mean 'hold'?\n");

  Command mock({cls::tests::cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  const std::string port = line.substr(line.rfind(':') + 1, line.find('\n') - line.rfind(':') - 1);
  const auto taken = cls::tests::run({cls::tests::cls_binary(), "mock", "--port", port});
  EXPECT_EQ(taken.exit_code, 75);
  EXPECT_NE(taken.err.find("cannot listen on 127.0.0.1:" + port), std::string::npos) << taken.err;
}

}  // namespace
