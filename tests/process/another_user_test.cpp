// The tests of what the sandbox and the owners of sockets promise, again as a user without rights.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/system/own_program.h"
#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

TEST(AnotherUser, HasTheSameSandbox) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can run it as another user";
  const tests::TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  tests::Command as_nobody(
      {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--no-new-privs",
       base::own_program()->string(),
       "--gtest_filter=Confinement.*:ConnectionTrapTest.*:SocketOwnersTest.*:Landlock.*:"
       "InNamespaces.*"},
      {"TMPDIR=" + folder.path().string(), "HOME=" + folder.path().string()}, folder.path());
  const auto tested = as_nobody.finish(std::chrono::seconds(120));

  if (tested.out.find("[==========]") == std::string::npos) {
    GTEST_SKIP() << "another user cannot start it: " << tested.err;
  }

  EXPECT_EQ(tested.exit_code, 0) << tested.out << tested.err;
  EXPECT_NE(tested.out.find("OK ] Confinement.ForbidsChangesOfOtherProcesses"), std::string::npos)
      << tested.out;
}

}  // namespace
}  // namespace cls::process
