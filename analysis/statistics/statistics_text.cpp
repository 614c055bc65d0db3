// The report of one match.
#include "analysis/statistics/statistics_text.h"

#include <fmt/format.h>

#include "analysis/results/results_text.h"
#include "analysis/statistics/team_totals.h"

namespace cls::analysis {
namespace {

using Align = base::TextTable::Align;

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

// One decimal; what rounds to nothing has no sign.
std::string one_decimal(double value) {
  const std::string text = fmt::format("{:.1f}", value);
  return text == "-0.0" ? "0.0" : text;
}

std::string of(int part, int whole) { return fmt::format("{} of {}", part, whole); }

double team_share(const PerTeam<int>& frames, std::size_t team) {
  const double left = left_share(frames);
  return team == 0 ? left : 1.0 - left;
}

struct Row {
  const char* head;
  std::string (*text)(const MatchStatistics& all, const TeamTotals& totals, std::size_t team);
};

// What everybody wants to know, in the order of a match report.
const Row kRows[] = {
    {"possession (last touch)",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return percent(team_share(all.possession.last_touch, team));
     }},
    {"ball at feet",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return percent(team_share(all.possession.at_feet, team));
     }},
    {"first at the ball",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return percent(team_share(all.possession.fastest, team));
     }},
    {"touches", [](const MatchStatistics&, const TeamTotals& t,
                   std::size_t) { return std::to_string(t.touches); }},
    {"passes completed", [](const MatchStatistics&, const TeamTotals& t,
                            std::size_t) { return of(t.passes.completed, t.passes.attempted); }},
    {"mean pass", [](const MatchStatistics&, const TeamTotals& t,
                     std::size_t) { return fmt::format("{:.1f} m", t.passes.mean_length); }},
    {"through passes, crosses, one-twos",
     [](const MatchStatistics&, const TeamTotals& t, std::size_t) {
       return fmt::format("{}, {}, {}", t.passes.through, t.passes.crosses, t.passes.one_twos);
     }},
    {"dribbles, opponents passed",
     [](const MatchStatistics&, const TeamTotals& t, std::size_t) {
       return fmt::format("{}, {}", t.dribbles, t.take_ons);
     }},
    {"shots on target", [](const MatchStatistics&, const TeamTotals& t,
                           std::size_t) { return of(t.shots.on_target, t.shots.total); }},
    {"goal, saved, blocked, wide, post",
     [](const MatchStatistics&, const TeamTotals& t, std::size_t) {
       const auto& o = t.shots.outcomes;
       return fmt::format("{}, {}, {}, {}, {}", o[0], o[1], o[2], o[3], o[4]);
     }},
    {"expected goals", [](const MatchStatistics&, const TeamTotals& t,
                          std::size_t) { return fmt::format("{:.2f}", t.shots.expected); }},
    {"box entries, touches in the box",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamTerritory& t = all.territory.teams[team];
       return fmt::format("{}, {}", t.box_entries, t.box_touches);
     }},
    {"pitch control",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return percent(all.territory.teams[team].pitch_control);
     }},
    {"tackles that hit", [](const MatchStatistics&, const TeamTotals& t,
                            std::size_t) { return of(t.tackles.succeeded, t.tackles.tried); }},
    {"interceptions, recoveries",
     [](const MatchStatistics& all, const TeamTotals& t, std::size_t team) {
       return fmt::format("{}, {}", t.interceptions, all.pressing.teams[team].recoveries);
     }},
    {"opponent's passes per action",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return fmt::format("{:.1f}", all.pressing.teams[team].passes_per_action());
     }},
    {"saves, catches",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       return fmt::format("{}, {}", all.goalkeeping[team].saves, all.goalkeeping[team].catches);
     }},
    {"offsides, fouls",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamStoppages& s = all.stoppages.teams[team];
       return fmt::format("{}, {}", s.offsides, s.fouls);
     }},
    {"yellow, red cards",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamStoppages& s = all.stoppages.teams[team];
       return fmt::format("{}, {}", s.yellow_cards, s.red_cards);
     }},
    {"kick-ins, corners, goal kicks",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamStoppages& s = all.stoppages.teams[team];
       return fmt::format("{}, {}, {}", s.kick_ins, s.corners, s.goal_kicks);
     }},
    {"free kicks, indirect",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamStoppages& s = all.stoppages.teams[team];
       return fmt::format("{}, {}", s.free_kicks, s.indirect_free_kicks);
     }},
    {"distance", [](const MatchStatistics&, const TeamTotals& t,
                    std::size_t) { return fmt::format("{:.1f} km", t.distance / 1000); }},
    {"formation", [](const MatchStatistics& all, const TeamTotals&,
                     std::size_t team) { return all.positions.teams[team].formation; }},
    {"length x width",
     [](const MatchStatistics& all, const TeamTotals&, std::size_t team) {
       const TeamShape& s = all.positions.teams[team];
       return fmt::format("{:.0f} x {:.0f} m", s.length, s.width);
     }},
};

std::string team_part(const MatchSummary& summary, const MatchStatistics& all) {
  const PerTeam<TeamTotals> totals = {totals_of(all, 0), totals_of(all, 1)};
  base::TextTable table;
  table.add_column("");
  table.add_column(summary.teams[0].name, Align::kRight);
  table.add_column(summary.teams[1].name, Align::kRight);
  for (const Row& row : kRows) {
    table.add_row({row.head, row.text(all, totals[0], 0), row.text(all, totals[1], 1)});
  }
  if (all.responsiveness) {
    const auto silent = [&](std::size_t team) {
      return of(totals[team].silent, totals[team].steps);
    };
    table.add_row({"silent steps", silent(0), silent(1)});
    table.add_row({"rejected commands", std::to_string(totals[0].rejected),
                   std::to_string(totals[1].rejected)});
  }
  return table.plain();
}

std::string player_part(const MatchSummary& summary, const MatchStatistics& all) {
  base::TextTable table;
  table.add_column("player");
  for (const char* head : {"touches", "passes", "dribbles", "shots", "goals", "tackles", "won",
                           "lost", "fouls", "metres", "stamina", "silent", "rating"}) {
    table.add_column(head, Align::kRight);
  }
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (all.attention[slot].frames == 0) continue;
    const BallWork& work = all.ball_work[slot];
    const int number = soccer::unum_of_slot(static_cast<int>(slot));
    table.add_row({fmt::format("{} {}", summary.teams[team_of(slot)].name, number),
                   std::to_string(work.touches), of(work.completed, work.passes),
                   std::to_string(work.dribbles), of(work.on_target, work.shots),
                   std::to_string(work.goals),
                   of(all.tackles[slot].succeeded, all.tackles[slot].tried),
                   std::to_string(all.pressing.recoveries[slot]), std::to_string(work.losses),
                   std::to_string(all.stoppages.fouls_by[slot]),
                   fmt::format("{:.0f}", all.movement[slot].distance()),
                   fmt::format("{:.0f}", all.stamina[slot].used),
                   all.responsiveness ? std::to_string((*all.responsiveness)[slot].silent) : "-",
                   one_decimal(all.ratings[slot].total())});
  }
  return table.plain();
}

}  // namespace

std::string statistics_text(const MatchSummary& summary, const MatchStatistics& all) {
  const auto& [left, right] = summary.teams;
  std::string text = fmt::format("{} {} {}  ({} cycles, {} of {} frames in play)\n", left.name,
                                 score_text(summary), right.name, summary.cycles,
                                 all.territory.live_frames, all.territory.frames);
  for (const std::string& doubt : doubts_about(summary, all)) text += "doubt: " + doubt + "\n";
  text += '\n';
  text += team_part(summary, all);
  text += '\n';
  text += player_part(summary, all);
  return text;
}

}  // namespace cls::analysis
