// `cls proxy` in the place of the framework's start scripts, and logs for soccerwindow2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/debug_packet.h"
#include "tests/support/files.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using testing::Each;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::SizeIs;
using Arguments = std::vector<std::string>;

constexpr const char* kScript = R"({"otherwise": "hold", "rules": [
  {"when": {"unum": 5}, "reply": [
    {"debug_client": {"message": "here"}},
    {"log": {"add_text": {"level": "PASS", "message": "pass"}}},
    {"log": {"add_text": {"level": "SHOOT", "message": "shot"}}},
    {"log": {"add_line": {"level": "PASS", "end": {"x": 10}, "color": "red"}}}]}]})";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The number behind `label` in what the command has printed.
std::string port_behind(const std::string& label, Command& command) {
  EXPECT_TRUE(command.wait_for_output("\n"));
  std::smatch port;
  const std::string out = command.out();
  EXPECT_TRUE(std::regex_search(out, port, std::regex(label + "(\\d+)"))) << out;
  return port[1];
}

class StartScript : public testing::Test, public ClsFolder {
 protected:
  StartScript() { std::ofstream(file("show.json")) << kScript; }

  fs::path file(const std::string& name) const { return folder_.path() / name; }
  std::string text(const std::string& name) const { return read_file(file(name)); }

  /// A match of 20 cycles on `cls server`; the left team has these options.
  CommandResult play(const Arguments& options, const Arguments& settings = {}) {
    const Arguments served =
        joined({cls_binary(), "server", "--port", "0", "--seed", "7", "--cycles", "20", "--dir",
                file("server").string(), "server::kick_off_wait=10", "server::auto_mode=on",
                "server::synch_mode=on"},
               settings);
    fs::remove_all(file("server"));
    fs::create_directories(file("server"));
    Command server(served);
    const std::string port = port_behind("[:]", server);
    const std::string coach_port = port_behind("coaches ", server);
    Command mock({cls_binary(), "mock", file("show.json").string()});
    const std::string rpc_port = port_behind("[:]", mock);
    const Arguments left = joined({cls_binary(), "proxy", "-h", "127.0.0.1", "-p", port, "-P",
                                   coach_port, "-t", "Reds", "--rpc-port", rpc_port},
                                  options);
    Command reds(left);
    EXPECT_TRUE(reds.wait_for_output("Reds plays on the left"));

    Command blues({cls_binary(), "proxy", "-h", "127.0.0.1", "-p", port, "-t", "Blues", "-C",
                   "--rpc-port", rpc_port});
    blues.finish();

    return reds.finish();
  }
};

TEST_F(StartScript, RefusesOptionsWithTheWayToDoIt) {
  const std::map<std::string, std::string> refused = {
      {"--offline-client-mode", "cls test --replay"},
      {"--use-random-rpc-port", "run:COMMAND"},
      {"--auto-close-rpc-server", "run:COMMAND"},
      {"--goalie", "--unum 1"},
      {"--player", "--unum N"}};
  for (const auto& [option, way] : refused) {
    EXPECT_THAT(
        run({"proxy", option}),
        Exits(2, testing::AllOf(testing::StartsWith("cls: " + option + ": "), HasSubstr(way))));
  }
  EXPECT_EQ(run({"proxy", "--fullstate", "some"}).exit_code, 2);
  EXPECT_EQ(run({"proxy", "--rpc-type", "rest"}).exit_code, 2);
  EXPECT_EQ(run({"proxy", "--rpc-type", "thrift", "--playmaker", "unix:x"}).exit_code, 2);
  EXPECT_EQ(run({"proxy", "--rpc-type", "thrift", "--batch", "always"}).exit_code, 2);
}

TEST_F(StartScript, WarnsOfOptionsThatChangeNothing) {
  const CommandResult result =
      run({"proxy", "-p", "9", "--start-timeout", "0.1", "--log-dir", "/tmp", "--debug_pass",
           "--debug-server-port", "7000", "--debug-start-time", "5"});
  EXPECT_EQ(result.exit_code, 69);
  EXPECT_THAT(result.err, HasSubstr("cls: warning: --log-dir has no effect without --debug or "
                                    "--debug-server-logging or --offline-logging\n"));
  EXPECT_THAT(result.err, HasSubstr("cls: warning: --debug-server-port has no effect without "
                                    "--debug-server-connect\n"));
  EXPECT_THAT(result.err, HasSubstr("cls: warning: --debug_pass has no effect without --debug\n"));
  EXPECT_THAT(result.err, HasSubstr("cls: warning: --debug-start-time has no effect without"));
}

TEST_F(StartScript, ReportsBadValues) {
  EXPECT_THAT(run({"proxy", "--debug", "--log-dir", "no/such"}).err,
              HasSubstr("--log-dir 'no/such': "));
  EXPECT_THAT(run({"proxy", "--debug-server", "127.0.0.1:x"}).err,
              HasSubstr("--debug-server '127.0.0.1:x': must be HOST:PORT"));
  EXPECT_THAT(run({"proxy", "--team-graphic", "no.xpm"}).err, HasSubstr("--team-graphic no.xpm: "));
  std::ofstream(file("one.xpm")) << "\"8 8 1 1\",\"a c red\","
                                 << "\"aaaaaaaa\",\"aaaaaaaa\",\"aaaaaaaa\",\"aaaaaaaa\","
                                 << "\"aaaaaaaa\",\"aaaaaaaa\",\"aaaaaaaa\",\"aaaaaaaa\"";
  EXPECT_THAT(run({"proxy", "-C", "--team-graphic", file("one.xpm").string()}),
              Exits(2, HasSubstr("--team-graphic: the coach shows it")));
}

// The options of the framework's start-debug.sh, and others.
TEST_F(StartScript, WritesLogsForSoccerwindow2) {
  UdpClient viewer(1);
  fs::create_directories(file("logs"));
  EXPECT_THAT(play({"--offline-logging", "--debug", "--debug-server-connect", "--debug-server-host",
                    "127.0.0.1", "--debug-server-port", std::to_string(viewer.own_port()),
                    "--debug-server-logging", "--log-dir", file("logs").string(), "--debug-log-ext",
                    ".txt", "--debug_pass", "--debug-start-time", "5", "--debug-end-time", "9"}),
              Exits(0, ""));

  const std::vector<std::string> log = lines_of(text("logs/Reds-5.txt"));
  EXPECT_THAT(log, testing::IsSupersetOf({"5,0 0 M here", "5,0 256 M pass",
                                          "5,0 256 l 0.0000 0.0000 10.0000 0.0000 red"}));
  EXPECT_THAT(log, Each(MatchesRegex("[5-9],.*")));
  EXPECT_THAT(log, Each(Not(HasSubstr("shot"))));
  EXPECT_FALSE(fs::exists(file("logs/Reds-6.txt"))) << "logs nothing";

  for (int unum = 1; unum <= 11; ++unum) {
    const std::string stem = "logs/Reds-" + std::to_string(unum);
    const auto packets = parse_debug_file(text(stem + ".dcl"));
    EXPECT_GE(packets.size(), 15U) << stem;
    for (const DebugPacket& packet : packets) {
      ASSERT_EQ(packet.error, "") << stem;
      EXPECT_EQ(packet.unum, unum);
      EXPECT_EQ(packet.items.contains("line"), unum == 5);
    }
    const std::vector<std::string> offline = lines_of(text(stem + ".ocl"));
    ASSERT_FALSE(offline.empty());
    EXPECT_THAT(offline[0], testing::StartsWith("(init l " + std::to_string(unum) + " "));
    EXPECT_GE(std::ranges::count(offline, "(think)"), 15);
  }

  std::set<int> seen;
  for (std::string bytes; viewer.receive_bytes(bytes);) {
    ASSERT_EQ(bytes.back(), '\0');
    const DebugPacket packet = parse_debug_packet(bytes.substr(0, bytes.size() - 1));
    EXPECT_EQ(packet.error, "") << bytes;
    seen.insert(packet.unum);
  }
  EXPECT_THAT(seen, SizeIs(11));
}

TEST_F(StartScript, ShowsTheTeamGraphic) {
  std::ofstream logo(file("logo.xpm"));
  logo << "/* XPM */\nstatic char *a[] = {\n\"16 8 2 1\",\n\"a c red\",\n\"b c blue\",\n";
  for (int row = 0; row < 8; ++row) logo << "\"aaaaaaaabbbbbbbb\",\n";
  logo << "};\n";
  logo.close();
  EXPECT_THAT(play({"--team-graphic", file("logo.xpm").string()}), Exits(0));
  std::string log;
  for (const auto& entry : fs::directory_iterator(file("server"))) {
    if (entry.path().extension() == ".rcg") log = read_file(entry.path());
  }
  for (const char* tile : {"(team_graphic_l (0 0 \"8 8 1 1\" \"a c red\" \"aaaaaaaa\"",
                           "(team_graphic_l (1 0 \"8 8 1 1\" \"b c blue\" \"bbbbbbbb\""}) {
    EXPECT_NE(log.find(tile), std::string::npos) << tile;
  }
}

// Players whose estimates are the server's full state know all others, always.
TEST_F(StartScript, OverridesEstimatesByTheFullState) {
  fs::create_directories(file("logs"));
  const Arguments logging = {"--debug-server-log", file("logs").string()};
  const auto known_players = [&](const Arguments& options) {
    EXPECT_EQ(play(joined(logging, options), {"server::fullstate_l=on"}).exit_code, 0);
    std::size_t least = 100;
    for (DebugPacket& packet : parse_debug_file(text("logs/Reds-5.dcl"))) {
      EXPECT_EQ(packet.error, "");
      least = std::min(least, packet.items["t"].size() + packet.items["o"].size());
    }
    return least;
  };
  EXPECT_LT(known_players({}), 21U);
  EXPECT_EQ(known_players({"--fullstate", "override"}), 21U);
}

TEST_F(StartScript, MatchesSendViewsOfBothSides) {
  UdpClient viewer(1);
  fs::create_directories(file("logs"));
  const Arguments match = {"match", "mock:" + file("show.json").string(),
                           "mock",  "--seed",
                           "5",     "--cycles",
                           "20",    "--left-name",
                           "Reds",  "--right-name",
                           "Blues", "--force",
                           "--dir"};
  const auto play_in = [&](const std::string& name, const Arguments& more) {
    Arguments argv = match;
    argv.push_back(file(name).string());
    argv.insert(argv.end(), more.begin(), more.end());
    EXPECT_THAT(run(argv), Exits(0));
    return text(name + "/match.rcg");
  };
  const std::string plain = play_in("plain", {});
  const std::string shown = play_in(
      "shown", {"--debug-server", "127.0.0.1:" + std::to_string(viewer.own_port()),
                "--debug-server-log", file("logs").string(), "--debug-log", file("logs").string()});
  EXPECT_TRUE(plain == shown) << "a viewer changes nothing in the match";

  for (const char* name : {"Reds-1", "Reds-11", "Blues-7"}) {
    const auto packets = parse_debug_file(text("logs/" + std::string(name) + ".dcl"));
    EXPECT_GE(packets.size(), 20U) << name;
    for (const DebugPacket& packet : packets) EXPECT_EQ(packet.error, "");
  }

  EXPECT_THAT(text("logs/Reds-5.log"), HasSubstr(" 0 M here\n"));
  std::string bytes;

  ASSERT_TRUE(viewer.receive_bytes(bytes));
  EXPECT_THAT(bytes, testing::StartsWith("((debug (format-version 5)) (time 0,0) (s "));
}

// Captured packets of helios-base's agents: the parser of these tests takes what they send.
TEST(DebugPackets, OfHeliosBaseHaveTheSameForm) {
  const fs::path captured = fixture("debug-view/helios-base.dcl");
  const auto packets = parse_debug_file(read_file(captured));
  std::set<std::string> names;
  for (const DebugPacket& packet : packets) {
    EXPECT_EQ(packet.error, "");
    for (const auto& [name, unused] : packet.items) names.insert(name);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"s", "b", "t", "o", "ut", "uo", "u", "say", "hear",
                                            "target-point", "message", "line", "circle"}));
}

// Of start.sh and start-agent.sh (proxy 1.1.4), and of py2d's start.py.
const std::vector<std::string> kFrameworkOptions = {"--help",
                                                    "-h",
                                                    "--host",
                                                    "-p",
                                                    "--port",
                                                    "-P",
                                                    "--coach-port",
                                                    "-t",
                                                    "--teamname",
                                                    "-n",
                                                    "--number",
                                                    "-u",
                                                    "--unum",
                                                    "-C",
                                                    "--without-coach",
                                                    "-f",
                                                    "--formation",
                                                    "--team-graphic",
                                                    "--offline-logging",
                                                    "--offline-client-mode",
                                                    "--debug",
                                                    "--debug_CATEGORY",
                                                    "--debug-start-time",
                                                    "--debug-end-time",
                                                    "--debug-server-connect",
                                                    "--debug-server-host",
                                                    "--debug-server-port",
                                                    "--debug-server-logging",
                                                    "--log-dir",
                                                    "--debug-log-ext",
                                                    "--fullstate",
                                                    "--rpc-host",
                                                    "--rpc-port",
                                                    "--rpc-port-step",
                                                    "--rpc-add-20-to-port-for-right",
                                                    "--rpc-type",
                                                    "--goalie",
                                                    "--player",
                                                    "--coach",
                                                    "--use-random-rpc-port",
                                                    "--auto-close-rpc-server"};

// The rows of the page and the options of the command.
TEST_F(StartScript, PageListsEveryOption) {
  std::set<std::string> rows;
  const std::regex option("`(--?[A-Za-z0-9_-]+)");
  bool in_table = false;
  for (const std::string& line : lines_of(read_file(source_folder() / "docs/network.md"))) {
    if (line.starts_with("| start script ")) in_table = true;
    if (!line.starts_with("|")) in_table = false;
    if (!in_table) continue;
    const std::string cell = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator at(cell.begin(), cell.end(), option), end; at != end; ++at) {
      rows.insert((*at)[1]);
    }
  }

  const std::string help = run({"proxy", "--help"}).out;
  for (const std::string& name : kFrameworkOptions) {
    EXPECT_TRUE(rows.contains(name)) << name << " is not in the table of docs/network.md";
    if (name == "--debug_CATEGORY") continue;
    EXPECT_THAT(help, HasSubstr(name));
  }

  for (const std::string& name : rows) {
    EXPECT_NE(std::ranges::find(kFrameworkOptions, name), kFrameworkOptions.end())
        << name << " is not an option of the framework";
  }
}

}  // namespace
}  // namespace cls::tests
