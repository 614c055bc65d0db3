// `--on-event` of `cls match`, `on_event` of tournaments, and the examples for both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

class EventHook : public testing::Test, protected ClsFolder {
 protected:
  EventHook() : ClsFolder(std::chrono::seconds(120)) {}

  // A short match with goals in both halves.
  CommandResult play(const std::string& command, std::vector<std::string> more = {}) const {
    return run(joined(
        {"match", "mock:planner", "mock:hold", "--left-name", "RED", "--right-name", "BLUE",
         "--seed", "1", "--dir", "game", "--set", "server::half_time=60", "--on-event", command},
        more));
  }

  std::vector<json> lines_of(const std::string& file) const {
    std::vector<json> lines;
    std::istringstream text(read_file(path(file)));
    for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
    return lines;
  }

  static std::string example(const std::string& name) {
    return (source_folder() / "examples/hooks" / name).string();
  }

  static std::vector<std::string> names(const std::vector<json>& events) {
    std::vector<std::string> all;
    for (const json& event : events) all.push_back(event["event"].get<std::string>());
    return all;
  }
};

TEST_F(EventHook, ReportsStartGoalsHalfTimeAndEndInOrder) {
  ASSERT_THAT(play("cat >>events.jsonl"), Exits(0));
  const std::vector<json> events = lines_of("events.jsonl");
  ASSERT_GE(events.size(), 4u);
  EXPECT_EQ(events.front()["event"], "start");
  EXPECT_EQ(events.front()["score"], json({0, 0}));

  const json& last = events.back();
  EXPECT_EQ(last["event"], "end");
  EXPECT_GE(last["cycle"], 1200);

  const std::vector<std::string> all = names(events);
  EXPECT_EQ(std::ranges::count(all, "half-time"), 1);

  const int goals = static_cast<int>(std::ranges::count(all, "goal"));
  EXPECT_GT(goals, 0);
  EXPECT_EQ(goals, last["score"][0].get<int>() + last["score"][1].get<int>());
  int cycle = 0;
  for (const json& event : events) {
    EXPECT_GE(event["cycle"], cycle) << "in the order of the match";
    cycle = event["cycle"].get<int>();
    if (event["event"] == "half-time") {
      EXPECT_EQ(cycle, 600);
    }
  }
}

TEST_F(EventHook, PassesTheEventAsVariables) {
  const CommandResult played = play(
      "cat >/dev/null; echo \"$CLS_EVENT|$CLS_LEFT|$CLS_RIGHT|$CLS_LEFT_SCORE|$CLS_CYCLE|"
      "$CLS_TEXT\" >>lines.txt");
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::string text = read_file(path("lines.txt"));
  EXPECT_EQ(text.substr(0, text.find('\n')), "start|RED|BLUE|0|0|RED 0:0 BLUE, kick-off");
  EXPECT_THAT(text, HasSubstr("goal|RED|BLUE|1|"));
  EXPECT_THAT(text, HasSubstr(", goal by RED (cycle "));
}

TEST_F(EventHook, ReportsTheFailureOfAMatch) {
  const CommandResult failed =
      run({"match", "run:exit 3 # {port}", "mock", "--on-event", "cat >>events.jsonl"});
  EXPECT_NE(failed.exit_code, 0);
  const std::vector<json> events = lines_of("events.jsonl");
  ASSERT_EQ(names(events), std::vector<std::string>{"failure"});
  EXPECT_THAT(events[0]["message"].get<std::string>(), HasSubstr("exit code 3"));
}

// All commands share one limit at the end of the match; later events are not lost in silence. On a
// busy machine the match lasts long enough for all of them.
TEST_F(EventHook, EndsCommandsThatHangAtOneLimit) {
  const auto begin = Clock::now();
  const CommandResult played =
      play("cat >>seen.jsonl; trap '' TERM; sleep 300", {"--hook-limit", "1"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, HasSubstr("on_event: ended, because it still ran"));

  const bool ran_for_all = names(lines_of("seen.jsonl")).back() == "end";
  const auto tells_of_the_rest = HasSubstr("on_event: not run for ");
  if (ran_for_all) {
    EXPECT_THAT(played.err, testing::Not(tells_of_the_rest));
  } else {
    EXPECT_THAT(played.err, tells_of_the_rest);
  }
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(200));
}

TEST_F(EventHook, TournamentAddsMatchAndStageAndReportsCrashes) {
  write("cup/cls.toml",
        "[tournament]\nname = \"Spring\"\ncycles = 20\non_crash = \"forfeit\"\nswap_sides = false\n"
        "on_event = \"cat >>seen.jsonl\"\n"
        "[teams.RED]\nendpoint = \"mock\"\n[teams.BLUE]\nendpoint = \"mock\"\n"
        "[teams.GONE]\nendpoint = \"run:exit 3 # {port}\"\n");

  ASSERT_THAT(run({"tournament", "run", "cup", "--no-preflight"}), Exits(0));

  std::vector<int> ended;
  for (const json& event : lines_of("cup/seen.jsonl")) {
    EXPECT_EQ(event["tournament"], "Spring");
    EXPECT_EQ(event["stage"], "round 1");
    if (event["event"] == "start") continue;
    ended.push_back(event["match"].get<int>());
    const bool crashes = event["left"] == "GONE" || event["right"] == "GONE";
    EXPECT_EQ(event["event"], crashes ? "failure" : "end") << event;
  }
  EXPECT_THAT(ended, testing::UnorderedElementsAre(1, 2, 3));
}

// Listens on loopback for one POST after the other and writes their bodies into a file.
constexpr const char* kListener = R"(
import http.server, sys
class Handler(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        open(sys.argv[1], "ab").write(body + b"\n")
        self.send_response(204)
        self.end_headers()
    def log_message(self, *words):
        pass
server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
print(server.server_address[1], flush=True)
server.serve_forever()
)";

TEST_F(EventHook, WebhookExamplePostsToAListener) {
  for (const char* program : {"python3", "curl"}) {
    if (tests::run({"sh", "-c", std::string("command -v ") + program}).exit_code != 0) {
      GTEST_SKIP() << "needs " << program;
    }
  }
  Command listener({"python3", "-c", kListener, path("posted.jsonl").string()});
  ASSERT_TRUE(listener.wait_for_output("\n"));
  const std::string url = "http://127.0.0.1:" + std::to_string(std::stoi(listener.out())) + "/";
  const CommandResult played =
      play("EVENTS='start end' WEBHOOK_URL=" + url + " " + example("webhook.sh"));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err.find("on_event"), std::string::npos) << played.err;

  const std::vector<json> posts = lines_of("posted.jsonl");
  ASSERT_EQ(posts.size(), 2u);
  EXPECT_EQ(posts[0]["text"], "RED 0:0 BLUE, kick-off");
  EXPECT_THAT(posts[1]["text"].get<std::string>(), HasSubstr("final score"));

  EXPECT_THAT(play("WEBHOOK_URL=http://127.0.0.1:9/ " + example("webhook.sh"),
                   {"--force", "--cycles", "5"}),
              Exits(0, HasSubstr("on_event: exit code ")));
}

TEST_F(EventHook, NoticeExampleWritesAFile) {
  ASSERT_THAT(play("env -u DISPLAY -u WAYLAND_DISPLAY " + example("notice.sh") + " notices.txt"),
              Exits(0));
  const std::string text = read_file(path("notices.txt"));
  EXPECT_THAT(text, HasSubstr(" start: RED 0:0 BLUE, kick-off\n"));
  EXPECT_THAT(text, HasSubstr(" half-time: RED "));
}

}  // namespace
}  // namespace cls::tests
