// Matches with viewers: the same bytes, the page while it is played, an end without a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "base/system/udp_socket.h"
#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/http_client.h"
#include "tests/support/pseudo_terminal.h"
#include "tests/support/temporary_folder.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

std::vector<std::string> match_command(const fs::path& folder) {
  return {cls_binary(), "match",        "mock", "mock",  "--seed",
          "7",          "--half-time",  "20",   "--set", "server::kick_off_wait=3",
          "--dir",      folder.string()};
}

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string url_in(const std::string& text) {
  std::smatch found;
  return std::regex_search(text, found, std::regex("http://127[^ \"\n]*")) ? found.str() : "";
}

void wait_for_file(const fs::path& file) {
  for (int i = 0; i < 400 && !fs::exists(file); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

/// A viewer that asks for the whole match and reads nothing, until it is destroyed.
std::unique_ptr<HttpConnection> stalled_viewer(const std::string& url) {
  auto viewer = std::make_unique<HttpConnection>(port_of(url));
  viewer->send("GET " + path_of(url) + "live HTTP/1.1\r\nHost: localhost\r\n\r\n");
  return viewer;
}

// Every program of the host sees the arguments of the browser: the address is in a file that only
// the user can read.
TEST(LiveMatch, GivesTheBrowserAFileInPlaceOfTheAddress) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "xdg-open")
      << "#!/bin/sh\nfile=${1#file://}\necho \"$1\" >" << (folder.path() / "argument.new").string()
      << "\nstat -c %a \"$file\" \"${file%/*}\" >" << (folder.path() / "rights").string()
      << "\ncp \"$file\" " << (folder.path() / "page").string() << "\nmv "
      << (folder.path() / "argument.new").string() << " " << (folder.path() / "argument").string()
      << "\n";
  fs::permissions(folder.path() / "xdg-open", fs::perms(0755));
  const char* path = std::getenv("PATH");
  Command watched(with(match_command(folder.path() / "m"),
                       {"--watch", "--open", "--linger", "0", "--speed", "20"}),
                  {"DISPLAY=:9", "PATH=" + folder.path().string() + ":" + path});
  wait_for_file(folder.path() / "argument");
  watched.send_signal(SIGINT);
  (void)watched.finish();

  const std::string argument = read_file(folder.path() / "argument");
  EXPECT_THAT(argument, testing::StartsWith("file:///"));
  EXPECT_EQ(read_file(folder.path() / "rights"), "600\n700\n");
  EXPECT_THAT(read_file(folder.path() / "page"), HasSubstr("url=http://127.0.0.1:"));
  EXPECT_FALSE(fs::exists(argument.substr(7, argument.size() - 8))) << "it went with the match";
}

TEST(LiveMatch, HasTheSameBytesWithViewers) {
  const TemporaryFolder folder;
  const auto alone = run(match_command(folder.path() / "alone"));
  ASSERT_EQ(alone.exit_code, 0) << alone.err;

  const fs::path where = folder.path() / "watched";
  // Slow enough to be watched.
  Command watched(with(match_command(where), {"--watch", "--linger", "0", "--speed", "20"}));
  wait_for_file(where / "match.rcg");
  Command watch({cls_binary(), "watch", where, "--no-open"});
  ASSERT_TRUE(watch.wait_for_output("/\n"));

  std::vector<std::unique_ptr<HttpConnection>> viewers;
  for (int i = 0; i < 3; ++i) viewers.push_back(stalled_viewer(url_in(watch.out())));
  const auto played = watched.finish();
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_NE(url_in(played.err), "") << played.err;
  viewers.clear();
  for (const char* file : {"match.rcg", "match.rcl", "events.jsonl"}) {
    EXPECT_TRUE(read_file(folder.path() / "alone" / file) ==
                read_file(folder.path() / "watched" / file))
        << file;
  }
}

TEST(LiveMatch, IsServedWhileItIsPlayed) {
  const TemporaryFolder folder;
  const fs::path where = folder.path() / "match";
  Command match(with(match_command(where), {"--speed", "20"}));
  wait_for_file(where / "match.rcg");
  Command watch({cls_binary(), "watch", where, "--no-open", "--json"});
  ASSERT_TRUE(watch.wait_for_output("\"url\""));
  const std::string url = url_in(watch.out());
  EXPECT_EQ(get(url).status, 200);

  const auto stream = get(url + "live");
  EXPECT_EQ(match.finish().exit_code, 0);

  const auto live = cls::viewer::read_stream(stream.body);
  ASSERT_TRUE(live) << live.error().message;
  const auto record = cls::gamelog::read_rcg_file(where / "match.rcg").value();
  EXPECT_EQ(live->record.frames(), record.frames());
  EXPECT_EQ(live->record.notes.size(), record.notes.size());
  EXPECT_EQ(live->record.errors.count, 0U);
  EXPECT_NE(live->statistics, "");
  // Without a terminal the page ends with the match.
  EXPECT_EQ(watch.finish().exit_code, 0);
}

// Tunnels of editors and of containers pass a host name of their own on.
TEST(LiveMatch, AnswersToTheHostNamesThatItIsGiven) {
  const TemporaryFolder folder;
  const fs::path errors = folder.path() / "errors";
  Command watched(joined({"/bin/sh", "-c", "exec \"$@\" 2>" + errors.string(), "sh"},
                         with(match_command(folder.path() / "m"),
                              {"--watch", "--host-name", "x-8080.app.github.dev,example.org",
                               "--linger", "0", "--speed", "10"})));
  wait_for_file(folder.path() / "m/match.rcg");
  const std::string url = url_in(read_file(errors));
  ASSERT_NE(url, "");
  const auto ask_as = [&url](const std::string& host) {
    return exchange(port_of(url), "GET " + path_of(url) + " HTTP/1.1\r\nHost: " + host +
                                      "\r\nConnection: close\r\n\r\n");
  };

  EXPECT_EQ(ask_as("X-8080.app.github.dev").status, 200);
  EXPECT_EQ(ask_as("example.org:443").status, 200);
  const HttpResponse refused = ask_as("y-8080.app.github.dev");
  EXPECT_EQ(refused.status, 403);
  EXPECT_THAT(refused.body, HasSubstr("--host-name NAME"));
  watched.send_signal(SIGINT);
  (void)watched.finish();
}

TEST(LiveMatch, StaysAsLongAsItIsTold) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "game.rcg";
  fs::copy_file(fixture("gamelog/rcg-v6-excerpt.rcg.gz"), log);
  Command watch({cls_binary(), "watch", log, "--live", "--no-open", "--linger", "60"});
  ASSERT_TRUE(watch.wait_for_output("/\n"));
  EXPECT_EQ(get(url_in(watch.out())).status, 200);
  watch.send_signal(SIGINT);
  EXPECT_EQ(watch.finish().exit_code, 0);
}

TEST(LiveMatch, NeedsALogAndAFreePort) {
  EXPECT_THAT(run({cls_binary(), "match", "mock", "mock", "--watch", "--set",
                   "server::game_logging=false"}),
              Exits(2, HasSubstr("server::game_logging")));
  EXPECT_THAT(run({cls_binary(), "watch", "none.rcg", "--live"}), Exits(66));
  const auto host = run({cls_binary(), "watch", fixture("gamelog/rcg-v6-excerpt.rcg.gz"), "--live",
                         "--listen", "example.org", "--no-open"});
  EXPECT_EQ(host.exit_code, 75);
  EXPECT_THAT(host.err, HasSubstr("not an IP address of this host"));
}

// Free a moment ago.
int free_port() {
  const auto address = cls::base::parse_ip_address("127.0.0.1", 0).value();
  return cls::base::UdpSocket::bind(address).value().local_port();
}

TEST(LiveMatch, IsWatchedOnItsServerAsAMonitor) {
  const TemporaryFolder folder;
  const std::string port = std::to_string(free_port());
  const fs::path where = folder.path() / "match";
  // Without a terminal, the view is a line per second: the match must last some seconds longer than
  // the start of a program on a busy host.
  Command match(with(match_command(where), {"--speed", "2", "--monitor-port", port}));
  wait_for_file(where / "match.rcg");
  Command watch({cls_binary(), "watch", "127.0.0.1:" + port, "--view", "terminal"});
  EXPECT_TRUE(watch.wait_for_output("play_on, mock_l")) << watch.out();
  match.send_signal(SIGINT);
  EXPECT_EQ(match.finish().exit_code, 128 + SIGINT);
  watch.send_signal(SIGINT);
  EXPECT_EQ(watch.finish().exit_code, 0);
}

TEST(LiveMatch, SaysThatNoServerAnswers) {
  EXPECT_THAT(run({cls_binary(), "watch", "127.0.0.1:9"}),
              Exits(69, HasSubstr("127.0.0.1:9: no soccer server answers")));
  EXPECT_THAT(run({cls_binary(), "watch", "127.0.0.1:70000"}), Exits(69, HasSubstr("1 to 65535")));
}

TEST(TournamentView, ListsTheMatchesAndHasAPageOfEach) {
  const TemporaryFolder folder;
  const fs::path cup = folder.path() / "cup";
  const auto played = run({cls_binary(), "tournament", "run", cup, "--team", "A=mock", "--team",
                           "B=mock:hold", "--rounds", "1", "--half-time", "2", "--no-preflight"});
  ASSERT_EQ(played.exit_code, 0) << played.err;

  // It is over: without a terminal only --linger makes it stay.
  const auto ended = run({cls_binary(), "watch", cup, "--no-open"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_EQ(ended.out, "") << "an address that is dead";
  EXPECT_THAT(ended.err, testing::HasSubstr("no match is played now; --linger SECONDS serves"));

  Command watch({cls_binary(), "watch", cup, "--no-open", "--linger", "60"});
  ASSERT_TRUE(watch.wait_for_output("/\n"));
  const std::string url = url_in(watch.out());
  const std::string list = get(url).body;
  for (const char* part : {">A<", ">B<", "href=\"match/1/\"", "href=\"match/2/\"", " : "}) {
    EXPECT_THAT(list, HasSubstr(part)) << part;
  }

  EXPECT_THAT(get(url + "match/1/").body, HasSubstr("id=\"match\""));
  for (const char* path :
       {"match/3/", "match/1", "match/1/../2/", "match/1/live", "match/x/", "x"}) {
    EXPECT_EQ(get(url + path).status, 404) << path;
  }
  watch.send_signal(SIGTERM);
  EXPECT_EQ(watch.finish().exit_code, 0);
}

TEST(TerminalView, PlaysALogAndRestoresTheTerminal) {
  const std::string log = fixture("gamelog/match-start.rcg.gz");
  PseudoTerminal terminal({cls_binary(), "watch", log, "--view", "terminal"}, {"TERM=xterm"}, ".");
  EXPECT_TRUE(terminal.wait_for("\x1b[?1049h"));
  EXPECT_TRUE(terminal.wait_for("q quit"));
  terminal.type(" ");
  // "play" becomes "pause"; only what changed is written.
  EXPECT_TRUE(terminal.wait_for("ause"));
  terminal.type("q");
  EXPECT_TRUE(terminal.wait_for("\x1b[?25h\x1b[?1049l"));
}

TEST(TerminalView, RestoresTheTerminalAfterCtrlC) {
  const std::string log = fixture("gamelog/match-start.rcg.gz");
  PseudoTerminal terminal({cls_binary(), "watch", log, "--view", "terminal"},
                          {"TERM=xterm", "NO_COLOR=1"}, ".");
  EXPECT_TRUE(terminal.wait_for("q quit"));
  EXPECT_THAT(terminal.shown(), Not(HasSubstr("38;5")));
  terminal.type("\x03");
  EXPECT_TRUE(terminal.wait_for("\x1b[?1049l"));
}

TEST(TerminalView, RecordsALogWithoutATerminal) {
  const TemporaryFolder folder;
  const std::string log = fixture("gamelog/match-start.rcg.gz");
  EXPECT_THAT(run({cls_binary(), "watch", log, "--view", "terminal"}),
              Exits(2, HasSubstr("--cast FILE")));
  const fs::path cast = folder.path() / "a.cast";
  EXPECT_THAT(run({cls_binary(), "watch", log, "--cast", cast}), Exits(0));
  const std::string text = read_file(cast);
  EXPECT_EQ(text.find("{\"version\":2,\"width\":80,\"height\":24"), 0U);
  EXPECT_GT(std::ranges::count(text, '\n'), 20);
}

}  // namespace
}  // namespace cls::tests
