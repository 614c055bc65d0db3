// `policy:FILE`: matches of a trained policy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PolicySide : public testing::Test, public cls::tests::ClsFolder {
 protected:
  PolicySide() : ClsFolder(std::chrono::seconds(180)) {}

  CommandResult match(const std::string& left, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"match",   left,           "mock:planner", "--left-name",
                                          "left",    "--right-name", "right",        "--seed",
                                          "7",       "--cycles",     "200",          "--quiet",
                                          "--force", "--dir",        "match"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  std::string game_log(const std::string& left, const std::vector<std::string>& more = {}) const {
    EXPECT_THAT(match(left, more), Exits(0));
    return read_file(folder_.path() / "match/match.rcg");
  }

  /// The options of each recorded decision of the left side.
  std::vector<base::Json> considered() const {
    const auto document =
        base::Json::parse(run({"explain", "decision", "match", "--json", "--side", "left"}).out);
    std::vector<base::Json> all;
    for (const base::Json& decision : document["decisions"]) all.push_back(decision["considered"]);
    return all;
  }

  const std::string file_ = "policy:" + fixture("policies/all_kinds.policy").string();
};

TEST_F(PolicySide, PlaysWhatItsFileSays) {
  const std::string log = game_log(file_);
  EXPECT_TRUE(game_log(file_, {"--rated"}) == log) << "reproducible, and rated";
  EXPECT_FALSE(game_log("policy:random") == log);
  EXPECT_FALSE(game_log("policy:planner") == log);
  EXPECT_TRUE(game_log("policy:planner") == game_log("policy:planner")) << "reproducible";
}

TEST_F(PolicySide, TheLearnedTeamNeedsNoFile) {
  const std::string log = game_log("mock:learned");
  EXPECT_TRUE(game_log("mock:learned") == log) << "reproducible";
  const std::string file = (source_folder() / "match/terms/learned.policy").string();
  EXPECT_TRUE(game_log("policy:" + file) == log);
  EXPECT_FALSE(game_log("policy:planner") == log);
}

TEST_F(PolicySide, ShowsWhatItConsidered) {
  const std::string plain = game_log("mock:learned");
  EXPECT_TRUE(game_log("mock:learned", {"--record-world-models"}) == plain);

  const CommandResult all = run({"explain", "decision", "match", "--json", "--side", "left"});
  ASSERT_THAT(all, Exits(0));
  const auto decisions = base::Json::parse(all.out)["decisions"];
  ASSERT_GT(decisions.size(), 3U);
  for (const base::Json& decision : decisions) {
    const base::Json& considered = decision["considered"];
    double sum = 0.0;
    int chosen = 0;
    for (const base::Json& option : considered) {
      sum += option["probability"].get<double>();
      chosen += option["chosen"].get<bool>() ? 1 : 0;
    }
    EXPECT_NEAR(sum, 1.0, 0.04) << "each is rounded to a thousandth";
    EXPECT_EQ(chosen, 1);
    EXPECT_TRUE(considered[0]["chosen"].get<bool>()) << "the most likely is played";
    EXPECT_EQ(decision["maker"], "policy");
  }

  const base::Json& first = decisions[0];
  const std::vector<std::string> one = {"explain",
                                        "decision",
                                        "match",
                                        "--side",
                                        "left",
                                        "--player",
                                        std::to_string(first["unum"].get<int>()),
                                        "--at",
                                        std::to_string(first["cycle"].get<int>())};
  EXPECT_THAT(run(one),
              Prints(0, AllOf(HasSubstr(", decided by policy"),
                              HasSubstr(first["considered"][0]["name"].get<std::string>()),
                              HasSubstr("probability"))));
  EXPECT_THAT(run({"explain", "decision", "match"}).out, HasSubstr("best of the others"));
}

TEST_F(PolicySide, BuiltInPoliciesShowTheirOptions) {
  game_log("policy:random", {"--record-world-models"});
  const auto random = considered();
  EXPECT_GT(random.size(), 3U);
  for (const base::Json& options : random) {
    const double share = 1.0 / static_cast<double>(options.size());
    for (const base::Json& option : options)
      EXPECT_NEAR(option["probability"].get<double>(), share, 0.0006);
  }

  game_log("policy:planner", {"--record-world-models"});
  for (const base::Json& options : considered()) {
    EXPECT_EQ(options[0]["probability"].get<double>(), 1.0);
    EXPECT_TRUE(options[0]["chosen"].get<bool>());
  }
}

TEST_F(PolicySide, SaysWhyThereIsNoDecision) {
  const auto explain = [this](std::vector<std::string> words) {
    return run(joined({"explain", "decision"}, words));
  };
  EXPECT_THAT(explain({}), Exits(2, HasSubstr("name the folder of one match")));
  EXPECT_THAT(explain({"absent"}), Exits(66, HasSubstr("absent: no such folder")));
  game_log("mock");
  EXPECT_THAT(explain({"match"}), Exits(66, HasSubstr("--record-world-models")));
  game_log("mock", {"--record-world-models"});
  EXPECT_THAT(explain({"match", "--side", "up"}), Exits(2, HasSubstr("must be left or right")));
  EXPECT_THAT(explain({"match", "--at", "99999"}),
              Exits(66, HasSubstr("no decision in cycle 99999 has something to choose from")));
  EXPECT_THAT(explain({"match", "--side", "left", "--player", "9", "--at", "100"}),
              Prints(0, HasSubstr("left 9, cycle 100, decided by ")));
  write("match/left.world-models", "garbage");
  EXPECT_THAT(explain({"match", "--side", "left"}), Exits(65, HasSubstr("left.world-models: ")));
}

TEST_F(PolicySide, IsNamedAfterItsFile) {
  const CommandResult result = run({"match", file_, "mock", "--cycles", "5", "--dir", "named"});
  EXPECT_THAT(result, Exits(0));
  EXPECT_THAT(read_file(folder_.path() / "named/result.json"), HasSubstr("\"all_kinds\""));
}

TEST_F(PolicySide, SaysWhatIsWrong) {
  write("other.policy", "PK");
  EXPECT_THAT(match("policy:other.policy").err,
              HasSubstr("other.policy: is not a file of cls.policy/2"));
  EXPECT_THAT(match("policy:no.policy").err, HasSubstr("no.policy: no such file"));
  EXPECT_THAT(match("policy:").err, HasSubstr("no file after the colon"));
  EXPECT_THAT(match("mix:1=policy:random;others=mock").err,
              HasSubstr("a policy plays for a whole team"));
  EXPECT_THAT(match("mock", {"--trainer", "policy:random"}).err,
              HasSubstr("a trainer has no policy"));
  EXPECT_THAT(run({"check", "playmaker", "policy:random"}).err,
              HasSubstr("a policy is not a Playmaker"));
}

}  // namespace
}  // namespace cls::tests
