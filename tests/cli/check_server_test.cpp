// End-to-end tests of `cls check server`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/junit.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

CommandResult check(std::vector<std::string> arguments) {
  return run(joined({cls_binary(), "check", "server"}, arguments));
}

void expect_all_passed(const CommandResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.check/1");
  EXPECT_EQ(document["steps_passed"], 32) << result.out;
  EXPECT_EQ(document["steps_failed"], 0);
}

TEST(CheckServer, EmbeddedServerPassesEveryStep) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "junit.xml";
  expect_all_passed(check({"embedded", "--json", "--junit", file}));
  const std::string xml = read_file(file);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"cls check server\" tests=\"32\" failures=\"0\""));
  EXPECT_EQ(junit_errors(xml).value_or(""), "");
}

TEST(CheckServer, RcssserverPassesEveryStep) {
  if (std::system("command -v rcssserver >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no rcssserver on PATH";
  }
  expect_all_passed(check({"rcssserver", "--json"}));
}

TEST(CheckServer, ReportsFailuresByExitCode) {
  const CommandResult unreachable = check({"127.0.0.1:9", "--start-timeout", "0.6", "--json"});
  EXPECT_EQ(unreachable.exit_code, 69) << unreachable.out << unreachable.err;
  const json document = json::parse(unreachable.out);
  EXPECT_EQ(document["steps"][0]["result"], "fail");
  EXPECT_EQ(document["steps"][1]["result"], "skip");
  EXPECT_THAT(check({"/bin/false", "--start-timeout", "3"}),
              Prints(69, HasSubstr("the server exited")));
  EXPECT_EQ(check({"/no/such/server"}).exit_code, 69);
  EXPECT_EQ(check({}).exit_code, 2);
}

}  // namespace
}  // namespace cls::tests
