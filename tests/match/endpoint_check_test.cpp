// Checks of sides before the first match: what is missing is named, and nothing is started.
#include "match/sides/endpoint_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "match/programs/run_command_check.h"
#include "mock-server/mock.h"
#include "mock-server/server.h"
#include "process/command_plan.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using Kind = EndpointProblem::Kind;

class EndpointCheck : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(path() / "team");
    std::ofstream(path() / "team" / "playmaker.py") << "";
    std::ofstream(path() / "brain") << "#!/bin/sh\n";
    fs::permissions(path() / "brain", fs::perms::owner_all);
  }

  fs::path path() const { return folder_.path(); }
  std::string missing(std::string_view command) const {
    return missing_in_command(command, path());
  }

  static std::optional<EndpointProblem> check(const std::string& side) {
    return check_endpoint(*parse_endpoint(side), std::chrono::milliseconds(0));
  }

  tests::TemporaryFolder folder_;
};

TEST_F(EndpointCheck, FindsProgramsAndScriptsOfRunCommands) {
  EXPECT_EQ(missing("./brain --port {port}"), "");
  EXPECT_EQ(missing("sh -e team/playmaker.py {port}"), "");
  EXPECT_EQ(missing("cd team && A=1 exec sh playmaker.py --port {port}"), "");
  EXPECT_EQ(missing("cd 'team' && env sh \"playmaker.py\" {port}"), "");
  EXPECT_THAT(missing("./brane --port {port}"), HasSubstr("brane: no such file"));
  EXPECT_THAT(missing("team/playmaker.py {port}"), HasSubstr("playmaker.py is not executable"));
  EXPECT_EQ(missing("sh playmaker.py --port {port}"), "playmaker.py: no such file");
  EXPECT_EQ(missing("sh -x nope.sh {port}"), "nope.sh: no such file");
  EXPECT_EQ(missing("cls_no_such_program {port}"), "cls_no_such_program: no such program on PATH");
  EXPECT_THAT(missing("cd nowhere && sh x.py {port}"), HasSubstr("nowhere: no such folder"));
}

// As endpoint_from() writes a folder with a quote.
TEST_F(EndpointCheck, ReadsQuotesInNamesOfFolders) {
  const std::filesystem::path folder = path() / "q'uote";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "x.py") << "";
  const std::string cd = "cd " + process::shell_quoted(folder.string()) + " && ";
  EXPECT_EQ(missing(cd + "sh x.py {port}"), "");
  EXPECT_EQ(missing(cd + "sh y.py {port}"), "y.py: no such file");
  EXPECT_EQ(missing("cd q\\'uote && sh y.py {port}"), "y.py: no such file");
  EXPECT_EQ(missing("cd \"$HOME\" && sh y.py {port}"), "");
}

TEST_F(EndpointCheck, AcceptsRunCommandsThatOnlyTheShellUnderstands) {
  for (const char* command :
       {"exit 3 # {port}", "$HOME/brain {port}", "`which brain` {port}", "(cd x; ./y {port})",
        "sh -c './nope {port}'", "if true; then ./nope {port}; fi", "sh $SCRIPT.py {port}",
        "echo {port} | ./nope"}) {
    EXPECT_EQ(missing(command), "") << command;
  }
}

TEST_F(EndpointCheck, NamesTheProblemOfEachKindOfSide) {
  EXPECT_FALSE(check("mock"));
  EXPECT_FALSE(check("mock:hold"));
  EXPECT_EQ(check("mock:hodl")->kind, Kind::kUnknown);
  EXPECT_EQ(check("mock:" + (path() / "none.json").string())->kind, Kind::kMissing);

  const fs::path script = path() / "drill.json";
  std::ofstream(script) << "{\"otherwhise\": \"simple\"}";
  EXPECT_EQ(check("mock:" + script.string())->kind, Kind::kBadScript);
  EXPECT_EQ(check("team:" + path().string())->kind, Kind::kMissing);
  EXPECT_EQ(check("run:" + (path() / "brane").string() + " {port}")->kind, Kind::kMissing);

  const auto unreachable = check("unix:" + (path() / "none.sock").string());
  ASSERT_TRUE(unreachable);
  EXPECT_EQ(unreachable->kind, Kind::kUnreachable);
  EXPECT_THAT(unreachable->text,
              AllOf(HasSubstr("nothing listens at "), HasSubstr("; start it first")));
}

TEST_F(EndpointCheck, AcceptsRunningPlaymaker) {
  const auto mock = mock_server::Server::start(*mock_server::make_mock(""), "127.0.0.1", 0);
  ASSERT_TRUE(mock) << mock.error().message;
  EXPECT_FALSE(check("127.0.0.1:" + std::to_string((*mock)->port())));
}

}  // namespace
}  // namespace cls::match
