// Decisions of the organizers on single matches: plain data, and their effect on results.
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
};

struct MatchDecision {
  int match = 0;  ///< number, from 1
  DecisionKind kind = DecisionKind::kAnnul;
  int left_score = 0;  ///< kAward: this and the next three
  int right_score = 0;
  std::optional<int> left_penalties;
  std::optional<int> right_penalties;
  std::uint64_t seed = 0;  ///< kReplay
  std::string reason;
  std::string before;  ///< the result until then, "2:1"; empty: not played
  std::string folder;  ///< match folder of that result inside the tournament's; empty: none
  std::string began;   ///< when that match began, UTC
  std::string time;    ///< UTC, ISO 8601
};

inline constexpr auto kDecisionKinds =
    base::enum_names<DecisionKind>("annul", "replay", "award", "as-played");

constexpr std::string_view name(DecisionKind kind) { return kDecisionKinds.name(kind); }

struct Outcome;
struct ScheduledMatch;

/// The outcome that a match has by an award.
Outcome awarded(Outcome outcome, const MatchDecision& decision);

/// Gives the matches, which are by number and as stored, what was decided about them. Of several
/// decisions on a match the last one counts. A match to be replayed that still has its old seed
/// loses its outcome and gets the new one.
void apply_decisions(std::span<ScheduledMatch> matches, std::span<const MatchDecision> decisions);

/// The seed of a replay of a match with `seed`: decisions are a function of results, too.
std::uint64_t seed_of_replay(std::uint64_t seed);

}  // namespace cls::league
