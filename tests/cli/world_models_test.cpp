// Recorded world models: what they contain, that they change nothing, and the page with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_reader.h"
#include "soccer/side.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/page/page_decisions.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using cls::viewer::DecisionSample;

CommandResult play(const fs::path& folder, std::vector<std::string> more) {
  return run(joined({cls_binary(), "match", "mock", "mock:hold", "--seed", "7", "--cycles", "120",
                     "--dir", folder.string(), "--set", "server::kick_off_wait=3"},
                    more));
}

cls::viewer::TeamDecisions decisions_in(const fs::path& file) {
  return cls::viewer::read_decisions(read_file(file)).value();
}

/// Two matches of one seed, one of them recorded.
class WorldModels : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(play(where("plain"), {}).exit_code, 0);
    ASSERT_EQ(play(where("recorded"), {"--record-world-models"}).exit_code, 0);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static fs::path where(const std::string& name) { return folder_->path() / name; }

 private:
  static TemporaryFolder* folder_;
};

TemporaryFolder* WorldModels::folder_ = nullptr;

TEST_F(WorldModels, ChangeNothingInTheMatch) {
  for (const char* file : {"match.rcg", "match.rcl", "events.jsonl"}) {
    EXPECT_TRUE(read_file(where("plain") / file) == read_file(where("recorded") / file)) << file;
  }
  EXPECT_FALSE(fs::exists(where("plain") / cls::viewer::kLeftWorldModelsFile));
}

/// The frame of a decision: the one that the player perceived.
std::map<std::pair<int, int>, std::size_t> frames_by_clock(
    const cls::gamelog::MatchRecord& record) {
  std::map<std::pair<int, int>, std::size_t> frames;
  for (std::size_t i = 0; i < record.frames(); ++i) {
    frames[{record.time[i], record.stopped[i]}] = i;
  }
  return frames;
}

double distance(cls::soccer::Vec2 a, double x, double y) { return std::hypot(a.x - x, a.y - y); }

TEST_F(WorldModels, AreBesideTheFullStateOfBothSides) {
  const auto record = cls::gamelog::read_rcg_file((where("recorded") / "match.rcg")).value();
  const auto frames = frames_by_clock(record);

  for (const char* file : {cls::viewer::kLeftWorldModelsFile, cls::viewer::kRightWorldModelsFile}) {
    const auto team = decisions_in(where("recorded") / file);
    int located = 0;
    int close = 0;
    int balls = 0;
    int ball_close = 0;
    for (int unum = 1; unum <= cls::soccer::kPlayersPerTeam; ++unum) {
      const auto& samples = team.players.at(static_cast<std::size_t>(unum - 1));
      EXPECT_GE(samples.size(), 120U) << file << ", player " << unum;
      for (const DecisionSample& sample : samples) {
        const auto frame = frames.find({sample.cycle, sample.stopped});
        if (frame == frames.end()) continue;
        const std::size_t entry =
            frame->second * 22 + static_cast<std::size_t>(cls::soccer::slot_of(team.side, unum));
        const auto position = record.players.position[entry];
        if (sample.self_age == 0) {
          ++located;
          close += distance(sample.self, position.x, position.y) < 0.5 ? 1 : 0;
        }
        if (sample.ball_age == 0) {
          ++balls;
          const auto ball = record.ball_position[frame->second];
          ball_close += distance(sample.ball, ball.x, ball.y) < 2.0 ? 1 : 0;
        }
      }
    }
    EXPECT_GT(located, 400) << file;
    EXPECT_GT(close, located * 95 / 100) << file << ": " << close << " of " << located;
    EXPECT_GT(balls, 300) << file;
    EXPECT_GT(ball_close, balls * 90 / 100) << file << ": " << ball_close << " of " << balls;
  }
}

/// The names of the commands of a datagram: "dash turn_neck done".
std::string command_names(std::string_view datagram) {
  std::string names;
  cls::gamelog::CommandCursor cursor(datagram);
  for (cls::gamelog::LoggedCommand command; cursor.next(command);) {
    const std::string_view kind = name(command.kind);
    if (kind != "done" && kind != "change_focus") names += std::string(kind) + " ";
  }
  return names;
}

TEST_F(WorldModels, HaveTheCommandsOfTheTextLog) {
  const auto text = cls::gamelog::read_rcl_file((where("recorded") / "match.rcl")).value();
  const auto team = decisions_in(where("recorded") / cls::viewer::kLeftWorldModelsFile);
  std::map<std::pair<int, int>, std::string> logged;
  for (const auto& line : text.lines) {
    if (line.source != cls::gamelog::RclSource::kPlayer || line.unum != 7) continue;
    if (text.teams.at(line.team) != team.team) continue;
    logged[{line.time, line.stopped}] = command_names(text.text.substr(line.offset, line.length));
  }
  const auto& samples = team.players[6];
  int found = 0;
  for (const DecisionSample& sample : samples) {
    const auto line = logged.find({sample.cycle, sample.stopped});
    if (line != logged.end() && line->second == command_names(sample.commands)) ++found;
  }
  EXPECT_GT(found, 110) << "of " << samples.size();
}

TEST_F(WorldModels, HaveTheActionsWithTheirOutcomes) {
  const auto team = decisions_in(where("recorded") / cls::viewer::kLeftWorldModelsFile);
  int executed = 0;
  int with_fields = 0;

  std::int64_t latency_us = 0;  // a single call of the mock can take less than one
  for (const auto& samples : team.players) {
    for (const DecisionSample& sample : samples) {
      EXPECT_EQ(sample.call, 0);
      EXPECT_GE(sample.latency_us, 0);
      latency_us += sample.latency_us;
      if (sample.reply.find("e ") != std::string::npos) ++executed;
      if (sample.reply.find('=') != std::string::npos) ++with_fields;
    }
  }

  EXPECT_GT(executed, 500);
  EXPECT_GT(latency_us, 0);
  EXPECT_GT(with_fields, 100);
}

TEST_F(WorldModels, AreTheSameInEachRunButForLatencies) {
  ASSERT_EQ(play(where("again"), {"--record-world-models"}).exit_code, 0);
  const auto a = decisions_in(where("recorded") / cls::viewer::kRightWorldModelsFile);
  const auto b = decisions_in(where("again") / cls::viewer::kRightWorldModelsFile);
  for (std::size_t i = 0; i < a.players.size(); ++i) {
    ASSERT_EQ(a.players[i].size(), b.players[i].size());
    for (std::size_t k = 0; k < a.players[i].size(); ++k) {
      EXPECT_EQ(a.players[i][k].ball.x, b.players[i][k].ball.x);
      EXPECT_EQ(a.players[i][k].reply, b.players[i][k].reply);
      EXPECT_EQ(a.players[i][k].commands, b.players[i][k].commands);
    }
  }
}

std::size_t page_size(const fs::path& match, const fs::path& page,
                      const std::vector<std::string>& more) {
  EXPECT_THAT(run(joined({cls_binary(), "watch", match.string(), "--out", page.string()}, more)),
              Exits(0));
  return read_file(page).size();
}

TEST_F(WorldModels, AreInThePageAsFarAsTheyAreAskedFor) {
  const std::size_t plain = page_size(where("plain"), where("plain.html"), {});
  const std::size_t all = page_size(where("recorded"), where("all.html"), {});
  const std::size_t some =
      page_size(where("recorded"), where("some.html"), {"--world-models", "l7,l8"});
  const std::size_t none =
      page_size(where("recorded"), where("none.html"), {"--world-models", "none"});
  const std::size_t part =
      page_size(where("recorded"), where("part.html"), {"--world-models", "l7,50-60,70"});
  EXPECT_GT(all, some);
  EXPECT_GT(some, part);
  EXPECT_GT(part, plain);
  EXPECT_GT(some, plain);
  EXPECT_EQ(none, plain);

  const std::string page = read_file(where("some.html"));
  EXPECT_THAT(page, HasSubstr("id=\"decisions-left\""));
  EXPECT_THAT(page, Not(HasSubstr("id=\"decisions-right\"")));
  EXPECT_THAT(read_file(where("plain.html")), Not(HasSubstr("decisions-left\"")));

  // The page is still the log.
  const auto log = run({cls_binary(), "convert", where("all.html"), where("log.rcg")});
  EXPECT_EQ(log.exit_code, 0) << log.err;
  EXPECT_TRUE(read_file(where("log.rcg")) == read_file(where("recorded") / "match.rcg"));
}

TEST_F(WorldModels, AreRefusedWhenTheyAreCorruptOrNamesAreWrong) {
  EXPECT_THAT(run({cls_binary(), "watch", where("recorded"), "--out", where("x.html"),
                   "--world-models", "l12"}),
              Exits(2, HasSubstr("--world-models 'l12': must be")));
  for (const char* which : {"9-3", "-5", "7-", "all,l7", "none,3"}) {
    EXPECT_THAT(run({cls_binary(), "watch", where("recorded"), "--out", where("x.html"),
                     std::string("--world-models=") + which}),
                Exits(2));
  }
  fs::copy(where("recorded"), where("cut"), fs::copy_options::recursive);
  fs::resize_file(where("cut") / cls::viewer::kLeftWorldModelsFile, 2000);
  EXPECT_THAT(run({cls_binary(), "watch", where("cut"), "--out", where("y.html")}),
              Exits(65, HasSubstr("left.world-models: ")));
}

TEST(Drawings, AreWithTheDecision) {
  const TemporaryFolder folder;
  const fs::path script = folder.path() / "draws.json";
  std::ofstream(script) << R"({"rules": [{"reply": [
    {"log": {"add_circle": {"level": "SHOOT", "center": {"x": 1.23456, "y": -2}, "radius": 3, "color": "red", "fill": true}}},
    {"body_go_to_point": {"target_point": {"x": 5, "y": 6}, "distance_threshold": 1, "max_dash_power": 50}},
    {"log": {"add_text": {"level": "TEAM", "message": "two\nlines 1.5"}}},
    {"debug_client": {"message": "shown"}}]}]})";

  const fs::path match = folder.path() / "match";
  ASSERT_THAT(run({cls_binary(), "match", "mock:" + script.string(), "mock:hold", "--seed", "7",
                   "--cycles", "5", "--record-world-models", "--dir", match}),
              Exits(0));

  const auto team = decisions_in(match / cls::viewer::kLeftWorldModelsFile);
  const DecisionSample& last = team.players[6].back();
  EXPECT_EQ(last.drawings, "1024 C 1.23 -2 3 red\n65536 M two lines 1.5\n0 M shown\n");
  EXPECT_THAT(last.reply, Not(HasSubstr("log")));
  EXPECT_THAT(last.reply, HasSubstr("body_go_to_point"));
}

TEST(MissedDecisions, AreInTheFolderAndInThePage) {
  const TemporaryFolder folder;
  const fs::path script = folder.path() / "errors.json";
  std::ofstream(script)
      << R"({"faults": {"error": 0.2, "status": "INTERNAL", "only": {"unum": 8}}})";
  const fs::path match = folder.path() / "match";
  ASSERT_THAT(run({cls_binary(), "match", "mock:" + script.string(), "mock:hold", "--seed", "7",
                   "--cycles", "60", "--dir", match}),
              Exits(0));

  const auto result = base::Json::parse(read_file(match / "result.json"));
  const int missed = result["left"]["players"][7]["missed"].get<int>();
  ASSERT_GT(missed, 3);
  const auto read = cls::viewer::read_missed_decisions(match);
  ASSERT_EQ(read.size(), static_cast<std::size_t>(missed));

  for (const auto& one : read) {
    EXPECT_EQ(one.player, "l8");
    EXPECT_EQ(one.reason, "error");
  }
  const fs::path page = folder.path() / "page.html";
  EXPECT_EQ(run({cls_binary(), "watch", match, "--out", page}).exit_code, 0);
  EXPECT_THAT(read_file(page), HasSubstr("\"missed\":[["));
}

TEST(PageDecisions, ReportFilesThatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_TRUE(cls::viewer::read_page_decisions(folder.path(), {})->empty()) << "none recorded";
  fs::create_directories(folder.path() / cls::viewer::kRightWorldModelsFile);
  const auto read = cls::viewer::read_page_decisions(folder.path(), {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("a folder, not a file"));
}

TEST(PageDecisions, BringTheSidesOfTheMatch) {
  const TemporaryFolder folder;
  const fs::path match = folder.path() / "match";
  ASSERT_THAT(run({cls_binary(), "match", "mock:planner", "mock:hold", "--seed", "7", "--cycles",
                   "5", "--record-world-models", "--dir", match}),
              Exits(0));
  const fs::path page = folder.path() / "page.html";
  EXPECT_EQ(run({cls_binary(), "watch", match, "--out", page}).exit_code, 0);
  EXPECT_THAT(read_file(page), HasSubstr(R"("sides":["mock:planner","mock:hold"])"));
}

TEST(MissedDecisions, SurviveLinesThatAreNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(cls::viewer::read_missed_decisions(folder.path()).empty());
  std::ofstream(folder.path() / "missed.jsonl")
      << "{\"t\":5,\"side\":\"left\",\"unum\":12,\"reason\":\"x\"}\nnonsense\n\n[1]\n"
      << "{\"t\":5,\"stopped\":2,\"side\":\"right\",\"unum\":11,\"reason\":\"deadline\"}";
  const auto read = cls::viewer::read_missed_decisions(folder.path());
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].player, "r11");
  EXPECT_EQ(read[0].stopped, 2);
}

}  // namespace
}  // namespace cls::tests
