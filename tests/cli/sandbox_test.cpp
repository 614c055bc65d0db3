// External teams in their sandbox: what they can use, and what happens where there is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/system/udp_socket.h"
#include "process/confinement.h"
#include "process/landlock.h"
#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/host_namespaces.h"
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

  for (const char* name : {"rivals", "change", "results", "manifest"}) {
    EXPECT_THAT(probe(name), HasSubstr("closed\n")) << name << ": ";
  }
  EXPECT_FALSE(fs::exists(path("file"))) << probe("beside");

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
  add_team(
      "guests",
      "for other in $PPID " + pid +
          "; do\n"
          "(prlimit --pid $other --core=0:0 || echo closed) >> limits\n"
          "(renice -n 19 -p $other || echo closed) >> priority\n"
          "(taskset -cp 0 $other || echo closed) >> cores\n"
          "(chrt -b -p 0 $other; chrt -p $other | grep -q BATCH || echo closed) >> scheduling\n"
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
  EXPECT_THAT(play({"--dir", path("guests/match"), "--sandbox=files"}),
              Exits(0, "cls: warning: the folder of team:" + path("guests").string() +
                           " contains the match folder: the team can change the results; choose "
                           "another --dir\n"));
}

/// As Sandbox, on a host that lets its users make namespaces.
class Namespaces : public Sandbox {
 protected:
  void SetUp() override {
    if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  }

  /// Adds guests that run `probes`, and plays twice: in namespaces, and as before without them.
  /// `closed`: the output file of each probe.
  void expect_closed_by_namespaces(const std::string& probes, const Words& closed,
                                   const Words& more = {}) {
    for (const char* level : {"files", "namespaces"}) {
      add_team("guests", "rm -f " + joined(closed) + "\n" + probes);
      Words options = {std::string("--sandbox=") + level};
      options.insert(options.end(), more.begin(), more.end());
      EXPECT_EQ(play(options).exit_code, 0);
      for (const std::string& name : closed) {
        const bool is_closed = probe(name).find("closed\n") != std::string::npos;
        EXPECT_EQ(is_closed, std::string(level) == "namespaces") << level << ": " << probe(name);
      }
    }
  }

  static std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += word + " ";
    return text;
  }
};

// The opponent could not be started any more, and lost two matches by forfeit.
TEST_F(Namespaces, ForbidPermissionsAndTimesOfFilesOfOthers) {
  std::ofstream(path("rivals/old")) << "x\n";
  expect_closed_by_namespaces(
      "(chmod 0755 ../rivals/start.sh || echo closed) > mode\n"
      "(chmod 0755 ../match || echo closed) > results\n"
      "(touch -d 2001-01-01 ../rivals/old || echo closed) > times\n"
      "(stat ../rivals/secret || echo closed) > size",
      {"mode", "results", "times", "size"});
}

TEST_F(Namespaces, ForbidSharedMemoryAndSocketsOfOthers) {
  const std::string name = path("").parent_path().filename();
  std::ofstream("/dev/shm/" + name) << "ours\n";
  const int memory = ::shmget(IPC_PRIVATE, 64, IPC_CREAT | 0666);
  expect_closed_by_namespaces("(grep ours /dev/shm/" + name +
                                  " || echo closed) > shm\n"
                                  "(ipcs -m -i " +
                                  std::to_string(memory) + " | grep bytes || echo closed) > sysv",
                              {"shm", "sysv"});
  ::shmctl(memory, IPC_RMID, nullptr);
  fs::remove("/dev/shm/" + name);
}

// A listener of the test stands for the page of --watch, a Playmaker, a drawing tool, a unix socket
// of the opponent.
TEST_F(Namespaces, ForbidPortsAndSocketsOfThisHost) {
  Command listener({"python3", "-u", "-c",
                    "import socket, sys\n"
                    "page = socket.create_server(('127.0.0.1', 0))\n"
                    "local = socket.socket(socket.AF_UNIX)\n"
                    "local.bind(sys.argv[1])\nlocal.listen()\n"
                    "print(page.getsockname()[1])\n"
                    "import time; time.sleep(600)",
                    path("rivals/socket")});
  ASSERT_TRUE(listener.wait_for_output("\n"));
  const std::string port = listener.out().substr(0, listener.out().find('\n'));
  const std::string connect =
      "import socket; socket.create_connection((\"127.0.0.1\", " + port + "), 2)";
  const std::string connect_locally =
      "import socket; socket.socket(socket.AF_UNIX).connect(\"../rivals/socket\")";
  expect_closed_by_namespaces("(/usr/bin/python3 -c '" + connect +
                                  "' && echo reached || echo closed) > page 2>&1\n"
                                  "(/usr/bin/python3 -c '" +
                                  connect_locally +
                                  "' && echo reached || echo closed) > local 2>&1",
                              {"page", "local"});
}

// Whatever is in its folder, such as those of tournaments or of a part of the other team.
TEST_F(Namespaces, CoverResultsAndTheOtherTeamInTheFolderOfATeam) {
  add_team("guests/rivals", "");
  add_team("guests",
           "(cat match/manifest.json || echo closed) > results\n"
           "(echo x > match/result.json || echo closed) > change\n"
           "(ls rivals/start.sh || echo closed) > other\n"
           "(mv rivals gone || echo closed) > move");
  const CommandResult played =
      run({cls_binary(), "match", "team:" + path("guests/rivals").string(),
           "team:" + path("guests").string(), "--half-time", "1", "--dir", path("guests/match")});
  EXPECT_THAT(played, Exits(0, Not(HasSubstr("the folder of"))));
  for (const char* name : {"results", "change", "other", "move"}) {
    EXPECT_EQ(probe(name), "closed\n") << name;
  }
}

TEST_F(Namespaces, HideTheProcessesOfThisHost) {
  expect_closed_by_namespaces(
      "(cat /proc/[0-9]*/cmdline | tr '\\0' ' ' | grep -q '[r]ivals' && echo seen || "
      "echo closed) > lines\n"
      "([ $(ls -d /proc/[0-9]* | wc -l) -gt 9 ] && echo seen || echo closed) > number",
      {"lines", "number"});
}

TEST_F(Namespaces, AreMadeWithoutAWarning) {
  add_team("guests", "");
  EXPECT_THAT(play({"--sandbox"}), Exits(0, ""));
  EXPECT_THAT(play({"--sandbox=namespaces"}), Exits(0, ""));
  EXPECT_THAT(play({"--sandbox=files"}), Exits(0, ""));
}

// Two teams that know the usual ports only, next to each other and to a server there.
TEST_F(Namespaces, LeaveTheUsualPortsToAll) {
  const auto taken = base::UdpSocket::bind(*base::parse_ip_address("127.0.0.1", 6000));
  add_team("guests", "");
  std::ofstream(path("guests/start"))
      << "#!/bin/sh\ngoalie=; [ $3 = 1 ] && goalie='--goalie 1'\n[ $3 = 12 ] && exec sleep 100\n"
      << "exec " << copy_built("cls_fake_player", path("guests")) << " --name guests $goalie\n";
  ::chmod(path("guests/start").c_str(), 0755);
  EXPECT_THAT(play(), Exits(0, ""));
}

// A container whose users may not make them is a kernel that refuses.
TEST_F(Namespaces, AreMissedWithOneWarning) {
  add_team("guests", "");
  const Words container = {
      "unshare", "--user", "--map-root-user",
      "sh",      "-c",     "echo 0 > /proc/sys/user/max_net_namespaces; exec \"$@\"",
      "sh"};
  const CommandResult played = play({}, container);
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err,
            "cls: warning: this host cannot make namespaces (a network namespace: No space left on "
            "device; sysctl user.max_net_namespaces=10000 allows it): the programs of team:DIR "
            "share its network, shared memory and sockets with each other (docs/security.md); "
            "accept that with --sandbox=files\n");

  const CommandResult refused = play({"--sandbox=namespaces"}, container);
  EXPECT_EQ(refused.exit_code, 69) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--sandbox=namespaces: this host cannot make them: a network "
                                     "namespace: No space left on device"));
}

// A team cannot void its matches by its own script, and its opponent cannot make it lose them.
TEST_F(Namespaces, ShowWhoseFaultAScriptIsThatCannotBeRun) {
  for (const char* level : {"files", "namespaces"}) {
    add_team("guests", "");
    ::chmod(path("guests/start.sh").c_str(), 0644);
    const CommandResult refused = play({std::string("--sandbox=") + level});
    EXPECT_EQ(refused.exit_code, 69) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("start.sh"));
    const auto result = base::Json::parse(read_file(path("match/result.json")));
    if (std::string(level) == "namespaces") {
      EXPECT_EQ(result["fault"], "right");
    } else {
      EXPECT_TRUE(result["fault"].is_null());
    }
  }
}

TEST_F(Namespaces, NeedBoundClients) {
  add_team("guests", "");
  EXPECT_THAT(play({"--sandbox=namespaces", "--no-bind-clients"}),
              Exits(69, HasSubstr("with --no-bind-clients programs of any place take part")));
  EXPECT_THAT(play({"--sandbox=network"}),
              Exits(2, HasSubstr("must be true, false, files or namespaces")));
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
