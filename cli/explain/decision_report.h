// `cls explain decision`: what players considered before they chose.
#pragma once

#include <optional>
#include <string>

namespace cls::cli {

struct DecisionQuestion {
  std::string folder;        ///< of a match with recorded decisions
  std::string side;          ///< "left", "right"; empty: both
  std::optional<int> unum;   ///< empty: all players
  std::optional<int> cycle;  ///< empty: all cycles
};

/// Prints the decisions that the question is about and had something to consider: each with its
/// candidates, or without a cycle a line each. With cycle, side and player those that had nothing
/// to consider, too. Prints errors; returns the exit code.
int explain_decision(const DecisionQuestion& question, bool json);

}  // namespace cls::cli
