// Playmakers of `run:` sides in namespaces of their own: the same matches, and nothing else to
// reach.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/host_namespaces.h"
#include "tests/support/json.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

constexpr const char* kPlain = "exec ./cls_fake_playmaker --port {port}";

/// cls runs in the folder `own`, with a Playmaker in it; `others` and `match` are next to it.
class SandboxedPlaymaker : public testing::Test {
 protected:
  void SetUp() override {
    if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
    copy_built("cls_fake_playmaker", path("own"));
    fs::create_directories(path("others"));
    std::ofstream(path("others/secret")) << "our tactics\n";
  }

  fs::path path(const std::string& name) const { return fs::canonical(folder_.path()) / name; }
  std::string file(const std::string& name) const { return read_file(path(name)); }

  std::vector<std::string> words(const std::string& left, const std::vector<std::string>& more,
                                 const std::string& folder) const {
    return joined({"sh", "-c", "cd \"$0\" && exec \"$@\"", path("own"), cls_binary(), "match", left,
                   "mock:hold", "--seed", "7", "--force", "--dir", path(folder)},
                  more);
  }

  /// Plays a match in the sandbox; its documents are in `match`.
  CommandResult play(const std::string& left, const std::vector<std::string>& more = {}) const {
    return run(words(left, joined({"--half-time", "3", "--sandbox-playmakers"}, more), "match"),
               environment());
  }
  base::Json result() const { return base::Json::parse(file("match/result.json")); }

  // Folders of PATH can be read: that of `cls mock`.
  static std::vector<std::string> environment() {
    return {"PATH=" + built("") + ":" + std::getenv("PATH"), "API_TOKEN=hunter2"};
  }

  TemporaryFolder folder_;
};

TEST_F(SandboxedPlaymaker, PlaysTheSameMatch) {
  const std::string run = std::string("run:") + kPlain;
  for (const std::string& side : {run, "each:" + run, "mix:1-5=" + run + ";6-11,coach=mock:hold"}) {
    const std::vector<std::string> length = {"--half-time", "3"};
    EXPECT_THAT(tests::run(words(side, length, "plain"), environment()), Exits(0, ""));
    EXPECT_THAT(play(side), Exits(0, "")) << side;
    EXPECT_EQ(file("match/match.rcg"), file("plain/match.rcg")) << side;
    EXPECT_EQ(file("match/match.rcl"), file("plain/match.rcl")) << side;
    EXPECT_EQ(result()["deterministic"], true) << side;
  }
}

TEST_F(SandboxedPlaymaker, PlaysOverUdp) {
  for (const char* mode : {"synch", "realtime"}) {
    EXPECT_THAT(play(std::string("run:sleep 1; ") + kPlain, {"--mode", mode}), Exits(0)) << mode;
    EXPECT_GT(result()["left"]["players"][10]["decisions"], 50) << mode;
  }
}

// A listener of the test stands for a page of --watch or a Playmaker of the opponent.
TEST_F(SandboxedPlaymaker, ReachesNoPortOfThisHost) {
  Command listener({"python3", "-u", "-c",
                    "import socket, time\n"
                    "page = socket.create_server(('127.0.0.1', 0))\n"
                    "print(page.getsockname()[1])\ntime.sleep(600)"});
  ASSERT_TRUE(listener.wait_for_output("\n"));
  const std::string port = listener.out().substr(0, listener.out().find('\n'));
  const std::string side =
      "run:(/usr/bin/python3 -c 'import socket; "
      "socket.create_connection((\"127.0.0.1\", " +
      port + "), 2)' && echo reached || echo closed) > page 2> /dev/null; " + kPlain;
  EXPECT_THAT(play(side), Exits(0, ""));
  EXPECT_EQ(file("own/page"), "closed\n");
  EXPECT_THAT(run(words(side, {"--half-time", "1"}, "plain")), Exits(0, ""));
  EXPECT_EQ(file("own/page"), "reached\n");
}

TEST_F(SandboxedPlaymaker, SeesItsFolderAndNoSecrets) {
  EXPECT_THAT(play("run:(cat ../others/secret || echo closed) > secret; "
                   "(ls ../match || echo closed) > results; env > variables; "
                   "(echo x > $TMPDIR/x && cat $TMPDIR/x) > temporary; " +
                   std::string(kPlain)),
              Exits(0, ""));
  EXPECT_EQ(file("own/secret"), "closed\n");
  EXPECT_EQ(file("own/results"), "closed\n");
  EXPECT_EQ(file("own/temporary"), "x\n");
  EXPECT_THAT(file("own/variables"), AllOf(HasSubstr("PYTHONUNBUFFERED=1\n"), HasSubstr("PATH="),
                                           Not(HasSubstr("hunter2"))));
}

// The script of a project shows its folder, not the one in which cls runs.
TEST_F(SandboxedPlaymaker, SeesTheFolderOfItsScript) {
  copy_built("cls_fake_playmaker", path("team"));
  std::ofstream(path("team/run")) << "#!/bin/sh\ncd \"$(dirname \"$0\")\"\nls -A > ../team/seen "
                                     "&& ls -A ../own > own\nexec ./cls_fake_playmaker \"$@\"\n";
  fs::permissions(path("team/run"), fs::perms::owner_all);
  EXPECT_THAT(play("run:../team/run --port {port}"), Exits(0, ""));
  EXPECT_EQ(file("team/seen"), "cls_fake_playmaker\nrun\nseen\n");
  EXPECT_EQ(file("team/own"), "");
}

TEST_F(SandboxedPlaymaker, SeesNoResultsInItsFolder) {
  const std::string side = "run:(ls -A runs/1; echo x > runs/1/x || echo closed) > results; ";
  EXPECT_THAT(run(words(side + kPlain, {"--half-time", "1", "--sandbox-playmakers"}, "own/runs/1")),
              Exits(0, ""));
  EXPECT_EQ(file("own/results"), "closed\n");
}

TEST_F(SandboxedPlaymaker, IsConnectedAgainAfterARestart) {
  EXPECT_THAT(play("run:exec cls mock hold --port {port} --restart-at-cycle 15 --restart-after 200",
                   {"--reconnect-within", "30", "--max-missed", "1000"}),
              Exits(0, HasSubstr("connection to the Playmaker lost")));
  int reconnects = 0;
  const base::Json played = result();
  for (const base::Json& player : played["left"]["players"]) {
    reconnects += player["reconnects"].get<int>();
  }
  EXPECT_EQ(reconnects, 11);
}

TEST_F(SandboxedPlaymaker, IsNamedWhenItEndsOrListensElsewhere) {
  const std::string side = std::string("run:") + kPlain;
  EXPECT_THAT(play(side + " --exit-at-cycle 9"),
              Exits(1, AllOf(HasSubstr(": exit code 3"), HasSubstr("out of ideas"))));
  EXPECT_EQ(result()["fault"], "left");
  EXPECT_THAT(file("match/left-playmaker.log"), HasSubstr("out of ideas\n"));

  EXPECT_THAT(play("run:cat ../others/secret {port}"),
              Exits(69, AllOf(HasSubstr("it runs in a sandbox: if it needs files outside of " +
                                        path("own").string()),
                              HasSubstr("play without --sandbox-playmakers"))));
  EXPECT_THAT(play(side + " --port-offset 1", {"--start-timeout", "3"}),
              Exits(69, HasSubstr("it listens on port ")));
}

TEST_F(SandboxedPlaymaker, HasTheLimitsOfASide) {
  EXPECT_THAT(play("run:head -c 60M /dev/zero > large; sleep 60; : {port}",
                   {"--side-disk", "32M", "--start-timeout", "40"}),
              Exits(69, HasSubstr("more than the 32M that --side-disk allows")));
  EXPECT_EQ(result()["fault"], "left");
  EXPECT_THAT(play("each:run:sleep 60; : {port}; exit 1", {"--side-processes", "8"}),
              Exits(69, HasSubstr("more than the 8 that --side-processes allows")));
}

TEST_F(SandboxedPlaymaker, IsRefusedWhereThereAreNoNamespaces) {
  const std::vector<std::string> container = {
      "unshare", "--user", "--map-root-user",
      "sh",      "-c",     "echo 0 > /proc/sys/user/max_net_namespaces; exec \"$@\"",
      "sh"};
  const std::vector<std::string> strict = {"--half-time", "1", "--sandbox-playmakers"};
  const CommandResult refused =
      run(joined(container, words(std::string("run:") + kPlain, strict, "match")));
  EXPECT_THAT(refused, Exits(69, HasSubstr("--sandbox-playmakers needs namespaces: this host "
                                           "cannot make them: a network namespace: No space")));
  EXPECT_FALSE(result().contains("fault") && !result()["fault"].is_null());
  EXPECT_THAT(run(joined(container, words("mock:hold", strict, "match"))), Exits(0, ""));
}

// In scenarios as in matches; the verdict of this one does not matter.
TEST_F(SandboxedPlaymaker, PlaysScenarios) {
  const std::string side =
      "run:(cat ../others/secret || echo closed) > secret; " + std::string(kPlain);
  const std::vector<std::string> words = {"sh",
                                          "-c",
                                          "cd \"$0\" && exec \"$@\"",
                                          path("own"),
                                          cls_binary(),
                                          "test",
                                          "team_goalie_catches",
                                          "--against",
                                          side,
                                          "--seed",
                                          "1",
                                          "--dir",
                                          path("runs")};
  run(words, environment());
  EXPECT_EQ(file("own/secret"), "our tactics\n");
  const CommandResult played = run(joined(words, {"--sandbox-playmakers"}), environment());
  EXPECT_EQ(file("own/secret"), "closed\n") << played.out << played.err;

  const std::vector<std::string> container = {
      "unshare", "--user", "--map-root-user",
      "sh",      "-c",     "echo 0 > /proc/sys/user/max_net_namespaces; exec \"$@\"",
      "sh"};
  EXPECT_THAT(run(joined(container, joined(words, {"--sandbox-playmakers"}))).out,
              HasSubstr("--sandbox-playmakers needs namespaces: this host cannot make them"));
}

TEST_F(SandboxedPlaymaker, PlaysAProjectInPython) {
  if (python_with_grpc().empty()) GTEST_SKIP() << "no Python with grpc: install python3-grpcio";
  ASSERT_THAT(run({"sh", "-c", "cd \"$0\" && exec \"$@\"", path("own").parent_path(), cls_binary(),
                   "new", "python", "ada"}),
              Exits(0));
  EXPECT_THAT(play("run:../ada/run --port {port}"), Exits(0));
  EXPECT_EQ(result()["end_reason"], "finished");
}

}  // namespace
}  // namespace cls::tests
