// Rows for spreadsheets: teams, players, events.
#include <fmt/format.h>

#include <cmath>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/statistics_text.h"
#include "analysis/statistics/team_totals.h"
#include "soccer/side_name.h"

namespace cls::analysis {
namespace {

// Four decimals at most.
std::string number(double value) { return fmt::format("{}", std::round(value * 1e4) / 1e4 + 0.0); }

template <typename... Values>
std::vector<std::string> row(const Values&... values) {
  return {fmt::format("{}", values)...};
}

base::TextTable with_columns(std::initializer_list<const char*> heads) {
  base::TextTable table;
  for (const char* head : heads) table.add_column(head);
  return table;
}

std::string unum_text(std::int8_t slot) {
  return slot == kNobody ? std::string() : std::to_string(soccer::unum_of_slot(slot));
}

const char* side_text(std::int8_t slot) {
  return slot == kNobody ? "" : side_name(soccer::side_of_slot(slot));
}

}  // namespace

base::TextTable team_table() {
  return with_columns({"file",
                       "side",
                       "name",
                       "score",
                       "opponent",
                       "opponent_score",
                       "cycles",
                       "complete",
                       "possession",
                       "possession_at_feet",
                       "possession_fastest",
                       "touches",
                       "passes",
                       "completed",
                       "mean_pass",
                       "through",
                       "crosses",
                       "one_twos",
                       "dribbles",
                       "take_ons",
                       "shots",
                       "on_target",
                       "goals",
                       "expected_goals",
                       "tackles",
                       "tackles_hit",
                       "tackles_effective",
                       "interceptions",
                       "recoveries",
                       "box_entries",
                       "box_touches",
                       "final_third_touches",
                       "pitch_control",
                       "corners",
                       "kick_ins",
                       "goal_kicks",
                       "free_kicks",
                       "indirect_free_kicks",
                       "catches",
                       "saves",
                       "offsides",
                       "fouls",
                       "yellow",
                       "red",
                       "distance",
                       "stamina_used",
                       "exhausted_frames",
                       "silent_steps",
                       "rejected_commands"});
}

void add_teams(const MatchSummary& summary, const MatchStatistics& all, base::TextTable& table) {
  for (std::size_t team = 0; team < 2; ++team) {
    const TeamTotals t = totals_of(all, team);
    const TeamSummary& own = summary.teams[team];
    const TeamSummary& other = summary.teams[1 - team];
    const TeamTerritory& place = all.territory.teams[team];
    const TeamStoppages& s = all.stoppages.teams[team];
    const auto part = [team](const PerTeam<int>& frames) {
      return number(team == 0 ? left_share(frames) : 1.0 - left_share(frames));
    };
    table.add_row(row(
        summary.file, team == 0 ? "left" : "right", own.name, own.score, other.name, other.score,
        summary.cycles, summary.complete, part(all.possession.last_touch),
        part(all.possession.at_feet), part(all.possession.fastest), t.touches, t.passes.attempted,
        t.passes.completed, number(t.passes.mean_length), t.passes.through, t.passes.crosses,
        t.passes.one_twos, t.dribbles, t.take_ons, t.shots.total, t.shots.on_target, t.goals,
        number(t.shots.expected), t.tackles.tried, t.tackles.succeeded, t.tackles.effective,
        t.interceptions, all.pressing.teams[team].recoveries, place.box_entries, place.box_touches,
        place.final_third_touches, number(place.pitch_control), s.corners, s.kick_ins, s.goal_kicks,
        s.free_kicks, s.indirect_free_kicks, all.goalkeeping[team].catches,
        all.goalkeeping[team].saves, s.offsides, s.fouls, s.yellow_cards, s.red_cards,
        number(t.distance), number(t.stamina_used), t.exhausted_frames,
        all.responsiveness ? std::to_string(t.silent) : std::string(),
        all.responsiveness ? std::to_string(t.rejected) : std::string()));
  }
}

base::TextTable player_table() {
  return with_columns({"file",
                       "side",
                       "name",
                       "unum",
                       "frames",
                       "touches",
                       "passes",
                       "completed",
                       "received",
                       "key_passes",
                       "assists",
                       "dribbles",
                       "take_ons",
                       "shots",
                       "on_target",
                       "goals",
                       "own_goals",
                       "expected_goals",
                       "threat_added",
                       "tackles",
                       "tackles_hit",
                       "interceptions",
                       "recoveries",
                       "losses",
                       "fouls",
                       "fouled",
                       "yellow",
                       "red",
                       "distance",
                       "top_speed",
                       "stamina_used",
                       "lowest_stamina",
                       "exhausted_frames",
                       "mean_x",
                       "mean_y",
                       "steps",
                       "silent",
                       "no_body_command",
                       "rejected_kicks",
                       "rating"});
}

void add_players(const MatchSummary& summary, const MatchStatistics& all, base::TextTable& table) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const BallWork& w = all.ball_work[slot];
    const Responsiveness* r = all.responsiveness ? &(*all.responsiveness)[slot] : nullptr;
    const auto answers = [r](int Responsiveness::*member) {
      return r == nullptr ? std::string() : std::to_string(r->*member);
    };
    const soccer::Vec2 mean = all.positions.players[slot].all.mean;
    table.add_row(row(
        summary.file, side_text(static_cast<std::int8_t>(slot)), summary.teams[team_of(slot)].name,
        soccer::unum_of_slot(static_cast<int>(slot)), all.attention[slot].frames, w.touches,
        w.passes, w.completed, w.received, w.key_passes, w.assists, w.dribbles, w.take_ons, w.shots,
        w.on_target, w.goals, w.own_goals, number(w.expected_goals), number(w.threat),
        all.tackles[slot].tried, all.tackles[slot].succeeded, all.pressing.interceptions[slot],
        all.pressing.recoveries[slot], w.losses, all.stoppages.fouls_by[slot],
        all.stoppages.fouls_against[slot], all.stoppages.yellow_cards[slot],
        all.stoppages.red_cards[slot], number(all.movement[slot].distance()),
        number(all.movement[slot].top_speed), number(all.stamina[slot].used),
        number(all.stamina[slot].lowest), all.stamina[slot].exhausted_frames, number(mean.x),
        number(mean.y), answers(&Responsiveness::steps), answers(&Responsiveness::silent),
        answers(&Responsiveness::no_body_command), answers(&Responsiveness::rejected_kicks),
        number(all.ratings[slot].total())));
  }
}

base::TextTable event_table() {
  return with_columns({"file", "cycle", "stopped", "kind", "side", "unum", "from_x", "from_y",
                       "to_x", "to_y", "other_side", "other_unum", "result", "marks"});
}

void add_events(const MatchSummary& summary, const MatchStatistics& all, base::TextTable& table) {
  for (const Event& event : events_of(all)) {
    const std::string marks = fmt::format("{}", fmt::join(event.marks, " "));
    table.add_row(row(summary.file, event.cycle, event.stopped, event.kind, side_text(event.slot),
                      unum_text(event.slot), number(event.from.x), number(event.from.y),
                      number(event.to.x), number(event.to.y), side_text(event.other),
                      unum_text(event.other), event.result, marks));
  }
}

}  // namespace cls::analysis
