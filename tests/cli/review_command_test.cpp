// `cls review`: what cost a team goals, and decisions played again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;

// The start of a match between helios-base teams with the first goal; it has no end.
constexpr int kIncomplete = 65;

class ReviewCommand : public testing::Test {
 protected:
  ReviewCommand() {
    for (const char* name : {"match-start.rcg.gz", "match-start.rcl.gz"}) {
      std::filesystem::copy_file(fixture(std::string("gamelog/") + name), folder_.path() / name);
    }
  }

  CommandResult review(const std::vector<std::string>& words) const {
    Command command(joined({cls_binary(), "review"}, words), {}, folder_.path());
    return command.finish();
  }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }

  TemporaryFolder folder_;
};

TEST_F(ReviewCommand, CountsGoalsAndChancesOfATeam) {
  const CommandResult loser = review({"match-start.rcg.gz", "--team", "HELIOS_R"});
  EXPECT_EQ(loser.exit_code, kIncomplete) << loser.err;
  EXPECT_THAT(loser.out, HasSubstr("HELIOS_R: 1 match, 0.00 : 1.00 goals a match\n"));
  EXPECT_THAT(loser.out, HasSubstr("\ngoals against, by how the ball was lost\n"));
  EXPECT_THAT(loser.out, HasSubstr("match-start.rcg.gz 169\n"));
  EXPECT_THAT(loser.out,
              HasSubstr("\nlost from a decision with the ball to the next one (goals a match)\n"));
  EXPECT_THAT(loser.out, Not(HasSubstr("decisions that cost most")));

  const CommandResult winner = review({"match-start.rcg.gz"});
  EXPECT_THAT(winner.out, HasSubstr("HELIOS_L: 1 match, 1.00 : 0.00 goals a match\n"));
  EXPECT_THAT(winner.out, Not(HasSubstr("goals against,")));
  EXPECT_EQ(winner.out, review({"match-start.rcg.gz", "--side", "left"}).out);
}

// A folder of matches has those of scenarios, too.
TEST_F(ReviewCommand, TakesTheTeamThatPlaysLongest) {
  const auto play = [&](const std::string& name, const std::string& cycles,
                        const std::string& dir) {
    Command match({cls_binary(), "match", "mock", "mock:hold", "--cycles", cycles, "--seed", "1",
                   "--left-name", name, "--right-name", "other" + name, "--dir", dir},
                  {}, folder_.path());
    ASSERT_EQ(match.finish().exit_code, 0);
  };
  play("SHORT", "20", "1");
  play("SHORT", "20", "2");
  play("LONG", "200", "3");
  EXPECT_THAT(review({"1", "2", "3"}).out, HasSubstr("LONG: 1 match, "));
}

TEST_F(ReviewCommand, PlaysDecisionsAgain) {
  const std::vector<std::string> words = {
      "match-start.rcg.gz", "--replay-decisions", "2", "--seeds", "4", "--cycles", "10", "--json"};
  const CommandResult first = review(joined(words, {"--jobs", "1"}));
  EXPECT_EQ(first.exit_code, kIncomplete) << first.err;
  EXPECT_EQ(first.out, review(joined(words, {"--jobs", "2"})).out);

  const json document = json::parse(first.out);
  EXPECT_EQ(document["schema"], "cls.review/1");
  std::size_t decisions = 0;
  for (const json& one : document["losses"]) decisions += one["decisions"].get<std::size_t>();
  EXPECT_GT(decisions, 0U);
  EXPECT_EQ(document["matches"][0]["decisions"], decisions);
  EXPECT_EQ(document["seeds"], 4);
  EXPECT_EQ(document["interrupted"], false);
  ASSERT_EQ(document["decisions"].size() + document["skipped"].size(), 2U);
  ASSERT_GT(document["decisions"].size(), 0U);
  for (const json& decision : document["decisions"]) {
    EXPECT_EQ(decision["worths"].size(), 4U);
    ASSERT_GT(decision["alternatives"].size(), 1U);
    for (const json& alternative : decision["alternatives"]) {
      EXPECT_EQ(alternative["worths"].size(), 4U);
    }
  }

  const CommandResult text = review({"match-start.rcg.gz", "--replay-decisions", "1", "--seeds",
                                     "4", "--cycles", "10", "--continue", "mock"});
  EXPECT_THAT(text.out, HasSubstr("decisions that cost most: 4 playouts of 10 cycles after each "
                                  "choice, played by the mock's simple team\n"));
}

// Two decisions, of which an earlier run has played and saved one.
TEST_F(ReviewCommand, ContinuesWhatItHasSaved) {
  const auto replay = [&](const std::string& decisions, const std::vector<std::string>& more) {
    return review(joined({"match-start.rcg.gz", "--replay-decisions", decisions, "--seeds", "4",
                          "--cycles", "10", "--json"},
                         more));
  };
  const CommandResult one = replay("1", {"--save", "kept.json"});
  EXPECT_EQ(one.exit_code, kIncomplete) << one.err;
  const auto saved = [&] { return json::parse(read_file(folder_.path() / "kept.json")); };
  EXPECT_EQ(saved(), json::parse(one.out));

  // What was saved is taken as it is, and not played again.
  const json before = saved();
  const std::string first = before["decisions"][0]["worths"][0].dump();
  std::string changed = before.dump();
  const std::size_t worths = changed.find(first, changed.find("\"worths\""));
  write("kept.json", changed.replace(worths, first.size(), "0.125"));
  const json two = json::parse(replay("2", {"--save", "kept.json"}).out);
  ASSERT_EQ(two["decisions"].size(), 2U);
  int taken = 0;
  for (const json& decision : two["decisions"]) taken += decision["worths"].at(0) == json(0.125);
  EXPECT_EQ(taken, 1);
  EXPECT_EQ(saved(), two);

  const json fresh = json::parse(replay("2", {}).out);
  ASSERT_EQ(fresh["decisions"].size(), 2U);
  for (const json& decision : fresh["decisions"]) {
    if (decision["cycle"] == before["decisions"][0]["cycle"]) continue;
    EXPECT_THAT(std::vector<json>({two["decisions"].at(0), two["decisions"].at(1)}),
                testing::Contains(decision));
  }
}

// In the page of its match, and of no other.
TEST_F(ReviewCommand, IsShownInThePageOfTheMatch) {
  const CommandResult saved = review({"match-start.rcg.gz", "--replay-decisions", "8", "--seeds",
                                      "4", "--cycles", "10", "--save", "kept.json"});
  ASSERT_EQ(saved.exit_code, kIncomplete) << saved.err;
  const auto watch = [&](const std::string& log, const std::string& file) {
    Command command({cls_binary(), "watch", log, "--review", file, "--out", "page.html"}, {},
                    folder_.path());
    return command.finish();
  };
  EXPECT_EQ(watch("./match-start.rcg.gz", "kept.json").exit_code, kIncomplete);
  EXPECT_THAT(read_file(folder_.path() / "page.html"), HasSubstr("\"review\":[{\"cycle\":"));

  std::filesystem::copy_file(folder_.path() / "match-start.rcg.gz",
                             folder_.path() / "other.rcg.gz");
  EXPECT_THAT(watch("other.rcg.gz", "kept.json"),
              Exits(65, HasSubstr("--review kept.json: has no decision of other.rcg.gz")));
  EXPECT_THAT(watch("other.rcg.gz", "none.json"),
              Exits(65, HasSubstr("--review none.json: no such file")));
}

// Scenarios that `cls test` plays.
TEST_F(ReviewCommand, WritesMomentsAsScenarios) {
  const std::vector<std::string> words = {
      "match-start.rcg.gz", "--replay-decisions", "8", "--seeds", "4", "--cycles", "10",
      "--scenarios",        "tests/costly"};
  const CommandResult written = review(joined(words, {"--json"}));
  ASSERT_EQ(written.exit_code, kIncomplete) << written.err;

  std::vector<std::string> files;
  const json document = json::parse(written.out);
  for (const json& decision : document["decisions"]) {
    if (decision["better"].is_null()) continue;
    files.push_back("match-start.rcg.gz-" + decision["cycle"].dump() + "-player-" +
                    decision["unum"].dump() + ".json");
    const json scenario = json::parse(read_file(folder_.path() / "tests/costly" / files.back()));
    EXPECT_EQ(scenario["left"]["players"].size(), 11U);
    EXPECT_EQ(scenario["cycle"], decision["cycle"]);
    EXPECT_THAT(scenario["about"].get<std::string>(),
                HasSubstr(decision["decision"].get<std::string>()));
  }
  ASSERT_FALSE(files.empty());

  Command test({cls_binary(), "test", "tests/costly", "--json"}, {}, folder_.path());
  const CommandResult tested = test.finish();
  EXPECT_TRUE(tested.exit_code == 0 || tested.exit_code == 1) << tested.err;
  const json report = json::parse(tested.out);
  EXPECT_EQ(report["scenarios"].size(), files.size());

  // In a project that names the team, it is the team under test.
  EXPECT_EQ(
      json::parse(read_file(folder_.path() / "tests/costly" / files.front()))["left"]["playmaker"],
      "mock:planner");
  write("cls.toml", "[teams.HELIOS_L]\nendpoint = \"mock\"\n");
  ASSERT_EQ(
      review(joined(std::vector<std::string>(words.begin(), words.end() - 1), {"own"})).exit_code,
      kIncomplete);
  const json own = json::parse(read_file(folder_.path() / "own" / files.front()));
  EXPECT_EQ(own["left"]["playmaker"], "HELIOS_L");
  EXPECT_EQ(own["right"]["playmaker"], "mock:planner");
  std::filesystem::remove(folder_.path() / "cls.toml");

  // The same again changes nothing; an edited file stays.
  EXPECT_EQ(review(words).exit_code, kIncomplete);
  write("tests/costly/" + files.front(), "{}");
  EXPECT_THAT(review(words), Exits(73, HasSubstr(files.front() + ": is there and differs; ")));
  EXPECT_EQ(read_file(folder_.path() / "tests/costly" / files.front()), "{}");
}

TEST_F(ReviewCommand, KeepsFilesThatItCannotContinue) {
  const auto replay = [&](const std::vector<std::string>& more) {
    return review(joined(
        {"match-start.rcg.gz", "--replay-decisions", "1", "--cycles", "10", "--save", "kept.json"},
        more));
  };
  ASSERT_EQ(replay({"--seeds", "4"}).exit_code, kIncomplete);
  const std::string kept = read_file(folder_.path() / "kept.json");

  EXPECT_THAT(replay({"--seeds", "6"}),
              Exits(2, HasSubstr("--save kept.json: --seeds: 4 there, 6 here; remove it, or name "
                                 "another file\n")));
  EXPECT_THAT(
      replay({"--seeds", "4", "--team", "HELIOS_R"}),
      Exits(2, HasSubstr("--save kept.json: the team: \"HELIOS_L\" there, \"HELIOS_R\" here")));
  EXPECT_EQ(read_file(folder_.path() / "kept.json"), kept);

  for (const char* other : {"", "[]", "{\"schema\": \"cls.stats/1\"}", "{\"schema\": 1}"}) {
    write("kept.json", other);
    EXPECT_THAT(replay({"--seeds", "4"}), Exits(2, HasSubstr("--save kept.json: is "))) << other;
    EXPECT_EQ(read_file(folder_.path() / "kept.json"), other);
  }

  EXPECT_THAT(review({"match-start.rcg.gz", "--save", "new.json"}),
              Exits(2, HasSubstr("--save: needs --replay-decisions\n")));
  EXPECT_THAT(review({"match-start.rcg.gz", "--scenarios", "new"}),
              Exits(2, HasSubstr("--scenarios: needs --replay-decisions\n")));
  EXPECT_THAT(review({"match-start.rcg.gz", "--replay-decisions", "1", "--seeds", "4", "--cycles",
                      "10", "--save", "no/folder.json"}),
              Exits(73, HasSubstr("no/folder.json")));
}

TEST_F(ReviewCommand, NamesWhatCannotBePlayedAgain) {
  std::filesystem::remove(folder_.path() / "match-start.rcl.gz");
  const CommandResult result = review({"match-start.rcg.gz", "--replay-decisions", "1"});
  EXPECT_EQ(result.exit_code, kIncomplete);
  EXPECT_THAT(result.out, HasSubstr("the text log (rcl) is missing\n"));
}

TEST_F(ReviewCommand, ComparesWithAReference) {
  const auto play = [&](const std::string& left, const std::string& seed, const std::string& dir) {
    Command match({cls_binary(), "match", left, "mock", "--cycles", "300", "--seed", seed, "--dir",
                   dir, "--right-name", "OPP"},
                  {}, folder_.path());
    ASSERT_EQ(match.finish().exit_code, 0);
  };
  for (const char* seed : {"1", "2"}) {
    play("mock:hold", seed, std::string("own/") + seed);
    play("mock:planner", seed, std::string("other/") + seed);
  }

  const CommandResult text = review({"own", "--side", "left", "--reference", "other"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr(" (2 matches)\n"));
  EXPECT_THAT(review({"own", "--side", "left", "--reference", "own"}).out,
              HasSubstr("  no statistic differs beyond doubt in these matches; nearest to it: "));

  const json document =
      json::parse(review({"own", "--side", "left", "--reference", "other", "--json"}).out);
  const json& reference = document["reference"];
  EXPECT_EQ(reference["matches"], 2);
  EXPECT_NE(reference["team"], "OPP");
  ASSERT_GT(reference["differences"].size(), 3U);
  for (const json& one : reference["differences"]) {
    EXPECT_NEAR(one["team"].get<double>() - one["reference"].get<double>(),
                one["difference"]["value"].get<double>(), 1e-9);
    EXPECT_LE(one["difference"]["low"], one["difference"]["value"]);
  }

  EXPECT_THAT(review({"own/1", "--reference", "other"}),
              Exits(2, HasSubstr("--reference: needs two matches of each team at least, has 1 and "
                                 "2\n")));
  EXPECT_THAT(review({"own", "--reference", "nowhere"}), Exits(66, HasSubstr("nowhere")));
}

TEST_F(ReviewCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(review({"match-start.rcg.gz", "--side", "up"}),
              Exits(2, HasSubstr("--side 'up': must be left or right\n")));
  EXPECT_THAT(review({"match-start.rcg.gz", "--continue", "hold"}),
              Exits(2, HasSubstr("--continue 'hold': must be planner or mock\n")));
  EXPECT_THAT(review({"match-start.rcg.gz", "--seeds", "3"}), Exits(2, HasSubstr("--seeds")));
  EXPECT_THAT(review({"match-start.rcg.gz", "--team", "HELIOS"}),
              Exits(66, HasSubstr("--team 'HELIOS': plays in none of these matches; did you mean "
                                  "'HELIOS_L'?\n")));
  EXPECT_THAT(review({"nothing.rcg"}), Exits(66, HasSubstr("nothing.rcg")));
}

}  // namespace
}  // namespace cls::tests
