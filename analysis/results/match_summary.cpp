// Derives the result of a match from its logs.
#include "analysis/results/match_summary.h"

#include <algorithm>
#include <cmath>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"
#include "base/text/enum_names.h"
#include "base/text/number_text.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;

constexpr std::string_view kResult = "(result ";
constexpr std::size_t kDateSize = 12;

constexpr auto kWinnerNames = base::enum_names<Winner>("left", "right", "draw", "");

std::string version_name(gamelog::RcgVersion version) {
  return version == gamelog::RcgVersion::kJson ? "json" : std::to_string(static_cast<int>(version));
}

// Stores the last non-empty names and the last score.
void read_teams(const gamelog::MatchRecord& record, MatchSummary& summary) {
  for (std::size_t i = 0; i < 2; ++i) {
    TeamSummary& team = summary.teams[i];
    for (const gamelog::TeamFrames& teams : record.teams) {
      if (!teams[i].name.empty()) team.name = teams[i].name;
    }

    const gamelog::TeamFrame& last = record.final_teams()[i];
    team.score = last.score;
    team.penalty_score = last.penalty_scored;
    team.penalty_missed = last.penalty_missed;
    summary.penalties = summary.penalties || last.penalties_taken() > 0;
  }
}

// Stores the score of the last frame of the first half.
void read_half_score(const gamelog::MatchRecord& record, MatchSummary& summary) {
  const double half = half_time_cycles(record.server);
  for (std::size_t i = record.frames(); half > 0.0 && i > 0; --i) {
    if (record.time[i - 1] > half) {
      summary.past_half = true;
      continue;
    }
    const gamelog::TeamFrames& teams = gamelog::teams_at(record, i - 1);
    summary.teams[0].first_half = teams[0].score;
    summary.teams[1].first_half = teams[1].score;
    return;
  }
}

void read_messages(const gamelog::MatchRecord& record, MatchSummary& summary) {
  for (const gamelog::Note& note : record.notes) {
    const auto* message = std::get_if<gamelog::Message>(&note.content);
    if (message == nullptr || !message->text.starts_with(kResult)) continue;
    summary.date = message->text.substr(kResult.size(), kDateSize);
  }
}

// Events of one player in state bits and player types.
void read_player(const gamelog::MatchRecord& record, std::size_t slot, MatchSummary& summary) {
  const PlayerEvent player = {0, side_of(slot), unum_of(slot)};
  const auto at = [&player](int cycle) { return PlayerEvent{cycle, player.side, player.unum}; };
  bool seen = false;
  bool gone = false;
  std::uint32_t before = 0;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    const std::size_t entry = entry_of(i, slot);
    const std::uint32_t state = record.players.state[entry];
    const int cycle = record.time[i];
    const bool enabled = (state & gamelog::kStateEnabled) != 0;

    const std::uint32_t cards = i > 0 ? state & ~before : 0;
    if ((cards & gamelog::kStateYellowCard) != 0) summary.cards.push_back({at(cycle), false});
    if ((cards & gamelog::kStateRedCard) != 0) summary.cards.push_back({at(cycle), true});

    if (enabled && !seen) {
      seen = true;
      if (i > 0) summary.late_starts.push_back(at(cycle));
    } else if (enabled && gone) {
      gone = false;
      summary.reconnections.push_back(at(cycle));
    } else if (!enabled && seen && !gone && (state & gamelog::kStateRedCard) == 0) {
      gone = true;
      summary.disconnections.push_back(at(cycle));
    }

    if (i > 0 && enabled && (before & gamelog::kStateEnabled) != 0) {
      const int old_type = record.players.type[entry - gamelog::kSlots];
      const int new_type = record.players.type[entry];
      if (old_type != new_type) {
        summary.substitutions.push_back({at(cycle), old_type, new_type});
      }
    }

    before = state;
  }
  if (!seen && record.frames() > 0) summary.never_connected.push_back(player);
}

void read_goals(const gamelog::MatchRecord& record, MatchSummary& summary) {
  const Flow flow = build_flow(record);
  for (const Goal& goal : find_goals(flow, find_shots(flow))) {
    const int unum = goal.scorer == kNoPlayer ? 0 : unum_of(goal.scorer);
    summary.goals.push_back({goal.cycle, goal.side, unum, goal.own_goal});
  }
}

// A referee message such as "goal_l_3": kind, side and number.
struct RefereeMessage {
  std::string_view what;
  Side side = Side::kNeutral;
  int number = 0;
};

std::optional<RefereeMessage> parse_referee_message(std::string_view text) {
  const std::size_t last = text.rfind('_');
  if (last == std::string_view::npos || last < 2 || text[last - 2] != '_') return std::nullopt;
  const auto number = base::parse_int(text.substr(last + 1));
  const char side = text[last - 1];
  if (!number || (side != 'l' && side != 'r')) return std::nullopt;
  return RefereeMessage{text.substr(0, last - 2), side == 'l' ? Side::kLeft : Side::kRight,
                        *number};
}

void read_cards(const gamelog::RclRecord& text, MatchSummary& summary) {
  for (const gamelog::RclLine& line : text.lines) {
    if (line.source != gamelog::RclSource::kReferee) continue;
    const auto message = parse_referee_message(text.text_of(line));
    if (!message || !soccer::is_unum(message->number)) continue;
    const bool red = message->what == "red_card";
    if (!red && message->what != "yellow_card") continue;
    summary.cards.push_back({{line.time, message->side, message->number}, red});
  }
}

void read_coin_toss(const gamelog::RclRecord& text, MatchSummary& summary, Winner& tossed) {
  for (const gamelog::RclLine& line : text.lines) {
    if (line.source != gamelog::RclSource::kReferee) continue;
    const std::string_view message = text.text_of(line);
    if (message == "penalty_winner_l") tossed = Winner::kLeft;
    if (message == "penalty_winner_r") tossed = Winner::kRight;
  }
  summary.coin_toss = summary.penalties && tossed != Winner::kNone &&
                      summary.teams[0].penalty_score == summary.teams[1].penalty_score;
}

// True after time_over, or after normal time if nothing can follow.
bool is_complete(const gamelog::MatchRecord& record) {
  if (record.frames() == 0) return false;
  if (record.mode.back() == PlayMode::kTimeOver) return true;
  const double normal_time = half_time_cycles(record.server) * record.server.nr_normal_halfs;
  if (record.version < gamelog::RcgVersion::kV3 || normal_time <= 0.0) return false;
  const auto& [left, right] = record.final_teams();
  const bool more_follows = left.score == right.score &&
                            (record.server.nr_extra_halfs > 0 || record.server.penalty_shoot_outs);
  return record.time.back() >= normal_time - 1 && !more_follows;
}

}  // namespace

double half_time_cycles(const soccer::ServerParams& server) {
  const double cycles = std::floor(server.half_time * 1000.0 / server.simulator_step + 0.5);
  return std::isfinite(cycles) ? cycles : 0.0;
}

std::string_view winner_name(Winner winner) { return kWinnerNames.name(winner); }

void set_end(const RecordedEnd& end, MatchSummary& summary) {
  summary.end_reason = end.reason;
  if (end.finished == summary.complete) return;
  summary.complete = end.finished;
  set_winner(summary, Winner::kNone);
}

void set_winner(MatchSummary& summary, Winner tossed) {
  const TeamSummary& left = summary.teams[0];
  const TeamSummary& right = summary.teams[1];

  if (!summary.complete) {
    summary.winner = Winner::kNone;
  } else if (left.score != right.score) {
    summary.winner = left.score > right.score ? Winner::kLeft : Winner::kRight;
  } else if (summary.penalties && left.penalty_score != right.penalty_score) {
    summary.winner = left.penalty_score > right.penalty_score ? Winner::kLeft : Winner::kRight;
  } else {
    summary.winner = summary.coin_toss ? tossed : Winner::kDraw;
  }
}

MatchSummary summarize(const gamelog::MatchRecord& record, const gamelog::RclRecord* text) {
  MatchSummary summary;
  summary.version = version_name(record.version);
  read_teams(record, summary);
  read_half_score(record, summary);
  read_messages(record, summary);
  summary.frames = static_cast<int>(record.frames());
  summary.cycles = record.time.empty() ? 0 : record.time.back();
  summary.complete = is_complete(record);

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) read_player(record, slot, summary);
  if (record.version < gamelog::RcgVersion::kV4 && text != nullptr) read_cards(*text, summary);

  std::ranges::stable_sort(summary.cards, {}, &PlayerEvent::cycle);
  std::ranges::stable_sort(summary.substitutions, {}, &PlayerEvent::cycle);
  for (auto* events : {&summary.disconnections, &summary.reconnections, &summary.late_starts}) {
    std::ranges::stable_sort(*events, {}, &PlayerEvent::cycle);
  }

  read_goals(record, summary);
  Winner tossed = Winner::kNone;
  if (text != nullptr) read_coin_toss(*text, summary, tossed);
  set_winner(summary, tossed);

  summary.parse_errors = record.errors.count + (text != nullptr ? text->errors.count : 0);
  return summary;
}

MatchSummary summarize(const gamelog::RclRecord& text) {
  MatchSummary summary;
  summary.version = "rcl";

  for (std::size_t i = 0; i < std::min<std::size_t>(2, text.teams.size()); ++i) {
    summary.teams[i].name = text.teams[i];
  }

  for (const gamelog::RclLine& line : text.lines) {
    summary.cycles = line.time;
    if (line.source != gamelog::RclSource::kReferee) continue;
    const std::string_view message = text.text_of(line);
    summary.complete = summary.complete || message == "time_over";

    const auto scored = parse_referee_message(message);
    if (scored && scored->what == "goal") {
      summary.goals.push_back({line.time, scored->side, 0, false});
      summary.teams[team_of(scored->side)].score = scored->number;
    }

    for (std::size_t i = 0; i < 2; ++i) {
      TeamSummary& team = summary.teams[i];
      if (message == "half_time" && team.first_half == 0) team.first_half = team.score;
      team.penalty_score += message == (i == 0 ? "penalty_score_l" : "penalty_score_r");
      team.penalty_missed += message == (i == 0 ? "penalty_miss_l" : "penalty_miss_r");
      summary.penalties = summary.penalties || team.penalty_score + team.penalty_missed > 0;
    }
  }

  read_cards(text, summary);
  Winner tossed = Winner::kNone;
  read_coin_toss(text, summary, tossed);
  set_winner(summary, tossed);

  summary.parse_errors = text.errors.count;
  return summary;
}

std::array<std::string, 2> team_ids(const MatchSummary& summary) {
  const auto& [left, right] = summary.teams;
  if (left.name == right.name || left.name.empty() || right.name.empty()) return {"left", "right"};
  return {left.name, right.name};
}

}  // namespace cls::analysis
