// What one match came to: a row of a result table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "soccer/side.h"

namespace cls::analysis {

struct TeamSummary {
  std::string name;  ///< empty: never connected
  int score = 0;
  int first_half = 0;  ///< score after the first half
  int penalty_score = 0;
  int penalty_missed = 0;
};

/// Who won; kNone for a match that did not reach its end.
enum class Winner : std::uint8_t { kLeft, kRight, kDraw, kNone };

struct GoalSummary {
  int cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< whose score grew
  int unum = 0;  ///< scorer; 0: not known. Of the other side for an own goal
  bool own_goal = false;
};

/// A player and when it happened to him.
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
  std::string file;      ///< the game log, or the text log where there is no game log
  std::string text_log;  ///< the text log that belongs to it; empty: none
  std::string version;   ///< "1" to "6", "json", "rcl"
  std::string date;      ///< of the result message, YYYYMMDDhhmm; empty where there is none

  std::array<TeamSummary, 2> teams;
  Winner winner = Winner::kNone;
  bool penalties = false;  ///< there was a shoot-out
  bool coin_toss = false;  ///< the shoot-out was level too, and the coin decided
  bool complete = false;   ///< reached its end
  std::string end_reason;  ///< in the words of `cls match`; empty where it has left none
  int cycles = 0;          ///< last game time
  int frames = 0;          ///< stopped cycles counted too

  std::vector<GoalSummary> goals;
  std::vector<CardSummary> cards;
  std::vector<SubstitutionSummary> substitutions;
  std::vector<PlayerEvent> disconnections;  ///< left before the end without a red card
  std::vector<PlayerEvent> reconnections;
  std::vector<PlayerEvent> late_starts;      ///< first seen after the first frame
  std::vector<PlayerEvent> never_connected;  ///< cycle 0

  std::uint64_t damage = 0;  ///< damaged places in both logs
};

/// From a game log, and its text log if there is one (which adds the coin toss and the cards that
/// versions 1 to 3 cannot show). Source: log-formats 5.
MatchSummary summarize(const gamelog::MatchRecord& record, const gamelog::RclRecord* text);

/// Sets the winner by score, shoot-out and coin (`tossed`), in this order; nobody's while the match
/// is not complete.
void decide_winner(MatchSummary& summary, Winner tossed);

/// Cycles of a half in normal time; 0 or less if the match has no limit. As a real number: logs may
/// state lengths that no match can have.
double half_time_cycles(const soccer::ServerParams& server);

/// From a text log alone: no scorers, no substitutions, no disconnections.
MatchSummary summarize(const gamelog::RclRecord& text);

}  // namespace cls::analysis
