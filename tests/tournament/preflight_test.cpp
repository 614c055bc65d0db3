// Checks and estimates before the first match.
#include "tournament/run/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/system/host.h"
#include "base/system/version.h"
#include "league/schedule/schedule.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/slots/concurrency.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;
using Kind = match::EndpointProblem::Kind;

TEST(Preflight, NamesTeamAndEndpoint) {
  tests::TemporaryFolder folder;
  TournamentConfig config = config_of(Format::kRoundRobin, 4);
  config.execution.folder = folder.path();
  EXPECT_TRUE(check_start(config, std::chrono::milliseconds(0)).empty());

  std::ofstream(folder.path() / "drill.json") << "{\"otherwise\": \"simple\"}";
  config.competition.teams[0].endpoint = "mock:drill.json";  // relative to the folder
  config.competition.teams[1].endpoint = "unix:none.sock";
  config.competition.teams[3].endpoint = "run:./nope {port}";
  const auto problems = check_start(config, std::chrono::milliseconds(0));

  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].kind, Kind::kUnreachable);
  EXPECT_EQ(problems[0].text.rfind("team B (unix:none.sock): nothing listens at ", 0), 0u)
      << problems[0].text;
  EXPECT_EQ(problems[1].kind, Kind::kMissing);
  EXPECT_EQ(problems[1].text.rfind("team D (run:./nope {port}): ", 0), 0u) << problems[1].text;

  config.execution.executor = ExecutorKind::kSlurm;
  EXPECT_TRUE(check_start(config, std::chrono::milliseconds(0)).empty())
      << "the endpoints must work on the nodes";

  config = config_of(Format::kRoundRobin, 2);
  config.conditions.options["server"] = "./no-server";
  ASSERT_EQ(check_start(config, std::chrono::milliseconds(0)).size(), 1u);
  EXPECT_EQ(check_start(config, std::chrono::milliseconds(0))[0].text,
            "soccer server ./no-server: no such file");
}

TEST(Preflight, WarnsOfTooManyMatchesTooLittleSpaceAndOtherVersion) {
  tests::TemporaryFolder folder;
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  auto matches = play_all(config.competition, better_wins);
  const auto warnings = [&](double to_play) {
    return host_warnings(config, matches, to_play, folder.path());
  };

  EXPECT_TRUE(warnings(10).empty());

  config.execution.concurrency = base::usable_cores() + 1;
  ASSERT_EQ(warnings(10).size(), 1u);
  EXPECT_THAT(warnings(10)[0], HasSubstr(" cores: they slow each other down"));

  config.execution.concurrency = 1;
  ASSERT_EQ(warnings(1e12).size(), 1u);
  EXPECT_THAT(warnings(1e12)[0], HasSubstr("--keep-logs failed"));

  config.execution.keep_logs = KeepLogs::kFailed;
  EXPECT_TRUE(warnings(1e12).empty());

  matches[1].outcome->version = base::kVersion;
  EXPECT_TRUE(warnings(1).empty());

  matches[2].outcome->version = "0.0.1";
  ASSERT_EQ(warnings(1).size(), 1u);
  EXPECT_EQ(warnings(1)[0].rfind("cls 0.0.1 played match 3, this is cls ", 0), 0u);
}

TEST(Preflight, EstimatesTimeFromMatchesPlayedOrRealTime) {
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  config.execution.concurrency = 2;
  EXPECT_FALSE(expected_seconds(config, {}, 10));

  auto matches = play_all(config.competition, better_wins);
  for (ScheduledMatch& match : matches) match.outcome->run_seconds = 4;
  EXPECT_DOUBLE_EQ(*expected_seconds(config, matches, 10), 20);

  config.conditions.options["mode"] = "realtime";
  EXPECT_DOUBLE_EQ(*expected_seconds(config, {}, 10), 3000);

  config.conditions.settings = {{"server::half_time", "100"}};
  EXPECT_DOUBLE_EQ(*expected_seconds(config, {}, 10), 1000);

  config.conditions.options["cycles"] = "50";
  EXPECT_DOUBLE_EQ(*expected_seconds(config, {}, 10), 25);
}

}  // namespace
}  // namespace cls::tournament
