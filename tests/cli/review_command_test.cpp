// `cls review`: what cost a team goals, and decisions played again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
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

  TemporaryFolder folder_;
};

TEST_F(ReviewCommand, CountsGoalsAndChancesOfATeam) {
  const CommandResult loser = review({"match-start.rcg.gz", "--team", "HELIOS_R"});
  EXPECT_EQ(loser.exit_code, kIncomplete) << loser.err;
  EXPECT_THAT(loser.out, HasSubstr("HELIOS_R: 1 match, 0.00 : 1.00 goals a match\n"));
  EXPECT_THAT(loser.out, HasSubstr("\ngoals against, by how the ball was lost\n"));
  EXPECT_THAT(loser.out, HasSubstr("match-start.rcg.gz 169\n"));
  EXPECT_THAT(loser.out, Not(HasSubstr("decisions that cost most")));

  const CommandResult winner = review({"match-start.rcg.gz"});
  EXPECT_THAT(winner.out, HasSubstr("HELIOS_L: 1 match, 1.00 : 0.00 goals a match\n"));
  EXPECT_THAT(winner.out, Not(HasSubstr("goals against,")));
  EXPECT_EQ(winner.out, review({"match-start.rcg.gz", "--side", "left"}).out);
}

TEST_F(ReviewCommand, PlaysDecisionsAgain) {
  const std::vector<std::string> words = {
      "match-start.rcg.gz", "--replay-decisions", "2", "--seeds", "4", "--cycles", "10", "--json"};
  const CommandResult first = review(joined(words, {"--jobs", "1"}));
  EXPECT_EQ(first.exit_code, kIncomplete) << first.err;
  EXPECT_EQ(first.out, review(joined(words, {"--jobs", "2"})).out);

  const json document = json::parse(first.out);
  EXPECT_EQ(document["schema"], "cls.review/1");
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

TEST_F(ReviewCommand, NamesWhatCannotBePlayedAgain) {
  std::filesystem::remove(folder_.path() / "match-start.rcl.gz");
  const CommandResult result = review({"match-start.rcg.gz", "--replay-decisions", "1"});
  EXPECT_EQ(result.exit_code, kIncomplete);
  EXPECT_THAT(result.out, HasSubstr("the text log (rcl) is missing\n"));
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
