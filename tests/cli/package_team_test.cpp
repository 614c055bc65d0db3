// `cls package-team`: the folder plays with the start script of competitions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/installed.h"
#include "tests/support/json.h"
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

  // A virtual environment with a module, and a program that needs it and starts a mock.
  static void write_environment(const fs::path& folder) {
    ASSERT_EQ(tests::run({"/usr/bin/python3", "-m", "venv", "--without-pip", folder}).exit_code, 0);
    const std::string python = (folder / "bin/python").string();
    const std::string site = tests::run({python, "-c",
                                         "import sysconfig; "
                                         "print(sysconfig.get_path('purelib'), end='')"})
                                 .out;
    std::ofstream(fs::path(site) / "ada_weights.py") << "import json\nQUIET = '--quiet'\n";
    std::ofstream(folder / "bin/my-playmaker")
        << "#!" << python << "\nimport os, sys, ada_weights\n"
        << "os.execv('../cls', ['../cls', 'mock', ada_weights.QUIET] + sys.argv[1:])\n";
    fs::permissions(folder / "bin/my-playmaker", fs::perms(0755));
  }

  // The report of `cls package-team ada --check`, or null where machines cannot be made.
  base::Json check(std::vector<std::string> options) const {
    options.insert(options.begin(), {"package-team", "ada", "--check", "--json"});
    const CommandResult result = run(options);
    EXPECT_NE(result.out, "") << result.err;
    auto report = base::Json::parse(result.out);
    EXPECT_EQ(report["schema"], "cls.package-check/1");
    EXPECT_EQ(result.exit_code, !report["skipped"].is_null() ? 69
                                : report["passed"] == true   ? 0
                                                             : 1);
    return report;
  }
};

TEST_F(PackageTeam, WritesScriptsProgramAndProject) {
  const CommandResult result = run({"package-team", "ada", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(base::Json::parse(result.out)["schema"], "cls.package-team/1");
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
  ASSERT_THAT(run({"tournament", "run", "cup", "--team", "A=mock", "--team", "B=mock", "--cycles",
                   "5", "--rounds", "1"}),
              Exits(0));
  write("web/page.html", "<!doctype html>\n<title>a page of the team</title>\n");
  write("web/manifest.json", "{}");

  ASSERT_THAT(
      run({"package-team", "ada"}),
      Prints(0, testing::AllOf(
                    testing::MatchesRegex("ada-team/: [0-9.]+ MB, [0-9.]+ MB compressed: "
                                          "cls and libraries [0-9.]+ MB, .*"),
                    HasSubstr("left out: cup/ (tournament), first/ (match), runs/ (matches), "
                              "shown.html (page)\n"))));

  for (const char* name : {"first", "cup", "runs", "shown.html"}) {
    EXPECT_FALSE(fs::exists(path("ada-team/team") / name)) << name;
  }
  EXPECT_TRUE(fs::exists(path("ada-team/team/web/page.html")));
  EXPECT_TRUE(fs::exists(path("ada-team/team/web/manifest.json")));
}

// Nobody else gets keys and tokens, and what .gitignore names; built programs come along.
TEST_F(PackageTeam, LeavesOutPrivateAndIgnoredFilesAndListsThem) {
  const std::vector<std::string> private_files = {
      ".aws/config",          ".env",        ".netrc", ".npmrc", ".ssh/config", ".ssh/id_rsa",
      "src/credentials.json", "src/tls.key", "tls.pem"};
  for (const std::string& file : private_files) write(file, "token");
  write(".env.example", "TOKEN=");
  write("roots.pem", "-----BEGIN CERTIFICATE-----\n");
  write(".gitignore", "# mine\n*.tmp\n!kept.tmp\n/notes\n.build/\nsecret/**\ndeep/**/x\n");
  for (const char* file : {"a.tmp", "kept.tmp", "src/b.tmp", "notes/mine", "src/notes/ours",
                           ".build/team", "secret/list", "deep/1/2/x", "deep/1/y"}) {
    write(file, "");
  }
  fs::create_symlink("/etc/hostname", path("host"));
  fs::create_symlink("src/team.txt", path("inside"));

  const CommandResult written = run({"package-team", "ada"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_THAT(written.out,
              HasSubstr("left out: .aws/ (private), .env (private), .netrc (private), .npmrc "
                        "(private), .ssh/ (private), a.tmp (.gitignore), deep/1/2/x (.gitignore), "
                        "notes/ (.gitignore), runs/ (matches), secret/list (.gitignore), "
                        "src/b.tmp (.gitignore), src/credentials.json (private), src/tls.key "
                        "(private), tls.pem (private)\n"));
  EXPECT_EQ(written.err,
            "cls: warning: host -> /etc/hostname: a link that leads out of the project; other "
            "hosts lack its target\n");
  for (const char* file : {".env.example", "roots.pem", "kept.tmp", "src/notes/ours", ".build/team",
                           "deep/1/y", "inside"}) {
    EXPECT_TRUE(fs::exists(path("ada-team/team") / file)) << file;
  }
  for (const std::string& file : private_files) {
    EXPECT_FALSE(fs::exists(path("ada-team/team") / file)) << file;
  }

  ASSERT_THAT(
      run({"package-team", "ada", "--force", "--include", ".ssh/id_rsa", "--include", "notes/"}),
      Exits(0));
  EXPECT_TRUE(fs::exists(path("ada-team/team/.ssh/id_rsa")));
  EXPECT_TRUE(fs::exists(path("ada-team/team/notes/mine")));
  EXPECT_FALSE(fs::exists(path("ada-team/team/.ssh/config")));
  EXPECT_FALSE(fs::exists(path("ada-team/team/.netrc")));
}

TEST_F(PackageTeam, LeavesOutWhatIsNoFile) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(path("page.html").c_str(), 0600), 0);
  const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = {}};
  path("socket").string().copy(static_cast<char*>(address.sun_path), sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(server);
  const bool has_device = ::mknod(path("zero").c_str(), S_IFCHR | 0600, makedev(1, 5)) == 0;

  const CommandResult written = run({"package-team", "ada"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_THAT(written.out, HasSubstr("page.html (pipe), pipe (pipe), runs/ (matches), socket "
                                     "(socket)"));
  EXPECT_THAT(written.out, HasSubstr(has_device ? "zero (device)" : "socket"));
  EXPECT_FALSE(fs::exists(path("ada-team/team/pipe")));
}

// The program is found only by the PATH of the environment, which is outside of the package.
TEST_F(PackageTeam, PlaysWithItsEnvironmentInTheSandbox) {
  const TemporaryFolder elsewhere;
  write_environment(elsewhere.path() / "env");
  write("cls.toml", "[teams.ada]\nendpoint = \"run:my-playmaker --port {port}\"\n");

  const std::string active = "VIRTUAL_ENV=" + (elsewhere.path() / "env").string();
  const CommandResult written = run({"package-team", "ada", "--json"}, {active});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const auto document = base::Json::parse(written.out);
  EXPECT_GT(document["bytes"], 1'000'000);
  ASSERT_EQ(document["interpreters"].size(), 1);
  EXPECT_EQ(document["interpreters"][0]["name"], "python3");
  EXPECT_THAT(document["interpreters"][0]["packages"].get<std::vector<std::string>>(),
              testing::Contains("ada_weights"));

  const PortLock ports;
  const CommandResult match = run({"match", "team:ada-team", "mock:hold", "--cycles", "20",
                                   "--start-timeout", "120", "--dir", "match", "--json"});
  ASSERT_EQ(match.exit_code, 0) << match.err;
  EXPECT_EQ(base::Json::parse(match.out)["end_reason"], "finished");
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
  EXPECT_THAT(match.err, HasSubstr("the Playmaker ended with exit code 3"));
  EXPECT_EQ(read_file(path("ada-team/playmaker.log")), "no weights\n");
}

TEST_F(PackageTeam, PlaysAsACompetitionStartsIt) {
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const PortLock ports;  // external teams need the ports of the server
  const CommandResult match = run({"match", "team:ada-team", "mock:hold", "--cycles", "20",
                                   "--start-timeout", "120", "--dir", "match", "--json"});
  ASSERT_EQ(match.exit_code, 0) << match.err;
  const auto result = base::Json::parse(match.out);
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["left"]["name"], "ada");
  EXPECT_FALSE(fs::exists(folder_.path() / "ada-team/run")) << "kill removes it";
}

// Each agent has a machine with a network, a user and files of its own; the package is read-only.
TEST_F(PackageTeam, PlaysOnTwelveMachines) {
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const auto report = check({"--cycles", "30"});
  if (!report["skipped"].is_null()) GTEST_SKIP() << report["skipped"];
  EXPECT_EQ(report["problem"], nullptr);
  ASSERT_EQ(report["agents"].size(), 12);
  for (const auto& agent : report["agents"]) {
    EXPECT_EQ(agent["finished"], true) << agent;
    if (agent["agent"] == "coach") continue;  // it counts none
    EXPECT_GT(agent["decisions"], 20) << agent;
  }
}

// CLS_OLD_ROOT: the files of a system with an old C library, as debootstrap makes them.
TEST_F(PackageTeam, PlaysOnAnOlderCLibrary) {
  const char* root = std::getenv("CLS_OLD_ROOT");
  if (root == nullptr) GTEST_SKIP() << "CLS_OLD_ROOT names no folder";
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  const auto report = check({"--cycles", "30", "--root", root});
  if (!report["skipped"].is_null()) GTEST_SKIP() << report["skipped"];
  EXPECT_LT(std::stod(report["glibc"].get<std::string>()), 2.36);
  for (const auto& agent : report["agents"]) EXPECT_EQ(agent["finished"], true) << agent;
}

TEST_F(PackageTeam, CheckReportsAgentsThatDoNotPlay) {
  write("cls.toml", "[teams.ada]\nendpoint = \"run:echo no weights; exit 3; : {port}\"\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  write("ada-team/start", "#!/bin/sh\necho no license for agent $3\nexit 3\n");
  const auto report = check({"--cycles", "30"});
  if (!report["skipped"].is_null()) GTEST_SKIP() << report["skipped"];
  EXPECT_EQ(report["passed"], false);
  EXPECT_EQ(report["agents"][4]["problem"], "exit code 3: no license for agent 5");
}

TEST_F(PackageTeam, CheckRefusesFoldersWithoutTheFilesOfALinux) {
  EXPECT_EQ(run({"package-team", "ada", "--check"}).err,
            "cls: ada-team/start: no such file; cls package-team without --check writes it\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  EXPECT_THAT(
      run({"package-team", "ada", "--check", "--root", "src"}),
      Exits(66,
            "cls: src/dev: no such file; --root needs the files of a Linux, as debootstrap makes "
            "them\n"));
}

// A program that needs a newer system than the oldest one starts with the loader of the package.
TEST_F(PackageTeam, StartsProgramsOfTheProjectWithItsLibraries) {
  fs::copy_file(cls_binary(), path("src/playmaker"));
  write("cls.toml", "[teams.ada]\nendpoint = \"run:src/playmaker mock --quiet --port {port}\"\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("ada-team/team/src/playmaker.program")));
  EXPECT_EQ(fs::last_write_time(path("ada-team/team/src/playmaker")),
            fs::last_write_time(path("src/playmaker")));
  const CommandResult version = tests::run({path("ada-team/team/src/playmaker"), "version"});
  EXPECT_THAT(version.out, HasSubstr("cls ")) << version.err;
}

// A project in C# as `cls new` makes it, with a program in place of the one that the SDK compiles.
TEST_F(PackageTeam, PublishesProjectsInCSharp) {
  write("Team.csproj", "<Project/>");
  write("run",
        "#!/bin/sh\n[ \"$1\" = publish ] || exit 1\ncd \"$(dirname \"$0\")\"\n"
        "mkdir -p .build/publish .build/bin/Team .build/obj/Team\n"
        "echo '{}' > .build/obj/Team/project.assets.json\n"
        "cp " +
            cls_binary().string() + " .build/publish/Team\n");
  fs::permissions(path("run"), fs::perms(0755));
  write("cls.toml", "[teams.ada]\nendpoint = \"run:./run mock --quiet --port {port}\"\n");
  ASSERT_THAT(run({"package-team", "ada"}), Exits(0));
  EXPECT_THAT(read_file(path("ada-team/start")), HasSubstr(".build/publish/Team mock --quiet"));
  EXPECT_TRUE(fs::exists(path("ada-team/team/.build/publish/Team.program")));
  EXPECT_FALSE(fs::exists(path("ada-team/team/.build/bin")));
  EXPECT_FALSE(fs::exists(path("ada-team/team/.build/obj")));
}

// A file that is loaded on demand may need what no host has: a warning, and the package is whole.
TEST_F(PackageTeam, WarnsOfLibrariesThatThisHostLacks) {
  if (!is_installed("cc")) GTEST_SKIP() << "no cc on PATH";
  write("empty.c", "");
  write("uses.c", "int from_lost(void); int uses(void) { return from_lost(); }");
  write("lost.c", "int from_lost(void) { return 1; }");
  ASSERT_EQ(tests::run({"cc", "-shared", "-o", path("liblost.so"), path("lost.c")}).exit_code, 0);
  ASSERT_THAT(tests::run({"cc", "-shared", "-o", path("src/plugin.so"), path("uses.c"),
                          path("liblost.so"), "-Wl,-soname,plugin.so"}),
              Exits(0));
  fs::remove(path("liblost.so"));
  EXPECT_THAT(run({"package-team", "ada"}),
              Exits(0, HasSubstr("liblost.so is not on this host, and so not in the package")));
}

TEST_F(PackageTeam, RefusesWhatCannotBeStarted) {
  EXPECT_THAT(run({"package-team", "adda"}).err,
              HasSubstr("has no team 'adda'; did you mean 'ada'?"));
  EXPECT_EQ(run({"package-team", "rivals"}).err,
            "cls: team 'rivals' is 'mock'; a package needs run:COMMAND, which starts the "
            "Playmaker\n");
  ASSERT_EQ(run({"package-team", "ada"}).exit_code, 0);
  EXPECT_THAT(
      run({"package-team", "ada"}),
      Exits(73, HasSubstr("--force renames it to ada-team.old, --dir selects a new folder")));

  const CommandResult forced = run({"package-team", "ada", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_THAT(forced.err, HasSubstr("cls: old package moved to "));
  EXPECT_THAT(forced.out, HasSubstr("left out: ada-team.old/ (package)"));
  EXPECT_FALSE(fs::exists(path("ada-team/team/ada-team.old")));
}

}  // namespace
}  // namespace cls::tests
