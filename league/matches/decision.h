// Decisions of the organizers on matches and teams: plain data, and their effect on results.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/enum_names.h"

namespace cls::league {

enum class DecisionKind {
  kAnnul,     ///< the match counts for nothing
  kReplay,    ///< it is played again, on a new seed
  kAward,     ///< it has the result of the decision, played or not
  kAsPlayed,  ///< the result as played counts, whatever was decided before
  kWithdraw,  ///< a team leaves: its matches without a result are won by the opponents
  kOrder,     ///< the order of teams that a lot would separate
};

struct MatchDecision {
  /// Number, from 1. kWithdraw: the last match that was played then; rounds after it do without the
  /// team where they can. kOrder: a match of the table.
  int match = 0;
  DecisionKind kind = DecisionKind::kAnnul;
  int left_score = 0;  ///< kAward: this and the next three
  int right_score = 0;
  std::optional<int> left_penalties;
  std::optional<int> right_penalties;
  std::uint64_t seed = 0;  ///< kReplay
  std::vector<int> teams;  ///< kWithdraw: the one that leaves; kOrder: best first
  std::string table;       ///< kOrder: the title of its table
  std::string reason;
  std::string before;  ///< the result until then, "2:1"; empty: not played
  std::string folder;  ///< match folder of that result inside the tournament's; empty: none
  std::string began;   ///< when that match began, UTC
  std::string time;    ///< UTC, ISO 8601
};

inline constexpr auto kDecisionKinds =
    base::enum_names<DecisionKind>("annul", "replay", "award", "as-played", "withdraw", "order");

constexpr std::string_view name(DecisionKind kind) { return kDecisionKinds.name(kind); }

struct Outcome;
struct ScheduledMatch;

/// The outcome that a match has by an award.
Outcome awarded(Outcome outcome, const MatchDecision& decision);

/// Gives the matches, which are by number and as stored, what was decided about them. Of several
/// decisions on a match the last one counts. A match to be replayed that still has its old seed
/// loses its outcome and gets the new one. Decisions on teams are in the histories of their
/// matches.
void apply_decisions(std::span<ScheduledMatch> matches, std::span<const MatchDecision> decisions);

constexpr bool is_about_teams(DecisionKind kind) {
  return kind == DecisionKind::kWithdraw || kind == DecisionKind::kOrder;
}

/// The teams that have left, in the order in which they did.
std::vector<int> withdrawn_teams(std::span<const ScheduledMatch> matches);

/// Awards the matches without an outcome of teams that have left: 3:0 for the opponent; annulled
/// if that one has left, too. Returns their numbers. apply_decisions() does the same.
std::vector<int> award_withdrawn(std::span<ScheduledMatch> matches);

/// Whether award_withdrawn() gave the match its outcome.
bool is_by_withdrawal(const ScheduledMatch& match);

/// The decided orders of teams.
std::vector<MatchDecision> decided_orders(std::span<const ScheduledMatch> matches);

/// The goals by which a match is won that a team forfeits.
inline constexpr int kForfeitGoals = 3;

/// The seed of a replay of a match with `seed`: decisions are a function of results, too.
std::uint64_t seed_of_replay(std::uint64_t seed);

}  // namespace cls::league
