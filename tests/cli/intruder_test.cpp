// Teams that reach for the other side: by its name, its players, its coach, and as monitors.
#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/cli/network_match.h"
#include "tests/support/command_matchers.h"
#include "tests/support/host_namespaces.h"
#include "tests/support/rcssserver.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

/// After the seconds that it is told, sends messages in the name of the server to all clients of
/// others: from each port of the server, which the program has on another address of loopback
/// (IP_PKTINFO).
constexpr const char* kForger = R"(
import glob, os, re, socket, struct, sys, time
def own_inodes():
    found = set()
    for link in glob.glob('/proc/[0-9]*/fd/*'):
        try: found.update(re.findall(r'socket:\[(\d+)\]', os.readlink(link)))
        except OSError: pass
    return found
def sockets():
    for line in open('/proc/net/udp').readlines()[1:]:
        words = line.split()
        local, peer = (word.split(':') for word in words[1:3])
        yield local[0], int(local[1], 16), int(peer[1], 16), words[9]
def victims():
    entries, own = list(sockets()), own_inodes()
    ports = {port for _, port, _, inode in entries if inode in own}
    return [(port, peer) for host, port, peer, _ in entries
            if peer and host == '0100007F' and peer not in ports]
source = struct.pack('=i4s4s', 0, socket.inet_aton('127.0.0.1'), bytes(4))
wait = float(sys.argv.pop(1))
seen, until = set(), time.time() + wait + 4
time.sleep(wait)
while time.time() < until:
    for port, peer in victims():
        seen.add(peer)
        forger = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        forger.bind(('127.0.0.2', port))
        for message in sys.argv[1:]:
            forger.sendmsg([message.encode()], [(socket.IPPROTO_IP, 8, source)], 0,
                           ('127.0.0.1', peer))
        forger.close()
    print('victims', len(seen), flush=True)
    time.sleep(0.01)
)";

class Intruder : public NetworkMatch {
 protected:
  /// A team in a folder of its own, whose script runs `before` and then starts 11 players under a
  /// name; `$intruder` in it is a program that sends (tests/fakes/fake_intruder.cpp).
  std::string named_team(const std::string& folder, const std::string& name,
                         const std::string& before = "", const std::string& after = "") {
    fs::create_directories(folder_.path() / folder);
    const std::string player = copy_built("cls_fake_player", folder_.path() / folder);
    const std::string intruder = copy_built("cls_fake_intruder", folder_.path() / folder);
    script(folder + "/start.sh",
           "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; -P) coach=$2;; esac; shift; "
           "[ $# -gt 0 ] && shift; done\n"
           "player='" +
               player + "'; intruder='" + intruder + "'\nexec 2>&1\n" + before +
               "\nfor i in $(seq 11); do\n  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n"
               "  $player --port $port --name " +
               name + " $goalie &\n  sleep 0.02\ndone\n" + after);
    return "team:" + (folder_.path() / folder).string();
  }

  /// A team whose forger sends the messages, from so many seconds after its start on.
  std::string forgers(int seconds, const std::vector<std::string>& messages) {
    fs::create_directories(folder_.path() / "team");
    std::ofstream(folder_.path() / "team/forger.py") << kForger;
    std::string forger = "/usr/bin/python3 forger.py " + std::to_string(seconds);
    for (const std::string& message : messages) forger += " '" + message + "'";
    return named_team("team", "Forgers", forger + " &\n", "wait\n");
  }

  void play_embedded(const std::string& right, const std::vector<std::string>& more = {},
                     const std::string& mode = "synch") {
    play(right, "embedded", joined({"--half-time", "5", "--mode", mode}, more));
  }

  /// On a server that accepts any client, where cls starts it. The intruder asks for what monitors,
  /// trainers and the other side have.
  void reach_beyond_its_side(const std::string& server, const std::vector<std::string>& more) {
    const auto ask = [](const std::string& port, const std::string& request) {
      return "$intruder --port " + port + " --first '" + request +
             "' --then '(dispcard 1 2 red)' & ";
    };
    play(named_team("team", "Watchers", "$intruder --port 6001 --first '(init (version 18))'",
                    ask("$port", "(dispinit version 4)") + ask("$port", "(reconnect hold 2)") +
                        ask("$port", "(init hold (version 18))") +
                        ask("$coach", "(init hold (version 18))") + "wait"),
         server, more);
    expect_finished();
    EXPECT_TRUE(result_["fault"].is_null());
  }

  std::string file(const std::string& name) const { return read_file(match_folder() + "/" + name); }
  /// What the programs of the right team have printed.
  std::string output() const { return file("right-team.log"); }
};

TEST_F(Intruder, TeamsOfOneNamePlayAndAreDistinct) {
  left_ = named_team("first", "Twins");
  play_embedded(named_team("second", "Twins"));
  expect_finished();
  EXPECT_EQ(result_["left"]["name"], "Twins");
  EXPECT_EQ(result_["right"]["name"], "Twins_r");
  EXPECT_TRUE(result_["fault"].is_null());
  EXPECT_THAT(file("match.rcg"), HasSubstr("Twins Twins_r"));
  EXPECT_THAT(output(), Not(HasSubstr("(error")));
}

// The names of the sides do not depend on who comes first, nor does a name give the right to play.
TEST_F(Intruder, DoesNotPlayForAnotherSideByItsName) {
  left_ = named_team("first", "Lions", "",
                     "for i in 1 2; do $intruder --port $port --first "
                     "'(init Bears (version 18))'; done\n");
  play_embedded(named_team("second", "Bears"));
  expect_finished();
  EXPECT_EQ(result_["left"]["name"], "Lions");
  EXPECT_EQ(result_["right"]["name"], "Bears");
  EXPECT_THAT(file("left-team.log"), HasSubstr("reply (error no_more_team)"));
  EXPECT_THAT(played_.err, HasSubstr("a program of the left side at UDP port "));
  EXPECT_THAT(played_.err, HasSubstr("sent (init Bears (version 18)): refused"));

  play_embedded(named_team("second", "Bears"), {"--sandbox=files"});
  expect_finished();
  EXPECT_THAT(played_.err, HasSubstr("a program of the left side (cls_fake_intrud, process "));
}

TEST_F(Intruder, ForgesNoMessagesOfTheServer) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  for (const char* message :
       {"(hear 100 referee goal_l_9)", "(hear 101 referee time_over)", "(error no_such_team)"}) {
    play_embedded(forgers(0, {message}));
    expect_finished();
    EXPECT_THAT(output(), AllOf(HasSubstr("victims 0\n"), Not(ContainsRegex("victims [1-9]"))));
    EXPECT_EQ(result_["left"]["score"], 0);
    EXPECT_EQ(result_["right"]["score"], 0);
    EXPECT_TRUE(result_["valid"].get<bool>());
  }
}

// Runs a command in a network of its own: the forger reaches all matches of its network.
const std::vector<std::string>& own_network() {
  static const std::vector<std::string> words = {"unshare", ::geteuid() == 0 ? "-n" : "-rn",
                                                 "/usr/bin/python3", "-c", R"(
import fcntl, os, socket, struct, sys
SET_FLAGS, UP = 0x8914, 1
fcntl.ioctl(socket.socket(socket.AF_INET, socket.SOCK_DGRAM), SET_FLAGS, struct.pack('16sh22x', b'lo', UP))
os.execv(sys.argv[1], sys.argv[1:]))"};
  return words;
}

// What the namespaces are for: agents of cls believe the forger, before the match begins. The score
// that they have heard counts no more than the log.
TEST_F(Intruder, WinsNothingByForgeryWhereTheSidesShareANetwork) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  launcher_ = own_network();
  play_embedded(forgers(0, {"(hear 100 referee goal_l_9)", "(hear 101 referee time_over)"}),
                {"--sandbox=files"});
  EXPECT_THAT(output(), ContainsRegex("victims [1-9]"));
  EXPECT_EQ(result_["left"]["score"], 0) << played_.err;
  EXPECT_FALSE(result_["valid"].get<bool>() && result_["right"]["score"] != 0) << played_.err;
}

// Without its agents a side would lose what is left of a match that the server plays on.
TEST_F(Intruder, WinsNothingWhereThePlayersBelieveThatTheMatchIsOver) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  launcher_ = own_network();
  play(forgers(5, {"(hear 101 referee time_over)"}), "embedded",
       {"--half-time", "10", "--mode", "realtime", "--sandbox=files"});
  EXPECT_THAT(output(), ContainsRegex("victims [1-9]"));
  EXPECT_FALSE(result_["valid"].get<bool>());
  EXPECT_THAT(played_.err, HasSubstr("because somebody told them that the match is over"));
}

TEST_F(Intruder, PlaysAloneUnderTheNameOfItsOpponent) {
  left_ = named_team("first", "Bears");
  play_embedded(named_team("second", "Bears"));
  expect_finished();
  EXPECT_EQ(result_["right"]["name"], "Bears_r");
}

TEST_F(Intruder, DoesNotTakeOverPlayers) {
  for (const char* mode : {"synch", "realtime"}) {
    play_embedded(named_team("team", "Thieves",
                             "for i in 1 2 3; do $intruder --port $port --first "
                             "\"(reconnect hold $i)\"; done"),
                  {}, mode);
    expect_finished();
    EXPECT_THAT(output(), HasSubstr("reply (error no_such_team_or_player)")) << mode;
    EXPECT_THAT(output(), Not(HasSubstr("reply (reconnect"))) << mode;
    EXPECT_THAT(played_.err, HasSubstr("sent (reconnect hold 1): refused"));
  }
}

TEST_F(Intruder, DoesNotTakeTheCoachOfTheOther) {
  play_embedded(
      named_team("team", "Thieves", "$intruder --port $coach --first '(init hold (version 18))'"),
      {"--no-coach"});
  expect_finished();
  EXPECT_THAT(output(), HasSubstr("reply (error no_such_team)"));
}

TEST_F(Intruder, NeitherWatchesNorSendsOff) {
  play_embedded(named_team("team", "Watchers",
                           "$intruder --port $port --first '(dispinit version 4)' --then "
                           "'(dispcard 1 2 red)' &"));
  expect_finished();
  EXPECT_THAT(output(), HasSubstr("reply (error no_more_monitor)"));
  EXPECT_THAT(file("match.rcl"), Not(HasSubstr("red_card")));
}

// As A3 of rcssserver: a monitor from outside of the match may watch, and nothing else.
TEST_F(Intruder, MonitorsFromOutsideOnlyWatch) {
  const int port = UdpClient(1).own_port();  // free a moment ago
  Command match(
      arguments("mock:hold", "embedded",
                {"--half-time", "10", "--mode", "synch", "--monitor-port", std::to_string(port)}),
      environment());
  ASSERT_TRUE(match.wait_for_errors("monitors may attach"));
  UdpClient monitor(port);
  monitor.send("(dispinit version 4)");
  const std::string reply = monitor.wait();
  EXPECT_THAT(reply, HasSubstr("server_param"));

  for (int i = 0; i < 50; ++i) {
    monitor.send("(dispcard 1 2 red)");
    monitor.wait(std::chrono::milliseconds(20));
  }

  EXPECT_THAT(match.finish(), Exits(0));
  EXPECT_THAT(file("match.rcl"), Not(HasSubstr("red_card")));
}

// A relay stands between a side in namespaces and a server that accepts any client.
TEST_F(Intruder, ReachesThePlacesOfItsSideOnlyOnAnyServer) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  reach_beyond_its_side(server(""), {"--cycles", "40"});
  for (const char* reply : {"(error no_more_monitor)", "(error no_such_team_or_player)",
                            "(error no_more_team)", "(error no_such_team)"}) {
    EXPECT_THAT(output(), HasSubstr("reply " + std::string(reply)));
  }
  EXPECT_THAT(output(), HasSubstr("no reply")) << "of the port of trainers";
  for (const char* reply : {"(init", "(reconnect", "(server_param"}) {
    EXPECT_THAT(output(), Not(HasSubstr("reply " + std::string(reply))));
  }
  EXPECT_THAT(played_.err, HasSubstr("sent (dispinit version 4): refused"));
  EXPECT_THAT(file("match.rcl"), Not(HasSubstr("red_card")));
}

TEST_F(Intruder, ReachesThePlacesOfItsSideOnlyOnRcssserver) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host makes no namespaces";
  if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  for (const char* mode : {"synch", "realtime"}) {
    reach_beyond_its_side(rcssserver_program(), {"--half-time", "8", "--mode", mode});
    EXPECT_THAT(output(), HasSubstr("reply (error no_more_monitor)")) << mode;
    for (const char* reply : {"(init", "(reconnect", "(server_param"}) {
      EXPECT_THAT(output(), Not(HasSubstr("reply " + std::string(reply)))) << mode;
    }
    EXPECT_THAT(file("match.rcl"), Not(HasSubstr("red_card"))) << mode;
  }
}

// Without namespaces, on a server that is not of cls: it accepts any client, as rcssserver does.
TEST_F(Intruder, IsNamedOnAServerThatAcceptsAnyClient) {
  const std::string watch = "$intruder --port $port --first '(dispinit version 4)' --then '(x)' & ";
  play(named_team("team", "Watchers", watch + watch + watch), server(""),
       {"--cycles", "25", "--sandbox=files"});
  EXPECT_THAT(played_.err, HasSubstr("an intrusion: programs of the right side hold "));
  EXPECT_THAT(played_.err, HasSubstr("connections to the soccer server; 12 can be its own"));
  EXPECT_NE(result_["fault"], "left");
}

TEST_F(Intruder, AloneIsAtFaultOnAServerThatAcceptsAnyClient) {
  left_ = "mock:hold";
  play(named_team("team", "Thieves", "",
                  "for i in 1 2 3 4 5 6 7 8 9 10 11; do $intruder --port $port --first "
                  "\"(reconnect hold $i)\" --then '(x)' --times 500 & done; wait"),
       server(""), {"--half-time", "50", "--sandbox=files"});
  EXPECT_NE(result_["end_reason"], "finished");
  EXPECT_EQ(result_["fault"], "right") << played_.err;
  EXPECT_THAT(played_.err, HasSubstr("an intrusion: programs of the right side hold "));
}

// For teams in containers, whose processes cannot be seen here.
TEST_F(Intruder, PlaysWhereTheUserDoesNotBindClients) {
  play_embedded(
      named_team("team", "Thieves", "$intruder --port $port --first '(init Guests (version 18))'"),
      {"--no-bind-clients"});
  EXPECT_THAT(output(), HasSubstr("reply (init")) << played_.err;
}

// Without the binding a started server is as rcssserver: so only a match may ask for it.
TEST_F(Intruder, BindingNeedsAMatch) {
  const auto server = run({cls_binary(), "server", "--port", "0", "match::sides=team,cls"});
  EXPECT_EQ(server.exit_code, 2);
  EXPECT_THAT(server.err, HasSubstr("match::sides: no match has started this server"));
}

}  // namespace
}  // namespace cls::tests
