// Statistics of scripted matches: possession, tackles, territory, stoppages, goalkeeping, pressing,
// movement, stamina, positions, responsiveness.
#include "analysis/statistics/match_statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/measures/position_stats.h"
#include "analysis/play/interception_time.h"
#include "analysis/statistics/statistics_text.h"
#include "base/index.h"
#include "base/text/lines.h"
#include "base/text/split.h"
#include "base/text/trimmed.h"
#include "tests/analysis/plays.h"
#include "tests/support/files.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Vec2;
using testing::HasSubstr;
using testing::Not;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

TEST(Possession, CountsByLastAndNextToucher) {
  ScriptedMatch match;                // frame 0: no owner
  match.step();                       // 1: no owner, left next
  match.kick(left(5), {1, 0});        // 2
  match.steps(2);                     // 3, 4
  match.kick(right(5), {0.1, 0});     // 5
  match.mode(PlayMode::kKickInLeft);  // 6
  match.step();
  const Possession p = measure_possession(build_flow(match.record()));

  EXPECT_EQ(p.live_frames, 6);
  EXPECT_EQ(p.last_touch, (PerTeam<int>{3, 1}));
  EXPECT_EQ(p.next_kicker, (PerTeam<int>{2, 3}));
  EXPECT_EQ(p.all_play, (PerTeam<int>{4, 1}));
  EXPECT_DOUBLE_EQ(left_share(p.last_touch), 0.75);
  EXPECT_DOUBLE_EQ(left_share({0, 0}), 0.5);
}

TEST(Possession, CountsFramesWithKickableBall) {
  ScriptedMatch match;
  match.player(left(5)).position = {1.0, 0};  // kickable radius 1.085
  match.step();
  match.player(right(5)).position = {0, 1.0};
  match.step();
  match.player(left(5)).position = {1.1, 0};
  match.step();
  const Possession p = measure_possession(build_flow(match.record()));
  EXPECT_EQ(p.at_feet, (PerTeam<int>{1, 1}));
  EXPECT_EQ(p.at_feet_contested, 1);
}

TEST(Interception, FindsFirstPlayerAtBall) {
  ScriptedMatch match;
  match.player(left(5)).position = {-3, 0};  // faces the ball
  match.player(right(5)).position = {3.5, 0};
  match.player(right(5)).body = 180;
  match.step();
  const auto first = first_to_ball(match.record(), 1);

  ASSERT_TRUE(first);
  EXPECT_EQ(first->slot, base::index(left(5)));
  // after one cycle of standing
  EXPECT_EQ(first->cycles, 3);
  EXPECT_EQ(cycles_to_ball(match.record(), 1, base::index(right(5))), 4);

  // Turned away, the player needs one more cycle.
  match.player(left(5)).body = 90;
  match.step();

  EXPECT_EQ(cycles_to_ball(match.record(), 2, base::index(left(5))), 4);
  EXPECT_FALSE(first_to_ball(match.record(), 2));  // both in the same cycle

  // A ball that rolls toward the player takes less.
  match.player(left(5)).body = 0;
  match.next().ball_velocity = {-1, 0};
  match.next().ball_position = {1, 0};
  match.step();

  EXPECT_EQ(cycles_to_ball(match.record(), 3, base::index(left(5))), 2);
}

TEST(Tackles, CountsHitsMissesAndEffectiveTackles) {
  ScriptedMatch match;
  match.kick(right(5), {0.5, 0});
  match.tackle(left(5), {0.5, 0});  // from the opponent, and left touches next
  match.kick(left(6), {0.5, 0});
  match.tackle(left(7), {0.5, 0});   // of the own team's ball: a kick
  match.tackle(right(8), {0.5, 0});  // from the opponent, but left touches next
  match.kick(left(9), {0.5, 0});
  miss_ball(match, right(3));
  match.step();
  ++match.player(right(3)).counts.tackle;
  match.player(right(3)).state |= gamelog::kStateTackleFailed;
  match.step();
  const auto tackles = count_tackles(build_flow(match.record()));

  EXPECT_EQ(tackles[left(5)], (Tackles{1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(tackles[left(7)], (Tackles{1, 1, 0, 0, 0, 1}));
  EXPECT_EQ(tackles[right(8)], (Tackles{1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(tackles[right(3)], (Tackles{2, 0, 1, 1, 0, 0}));
}

TEST(Territory, CountsThirdsQuartersAndBoxEntries) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  const auto roll_to = [&match](double target) {
    while (std::fabs(match.next().ball_position.x - target) > 0.1) {
      match.next().ball_velocity = {match.next().ball_position.x < target ? 3.0 : -3.0, 0.0};
      match.step();
    }
  };
  for (const double x : {-20.0, 37.0, 34.0, 37.0}) roll_to(x);
  const Territory t = measure_territory(build_flow(match.record()));

  EXPECT_EQ(t.live_frames, 30);
  EXPECT_EQ(t.thirds, (std::array<int, 3>{1, 20, 9}));
  EXPECT_EQ(t.quarters, (std::array<int, 4>{0, 13, 11, 6}));
  EXPECT_EQ(t.teams[0].thirds_owned, (std::array<int, 3>{1, 19, 9}));
  EXPECT_EQ(t.teams[0].box_entries, 2);
  EXPECT_EQ(t.teams[1].box_entries, 0);
}

TEST(Territory, MirrorsRightTeamAndComputesPitchControl) {
  ScriptedMatch match;
  kick_from(match, {-35, 0}, right(9), {-2.0, 0});
  match.step();
  const Territory t = measure_territory(build_flow(match.record()));
  EXPECT_EQ(t.teams[1].box_entries, 1);
  EXPECT_EQ(t.teams[1].final_third_touches, 1);
  EXPECT_DOUBLE_EQ(t.field_tilt(), 0.0);
  EXPECT_NEAR(t.teams[0].pitch_control + t.teams[1].pitch_control, 1.0, 0.1);
  EXPECT_NEAR(t.teams[0].pitch_control, t.teams[1].pitch_control, 1e-9);
}

TEST(Stoppages, CountsRestartsAndOffensesBySide) {
  ScriptedMatch match;
  for (const PlayMode mode :
       {PlayMode::kKickInLeft, PlayMode::kPlayOn, PlayMode::kCornerKickRight, PlayMode::kPlayOn,
        PlayMode::kGoalKickLeft, PlayMode::kPlayOn, PlayMode::kOffsideRight,
        PlayMode::kFreeKickLeft, PlayMode::kPlayOn, PlayMode::kBackPassLeft,
        PlayMode::kIndirectFreeKickRight, PlayMode::kPlayOn, PlayMode::kFoulPushRight,
        PlayMode::kFreeKickLeft, PlayMode::kGoalLeft, PlayMode::kKickOffRight}) {
    match.mode(mode);
    match.steps(2);
  }

  const Stoppages s = count_stoppages(build_flow(match.record()));

  EXPECT_EQ(
      s.teams[0],
      (TeamStoppages{
          .kick_ins = 1, .goal_kicks = 1, .free_kicks = 2, .back_passes = 1, .restart_frames = 8}));
  EXPECT_EQ(s.teams[0].set_plays(), 4);
  EXPECT_EQ(s.teams[1], (TeamStoppages{.kick_offs = 1,
                                       .corners = 1,
                                       .indirect_free_kicks = 1,
                                       .offsides = 1,
                                       .fouls = 1,
                                       .restart_frames = 6}));
}

TEST(Stoppages, IdentifiesFoulerAndVictim) {
  ScriptedMatch match;
  match.player(left(5)).position = {0.5, 0};
  match.player(right(6)).position = {1, 0};
  match.step();
  ++match.player(left(5)).counts.tackle;
  match.player(left(5)).state |= gamelog::kStateTackle;
  match.player(right(6)).state |= gamelog::kStateCharged | gamelog::kStateYellowCard;
  match.mode(PlayMode::kFoulChargeLeft);
  match.step();
  const Stoppages s = count_stoppages(build_flow(match.record()));

  ASSERT_EQ(s.fouls.size(), 1u);
  EXPECT_EQ(s.fouls[0].fouler, left(5));
  EXPECT_EQ(s.fouls[0].victim, right(6));
  EXPECT_EQ(s.fouls_by[left(5)], 1);
  EXPECT_EQ(s.fouls_against[right(6)], 1);
  EXPECT_EQ(s.yellow_cards[right(6)], 1);
  EXPECT_EQ(s.teams[1].yellow_cards, 1);
}

TEST(Stoppages, ExcludesFreeKicksAfterCatch) {
  ScriptedMatch match;
  catch_ball(match, left(1));
  match.mode(PlayMode::kFreeKickLeft);
  match.steps(2);
  const Stoppages s = count_stoppages(build_flow(match.record()));
  EXPECT_EQ(s.teams[0].goalie_catches, 1);
  EXPECT_EQ(s.teams[0].free_kicks, 0);
}

TEST(Goalkeeping, CountsCatchesSavesAndMoves) {
  ScriptedMatch match;
  kick_from(match, {40, 0}, left(9), {2.5, 0.6});
  match.step();
  catch_ball(match, right(1));
  match.mode(PlayMode::kFreeKickRight);
  match.step();
  match.player(right(1)).counts.move += 2;
  match.step();
  match.mode(PlayMode::kPlayOn);
  match.place_ball({45, 0});
  match.player(right(1)).position = {45, 3};
  match.step();
  match.player(right(1)).state |=
      gamelog::kStateCatch | gamelog::kStateCatchFailed;  // out of reach: not counted
  match.step();
  const Play play(match);
  const auto keepers = measure_goalkeeping(play.flow, play.shots);

  EXPECT_EQ(keepers[1].catches, 1);
  EXPECT_EQ(keepers[1].saves, 1);
  EXPECT_EQ(keepers[1].moves_after_catch, 2);
  EXPECT_EQ(keepers[1].failed_catches, 1);
  EXPECT_EQ(keepers[1].punches, 0);
  EXPECT_EQ(keepers[1].save_rate(), 1.0);
  EXPECT_NEAR(keepers[1].furthest_rush, std::sqrt(7.5 * 7.5 + 9), 1e-6);
  EXPECT_EQ(keepers[0].catches, 0);
}

TEST(Pressing, CountsLossesRecoveriesAndPressure) {
  ScriptedMatch match;
  match.player(left(5)).position = {0, 0};
  match.player(right(5)).position = {2, 0};
  match.step();
  match.kick(left(5), {0.8, 0});   // owner left, pressed
  match.kick(right(5), {0.5, 0});  // left loses, right recovers
  match.steps(9);
  match.kick(left(6), {0.5, 0});  // regained after ten frames
  const Play play(match);
  const PressingStats p = measure_pressing(play.flow, play.passes, count_stoppages(play.flow));

  EXPECT_EQ(p.teams[0].losses, 1);
  EXPECT_EQ(p.teams[1].losses, 1);
  EXPECT_EQ(p.recoveries[right(5)], 1);
  EXPECT_EQ(p.recoveries[left(6)], 1);
  EXPECT_EQ(p.teams[0].regained, 1);
  EXPECT_EQ(p.teams[0].regained_soon, 1);
  EXPECT_DOUBLE_EQ(p.teams[0].regain_cycles, 10.0);
  EXPECT_EQ(p.teams[1].opponent_frames, 2);
  EXPECT_EQ(p.teams[1].pressure_frames, 1);
  EXPECT_EQ(p.interceptions[right(5)], 1);
  EXPECT_EQ(p.teams[1].opponent_passes, 1);
  EXPECT_EQ(p.teams[1].defensive_actions, 1);
}

TEST(Movement, SumsStepsWithoutPlacements) {
  ScriptedMatch match;
  match.player(left(5)).position.x += 1.0;
  match.step();
  match.player(left(5)).position.x += 0.1;
  match.step();
  match.player(left(5)).position = {0, 0};
  match.step();
  match.mode(PlayMode::kKickInLeft);
  match.player(left(5)).position.y += 0.5;
  match.step();
  const Movement m = measure_movement(build_flow(match.record()))[left(5)];

  EXPECT_NEAR(m.live_distance, 1.1, 1e-5);
  EXPECT_NEAR(m.other_distance, 0.5, 1e-5);
  EXPECT_NEAR(m.top_speed, 1.0, 1e-5);
  EXPECT_EQ(m.bands, (std::array<int, 4>{1, 0, 0, 1}));
}

TEST(Stamina, SumsConsumptionOfStaminaAndCapacity) {
  ScriptedMatch match;
  const auto set = [&](double stamina, double capacity) {
    match.player(left(5)).stamina = stamina;
    match.player(left(5)).capacity = capacity;
    match.step();
  };
  set(7900, 130600);
  set(7845, 130555);
  set(3000, 130000);
  set(8000, 130600);  // second half
  set(2000, 130000);
  const Stamina s = measure_stamina(match.record())[left(5)];

  EXPECT_NEAR(s.used, (8000 - 3000 + 600) + (8000 - 2000 + 600), 1e-6);
  EXPECT_EQ(s.refills, 1);
  EXPECT_EQ(s.lowest, 2000);
  EXPECT_EQ(s.exhausted_frames, 1);  // below 0.3 * 8000

  // An extra half refills only the capacity.
  set(1950, 130600);
  EXPECT_NEAR(measure_stamina(match.record())[left(5)].used, s.used + 50, 1e-6);
}

TEST(Stamina, EstimatesConsumptionWithoutCapacity) {
  ScriptedMatch match;
  match.record().version = gamelog::RcgVersion::kV4;
  match.player(left(5)).stamina = 7900;
  match.step();
  match.player(left(5)).stamina = 7900;  // used the recovered stamina
  match.step();
  EXPECT_NEAR(measure_stamina(match.record())[left(5)].used, 100 + 45, 1e-6);
}

TEST(Positions, AverageFromTeamView) {
  ScriptedMatch match;
  match.player(right(5)).position = {30, 10};
  match.step();
  match.player(right(5)).position = {32, 14};
  match.step();
  match.record().time[0] = 0;
  const PositionStats p = measure_positions(build_flow(match.record()));
  const Cloud& cloud = p.players[right(5)].all;

  EXPECT_EQ(cloud.count, 3);
  EXPECT_NEAR(cloud.mean.x, -(40 + 30 + 32) / 3.0, 1e-5);
  EXPECT_NEAR(cloud.mean.y, -(-3 + 10 + 14) / 3.0, 1e-5);
  EXPECT_NEAR(cloud.var_x, (1600 + 900 + 1024) / 3.0 - 34 * 34, 1e-3);

  const HeatMap& heat = p.players[right(5)].heat;
  EXPECT_EQ(std::accumulate(heat.begin(), heat.end(), 0), 3);
  EXPECT_EQ(p.ball[7 * kHeatColumns + 10], 3);  // the center
}

TEST(Positions, MeasureTeamShape) {
  EXPECT_DOUBLE_EQ(hull_area({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 0}}), 4.0);
  EXPECT_EQ(hull_area({{0, 0}, {1, 1}}), 0.0);

  TeamShape shape;
  set_formation({-30, -31, -29, -30.5, -10, -11, -9, 10, 11, 12}, shape);
  EXPECT_EQ(shape.formation, "4-3-3");
  EXPECT_NEAR(shape.line_distance, (11 + 30.125) / 2, 1e-9);

  TeamShape four;
  set_formation({-30, -31, -29, -30.5, -18, 0, 1, 2, 20, 21}, four);
  EXPECT_EQ(four.formation, "4-1-3-2");

  ScriptedMatch match;
  const TeamShape line = measure_positions(build_flow(match.record())).teams[0];
  EXPECT_NEAR(line.width, 27, 1e-5);  // players 2 to 11 in one line
  EXPECT_NEAR(line.length, 0, 1e-5);
  EXPECT_NEAR(line.defense_x, -40, 1e-5);
}

TEST(Positions, KnowGoalieWhoConnectsLateAndLeavesEarly) {
  ScriptedMatch match;
  match.steps(2);
  const std::string formation = measure_positions(build_flow(match.record())).teams[0].formation;
  std::size_t last = (match.record().frames() - 1) * gamelog::kSlots;
  for (const std::size_t first : {std::size_t{0}, last}) {
    match.record().players.state[first + base::index(left(1))] = 0;
  }
  const MatchStatistics statistics = compute_statistics(match.record(), nullptr);
  EXPECT_EQ(statistics.positions.teams[0].formation, formation);
  EXPECT_TRUE(was_goalie(match.record(), base::index(left(1))));
  EXPECT_FALSE(was_goalie(match.record(), base::index(left(2))));
}

TEST(Responsiveness, ComparesSentWithExecutedCommands) {
  ScriptedMatch match;
  match.record().server.synch_mode = true;
  match.kick(left(5), {1, 0});  // clock 1 to 2
  match.steps(3);               // to 5
  const gamelog::RclRecord text = text_log(
      "0,9\tRecv A_5: (turn 1)(done)\n"
      "1,0\tRecv A_5: (kick 100 0)(say \"abc\")(turn_neck 5)(done)\n"
      "1,0\tRecv B_5: (turn 1)(done)\n"
      "2,0\tRecv A_5: (kick 100 0)(turn 5)(done)\n"
      "3,0\tRecv A_5: (turn_neck 3)(turn_neck 4)(done)\n"
      "4,0\tRecv A_5: (tackle 10 true)\n"
      "4,0\tRecv X_5: (tackle 10 true)\n");
  const auto all = measure_responsiveness(build_flow(match.record()), text);
  const Responsiveness& r = all[left(5)];

  EXPECT_EQ(r.steps, 4);
  EXPECT_EQ(r.answered, 4);
  EXPECT_EQ(r.silent, 1);  // no (done) at 4
  EXPECT_EQ(r.no_body_command, 1);
  EXPECT_EQ(r.several_body, 1);
  EXPECT_EQ(r.late_steps, 1);
  EXPECT_EQ(r.rejected_kicks, 1);
  EXPECT_EQ(r.rejected_turn_necks, 3);
  EXPECT_EQ(r.rejected_tackles, 1);
  EXPECT_EQ(r.intentional_fouls, 1);
  EXPECT_EQ(r.say_characters, 3);
  EXPECT_EQ(r.commands[base::index(gamelog::CommandKind::kKick)], 2);
  EXPECT_EQ(all[right(5)].answered, 1);
  EXPECT_EQ(all[right(5)].silent, 3);
  EXPECT_EQ(all[left(6)].silent, 4);
}

TEST(Responsiveness, AssignsTeamsByOrderWhenNamesAreEqual) {
  ScriptedMatch match;
  match.next().teams[0].name = "same";
  match.next().teams[1].name = "same";
  match.step();
  const auto sides =
      assign_sides(match.record(), text_log("1,0\tRecv x_1: (done)\n1,0\tRecv y_1: (done)\n"));
  EXPECT_EQ(sides[0], 0);
  EXPECT_EQ(sides[1], 1);
  EXPECT_EQ(sides[2], -1);
}

TEST(Attention, CountsFramesByViewAndTarget) {
  ScriptedMatch match;
  gamelog::PlayerFrame& player = match.player(left(5));
  player.view_width = 60;
  player.attention_side = soccer::Side::kRight;
  player.attention_unum = 9;
  match.step();

  player.view_width = 180;
  player.high_quality = false;
  player.pointing_at = Vec2{1, 2};
  match.step();

  const Attention a = measure_attention(match.record())[left(5)];
  EXPECT_EQ(a.frames, 3);
  EXPECT_EQ(a.narrow, 1);
  EXPECT_EQ(a.normal, 1);
  EXPECT_EQ(a.wide, 1);
  EXPECT_EQ(a.low_quality, 1);
  EXPECT_EQ(a.pointing, 1);
  EXPECT_EQ(a.attentive, 2);
  EXPECT_EQ(a.targets[right(9)], 2);
  EXPECT_NEAR(a.mean_view_width, 120, 1e-9);
}

std::vector<std::string> reasons(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                                 const std::string& end_reason = "") {
  MatchSummary summary = summarize(record, text);
  summary.end_reason = end_reason;
  if (!end_reason.empty()) summary.complete = end_reason == "finished";
  return exclusion_reasons(summary, compute_statistics(record, text));
}

TEST(ExclusionReasons, ListDisconnectionsSilenceAndMissingEnd) {
  ScriptedMatch match;
  match.step();
  match.player(left(4)).state = 0;
  match.step();

  EXPECT_EQ(reasons(match.record(), nullptr),
            (std::vector<std::string>{"no time_over", "l 4 disconnected"}));

  match.player(left(4)).state = gamelog::kStateEnabled;
  match.step();
  EXPECT_EQ(reasons(match.record(), nullptr, "stalled"),
            std::vector<std::string>{"end reason: stalled"});
  EXPECT_TRUE(reasons(match.record(), nullptr, "finished").empty());

  match.mode(PlayMode::kTimeOver);
  match.step();
  EXPECT_TRUE(reasons(match.record(), nullptr).empty());

  const gamelog::RclRecord silence = text_log("1,0\t(referee play_on)\n");
  EXPECT_EQ(reasons(match.record(), &silence).size(), 22u);
}

TEST(MatchStatistics, HandlesEmptyAndTinyRecords) {
  const gamelog::MatchRecord empty;
  EXPECT_TRUE(compute_statistics(empty, nullptr).shots.empty());
  EXPECT_EQ(reasons(empty, nullptr), std::vector<std::string>{"no frames"});
  ScriptedMatch one;
  EXPECT_EQ(compute_statistics(one.record(), nullptr).possession.live_frames, 1);
}

TEST(StatisticsText, WritesNoNegativeZero) {
  ScriptedMatch match;
  match.player(left(5)).position = {0.5, 0};
  match.place_ball({0, 0});
  match.step();
  MatchStatistics all = compute_statistics(match.record(), nullptr);
  all.ratings[left(5)].passing = -0.04;
  all.ratings[right(5)].passing = -0.06;
  const std::string text = statistics_text(summarize(match.record(), nullptr), all);
  EXPECT_THAT(text, Not(HasSubstr("-0.0")));
  EXPECT_THAT(text, HasSubstr("-0.1"));
}

TEST(StatisticsText, FitsLinesIntoWidth) {
  ScriptedMatch match;
  for (int unum = 1; unum <= 11; ++unum) match.player(left(unum)).position = {0.5, 0};
  match.step();
  const MatchStatistics all = compute_statistics(match.record(), nullptr);
  MatchSummary summary = summarize(match.record(), nullptr);
  for (TeamSummary& team : summary.teams) team.name = "FIFTEEN_CHARS_A";
  for (const std::size_t width : {60U, 80U, 200U}) {
    const std::string text = statistics_text(summary, all, width);
    int with_player = 0;
    for (const std::string_view line : base::lines_of(text)) {
      EXPECT_LE(line.size(), width) << line;
      with_player += line.starts_with("FIFTEEN_CHARS_A 1 ");
    }
    EXPECT_GE(with_player, width == 200 ? 1 : 2) << "blocks repeat the player at " << width;
  }
}

// A row of the page names the columns in its first cell.
TEST(StatisticsCsv, PageNamesEveryColumn) {
  const std::string page = tests::read_file(tests::source_folder() / "docs/formats/statistics.md");
  const auto of_format = [&page](const std::string& format) {
    const std::size_t begin = page.find("| columns of `" + format + "` |");
    EXPECT_NE(begin, std::string::npos) << format;
    return page.substr(begin, page.find("\n\n", begin) - begin);
  };

  for (const auto& [format, table] :
       {std::pair("csv", team_table()), std::pair("csv-players", player_table()),
        std::pair("csv-events", event_table())}) {
    const std::string rows = of_format(format);
    const std::string csv = table.format_csv();
    for (const std::string_view column : base::split(base::trimmed(csv), ',')) {
      EXPECT_THAT(rows, HasSubstr("`" + std::string(column) + "`")) << format;
    }
  }
}

}  // namespace
}  // namespace cls::analysis
