// `cls package-team`: the folder plays with the start script of competitions.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

class PackageTeam : public testing::Test {
 protected:
  PackageTeam() {
    fs::create_directories(folder_.path() / "runs");
    fs::create_directories(folder_.path() / "src");
    std::ofstream(folder_.path() / "src/team.txt") << "ada\n";
    std::ofstream(folder_.path() / "cls.toml")
        << "[teams.ada]\nendpoint = \"run:../cls mock --port {port} --quiet\"\n"
           "[teams.rivals]\nendpoint = \"mock\"\n";
  }

  CommandResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), cls_binary());
    return Command(words, {}, folder_.path()).finish(std::chrono::seconds(240));
  }

  TemporaryFolder folder_;
};

TEST_F(PackageTeam, WritesScriptsProgramAndProject) {
  const CommandResult result = run({"package-team", "ada", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["schema"], "cls.package-team/1");
  const fs::path package = folder_.path() / "ada-team";
  EXPECT_EQ(read_file(package / "team/src/team.txt"), "ada\n");
  EXPECT_FALSE(fs::exists(package / "team/runs"));
  EXPECT_FALSE(fs::exists(package / "team/ada-team"));
  EXPECT_NE(read_file(package / "start").find("../cls mock --port \"$port\" --quiet"),
            std::string::npos);
  for (const char* script : {"start", "kill"}) {
    EXPECT_EQ(tests::run({"sh", "-n", package / script}).exit_code, 0) << script;
  }
}

TEST_F(PackageTeam, PlaysAsACompetitionStartsIt) {
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const PortLock ports;  // external teams need the ports of the server
  const CommandResult match = run({"match", "team:ada-team", "mock:hold", "--cycles", "20",
                                   "--start-timeout", "120", "--dir", "match", "--json"});
  ASSERT_EQ(match.exit_code, 0) << match.err;
  const auto result = nlohmann::json::parse(match.out);
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["left"]["name"], "ada");
  EXPECT_FALSE(fs::exists(folder_.path() / "ada-team/run")) << "kill removes it";
}

TEST_F(PackageTeam, RefusesWhatCannotBeStarted) {
  EXPECT_NE(run({"package-team", "adda"}).err.find("has no team 'adda'; did you mean 'ada'?"),
            std::string::npos);
  EXPECT_EQ(run({"package-team", "rivals"}).err,
            "cls: team 'rivals' is 'mock'; a package needs run:COMMAND, which starts the "
            "Playmaker\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const CommandResult again = run({"package-team", "ada"});
  EXPECT_EQ(again.exit_code, 73);
  EXPECT_NE(again.err.find("select a new folder with --dir"), std::string::npos);
}

}  // namespace
}  // namespace cls::tests
