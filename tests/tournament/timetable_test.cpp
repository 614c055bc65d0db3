// Planned starts: servers, stages and start times.
#include "tournament/slots/timetable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "league/schedule/schedule.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/config/start_times.h"

namespace cls::tournament {
namespace {

using testing::Each;

// Matches of 20 minutes on one server.
TournamentConfig config_with(Format format, int teams, std::vector<std::string> start_times) {
  TournamentConfig config = config_of(format, teams);
  config.execution.concurrency = 1;
  config.report.slot_minutes = 20;
  config.report.start_times = std::move(start_times);
  return config;
}

// The planned starts of the next matches, "09:00".
std::vector<std::string> next_starts(const TournamentConfig& config,
                                     std::vector<ScheduledMatch> matches = {}) {
  for (Fixture& fixture : next_fixtures(config.competition, matches)) {
    matches.push_back(planned(std::move(fixture)));
  }
  std::vector<std::string> starts;
  for (const PlannedStart& start : timetable(config, matches, 0).starts) {
    starts.push_back(local_time_text(start.time).substr(11));
  }
  return starts;
}

TEST(Timetable, OneMatchFollowsTheOther) {
  TournamentConfig config = config_with(Format::kRoundRobin, 2, {"2027-07-15 09:00"});
  EXPECT_EQ(next_starts(config), (std::vector<std::string>{"09:00", "09:20"}));
  config.execution.concurrency = 2;
  EXPECT_THAT(next_starts(config), Each("09:00"));
}

TEST(Timetable, AStartIsThatOfItsStageNotOfOneWhoseNameBeginsSo) {
  for (const char* last : {"final", "the final"}) {
    TournamentConfig config =
        config_with(Format::kStages, 3,
                    {"final day: 2027-07-15 09:00", std::string(last) + ": 2027-07-15 18:00"});
    config.competition.stages.resize(2);
    config.competition.stages[0].name = "final day";
    config.competition.stages[1].name = last;
    config.competition.swap_sides = false;

    EXPECT_EQ(next_starts(config).front(), "09:00") << last;
    Competition first = config.competition;
    first.stages.pop_back();
    const auto played = league::play_all(first, league::better_wins);
    EXPECT_EQ(next_starts(config, played).front(), "18:00") << last;
  }
}

TEST(Timetable, AStartHoldsForAllStagesWhoseNamesBeginSo) {
  const TournamentConfig config =
      config_with(Format::kKnockout, 4, {"2027-07-15 09:00", "semi-final: 2027-07-15 15:00"});
  EXPECT_EQ(next_starts(config).front(), "15:00");
}

}  // namespace
}  // namespace cls::tournament
