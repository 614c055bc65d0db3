// Fills the documents.
#include "analysis/tables/cdf_match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "soccer/pitch.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

using base::Json;
using soccer::Side;

constexpr const char* kVendor = "cls";
constexpr std::array<const char*, 2> kSides = {"home", "away"};

Json score(int home, int away) { return {{"home", home}, {"away", away}}; }

std::string line(const Json& json) { return base::json_line(json) + "\n"; }

const Period* find(const CdfMatch& match, PeriodKind kind) {
  const auto found = std::ranges::find(match.periods, kind, &Period::kind);
  return found == match.periods.end() ? nullptr : &*found;
}

// Goals in a period, which is that of its last frame minus that of the frame before it.
Json goals_in(const CdfMatch& match, PeriodKind kind) {
  const Period* period = find(match, kind);
  if (period == nullptr) return score(0, 0);
  const auto& record = match.record;
  const auto& last = gamelog::teams_at(record, period->end_frame - 1);
  if (period->first_frame == 0) return score(last[0].score, last[1].score);
  const auto& before = gamelog::teams_at(record, period->first_frame - 1);
  return score(last[0].score - before[0].score, last[1].score - before[1].score);
}

Json result_of(const CdfMatch& match) {
  const auto& [home, away] = match.summary.teams;
  const Winner winner = match.summary.winner;
  // The schema demands extra time and shoot-out of every match.
  return {{"final", score(home.score, away.score)},
          {"final_winning_team_id", winner == Winner::kLeft    ? match.teams[0]
                                    : winner == Winner::kRight ? match.teams[1]
                                                               : ""},
          {"first_half", goals_in(match, PeriodKind::kFirstHalf)},
          {"second_half", goals_in(match, PeriodKind::kSecondHalf)},
          {"first_half_extratime", goals_in(match, PeriodKind::kFirstExtraHalf)},
          {"second_half_extratime", goals_in(match, PeriodKind::kSecondExtraHalf)},
          {"shootout", score(home.penalty_score, away.penalty_score)}};
}

bool played(const CdfMatch& match, std::size_t slot) {
  for (std::size_t i = 0; i < match.record.frames(); ++i) {
    if (gamelog::is_enabled(match.record, entry_of(i, slot))) return true;
  }
  return false;
}

// In the first frame of play: the log may begin before the teams connect.
bool starts(const CdfMatch& match, std::size_t slot) {
  const gamelog::MatchRecord& record = match.record;
  std::size_t frame = 0;
  while (frame + 1 < record.frames() && !match.statistics.flow.is_live(frame)) ++frame;
  return frame < record.frames() && gamelog::is_enabled(record, entry_of(frame, slot));
}

// `whole`: with names, as the match sheet has them.
Json players_of(const CdfMatch& match, std::size_t team, bool whole) {
  Json players = Json::array();
  for (const std::size_t slot : kTeamSlots[team]) {
    Json player = {{"id", match.player_id(slot)}};
    if (whole) {
      player["first_name"] = match.teams[team];
      player["last_name"] = std::to_string(unum_of(slot));
    }
    player["team_id"] = match.teams[team];
    player["jersey_number"] = unum_of(slot);
    player["is_starter"] = starts(match, slot);
    if (whole) player["has_played"] = played(match, slot);
    players.push_back(player);
  }
  return players;
}

Json teams_of(const CdfMatch& match, bool whole) {
  Json teams;
  for (std::size_t team = 0; team < 2; ++team) {
    Json one = {{"id", match.teams[team]}};
    if (whole) one["short_name"] = match.summary.teams[team].name;
    one["players"] = players_of(match, team, whole);
    teams[kSides[team]] = one;
  }
  return teams;
}

Json goals_of(const CdfMatch& match) {
  Json goals = Json::array();
  const MatchStatistics& all = match.statistics;
  for (std::size_t i = 0; i < all.goals.size(); ++i) {
    const Goal& goal = all.goals[i];
    if (goal.scorer == kNoPlayer) continue;

    const auto& teams = gamelog::teams_at(match.record, goal.frame);
    const std::int8_t assist = i < all.assists.size() ? all.assists[i].passer : kNoPlayer;
    goals.push_back(
        {{"time", match.time_of(goal.frame)},
         {"period", cdf_name(period_of(match.periods, goal.frame).kind)},
         {"team_id", match.teams[team_of(goal.side)]},
         {"player_id", match.player_id(slot_index(goal.scorer))},
         {"assist_id", assist == kNoPlayer ? Json() : Json(match.player_id(slot_index(assist)))},
         {"is_own_goal", goal.own_goal},
         {"is_penalty", false},
         {"score", score(teams[0].score, teams[1].score)}});
  }
  return goals;
}

// The first frame of a cycle.
std::size_t frame_of(const CdfMatch& match, int cycle) {
  const auto& time = match.record.time;
  const auto found = std::ranges::find(time, cycle);
  return found == time.end() ? 0 : base::index(found - time.begin());
}

Json cards_of(const CdfMatch& match) {
  Json cards = Json::array();
  for (const CardSummary& card : match.summary.cards) {
    if (card.side == Side::kNeutral || match.record.frames() == 0) continue;
    const std::size_t frame = frame_of(match, card.cycle);
    const std::size_t slot = base::index(soccer::slot_of(card.side, card.unum));
    cards.push_back({{"team_id", match.teams[team_of(slot)]},
                     {"time", match.time_of(frame)},
                     {"period", cdf_name(period_of(match.periods, frame).kind)},
                     {"player_id", match.player_id(slot)},
                     {"type", card.red ? "red_card" : "yellow_card"}});
  }
  return cards;
}

// Adds a period and the whistles at its ends.
void add_period(const CdfMatch& match, const Period& period, Json& periods, Json& whistles) {
  const std::string start = match.time_of(period.first_frame);
  const std::string end = match.time_of(period.end_frame - 1);
  periods.push_back({{"period", cdf_name(period.kind)},
                     {"play_direction", "left_right"},
                     {"time_start", start},
                     {"time_end", end},
                     {"frame_id_start", period.first_frame},
                     {"frame_id_end", period.end_frame - 1},
                     {"left_team_id", match.teams[0]},
                     {"right_team_id", match.teams[1]}});
  whistles.push_back({{"type", cdf_name(period.kind)}, {"sub_type", "start"}, {"time", start}});
  whistles.push_back({{"type", cdf_name(period.kind)}, {"sub_type", "end"}, {"time", end}});
}

}  // namespace

std::string cdf_match_document(const CdfMatch& match) {
  const Json status = {{"is_neutral", true},
                       {"has_extratime", find(match, PeriodKind::kFirstExtraHalf) != nullptr},
                       {"has_shootout", match.summary.penalties}};
  const Json events = {
      {"goals", goals_of(match)}, {"substitutions", Json::array()}, {"cards", cards_of(match)}};
  return line({{"match", {{"id", match.id}, {"status", status}, {"result", result_of(match)}}},
               {"teams", teams_of(match, true)},
               {"referees", Json::array()},
               {"events", events},
               {"meta", {{"vendor", kVendor}}}});
}

std::string cdf_meta_document(const CdfMatch& match) {
  Json periods = Json::array();
  Json whistles = Json::array();
  for (const Period& period : match.periods) add_period(match, period, periods, whistles);

  const int fps = static_cast<int>(std::lround(1.0 / cycle_seconds(match.record.server)));
  const Json tracking = {{"version", base::kVersion},
                         {"name", kVendor},
                         {"fps", fps},
                         {"collection_timing", "post_match"}};
  const Json meta = {{"video", nullptr},
                     {"tracking", tracking},
                     {"event", {{"collection_timing", "post_match"}}},
                     {"landmarks", nullptr},
                     {"ball", nullptr},
                     {"meta", {{"version", base::kVersion}, {"name", kVendor}}},
                     {"cdf", {{"version", kCdfVersion}}}};
  return line({{"competition", {{"id", "robocup_2d"}}},
               {"season", {{"id", "unknown"}}},
               {"match",
                {{"id", match.id},
                 {"kickoff_time", match.time_of(0)},
                 {"periods", periods},
                 {"whistles", whistles}}},
               {"teams", teams_of(match, false)},
               {"stadium",
                {{"id", "soccer_server"},
                 {"pitch_length", soccer::kPitchLength},
                 {"pitch_width", soccer::kPitchWidth}}},
               {"meta", meta}});
}

}  // namespace cls::analysis
