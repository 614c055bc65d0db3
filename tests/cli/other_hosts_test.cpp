// Tournaments on hosts that share nothing but a remote shell (executor = "hosts"). A host is a
// folder with an empty environment and, where the system allows it, a network namespace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "tests/support/built.h"
#include "tests/support/cls_folder.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;

class OtherHosts : public testing::Test, protected ClsFolder {
 protected:
  OtherHosts() : ClsFolder(300s) {}

  // `ssh HOST COMMAND`: the host "down" cannot be reached.
  void SetUp() override {
    const bool namespaces =
        tests::run({"unshare", "-rn", "sh", "-c", "ip link set lo up"}).exit_code == 0;
    const std::string shell =
        namespaces ? "unshare -rn sh -c 'ip link set lo up; exec sh -c \"$1\"' sh \"$1\""
                   : "sh -c \"$1\"";
    script(
        "ssh",
        "host=$1; shift\n"
        "[ \"$host\" != down ] || { echo 'ssh: connect to host down: No route' >&2; exit 255; }\n"
        "mkdir -p " +
            path("farm").string() + "/$host; cd " + path("farm").string() +
            "/$host || exit 255\n"
            "exec env -i PATH=\"$PATH\" HOME=\"$PWD\" " +
            kMarkVariable + "=" + mark_ + " " + shell);
    config("rounds = 2\nhosts = [\"one\", \"2/two\"]\n");
  }

  void TearDown() override { EXPECT_TRUE(all_marked_gone(mark_, 5s)); }

  void script(const std::string& name, const std::string& text) const {
    write(name, "#!/bin/sh\n" + text + "\n");
    ::chmod(path(name).c_str(), 0755);
  }

  void config(const std::string& tournament, const std::string& more = "") const {
    write("cup/cls.toml",
          "[tournament]\ncycles = 60\nswap_sides = false\nexecutor = \"hosts\"\n"
          "remote_shell = \"" +
              path("ssh").string() + " {host}\"\n" + tournament +
              "[teams.RED]\nendpoint = \"mock\"\n"
              "[teams.BLUE]\nendpoint = \"mock:simple\"\n"
              "[teams.HOLD]\nendpoint = \"mock:hold\"\n" +
              more);
  }

  std::string marked() const { return std::string(kMarkVariable) + "=" + mark_; }

  json report() const { return json::parse(run({"tournament", "report", "cup", "--json"}).out); }

  // Folders of jobs that are left on the hosts.
  int jobs_left() const {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path("farm"))) {
      count += entry.path().filename() == "run.sh";
    }
    return count;
  }

  const std::string mark_ = new_mark();
};

TEST_F(OtherHosts, PlayAndSendResultsLogsAndEventsBack) {
  config("rounds = 2\nhosts = [\"one\", \"2/two\"]\non_event = \"cat >>seen.jsonl\"\n");
  const CommandResult played = run({"tournament", "run", "cup"}, {marked()});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const json document = report();
  EXPECT_EQ(document["counts"]["finished"], 6);
  for (const json& match : document["matches"]) {
    const fs::path folder = path("cup") / match["folder"].get<std::string>();
    EXPECT_TRUE(fs::exists(folder / "match.rcg.gz")) << folder;
    EXPECT_TRUE(fs::exists(folder / "result.json")) << folder;
  }

  EXPECT_EQ(jobs_left(), 0);
  EXPECT_TRUE(fs::is_empty(path("cup/unfinished")));
  EXPECT_TRUE(fs::exists(path("farm/one/.cache/cls/objects")));
  EXPECT_TRUE(fs::exists(path("farm/two/.cache/cls/objects")));

  std::multiset<std::string> events;
  std::istringstream lines(read_file(path("cup/seen.jsonl")));
  for (std::string line; std::getline(lines, line);) {
    const json event = json::parse(line);
    events.insert(event["event"].get<std::string>());
    EXPECT_GE(event["match"], 1);
  }

  EXPECT_EQ(events.count("start"), 6u);
  EXPECT_EQ(events.count("end"), 6u);

  // The same seeds give the same matches, wherever they are played.
  write("here/cls.toml",
        "[tournament]\ncycles = 60\nswap_sides = false\nrounds = 2\n"
        "[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.BLUE]\nendpoint = \"mock:simple\"\n"
        "[teams.HOLD]\nendpoint = \"mock:hold\"\n");
  ASSERT_EQ(run({"tournament", "run", "here"}).exit_code, 0);
  const std::string log = document["matches"][0]["folder"].get<std::string>() + "/match.rcg.gz";
  EXPECT_EQ(read_file(path("cup") / log), read_file(path("here") / log));
}

TEST_F(OtherHosts, MatchesOfAHostThatIsDownGoToOthers) {
  config("hosts = [\"down\", \"one\"]\n");
  EXPECT_THAT(run({"tournament", "run", "cup"}, {marked()}),
              Exits(0, HasSubstr("host down: cannot be reached; trying again every 20 s")));
  EXPECT_EQ(report()["counts"]["finished"], 3);
}

TEST_F(OtherHosts, CopyTeamsByTheirContent) {
  config("rounds = 1\nhosts = [\"one\"]\ncoach = false\nsandbox = false\n",
         "[teams.GUESTS]\nendpoint = \"team:guests\"\n");
  const std::string player = fs::path(copy_built("cls_fake_player", path("cup/guests"))).filename();
  script("cup/guests/start",
         "[ $3 = 12 ] && exec sleep 600\n[ $3 = 1 ] && goalie='--goalie 1'\n"
         "exec \"$2/" +
             player + "\" --port $4 --name Others $goalie");
  const PortLock ports;

  EXPECT_THAT(run({"tournament", "run", "cup"}, {marked()}), Exits(0));
  EXPECT_EQ(report()["counts"]["finished"], 6);

  const auto objects = [this] {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("farm/one/.cache/cls/objects"))) {
      names.insert(entry.path().filename());
    }
    return names;
  };
  EXPECT_EQ(objects().size(), 2u) << "cls and the team";
}

TEST_F(OtherHosts, KillsOfAnyPartLoseNoResult) {
  config("rounds = 4\nhosts = [\"one\", \"2/two\"]\n");
  std::map<int, std::string> finished;
  for (int kill = 0; kill < 3; ++kill) {
    Command playing({cls_binary(), "tournament", "run", path("cup")}, {marked()}, path("."));
    EXPECT_TRUE(playing.wait_for_errors("  (finished", 60s));
    std::this_thread::sleep_for(std::chrono::milliseconds(150 * kill));
    playing.send_signal(SIGKILL);
    playing.finish();
    EXPECT_TRUE(all_marked_gone(mark_, 5s)) << "no process survives";
    const json reported = report();
    for (const json& match : reported["matches"]) {
      if (match["end_reason"].is_null()) continue;
      const std::string once = match["ended"].get<std::string>() + match["folder"].dump();
      EXPECT_EQ(finished.emplace(match["index"].get<int>(), once).first->second, once);
    }
    EXPECT_GT(finished.size(), static_cast<std::size_t>(kill)) << "each run has added results";
  }

  const CommandResult played = run({"tournament", "run", "cup"}, {marked()});
  EXPECT_EQ(played.exit_code, 0) << played.err;

  const json document = report();
  EXPECT_EQ(document["counts"]["finished"], 12);

  for (const auto& [index, once] : finished) {
    const json& match = document["matches"][static_cast<std::size_t>(index) - 1];
    EXPECT_EQ(once, match["ended"].get<std::string>() + match["folder"].dump()) << "played twice";
  }
}

// The host loses its connection when the match is over, before the result is here.
TEST_F(OtherHosts, ResultThatDidNotArriveIsFetchedLater) {
  const std::string cut = path("cut").string();
  script("flaky", "case $2 in *run.sh*)\n  if mkdir " + cut + " 2>/dev/null; then " +
                      path("ssh").string() + " \"$@\" | head -c 100; exit 255; fi;;\nesac\nexec " +
                      path("ssh").string() + " \"$@\"");
  config("rounds = 1\nhosts = [\"one\"]\n");
  Command playing({cls_binary(), "tournament", "run", path("cup"), "--remote-shell",
                   path("flaky").string() + " {host}"},
                  {marked()}, path("."));
  EXPECT_TRUE(playing.wait_for_errors("the connection ended with exit code", 60s) ||
              playing.wait_for_errors("the result did not arrive", 5s));

  playing.send_signal(SIGKILL);
  playing.finish();
  const json there = json::parse(
      tests::run(
          {"sh", "-c", "cat " + path("farm/one/.cache/cls/jobs").string() + "/*/*/results/*.json"})
          .out);
  ASSERT_EQ(run({"tournament", "run", "cup"}, {marked()}).exit_code, 0);

  const json document = report();
  const json& match = document["matches"][0];
  EXPECT_EQ(match["ended"], there["ended"]) << "not played again";
  EXPECT_EQ(document["counts"]["finished"], 3);
}

// A power cut can leave empty files; someone else could put another program there.
TEST_F(OtherHosts, ObjectsOfOtherContentAreCopiedAgain) {
  config("rounds = 1\nhosts = [\"one\"]\n");
  ASSERT_THAT(run({"tournament", "run", "cup"}, {marked()}), Exits(0));
  const fs::path objects = path("farm/one/.cache/cls/objects");
  for (const char* content : {"", "#!/bin/sh\nexit 0\n"}) {
    for (const auto& entry : fs::directory_iterator(objects)) {
      std::ofstream(entry.path()) << content;
    }
    ASSERT_THAT(run({"tournament", "run", "cup", "--force"}, {marked()}), Exits(0));
    EXPECT_EQ(report()["counts"]["finished"], 3);
  }
}

// A host sends files. A link or a device among them could reach anything of this host.
TEST_F(OtherHosts, ResultsWithLinksAreRefused) {
  script("evil", "case $2 in *run.sh*)\n  " + path("ssh").string() +
                     " \"$@\" >/dev/null; mkdir -p " + path("pack").string() + "/results; cd " +
                     path("pack").string() +
                     "; ln -sf /etc/passwd results/link; exec tar -czf - results;;\nesac\nexec " +
                     path("ssh").string() + " \"$@\"");
  config("rounds = 1\nhosts = [\"one\"]\n");
  Command playing({cls_binary(), "tournament", "run", path("cup"), "--remote-shell",
                   path("evil").string() + " {host}"},
                  {marked()}, path("."));
  EXPECT_TRUE(
      playing.wait_for_errors("the result holds what is neither a file nor a folder: l", 60s));
  playing.send_signal(SIGINT);
  playing.finish();
  EXPECT_FALSE(fs::is_symlink(path("cup/results/link")));
}

TEST_F(OtherHosts, WrongConfigurationsAreRefused) {
  const auto refusal = [this](const std::string& tournament, const std::string& more = "") {
    config(tournament, more);
    const CommandResult refused = run({"tournament", "run", "cup"});
    EXPECT_EQ(refused.exit_code, 78) << refused.err;
    return refused.err;
  };
  EXPECT_THAT(refusal(""), HasSubstr("needs at least one host in hosts"));
  EXPECT_THAT(refusal("hosts = [\"0/one\"]\n"), HasSubstr("'0/one' must be HOST or MATCHES/HOST"));
  EXPECT_THAT(refusal("hosts = [\"-oProxy\"]\n"), HasSubstr("must be HOST"));
  EXPECT_THAT(refusal("hosts = [\"one\"]\n", "[teams.RUN]\nendpoint = \"run:./run {port}\"\n"),
              HasSubstr("only team:DIR and built-in mocks play"));
}

}  // namespace
}  // namespace cls::tests
