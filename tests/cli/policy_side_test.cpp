// `policy:FILE`: matches of a trained policy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

class PolicySide : public testing::Test, public cls::tests::ClsFolder {
 protected:
  PolicySide() : ClsFolder(std::chrono::seconds(180)) {}

  CommandResult match(const std::string& left, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"match",   left,           "mock:planner", "--left-name",
                                          "left",    "--right-name", "right",        "--seed",
                                          "7",       "--cycles",     "200",          "--quiet",
                                          "--force", "--dir",        "match"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  std::string game_log(const std::string& left, const std::vector<std::string>& more = {}) const {
    EXPECT_THAT(match(left, more), Exits(0));
    return read_file(folder_.path() / "match/match.rcg");
  }

  const std::string file_ = "policy:" + fixture("policies/all_kinds.policy").string();
};

TEST_F(PolicySide, PlaysWhatItsFileSays) {
  const std::string log = game_log(file_);
  EXPECT_TRUE(game_log(file_, {"--rated"}) == log) << "reproducible, and rated";
  EXPECT_FALSE(game_log("policy:random") == log);
  EXPECT_FALSE(game_log("policy:planner") == log);
  EXPECT_TRUE(game_log("policy:planner") == game_log("policy:planner")) << "reproducible";
}

TEST_F(PolicySide, TheLearnedTeamNeedsNoFile) {
  const std::string log = game_log("mock:learned");
  EXPECT_TRUE(game_log("mock:learned") == log) << "reproducible";
  const std::string file = (source_folder() / "match/terms/learned.policy").string();
  EXPECT_TRUE(game_log("policy:" + file) == log);
  EXPECT_FALSE(game_log("policy:planner") == log);
}

TEST_F(PolicySide, IsNamedAfterItsFile) {
  const CommandResult result = run({"match", file_, "mock", "--cycles", "5", "--dir", "named"});
  EXPECT_THAT(result, Exits(0));
  EXPECT_THAT(read_file(folder_.path() / "named/result.json"), HasSubstr("\"all_kinds\""));
}

TEST_F(PolicySide, SaysWhatIsWrong) {
  write("other.policy", "PK");
  EXPECT_THAT(match("policy:other.policy").err,
              HasSubstr("other.policy: is not a file of cls.policy/2"));
  EXPECT_THAT(match("policy:no.policy").err, HasSubstr("no.policy: no such file"));
  EXPECT_THAT(match("policy:").err, HasSubstr("no file after the colon"));
  EXPECT_THAT(match("mix:1=policy:random;others=mock").err,
              HasSubstr("a policy plays for a whole team"));
  EXPECT_THAT(match("mock", {"--trainer", "policy:random"}).err,
              HasSubstr("a trainer has no policy"));
  EXPECT_THAT(run({"check", "playmaker", "policy:random"}).err,
              HasSubstr("a policy is not a Playmaker"));
}

}  // namespace
}  // namespace cls::tests
