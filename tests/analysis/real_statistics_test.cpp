// Statistics of rcssserver matches compared with text logs and the rules of the game.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/team_totals.h"
#include "base/index.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/gamelog/recorded_match.h"

namespace cls::analysis {
namespace {

struct RealMatch {
  gamelog::MatchRecord record;
  gamelog::RclRecord text;
};

RealMatch read_both(const std::filesystem::path& stem) {
  auto record = gamelog::read_rcg_file(stem.string() + ".rcg.gz");
  auto text = gamelog::read_rcl_file(stem.string() + ".rcl.gz");
  EXPECT_TRUE(record && text);
  return {std::move(*record), std::move(*text)};
}

// Number of each referee message.
std::map<std::string, int> count_referee_messages(const gamelog::RclRecord& text) {
  std::map<std::string, int> messages;
  for (const gamelog::RclLine& line : text.lines) {
    if (line.source == gamelog::RclSource::kReferee) ++messages[std::string(text.text_of(line))];
  }
  return messages;
}

void expect_agreement_with_referee(const RealMatch& match, const MatchStatistics& all) {
  std::map<std::string, int> messages = count_referee_messages(match.text);
  for (std::size_t team = 0; team < 2; ++team) {
    const TeamStoppages& s = all.stoppages.teams[team];
    const auto count = [&](const char* prefix) {
      return messages[prefix + std::string(1, "lr"[team])];
    };

    EXPECT_EQ(s.kick_offs, count("kick_off_"));
    EXPECT_EQ(s.kick_ins, count("kick_in_"));
    EXPECT_EQ(s.corners, count("corner_kick_"));
    EXPECT_EQ(s.goal_kicks, count("goal_kick_"));
    EXPECT_EQ(s.free_kicks + s.goalie_catches, count("free_kick_"));
    EXPECT_EQ(s.indirect_free_kicks, count("indirect_free_kick_"));
    EXPECT_EQ(s.goalie_catches, count("goalie_catch_ball_"));
    EXPECT_EQ(s.offsides, count("offside_"));
    EXPECT_EQ(s.fouls, count("foul_charge_") + count("foul_push_"));
    EXPECT_EQ(all.goalkeeping[team].catches, count("goalie_catch_ball_"));
  }

  EXPECT_EQ(std::ssize(all.flow.placed), messages["drop_ball"]);
}

// Increase of the counters between the first frame and time_over, and number of commands sent.
void expect_counts_to_add_up(const RealMatch& match, const MatchStatistics& all) {
  const gamelog::MatchRecord& record = match.record;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const Responsiveness& answers = (*all.responsiveness)[slot];
    const auto asked = [&](gamelog::CommandKind kind) {
      return answers.commands[base::index(kind)];
    };
    const auto grew = [&](gamelog::Counter counter) {
      const auto count = [&](std::size_t entry) {
        return record.players.counters[entry][base::index(counter)];
      };
      return count(entry_of(record.frames() - 1, slot)) - count(slot);
    };

    EXPECT_EQ(asked(gamelog::CommandKind::kKick) - answers.rejected_kicks,
              grew(gamelog::Counter::kKick))
        << slot;
    EXPECT_EQ(asked(gamelog::CommandKind::kTackle) - answers.rejected_tackles,
              grew(gamelog::Counter::kTackle));
    // Half time hides the commands of a cycle, and dashes of tackled players have no effect.
    EXPECT_NEAR(asked(gamelog::CommandKind::kDash), grew(gamelog::Counter::kDash), 1) << slot;
    EXPECT_EQ(all.tackles[slot].tried, grew(gamelog::Counter::kTackle));
    // helios and cyrus respond in every step of synch mode.
    EXPECT_EQ(answers.silent, 0);
    EXPECT_EQ(answers.answered, answers.steps);
  }
}

// No player can use more than two capacities per half; an exhausted one has used exactly that.
void expect_possible_stamina(const RealMatch& match, const MatchStatistics& all) {
  const double store = match.record.server.stamina_max + match.record.server.stamina_capacity;
  int exhausted = 0;
  for (const Stamina& s : all.stamina) {
    EXPECT_LE(s.used, store * (s.refills + 1) + 0.5) << exhausted;
    EXPECT_GE(s.refills, 1);
    if (s.lowest != 0.0 || s.refills != 1 || s.last_capacity != 0.0 || s.last != 0.0) continue;

    ++exhausted;
    EXPECT_NEAR(s.used, 2 * store, 1.0) << exhausted;
  }
  EXPECT_GE(exhausted, 3);
}

int sum(const auto& counts) { return std::accumulate(counts.begin(), counts.end(), 0); }

int interceptions_of(const MatchStatistics& all, std::size_t team) {
  int count = 0;
  for (const std::size_t slot : kTeamSlots[team]) count += all.pressing.interceptions[slot];
  return count;
}

// Conditions that hold for any definition.
void expect_consistency(const MatchStatistics& all) {
  for (std::size_t team = 0; team < 2; ++team) {
    const PassTotals passes = pass_totals(all, team);
    const ShotTotals shots = shot_totals(all, team);
    const Possession& p = all.possession;
    int chain_passes = 0;
    for (const Chain& chain : all.chains) chain_passes += chain.team == team ? chain.passes : 0;

    EXPECT_EQ(sum(shots.outcomes), shots.total);
    EXPECT_EQ(sum(passes.outcomes), passes.attempted);
    EXPECT_EQ(passes.completed, all.networks[team].passes);
    EXPECT_LE(passes.completed, passes.attempted);
    EXPECT_EQ(chain_passes, passes.completed);
    EXPECT_LE(p.last_touch[team], p.live_frames);
    EXPECT_LE(p.fastest[team], p.live_frames);
    EXPECT_EQ(passes.outcomes[base::index(PassOutcome::kIntercepted)],
              interceptions_of(all, 1 - team));
  }

  for (const Positions& player : all.positions.players) {
    EXPECT_EQ(sum(player.heat), all.territory.live_frames);
  }
}

TEST(RealStatistics, MatchTextLogAtStartOfMatch) {
  const RealMatch match = read_both(tests::fixture("gamelog/match-start"));
  const MatchStatistics all = compute_statistics(match.record, &match.text);
  expect_agreement_with_referee(match, all);
  expect_counts_to_add_up(match, all);
  expect_consistency(all);
  ASSERT_EQ(all.goals.size(), 1u);
  EXPECT_EQ(all.goals[0].scorer, 10);
}

TEST(RealStatistics, MatchTextLogOfWholeMatches) {
  struct Figures {
    const char* name;
    PerTeam<int> completed;
    PerTeam<int> shots;
    PerTeam<int> tackles;
    double possession;
  };
  // These values detect changes of definitions; docs/formats/statistics.md explains them.
  for (const auto& [name, completed, shots, tackles, possession] :
       {Figures{"helios-vs-helios-full", {68, 75}, {5, 4}, {26, 16}, 0.5463},
        Figures{"cyrus-vs-helios-full", {135, 87}, {12, 0}, {43, 18}, 0.6157}}) {
    const auto data = tests::data("logs/" + std::string(name) + ".rcg.gz");
    if (!data) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    const RealMatch match = read_both(data->parent_path() / name);
    const MatchStatistics all = compute_statistics(match.record, &match.text);

    expect_agreement_with_referee(match, all);
    expect_counts_to_add_up(match, all);
    expect_possible_stamina(match, all);
    expect_consistency(all);
    EXPECT_TRUE(exclusion_reasons(summarize(match.record, &match.text), all).empty());

    EXPECT_NEAR(left_share(all.possession.last_touch), possession, 1e-4);

    for (std::size_t team = 0; team < 2; ++team) {
      EXPECT_EQ(pass_totals(all, team).completed, completed[team]);
      EXPECT_EQ(shot_totals(all, team).total, shots[team]);
      int succeeded = 0;
      // Field players run 1.7 to 2.9 km, goalies 0.1 to 0.5 (docs/spec/match-statistics.md 4.1).
      for (const std::size_t slot : kTeamSlots[team]) {
        const double distance = all.movement[slot].distance();
        const bool keeper = slot % kTeamSize == 0;
        EXPECT_GT(distance, keeper ? 100 : 1700) << slot;
        EXPECT_LT(distance, keeper ? 500 : 2900) << slot;
        succeeded += all.tackles[slot].succeeded;
      }
      EXPECT_EQ(succeeded, tackles[team]);
    }
  }
}

TEST(RealStatistics, ReadEveryLogVersion) {
  for (const char* name : {"rcg-v1-excerpt", "rcg-v2-excerpt", "rcg-v3-excerpt", "rcg-v4-excerpt",
                           "rcg-v5-excerpt", "rcg-json-excerpt"}) {
    SCOPED_TRACE(name);
    const gamelog::MatchRecord record = tests::record_of(name);
    const MatchStatistics all = compute_statistics(record, nullptr);
    EXPECT_GT(all.possession.live_frames, 0);
    EXPECT_GT(all.flow.touches.size(), 0u);
    expect_consistency(all);
    for (const Movement& movement : all.movement) EXPECT_FALSE(std::isnan(movement.distance()));
  }
}

}  // namespace
}  // namespace cls::analysis
