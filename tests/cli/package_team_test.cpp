// `cls package-team`: the folder plays with the start script of competitions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/port_lock.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class PackageTeam : public testing::Test, public cls::tests::ClsFolder {
 protected:
  PackageTeam() : ClsFolder(std::chrono::seconds(240)) {
    fs::create_directories(folder_.path() / "runs");
    fs::create_directories(folder_.path() / "src");
    std::ofstream(folder_.path() / "src/team.txt") << "ada\n";
    std::ofstream(folder_.path() / "cls.toml")
        << "[teams.ada]\nendpoint = \"run:../cls mock --port {port} --quiet\"\n"
           "[teams.rivals]\nendpoint = \"mock\"\n";
  }

  // A virtual environment, as far as the package is concerned, with the program my-playmaker.
  static void write_environment(const fs::path& folder, const std::string& command) {
    fs::create_directories(folder / "bin");
    std::ofstream(folder / "pyvenv.cfg") << "home = /usr/bin\n";
    fs::create_symlink("/bin/sh", folder / "bin/python");
    std::ofstream(folder / "bin/my-playmaker") << "#!/bin/sh\n" << command << "\n";
    fs::permissions(folder / "bin/my-playmaker", fs::perms(0755));
  }
};

TEST_F(PackageTeam, WritesScriptsProgramAndProject) {
  const CommandResult result = run({"package-team", "ada", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["schema"], "cls.package-team/1");
  const fs::path package = folder_.path() / "ada-team";
  EXPECT_EQ(read_file(package / "team/src/team.txt"), "ada\n");
  EXPECT_FALSE(fs::exists(package / "team/runs"));
  EXPECT_FALSE(fs::exists(package / "team/ada-team"));
  EXPECT_THAT(read_file(package / "start"), HasSubstr("../cls mock --port \"$port\" --quiet"));
  for (const char* script : {"start", "kill"}) {
    EXPECT_EQ(tests::run({"sh", "-n", package / script}).exit_code, 0) << script;
  }
}

TEST_F(PackageTeam, LeavesOutMatchesAndPagesAndSaysItsSize) {
  ASSERT_EQ(run({"match", "mock", "mock", "--cycles", "5", "--dir", "first"}).exit_code, 0);
  ASSERT_EQ(run({"watch", "first", "--out", "shown.html"}).exit_code, 0);
  ASSERT_EQ(run({"tournament", "run", "cup", "--team", "A=mock", "--team", "B=mock", "--cycles",
                 "5", "--rounds", "1"})
                .exit_code,
            0);
  write("web/page.html", "<!doctype html>\n<title>a page of the team</title>\n");
  write("web/manifest.json", "{}");

  const CommandResult result = run({"package-team", "ada"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::MatchesRegex("ada-team/: [0-9.]+ MB: cls [0-9.]+ MB, .*"));
  EXPECT_THAT(result.out, HasSubstr("left out: cup/ (tournament), first/ (match), runs/ (matches), "
                                    "shown.html (page)\n"));
  for (const char* name : {"first", "cup", "runs", "shown.html"}) {
    EXPECT_FALSE(fs::exists(path("ada-team/team") / name)) << name;
  }
  EXPECT_TRUE(fs::exists(path("ada-team/team/web/page.html")));
  EXPECT_TRUE(fs::exists(path("ada-team/team/web/manifest.json")));
}

// The program is found only by the PATH of the environment, which is outside of the package.
TEST_F(PackageTeam, PlaysWithItsEnvironmentInTheSandbox) {
  const TemporaryFolder elsewhere;
  write_environment(elsewhere.path() / "env", "exec ../cls mock --quiet \"$@\"");
  write("cls.toml", "[teams.ada]\nendpoint = \"run:my-playmaker --port {port}\"\n");

  const std::string active = "VIRTUAL_ENV=" + (elsewhere.path() / "env").string();
  const CommandResult written = run({"package-team", "ada", "--json"}, {active});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_GT(nlohmann::json::parse(written.out)["bytes"], 1'000'000);

  const PortLock ports;
  const CommandResult match = run({"match", "team:ada-team", "mock:hold", "--cycles", "20",
                                   "--start-timeout", "120", "--dir", "match", "--json"});
  ASSERT_EQ(match.exit_code, 0) << match.err;
  EXPECT_EQ(nlohmann::json::parse(match.out)["end_reason"], "finished");
  for (const auto& file : fs::directory_iterator(path("match"))) {
    EXPECT_THAT(read_file(file.path()), testing::Not(HasSubstr("the Playmaker ended")))
        << "all agents share one: " << file.path();
  }
}

TEST_F(PackageTeam, SaysWhyItsPlaymakerEndedAndKeepsItsLog) {
  write("cls.toml", "[teams.ada]\nendpoint = \"run:echo no weights; exit 3; : {port}\"\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const PortLock ports;
  const CommandResult match =
      run({"match", "team:ada-team", "mock:hold", "--cycles", "20", "--dir", "match"});
  EXPECT_NE(match.exit_code, 0);
  EXPECT_THAT(match.err, HasSubstr("the Playmaker ended with exit code 3")) << match.err;
  EXPECT_EQ(read_file(path("ada-team/playmaker.log")), "no weights\n");
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
  EXPECT_THAT(run({"package-team", "adda"}).err,
              HasSubstr("has no team 'adda'; did you mean 'ada'?"));
  EXPECT_EQ(run({"package-team", "rivals"}).err,
            "cls: team 'rivals' is 'mock'; a package needs run:COMMAND, which starts the "
            "Playmaker\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const CommandResult again = run({"package-team", "ada"});
  EXPECT_EQ(again.exit_code, 73);
  EXPECT_THAT(again.err,
              HasSubstr("--force renames it to ada-team.old, --dir selects a new folder"));

  const CommandResult forced = run({"package-team", "ada", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_THAT(forced.err, HasSubstr("cls: old package moved to "));
  EXPECT_THAT(forced.out, HasSubstr("left out: ada-team.old/ (package)"));
  EXPECT_FALSE(fs::exists(path("ada-team/team/ada-team.old")));
}

}  // namespace
}  // namespace cls::tests
