// `planner:FILE=SIDE`: matches with other parameters of the planner.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class PlannerSide : public testing::Test, public cls::tests::ClsFolder {
 protected:
  PlannerSide() : ClsFolder(std::chrono::seconds(180)) {}

  CommandResult match(const std::string& left, const std::string& folder) const {
    return run({"match", left, "mock:planner", "--left-name", "left", "--right-name", "right",
                "--seed", "7", "--cycles", "60", "--quiet", "--force", "--dir", folder});
  }

  /// The game log of a match of this side against mock:planner.
  std::string game_log(const std::string& left) const {
    EXPECT_THAT(match(left, "match"), Exits(0));
    return read_file(folder_.path() / "match/match.rcg");
  }
};

std::vector<std::string> fields_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> fields;
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

// The planner is at work in the first seconds: other passes, another match.
constexpr const char* kOther = "pass_margin = 1.5\nx_weight = 0.2\nshift_normal = -8\n";

TEST_F(PlannerSide, PlaysTheSameMatchWithDefaults) {
  ASSERT_EQ(run({"init", "--planner"}).exit_code, 0);
  write("empty.toml", "");
  const std::string plain = game_log("mock:planner");
  EXPECT_TRUE(game_log("planner:planner.toml=mock:planner") == plain);
  EXPECT_TRUE(game_log("planner:empty.toml=mock:planner") == plain);
}

TEST_F(PlannerSide, PlaysAnotherMatchWithOtherValues) {
  write("other.toml", kOther);
  const std::string plain = game_log("mock:planner");
  const std::string other = game_log("planner:other.toml=mock:planner");
  EXPECT_FALSE(other == plain);
  EXPECT_TRUE(game_log("planner:other.toml=mock:planner") == other) << "reproducible";
}

// The coach gives the types that the usual order gives to 11 and 2 to the side backs.
TEST_F(PlannerSide, TellsTheCoachWhoGetsFastTypes) {
  write("backs.toml", "fast_backs = 1\n");
  const auto types = [&](const std::string& left) {
    game_log(left);
    const CommandResult table = run({"convert", "match/match.rcg", "-", "--to", "tracking"});
    std::istringstream lines(table.out);
    std::string head;
    std::string last;
    std::getline(lines, head);
    for (std::string line; std::getline(lines, line);) last = line;
    const auto names = fields_of(head);
    const auto values = fields_of(last);
    std::map<std::string, std::string> out;
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
      out[names[i]] = values[i];
    }
    return out;
  };

  auto usual = types("mock:planner");
  auto backs = types("planner:backs.toml=mock:planner");
  ASSERT_NE(usual["l11_t"], "");
  EXPECT_EQ(backs["l4_t"], usual["l11_t"]);
  EXPECT_EQ(backs["l5_t"], usual["l2_t"]);
  EXPECT_NE(usual["l4_t"], usual["l11_t"]);
}

// The parameters belong to the agents, wherever their Playmaker runs.
TEST_F(PlannerSide, PlaysTheSameMatchWithPlaymakerElsewhere) {
  write("other.toml", kOther);
  const std::string here = game_log("planner:other.toml=mock:planner");
  EXPECT_TRUE(game_log("planner:other.toml=run:exec " + cls_binary().string() +
                       " mock planner --port {port}") == here);
  EXPECT_TRUE(game_log("planner:other.toml=mix:1-5=mock:planner;others=mock:planner") == here);
}

TEST_F(PlannerSide, ReportsErrorsBeforeTheMatch) {
  EXPECT_THAT(match("planner:no.toml=mock:planner", "match"),
              Exits(66, "cls: no.toml: no such file; `cls init --planner` writes one\n"));
  write("typo.toml", "# mine\npas_margin = 1\n");
  const CommandResult typo = match("planner:typo.toml=mock:planner", "match");
  EXPECT_EQ(typo.exit_code, 65);
  EXPECT_EQ(typo.err,
            "cls: typo.toml:2: unknown parameter 'pas_margin'; did you mean 'pass_margin'?\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "match"));
}

TEST_F(PlannerSide, IsRefusedWhereAMatchIsRepeated) {
  write("other.toml", kOther);
  EXPECT_THAT(run({"match", "planner:other.toml=mock", "mock", "--cycles", "20", "--save-at", "10",
                   "x.saved", "--dir", "match"}),
              Exits(2, HasSubstr("the built-in formations and planner")));
}

TEST_F(PlannerSide, InitWritesAFileOnce) {
  EXPECT_EQ(run({"init", "--planner", "a"}).out, "a/planner.toml\n");
  EXPECT_THAT(run({"init", "--planner", "a"}),
              Exits(73, "cls: a/planner.toml: exists; --force renames it to planner.toml.old\n"));
  EXPECT_EQ(run({"init", "--planner", "a", "--force"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "a/planner.toml.old"));
}

// The search of docs/tuning.md, with few and short matches.
TEST_F(PlannerSide, IsTuned) {
  std::filesystem::create_directory(folder_.path() / "search");
  write("search/tune.toml", R"(
[tune]
team = "planner:{file}=mock:planner"
file = "planner.toml"
opponents = ["mock:hold"]
generations = 1
population = 4
pairs = 1
verdict_pairs = 0

[parameters.pass_margin]
min = 0
max = 1.5
start = 0.35

[parameters.hold_cycles]
min = 0
max = 20
start = 5
integer = true
)");
  ASSERT_THAT(run({"tune", "run", "search", "--cycles", "10", "--quiet"}), Exits(0));
  EXPECT_THAT(match("planner:search/best.toml=mock:planner", "match"), Exits(0));
}

}  // namespace
}  // namespace cls::tests
