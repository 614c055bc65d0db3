// External teams in their sandbox: what they can use, and what happens where there is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "process/confinement.h"
#include "process/landlock.h"
#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

bool has_landlock() { return process::landlock_version() > 0; }

/// Two external teams. The left one has a secret; the right one runs `probes` before it plays, with
/// output in its folder.
class Sandbox : public testing::Test {
 protected:
  Sandbox() {
    add_team("rivals", "");
    std::ofstream(path("rivals/secret")) << "our tactics\n";
  }

  void add_team(const std::string& name, const std::string& probes) const {
    fs::create_directories(path(name));
    const std::string player = copy_built("cls_fake_player", path(name));
    std::ofstream(path(name + "/start.sh"))
        << "#!/bin/sh\nwhile [ $# -gt 0 ]; do case $1 in -p) port=$2;; esac; shift 2; done\n"
        << "exec 2>&1\n"
        << probes << "\nfor i in $(seq 11); do\n  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n  "
        << player << " --port $port --name " << name << " $goalie &\n  sleep 0.02\ndone\n";
    ::chmod(path(name + "/start.sh").c_str(), 0755);
  }

  CommandResult play(const Words& more = {}, const Words& launcher = {},
                     const Words& environment = {}) const {
    Words argv = launcher;
    for (const std::string& word :
         {cls_binary().string(), std::string("match"), "team:" + path("rivals").string(),
          "team:" + path("guests").string(), std::string("--half-time"), std::string("1"),
          std::string("--force")}) {
      argv.push_back(word);
    }
    argv.insert(argv.end(), more.begin(), more.end());
    if (std::ranges::find(more, "--dir") == more.end()) {
      argv.insert(argv.end(), {"--dir", path("match")});
    }
    return run(argv, environment);
  }

  std::string probe(const std::string& name) const { return read_file(path("guests/" + name)); }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
  // External teams take the usual ports of a server if they are free, which other tests need.
  const PortLock ports_;
};

TEST_F(Sandbox, ClosesResultsAndTheOtherTeam) {
  if (!has_landlock()) GTEST_SKIP() << "this kernel has no Landlock";
  add_team("guests",
           "(cat ../rivals/secret || echo closed) > rivals\n"
           "(echo worse > ../rivals/secret || echo closed) > change\n"
           "(ls ../match || echo closed) > results\n"
           "(echo '{}' > ../match/manifest.json || echo closed) > manifest\n"
           "(echo new > ../file || echo closed) > beside\n"
           "(echo 'a file' > $TMPDIR/file && cat $TMPDIR/file) > temporary\n"
           "echo $TMPDIR > folder");
  EXPECT_THAT(play(), Exits(0, ""));

  for (const char* name : {"rivals", "change", "results", "manifest", "beside"}) {
    EXPECT_THAT(probe(name), HasSubstr("closed\n")) << name << ": ";
  }

  EXPECT_EQ(read_file(path("rivals/secret")), "our tactics\n");
  EXPECT_FALSE(base::Json::parse(read_file(path("match/manifest.json"))).empty());
  EXPECT_EQ(probe("temporary"), "a file\n");
  std::string folder = probe("folder");
  folder.pop_back();
  EXPECT_TRUE(fs::path(folder).is_absolute());
  EXPECT_FALSE(fs::exists(folder)) << "of the match only";
}

// A limit of CPU time would end the opponent, or cls; a low priority would make them slow.
TEST_F(Sandbox, ClosesOtherProcesses) {
  if (!process::can_confine()) GTEST_SKIP() << "this kernel has no seccomp";
  Command victim({"/bin/sleep", "600"});
  const std::string pid = std::to_string(victim.pid());
  add_team("guests",
           "for other in $PPID " + pid +
               "; do\n"
               "(prlimit --pid $other --core=0:0 || echo closed) >> limits\n"
               "(renice -n 19 -p $other || echo closed) >> priority\n"
               "(taskset -cp 0 $other || echo closed) >> cores\n"
               "(chrt -b -p 0 $other || echo closed) >> scheduling\n"
               "(ionice -c 3 -p $other || echo closed) >> disk\n"
               "(head -c 1 /proc/$other/environ || echo closed) >> variables\n"
               "(head -c 1 /proc/$other/maps || echo closed) >> memory\n"
               "done\n"
               "grep -q 'CapPrm:.0000000000000000' /proc/self/status && echo none > caps");
  EXPECT_THAT(play(), Exits(0));

  for (const char* name : {"limits", "priority", "cores", "scheduling", "disk"}) {
    EXPECT_THAT(probe(name), MatchesRegex("(.*\n)*closed\n(.*\n)*closed\n")) << name;
  }

  if (has_landlock()) {
    EXPECT_THAT(probe("variables"), MatchesRegex("(.*\n)*closed\n(.*\n)*closed\n"));
    EXPECT_THAT(probe("memory"), MatchesRegex("(.*\n)*closed\n(.*\n)*closed\n"));
  }
  EXPECT_EQ(probe("caps"), "none\n");
}

// On every kernel.
TEST_F(Sandbox, PassesNoSecretsOfTheEnvironment) {
  add_team("guests", "env > variables");
  const Words environment = {"API_TOKEN=hunter2", "LC_ALL=C", "CLS_TLS_KEY=key.pem"};
  EXPECT_THAT(play({}, {}, environment), Exits(0));
  const std::string variables = probe("variables");
  EXPECT_THAT(variables, Not(HasSubstr("hunter2")));
  EXPECT_THAT(variables, Not(HasSubstr("CLS_")));
  for (const char* name : {"PATH=", "TMPDIR=", "LC_ALL=C\n"}) {
    EXPECT_THAT(variables, HasSubstr(name)) << name << " in ";
  }
}

TEST_F(Sandbox, CanBeTurnedOff) {
  add_team("guests", "cat ../rivals/secret > rivals; env > variables");
  EXPECT_THAT(play({"--no-sandbox"}, {}, {"API_TOKEN=hunter2"}), Exits(0));
  EXPECT_THAT(probe("variables"), HasSubstr("API_TOKEN=hunter2\n"));
  EXPECT_EQ(probe("rivals"), "our tactics\n");
}

TEST_F(Sandbox, WarnsOnAKernelWithoutLandlock) {
  const Words launcher = {built("cls_without_landlock")};
  add_team("guests", "cat ../rivals/secret > rivals");
  const CommandResult played = play({}, launcher);
  if (played.exit_code == 97) GTEST_SKIP() << played.err;
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err,
            "cls: warning: this kernel has no Landlock: the programs of team:DIR can use all your "
            "files; run them as another user or in a container, or accept that with "
            "--no-sandbox\n");
  EXPECT_EQ(probe("rivals"), "our tactics\n");
  EXPECT_EQ(play({"--no-sandbox"}, launcher).err, "");
}

TEST_F(Sandbox, TournamentsWarnOnceOnAKernelWithoutLandlock) {
  add_team("guests", "");
  std::ofstream(path("cls.toml")) << "[tournament]\nhalf_time = 1\n"
                                     "[teams.RIVALS]\nendpoint = \"team:rivals\"\n"
                                     "[teams.GUESTS]\nendpoint = \"team:guests\"\n";
  const CommandResult played =
      run({built("cls_without_landlock"), cls_binary(), "tournament", "run", folder_.path()});
  if (played.exit_code == 97) GTEST_SKIP() << played.err;
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const std::size_t first = played.err.find("cls: warning: this kernel has no Landlock");
  EXPECT_NE(first, std::string::npos) << played.err;
  EXPECT_LT(first, played.err.find("match 1")) << "before the first match: " << played.err;
  EXPECT_EQ(played.err.find("Landlock", first + 40), std::string::npos) << played.err;
}

TEST_F(Sandbox, WarnsOfResultsInTheFolderOfATeam) {
  if (!has_landlock()) GTEST_SKIP() << "this kernel has no Landlock";
  add_team("guests", "");
  EXPECT_THAT(play({"--dir", path("guests/match")}),
              Exits(0, "cls: warning: the folder of team:" + path("guests").string() +
                           " contains the match folder: the team can change the results; choose "
                           "another --dir\n"));
}

TEST_F(Sandbox, IsNamedWhenATeamMissesAFile) {
  if (!has_landlock()) GTEST_SKIP() << "this kernel has no Landlock";
  add_team("guests", "cat ../rivals/secret || exit 3");
  EXPECT_THAT(
      play(),
      Exits(69, HasSubstr("exit code 3; it runs in a sandbox: if it needs files outside of " +
                          fs::canonical(path("guests")).string() +
                          " or variables of your environment, copy them there or use "
                          "--no-sandbox")));
}

}  // namespace
}  // namespace cls::tests
