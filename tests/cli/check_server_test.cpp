// End-to-end tests of `cls check server`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/junit.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::cls_binary;
using cls::tests::CommandResult;
using nlohmann::json;
using testing::HasSubstr;

CommandResult check(std::vector<std::string> arguments) {
  std::vector<std::string> all = {cls_binary(), "check", "server"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return cls::tests::run(all);
}

void expect_all_passed(const CommandResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.check/1");
  EXPECT_EQ(document["steps_passed"], 32) << result.out;
  EXPECT_EQ(document["steps_failed"], 0);
}

TEST(CheckServer, EmbeddedServerPassesEveryStep) {
  const cls::tests::TemporaryFolder folder;
  const std::string file = folder.path() / "junit.xml";
  expect_all_passed(check({"embedded", "--json", "--junit", file}));
  const std::string xml = cls::tests::read_file(file);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"cls check server\" tests=\"32\" failures=\"0\""))
      << xml;
  EXPECT_EQ(cls::tests::junit_errors(xml).value_or(""), "");
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
  const CommandResult ended = check({"/bin/false", "--start-timeout", "3"});
  EXPECT_EQ(ended.exit_code, 69) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the server exited")) << ended.out;
  EXPECT_EQ(check({"/no/such/server"}).exit_code, 69);
  EXPECT_EQ(check({}).exit_code, 2);
}

}  // namespace
