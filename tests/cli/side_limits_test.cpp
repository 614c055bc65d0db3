// Sides that take more of the host than a side may: they lose, and nobody else is harmed.
#include <gmock/gmock.h>

#include "tests/cli/network_match.h"
#include "tests/support/host_namespaces.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class SideLimits : public NetworkMatch {
 protected:
  SideLimits() { left_ = team_that("rivals", ""); }

  /// A team whose script does something before it starts eleven players.
  std::string team_that(const std::string& name, const std::string& before) {
    fs::remove_all(folder_.path() / name);  // what a match before wrote counts for none
    fs::create_directories(folder_.path() / name);
    const std::string player = copy_built("cls_fake_player", folder_.path() / name);
    script(name + "/start.sh",
           "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; esac; shift 2; done\n" + before +
               "\nfor i in $(seq 11); do\n  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n  " +
               player + " --port $port --name " + name + " $goalie &\n  sleep 0.02\ndone\n");
    return "team:" + (folder_.path() / name).string();
  }

  /// Of the 60 that `guests` write, as many as they had written when the match looked.
  void expect_megabytes_above_32() const {
    constexpr std::string_view kStart = "its programs wrote ";
    const std::size_t at = played_.err.find(kStart);
    ASSERT_NE(at, std::string::npos) << played_.err;
    const int megabytes = std::atoi(played_.err.c_str() + at + kStart.size());
    EXPECT_GT(megabytes, 32);
    EXPECT_LE(megabytes, 64);
    EXPECT_THAT(played_.err, HasSubstr("M to disk, more than the 32M that --side-disk allows"));
  }

  /// The right side does this before it joins, and then waits: it is at fault.
  void expect_blamed(const std::string& deed, const std::vector<std::string>& limit,
                     const std::string& message) {
    for (const char* level : {"--sandbox=files", "--sandbox=true"}) {
      if (std::string(level) == "--sandbox=true" && !host_has_namespaces()) continue;
      const std::string guests = team_that("guests", deed + "\nsleep 60");
      std::vector<std::string> more = limit;
      more.insert(more.end(), {"--half-time", "5", level, "--start-timeout", "40"});
      play(guests, "embedded", more);
      EXPECT_EQ(result_["end_reason"], "refused") << level << played_.err;
      EXPECT_EQ(result_["fault"], "right") << level << played_.err;
      EXPECT_THAT(played_.err, HasSubstr("cls: guests (" + guests + "): ")) << level;
      EXPECT_THAT(played_.err, HasSubstr(message)) << level;
      EXPECT_LT(took_, std::chrono::seconds(30)) << level;
    }
  }
};

TEST_F(SideLimits, OfProcessesBlameWhoStartsMore) {
  expect_blamed("for i in $(seq 600); do sleep 60 & done", {"--side-processes", "250"},
                "its programs are ");
  EXPECT_THAT(played_.err, HasSubstr("more than the 250 that --side-processes allows"));
}

TEST_F(SideLimits, OfMemoryBlameWhoTakesMore) {
  expect_blamed("/usr/bin/python3 -c 'b = b\"x\" * (400 << 20); import time; time.sleep(60)' &",
                {"--side-memory", "200M"}, "its programs use ");
  EXPECT_THAT(played_.err, HasSubstr("more than the 200M that --side-memory allows"));
}

TEST_F(SideLimits, OfMemoryIncludeFilesInIt) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  const std::string guests = team_that("guests",
                                       "head -c 90M /dev/zero > /tmp/a\n"
                                       "head -c 90M /dev/zero > /dev/shm/b\nsleep 60");
  play(guests, "embedded", {"--half-time", "5", "--side-memory", "150M"});
  EXPECT_EQ(result_["fault"], "right") << played_.err;
  EXPECT_THAT(played_.err, HasSubstr("more than the 150M that --side-memory allows"));
}

TEST_F(SideLimits, OfTheDiskBlameWhoWritesMore) {
  expect_blamed("head -c 60M /dev/zero > large", {"--side-disk", "32M"}, "its programs wrote ");
  expect_megabytes_above_32();
  expect_blamed("exec 7> hidden; rm hidden; head -c 60M /dev/zero >&7", {"--side-disk", "32M"},
                "its programs wrote ");
  expect_megabytes_above_32();
}

// During play, too, with the score of that moment.
TEST_F(SideLimits, CountInPlay) {
  const std::string guests =
      team_that("guests", "(sleep 3; head -c 60M /dev/zero > large; sleep 60) &");
  play(guests, "embedded", {"--half-time", "30", "--mode", "realtime", "--side-disk", "32M"});
  expect_end("crashed", 1, "guests (" + guests + "): its programs wrote ");
  expect_megabytes_above_32();
  EXPECT_EQ(result_["fault"], "right");
  EXPECT_EQ(result_["left"]["score"], 0);
}

TEST_F(SideLimits, LeaveUsualTeamsAlone) {
  play(team_that("guests", "head -c 20M /dev/zero > large"), "embedded", {"--half-time", "5"});
  expect_finished();
}

// A small disk is full at once.
TEST_F(SideLimits, NameWhoFilledTheDisk) {
  if (!host_has_namespaces()) GTEST_SKIP() << "only in a mount namespace";
  const std::string small = folder_.path() / "small";
  const std::string large = folder_.path() / "guests";
  const std::string kept = folder_.path() / "result.json";
  fs::create_directories(small);
  team_that("guests", "(sleep 4; head -c 60M /dev/zero > large; sleep 60) &");

  const std::string prepare = "mount -t tmpfs -o size=48m tmpfs " + small + " && cp -r " + large +
                              " " + small + " && sed -i s#" + large + "#" + small + "/guests# " +
                              small + "/guests/start.sh && mkdir " + small +
                              "/tmp && export TMPDIR=" + small + "/tmp && ";
  const std::string match = cls_binary().string() + " match " + left_ + " team:" + small +
                            "/guests --half-time 30 --mode realtime --dir " + small + "/match";
  const std::string keep = "; code=$?; cp " + small + "/match/result.json " + kept + "; exit $code";
  const PortLock ports;
  const CommandResult played =
      run({"unshare", "--user", "--map-root-user", "--mount", "sh", "-c", prepare + match + keep},
          environment());

  EXPECT_EQ(played.exit_code, 1) << played.err;
  EXPECT_THAT(played.err, HasSubstr("its programs filled the disk: they wrote "));
  const auto result = base::Json::parse(read_file(kept));
  EXPECT_EQ(result["fault"], "right") << played.err;
  EXPECT_EQ(result["end_reason"], "crashed") << played.err;
  EXPECT_TRUE(all_marked_gone(mark_));
}

}  // namespace
}  // namespace cls::tests
