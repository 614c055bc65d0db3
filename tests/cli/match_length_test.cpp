// How long matches are under unusual parameters, and that none lasts for ever.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
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
using Arguments = std::vector<std::string>;

class MatchLength : public testing::Test, public ClsFolder {
 protected:
  MatchLength() : ClsFolder(std::chrono::seconds(30)) {}

  // Halves of 20 cycles.
  CommandResult play(const Arguments& settings, Arguments more = {}) const {
    Arguments all = {"match", "mock:hold", "mock:hold", "--half-time", "2", "--json", "--quiet"};
    for (const std::string& setting : settings) {
      all.push_back("--set");
      all.push_back(setting);
    }
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(MatchLength, IsThatOfRcssserver) {
  const std::pair<Arguments, int> lengths[] = {
      {{"server::slow_down_factor=3"}, 40},
      {{"server::nr_extra_halfs=-1"}, 40},
      {{"server::nr_extra_halfs=2", "server::extra_half_time=-5"}, 40},
      {{"server::nr_normal_halfs=1"}, 20},
      {{"server::nr_extra_halfs=1", "server::extra_half_time=1", "server::slow_down_factor=2"}, 50},
  };
  for (const auto& [settings, cycles] : lengths) {
    const CommandResult result = play(settings);
    ASSERT_EQ(result.exit_code, 0) << settings.front() << result.err;
    EXPECT_EQ(json::parse(result.out)["cycles"], cycles) << settings.front();
  }
}

TEST_F(MatchLength, IsRequiredWhereNoRefereeEndsTheMatch) {
  const std::pair<const char*, const char*> endless[] = {
      {"server::coach=on", "server::coach=on: without a referee, give --cycles"},
      {"server::half_time=-1", "server::half_time: without a limit of halves, give --cycles"},
      {"server::simulator_step=1000000", "without a limit of halves, give --cycles"},
  };
  for (const auto& [setting, problem] : endless) {
    EXPECT_THAT(run({"match", "mock:hold", "mock:hold", "--set", setting}),
                Exits(2, HasSubstr(problem)));
  }
  EXPECT_EQ(play({"server::coach=on"}, {"--cycles", "5"}).exit_code, 0);
  EXPECT_EQ(play({"server::coach=on", "server::coach_w_referee=on"}).exit_code, 0);
  EXPECT_THAT(play({"server::nr_normal_halfs=0"}),
              Exits(2, HasSubstr("neither a half nor a shoot-out is played")));
}

TEST_F(MatchLength, EndsWithADecisiveLead) {
  const auto played = [this](const Arguments& more) {
    return run(joined({"match", "mock", "mock:hold", "--seed", "1", "--half-time", "60", "--json",
                       "--quiet", "--force", "--dir", "m"},
                      more));
  };
  const json whole = json::parse(played({}).out);
  ASSERT_GT(whole["goals"].size(), 2U);
  const CommandResult ended = played({"--adjudicate", "2"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;

  const json result = json::parse(ended.out);
  EXPECT_EQ(result["left"]["score"], 2);
  EXPECT_EQ(result["cycles"], whole["goals"][1]["cycle"]) << "the same match until then";

  for (const Arguments& other : {Arguments{"--mode", "synch"}, Arguments{"--mode", "realtime"}}) {
    EXPECT_THAT(played({"--adjudicate", "2", other[0], other[1]}),
                Exits(2, HasSubstr("--adjudicate needs the embedded server in lockstep")));
  }
}

TEST_F(MatchLength, IsRequiredInTournaments) {
  const auto plan = [&](const std::string& text) {
    write("cls.toml", "[tournament]\n" + text + "[teams.A]\nendpoint = \"mock\"\n" +
                          "[teams.B]\nendpoint = \"mock\"\n");
    return run({"tournament", "plan", "cup"});
  };
  EXPECT_THAT(plan("[server]\ncoach = true\n").err,
              HasSubstr("server::coach=on: without a referee, set cycles"));
  EXPECT_THAT(plan("half_time = 0\n").err, HasSubstr("without a limit of halves, set cycles"));
  EXPECT_EQ(plan("cycles = 5\n[server]\ncoach = true\n").exit_code, 0);
}

// One team may not have kicked yet.
TEST_F(MatchLength, CutsAShootOutWithOneResult) {
  const CommandResult result =
      run({"match", "mock", "mock", "--half-time", "2", "--seed", "3", "--cycles", "200", "--set",
           "server::nr_normal_halfs=1", "--set", "server::penalty_shoot_outs=on", "--dir", "m"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("(1 : 0 on penalties)"));
  const json document = json::parse(read_file(path("m/result.json")));
  EXPECT_EQ(document["left"]["penalty_score"], 1);
  EXPECT_EQ(document["right"]["penalty_score"], 0);
  EXPECT_THAT(run({"results", "m"}).out, HasSubstr("1:0"));
}

// The server makes steps, and no Playmaker is awaited.
TEST_F(MatchLength, IsLimitedByAStallOfTheGameClock) {
  const CommandResult result = play({"server::kick_off_wait=1000000000"}, {"--stall-after", "0.2"});
  ASSERT_FALSE(result.out.empty()) << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["end_reason"], "stalled");
  EXPECT_THAT(document["message"].get<std::string>(),
              HasSubstr("the game clock has stood still at cycle 0 in before_kick_off for"));
  EXPECT_TRUE(document["fault"].is_null());
}

}  // namespace
}  // namespace cls::tests
