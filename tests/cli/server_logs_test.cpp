// Compares the logs of `cls server` with those of rcssserver for the same match, cycle by cycle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;

/// Messages sent before the end of a cycle.
struct Cycle {
  Arguments trainer;
  std::string left;
  std::string right;
};

/// A server with one player per side and a trainer, in synchronous mode, so that each cycle has
/// exactly the given commands.
class ScriptedServer {
 public:
  ScriptedServer(Arguments command, const Arguments& settings) {
    for (int& port : ports_) port = free_udp_port();
    const std::string path = folder_.path();

    for (const std::string& argument :
         Arguments{"server::port=" + std::to_string(ports_[0]),
                   "server::coach_port=" + std::to_string(ports_[1]),
                   "server::olcoach_port=" + std::to_string(ports_[2]), "server::synch_mode=on",
                   "server::coach_w_referee=on", "server::ball_rand=0", "server::player_rand=0",
                   "server::kick_rand=0", "server::wind_rand=0", "server::wind_force=0",
                   "player::player_types=1", "player::random_seed=1", "server::game_log_dated=off",
                   "server::text_log_dated=off", "server::keepaway_log_dated=off"}) {
      command.push_back(argument);
    }

    command.insert(command.end(), settings.begin(), settings.end());
    server_ = std::make_unique<Command>(
        command, Arguments{"RCSS_CONF_DIR=" + path + "/conf", "USER=nobody"}, path);
    wait_for_start();
    left_ = join("(init A (version 18))", ports_[0]);
    right_ = join("(init B (version 18))", ports_[0]);
    trainer_ = join("(init (version 18))", ports_[1]);
    settle();
  }

  void play(const Cycle& cycle) {
    for (const std::string& order : cycle.trainer) trainer_->send(order);
    if (!cycle.left.empty()) left_->send(cycle.left);
    if (!cycle.right.empty()) right_->send(cycle.right);
    be_done();
    for (std::size_t i = 0; i < cycle.trainer.size(); ++i) wait_for("(ok ", *trainer_);
    await_think();
  }

  /// Stops the server; returns the log with this file name ending.
  std::string log(const std::string& ending) {
    server_->send_signal(SIGINT);
    server_->finish();
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      if (entry.path().extension() == ending) return read_file(entry.path());
    }
    ADD_FAILURE() << "no log " << ending << "\n" << server_->out();
    return {};
  }

 private:
  static constexpr std::chrono::seconds kPatience{20};

  void wait_for_start() const {
    for (int i = 0; i < 400; ++i) {
      UdpClient probe(ports_[0]);
      probe.send("(anybody)");
      if (probe.wait(std::chrono::milliseconds(50)) == "(error unknown_command)") return;
    }
    throw std::runtime_error("the server does not start: " + server_->out());
  }

  static std::unique_ptr<UdpClient> join(const std::string& request, int port) {
    auto client = std::make_unique<UdpClient>(port);
    client->send(request);
    wait_for("(init ", *client);
    return client;
  }

  // While later clients connected, cycles passed without commands of the earlier ones.
  void settle() {
    for (int i = 0; i < 3; ++i) {
      await_think();
      std::string missed;
      for (UdpClient* player : {left_.get(), right_.get()}) {
        while (player->receive(missed)) {
        }
      }
      be_done();
    }
    await_think();
  }

  void await_think() {
    wait_for("(think)", *left_);
    wait_for("(think)", *right_);
  }

  void be_done() {
    left_->send("(done)");
    right_->send("(done)");
  }

  static void wait_for(const std::string& start, UdpClient& client) {
    for (;;) {
      const std::string message = client.wait(kPatience);
      if (message.empty()) throw std::runtime_error("no message starts with " + start);
      if (message.starts_with(start)) return;
    }
  }

  int ports_[3] = {};
  TemporaryFolder folder_;
  std::unique_ptr<Command> server_;
  std::unique_ptr<UdpClient> left_;
  std::unique_ptr<UdpClient> right_;
  std::unique_ptr<UdpClient> trainer_;
};

std::string log_of(const Arguments& command, const Arguments& settings,
                   const std::vector<Cycle>& match, const std::string& ending) {
  ScriptedServer server(command, settings);
  for (const Cycle& cycle : match) server.play(cycle);
  return server.log(ending);
}

const Arguments kOwnTeam = {cls_binary(), "server"};

/// The ball leaves the area; a taker has it; a taker has it when it leaves.
std::vector<Cycle> three_episodes() {
  std::vector<Cycle> match(30);
  match[1].trainer = {"(start)"};
  match[8].trainer = {"(move (ball) 10.5 0)"};
  const Arguments taken = {"(move (ball) 0 0)", "(move (player B 1) 0.6 0)",
                           "(move (player A 1) 8 8)"};
  for (std::size_t i = 12; i < 17; ++i) match[i].trainer = taken;
  for (std::size_t i = 20; i < 24; ++i) match[i].trainer = taken;
  match[24].trainer = {"(move (ball) 0 12)"};
  return match;
}

TEST(KeepawayLogs, RecordEpisodesAndTheirEnds) {
  const std::string log = log_of(kOwnTeam, {"server::keepaway=on"}, three_episodes(), ".kwy");
  EXPECT_TRUE(log.starts_with("# Keepers: 1\n# Takers:  1\n# Region:  20 x 20\n#\n")) << log;
  EXPECT_TRUE(std::regex_search(log, std::regex("\n1\t0\t(\\d+)\t\\1\to\n2\t\\1\t\\d+\t\\d+\tt\n3\t"
                                                "\\d+\t\\d+\t\\d+\to\n$")))
      << log;
}

TEST(KeepawayLogs, MatchRcssserver) {
  if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const Arguments keepaway = {"server::keepaway=on"};
  EXPECT_EQ(log_of({rcssserver_program()}, keepaway, three_episodes(), ".kwy"),
            log_of(kOwnTeam, keepaway, three_episodes(), ".kwy"));
}

std::vector<Cycle> short_match() {
  std::vector<Cycle> match(14);
  match[0] = {{"(move (player A 1) -10 0 30)", "(move (player B 1) 20 5 -90)"}, "", ""};
  match[1].trainer = {"(start)"};
  match[3].left = "(dash 50)(say hi)";
  match[4].right = "(turn 40)(turn_neck -20)(change_view narrow)";
  match[5].trainer = {"(move (ball) -10 0.5)", "(say (hello there))"};
  match[6].left = "(kick 60 10)";
  match[7].right = "(pointto 10 20)(attentionto opp 1)";
  match[8].right = "(dash 100 90)(change_focus 3 20)";
  match[9].trainer = {"(change_mode free_kick_r)"};
  match[11].left = "(catch 0)(tackle 0)";
  return match;
}

/// May differ: date, ports, waiting time for clients, body of players that never connected, and
/// commands, after which rcssserver leaves the end of a longer previous one.
Arguments without_circumstances(std::string log) {
  for (const auto& [pattern, text] : std::vector<std::pair<const char*, const char*>>{
           {"\\(result [0-9]+ ", "(result DATE "},
           {"\"timestamp\":\"[^\"]*\"", "\"timestamp\":\"DATE\""},
           {"\"stime\":[0-9]+,?", ""},
           {" 180 0 \\(v h 90\\)", " 0 0 (v h 90)"},
           {"\"body\":180,", "\"body\":0,"},
           {"(coach_port|olcoach_port|port)( |\":)[0-9]+", "$1$2PORT"}}) {
    log = std::regex_replace(log, std::regex(pattern), text);
  }
  Arguments lines;
  for (const std::string_view line : split_lines(log)) {
    if (line.find("Recv ") == line.npos) lines.emplace_back(line);
  }
  return lines;
}

TEST(GameLogMessages, ContainCommandsAndRefereeMessages) {
  const std::string log = log_of(kOwnTeam, {"server::record_messages=on"}, short_match(), ".rcg");
  for (const char* line :
       {"(msg 0 2 \"Recv A_1: (init A (version 18))\")\n", "(msg 0 1 \"(referee kick_off_l)\")\n",
        "2 \"Recv Coach: (start)\")\n", "2 \"Recv B_1: (pointto 10 20)(attentionto opp 1)\")\n",
        "1 \"((player A 1) hi)\")\n", "1 \"(referee (hello there))\")\n"}) {
    EXPECT_THAT(log, HasSubstr(line)) << line;
  }
}

class GameLogVersions : public testing::TestWithParam<int> {};

TEST_P(GameLogVersions, MatchRcssserver) {
  if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const Arguments settings = {"server::game_log_version=" + std::to_string(GetParam()),
                              "server::record_messages=on"};
  EXPECT_EQ(without_circumstances(log_of({rcssserver_program()}, settings, short_match(), ".rcg")),
            without_circumstances(log_of(kOwnTeam, settings, short_match(), ".rcg")));
}

INSTANTIATE_TEST_SUITE_P(Text, GameLogVersions, testing::Values(4, 5, 6, -1));

}  // namespace
}  // namespace cls::tests
