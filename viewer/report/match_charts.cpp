// Picks from the statistics what each chart shows.
#include "viewer/report/match_charts.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/counted.h"
#include "soccer/side.h"
#include "viewer/charts/charts.h"
#include "viewer/charts/drawing.h"
#include "viewer/report/match_series.h"

namespace cls::viewer {
namespace {

using analysis::Goal;
using analysis::kTeamSize;
using analysis::MatchStatistics;
using analysis::MatchSummary;
using analysis::Pass;
using analysis::Shot;
using analysis::team_of;
using soccer::Vec2;

constexpr const char* kAttacksRight = "attacks to the right";

std::string player_label(const MatchSummary& summary, std::size_t slot) {
  return fmt::format("{} {}", team_label(summary, team_of(slot)), analysis::unum_of(slot));
}

std::string short_label(const MatchSummary& summary, std::size_t team) {
  return shortened_name(team_label(summary, team));
}

std::string goal_text(const MatchSummary& summary, const Goal& goal) {
  std::string text =
      fmt::format("cycle {}: goal for {}", goal.cycle, team_label(summary, team_of(goal.side)));
  if (goal.scorer != analysis::kNoPlayer) {
    text += fmt::format(" by {}", player_label(summary, analysis::slot_index(goal.scorer)));
  }
  return goal.own_goal ? text + " (own goal)" : text;
}

struct TeamShots {
  int count = 0;
  int goals = 0;
  double expected = 0.0;
};

TeamShots shots_of(const MatchStatistics& all, std::size_t team) {
  TeamShots sum;
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    if (team_of(all.shots[i].slot) != team) continue;
    ++sum.count;
    sum.expected += all.expected[i];
  }

  for (const Goal& goal : all.goals) sum.goals += team_of(goal.side) == team;
  return sum;
}

// "HELIOS: 12 shots, 1.83 xG, 2 goals"
std::array<std::string, 2> shot_legend(const MatchSummary& summary, const MatchStatistics& all) {
  std::array<std::string, 2> texts;
  for (std::size_t team = 0; team < 2; ++team) {
    const TeamShots sum = shots_of(all, team);
    texts[team] = fmt::format("{}: {}, {:.2f} xG, {}", short_label(summary, team),
                              base::counted(sum.count, "shot"), sum.expected,
                              base::counted(sum.goals, "goal"));
  }
  return texts;
}

std::string shot_text(const MatchSummary& summary, const MatchStatistics& all, std::size_t index) {
  const Shot& shot = all.shots[index];
  const std::uint32_t frame = all.flow.touches[shot.touch].frame;
  return fmt::format("cycle {}: {} from {:.1f} m, {}, {:.2f} xG", all.flow.record->time[frame],
                     player_label(summary, analysis::slot_index(shot.slot)), shot.distance,
                     analysis::name(shot.outcome), all.expected[index]);
}

std::string race_svg(const MatchSummary& summary, const MatchStatistics& all) {
  RaceData data;
  data.title = {"Expected goals over time", "circles: goals"};
  data.axis = time_axis(*all.flow.record);
  data.teams = shot_legend(summary, all);

  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const double frame = all.flow.touches[all.shots[i].touch].frame;
    data.steps[team_of(all.shots[i].slot)].push_back({frame, all.expected[i], false, {}});
  }

  for (const Goal& goal : all.goals) {
    data.steps[team_of(goal.side)].push_back(
        {static_cast<double>(goal.frame), 0.0, true, goal_text(summary, goal)});
  }

  for (auto& steps : data.steps) std::ranges::stable_sort(steps, {}, &RaceData::Step::at);
  return race_chart(data);
}

std::string shots_svg(const MatchSummary& summary, const MatchStatistics& all) {
  ShotMapData data;
  data.title = {"Shots", "the left team shoots to the right"};
  data.teams = shot_legend(summary, all);

  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    data.shots.push_back({team_of(shot.slot), all.flow.touches[shot.touch].contact, all.expected[i],
                          shot.outcome == analysis::ShotOutcome::kGoal,
                          shot_text(summary, all, i)});
  }
  return shot_map(data);
}

std::string possession_svg(const MatchSummary& summary, const MatchStatistics& all) {
  SharesData data;
  data.title = {"Possession and field tilt", "mean over a tenth of the match"};
  data.axis = time_axis(*all.flow.record);
  data.teams = {short_label(summary, 0), short_label(summary, 1)};

  data.strips = {
      {"possession: the left team's share of the time in play, %", possession_over_time(all)},
      {"field tilt: the left team's share of the touches in the opponents' third, %",
       field_tilt_over_time(all)}};
  return shares_chart(data);
}

// Positions are the mean of given and received passes, as the team sees the pitch.
std::string network_svg(const MatchSummary& summary, const MatchStatistics& all, std::size_t team) {
  std::array<Vec2, kTeamSize> sums;
  std::array<int, kTeamSize> counts = {};
  const auto add = [&](std::int8_t slot, Vec2 point) {
    sums[analysis::slot_index(slot) % kTeamSize] += point;
    ++counts[analysis::slot_index(slot) % kTeamSize];
  };
  for (const Pass& pass : all.passes) {
    if (!pass.completed() || team_of(pass.passer) != team) continue;
    add(pass.passer, pass.from);
    add(pass.receiver, pass.to);
  }

  PassNetworkData data;
  data.title = {fmt::format("Passes of {}", team_label(summary, team)), kAttacksRight};
  data.tone = tone_of(team);

  std::array<std::size_t, kTeamSize> nodes = {};
  for (std::size_t i = 0; i < kTeamSize; ++i) {
    nodes[i] = data.nodes.size();
    if (counts[i] == 0) continue;
    data.nodes.push_back({static_cast<int>(i) + 1, sums[i] / counts[i], counts[i]});
  }

  const auto& edges = all.networks[team].edges;
  for (std::size_t a = 0; a < kTeamSize; ++a) {
    for (std::size_t b = a + 1; b < kTeamSize; ++b) {
      const int passes = edges[a][b].passes + edges[b][a].passes;
      if (passes > 0) data.edges.push_back({nodes[a], nodes[b], passes});
    }
  }

  return pass_network_chart(data);
}

HeatMapData heat_data(ChartTitle title, Tone tone) {
  return {std::move(title),
          tone,
          5.0,
          analysis::kHeatColumns,
          analysis::kHeatRows,
          std::vector<double>(analysis::kHeatColumns * analysis::kHeatRows)};
}

std::string ball_heat_svg(const MatchStatistics& all) {
  HeatMapData data =
      heat_data({"Where the ball was", "the left team attacks to the right"}, Tone::kBoth);
  std::ranges::copy(all.positions.ball, data.cells.begin());
  return heat_map(data);
}

std::string team_heat_svg(const MatchSummary& summary, const MatchStatistics& all,
                          std::size_t team) {
  HeatMapData data =
      heat_data({fmt::format("Field players of {}", team_label(summary, team)), kAttacksRight},
                tone_of(team));

  for (const std::size_t slot : analysis::kTeamSlots[team]) {
    if (plays_in_goal(*all.flow.record, slot)) continue;
    std::ranges::transform(all.positions.players[slot].heat, data.cells, data.cells.begin(),
                           [](int frames, double sum) { return sum + frames; });
  }

  if (team == 1) std::ranges::reverse(data.cells);
  return heat_map(data);
}

// The moment of the shot, or shortly before a goal without one.
std::string goal_svg(const MatchSummary& summary, const MatchStatistics& all, const Goal& goal) {
  constexpr std::uint32_t kBefore = 25;
  const gamelog::MatchRecord& record = *all.flow.record;
  std::uint32_t frame = goal.frame - std::min<std::uint32_t>(goal.frame, 10);
  if (goal.shot >= 0) {
    frame = all.flow.touches[all.shots[base::index(goal.shot)].touch].frame;
    frame -= std::min(frame, 1U);
  }

  SceneData data;
  data.title = {goal_text(summary, goal), {}};
  data.teams = {short_label(summary, 0), short_label(summary, 1)};

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = analysis::entry_of(frame, slot);
    if (!gamelog::is_enabled(record, entry)) continue;
    data.players.push_back({team_of(slot), analysis::unum_of(slot), record.players.position[entry],
                            record.players.body[entry], static_cast<int>(slot) == goal.scorer});
  }

  data.ball = record.ball_position[frame];
  for (std::uint32_t i = frame - std::min(frame, kBefore); i <= goal.frame; ++i) {
    data.ball_path.emplace_back(record.ball_position[i]);
  }
  return scene_chart(data);
}

}  // namespace

std::string team_label(const MatchSummary& summary, std::size_t team) {
  const std::string& name = summary.teams[team].name;
  return name.empty() ? (team == 0 ? "left team" : "right team") : name;
}

std::vector<Chart> match_charts(const MatchSummary& summary, const MatchStatistics& all) {
  constexpr std::size_t kMaxScenes = 12;
  std::vector<Chart> charts;
  if (all.flow.record->frames() == 0) return charts;

  charts.push_back({"expected-goals", "Expected goals over time", race_svg(summary, all)});
  charts.push_back({"possession", "Possession and field tilt", possession_svg(summary, all)});
  charts.push_back({"shots", "Shots", shots_svg(summary, all)});
  charts.push_back({"ball", "Where the ball was", ball_heat_svg(all)});

  const std::array<std::string, 2> sides = {"left", "right"};
  for (std::size_t team = 0; team < 2; ++team) {
    charts.push_back({"passes-" + sides[team],
                      fmt::format("Passes of {}", team_label(summary, team)),
                      network_svg(summary, all, team)});
  }
  for (std::size_t team = 0; team < 2; ++team) {
    charts.push_back({"positions-" + sides[team],
                      fmt::format("Field players of {}", team_label(summary, team)),
                      team_heat_svg(summary, all, team)});
  }

  for (std::size_t i = 0; i < std::min(kMaxScenes, all.goals.size()); ++i) {
    charts.push_back({fmt::format("goal-{}", i + 1), goal_text(summary, all.goals[i]),
                      goal_svg(summary, all, all.goals[i])});
  }

  return charts;
}

}  // namespace cls::viewer
