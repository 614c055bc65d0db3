// `cls tournament watch`: where its page is, who may ask for it, and how far behind it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/http_client.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class TournamentWatch : public testing::Test {
 protected:
  // A match takes forty seconds, and is stopped with the test.
  void SetUp() override {
    std::ofstream(folder_.path() / "cls.toml") << R"([tournament]
format = "round-robin"
cycles = 400
mode = "realtime"
[teams.RED]
endpoint = "mock"
[teams.BLUE]
endpoint = "mock"
)";
  }

  Command command(const std::vector<std::string>& words) const {
    return Command(joined({cls_binary().string(), "tournament"}, words), {}, folder_.path());
  }

  void wait_for_store() const {
    for (int i = 0; i < 200 && !std::filesystem::exists(folder_.path() / "cup/tournament.db");
         ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }

  static std::string url_of(Command& watch) {
    if (!watch.wait_for_output("}\n")) return watch.finish().err;
    return base::Json::parse(watch.out())["url"].get<std::string>();
  }

  static int status(const std::string& url, const std::string& path, const std::string& host) {
    return exchange(port_of(url),
                    "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n")
        .status;
  }

  // What the page shows now; waits up to 20 s for `part`.
  static std::string shown(const std::string& url, const std::string& part) {
    std::string body;
    for (int i = 0; i < 200 && body.find(part) == std::string::npos; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      body = get(url + "now").body;
    }
    return body;
  }

  TemporaryFolder folder_;
};

// Programs of teams can reach the page, which knows more than they may.
TEST_F(TournamentWatch, IsBehindWhereTeamsAreProgramsAndWarns) {
  std::filesystem::create_directory(folder_.path() / "cup");
  std::ofstream(folder_.path() / "cup/plan.toml")
      << "[teams.RED]\nendpoint = \"mock\"\n"
         "[teams.OWN]\nendpoint = \"run:sleep 60 --port {port}\"\n";
  Command safe = command({"watch", "cup", "--port", "0", "--json"});
  EXPECT_THAT(url_of(safe), HasSubstr("http://"));
  safe.send_signal(SIGINT);
  EXPECT_EQ(safe.finish().err, "");

  Command open = command({"watch", "cup", "--port", "0", "--json", "--delay", "0"});
  EXPECT_THAT(url_of(open), HasSubstr("http://"));
  open.send_signal(SIGINT);
  EXPECT_THAT(open.finish().err,
              HasSubstr("can read where all players are, 0 s late; --delay 10 "));
}

TEST_F(TournamentWatch, IsAtItsPathForItsHostsAndBehindByItsDelay) {
  Command cup = command({"run", "cup", "--quiet"});
  wait_for_store();
  Command watch = command({"watch", "cup", "--port", "0", "--json", "--path", "cup", "--host-name",
                           "Cup.Example.org,other.example.org"});
  Command late = command({"watch", "cup", "--port", "0", "--json", "--delay", "3600"});
  const std::string url = url_of(watch);
  ASSERT_TRUE(url.ends_with("/cup/")) << url;
  const std::string late_url = url_of(late);

  EXPECT_EQ(status(url, "/cup/", "localhost"), 200);
  EXPECT_EQ(status(url, "/cup/now", "cup.example.org"), 200);
  EXPECT_EQ(status(url, "/cup/", "other.example.org:443"), 200);
  EXPECT_EQ(status(url, "/cup/", "evil.example.org"), 403);
  EXPECT_EQ(status(url, "/", "localhost"), 404);
  EXPECT_EQ(status(late_url, "/", "cup.example.org"), 403) << "named for the other page only";

  EXPECT_THAT(shown(url, " · cycle "), HasSubstr(" · cycle ")) << "the match is seen";
  const std::string behind = shown(late_url, "RED");
  EXPECT_THAT(behind, HasSubstr("RED"));
  EXPECT_THAT(behind, Not(HasSubstr(" · cycle "))) << "what happens is shown an hour later";
}

TEST_F(TournamentWatch, SaysWhatKeepsItFromReading) {
  EXPECT_THAT(command({"watch", "cup"}).finish(),
              Exits(66, HasSubstr("cup: no tournament; 'cls tournament run cup' begins one")));
  std::filesystem::create_directory(folder_.path() / "cup");
  std::ofstream(folder_.path() / "cup/plan.toml") << "nonsense";
  EXPECT_THAT(command({"watch", "cup"}).finish(), Exits(65, Not(HasSubstr("begins one"))));
}

TEST_F(TournamentWatch, RefusesValuesThatCannotWork) {
  const std::vector<std::vector<std::string>> wrong = {{"--listen", "localhost"},
                                                       {"--delay", "-1"},
                                                       {"--delay", "1e300"},
                                                       {"--path", "/c up/"},
                                                       {"--max-connections", "0"}};
  for (const auto& option : wrong) {
    Command watch = command({"watch", "cup", option[0], option[1]});
    EXPECT_THAT(watch.finish(), Exits(2, HasSubstr(option[0] + " '" + option[1] + "'")));
  }
}

}  // namespace
}  // namespace cls::tests
