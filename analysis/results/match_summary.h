// The result of a match: a row of the result table.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "soccer/side.h"

namespace cls::analysis {

struct TeamSummary {
  std::string name;  ///< empty if the team never connected
  int score = 0;
  int first_half = 0;  ///< score after the first half
  int penalty_score = 0;
  int penalty_missed = 0;
};

/// Winner; kNone for an incomplete match.
enum class Winner : std::uint8_t { kLeft, kRight, kDraw, kNone };

/// "left", "right", "draw"; empty for kNone, which is null in JSON.
std::string_view winner_name(Winner winner);

struct GoalSummary {
  int cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< scoring side
  int unum = 0;  ///< scorer, 0 if unknown; a player of the other side for an own goal
  bool own_goal = false;
};

/// A player and the cycle of an event.
struct PlayerEvent {
  int cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;
  int unum = 0;
};

struct CardSummary : PlayerEvent {
  bool red = false;
};

struct SubstitutionSummary : PlayerEvent {
  int from_type = 0;
  int to_type = 0;
};

struct MatchSummary {
  std::string file;      ///< the game log, or the text log if there is no game log
  std::string text_log;  ///< the text log of the match; empty if none
  std::string version;   ///< "1" to "6", "json", "rcl"
  std::string date;      ///< of the result message, YYYYMMDDhhmm; may be empty

  std::array<TeamSummary, 2> teams;
  Winner winner = Winner::kNone;
  bool penalties = false;  ///< the match had a shoot-out
  bool coin_toss = false;  ///< the shoot-out was level, and the coin decided
  bool complete = false;   ///< reached the end of the match
  bool past_half = false;  ///< the first half was played to its end
  std::string end_reason;  ///< recorded by `cls match`; empty if not recorded
  int cycles = 0;          ///< last game time
  int frames = 0;          ///< including stopped cycles

  std::vector<GoalSummary> goals;
  std::vector<CardSummary> cards;
  std::vector<SubstitutionSummary> substitutions;
  std::vector<PlayerEvent> disconnections;  ///< disconnected before the end without a red card
  std::vector<PlayerEvent> reconnections;
  std::vector<PlayerEvent> late_starts;      ///< first connected after the first frame
  std::vector<PlayerEvent> never_connected;  ///< cycle 0

  std::uint64_t parse_errors = 0;  ///< in both logs
};

/// Summarizes a game log and its text log, if any, which adds the coin toss and the cards of
/// versions 1 to 3. Source: docs/spec/log-formats.md 5.
MatchSummary summarize(const gamelog::MatchRecord& record, const gamelog::RclRecord* text);

/// The reason of a match that is being played: its logs have no end yet.
inline constexpr const char* kRunning = "running";

/// How a match ended, as recorded outside its logs. The logs of a match with a limit of cycles look
/// like those of an aborted match.
struct RecordedEnd {
  std::string reason;     ///< "finished", "stalled", ...; kRunning
  bool finished = false;  ///< ended as planned: the match is complete
};

/// Sets the end reason, and by it whether the match is complete and the winner.
void set_end(const RecordedEnd& end, MatchSummary& summary);

/// Sets the winner by score, shoot-out and coin (`tossed`), in this order; kNone while the match is
/// incomplete.
void set_winner(MatchSummary& summary, Winner tossed);

/// Cycles of a half in normal time, 0 or less if unlimited. A real number, because corrupt logs may
/// state any length.
double half_time_cycles(const soccer::ServerParams& server);

/// Summarizes a text log alone: no scorers, substitutions or disconnections.
MatchSummary summarize(const gamelog::RclRecord& text);

/// Identifiers of the teams in files for other programs: the names of left and right team, because
/// a team plays on both sides in a tournament; "left" and "right" if the names do not tell the
/// teams apart.
std::array<std::string, 2> team_ids(const MatchSummary& summary);

}  // namespace cls::analysis
