// What a match of the playground is played under, as plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/situations/book.h"
#include "base/result.h"
#include "soccer/per_side.h"
#include "soccer/protocol/team_names.h"

namespace cls::playground {

/// The side of a bundled team; its name may follow a colon.
inline constexpr std::string_view kMockSide = "mock";
/// The side of a team that decides in a function of the caller.
inline constexpr std::string_view kFunctionSide = "function";

struct MatchSetup {
  soccer::PerSide<std::string> sides;  ///< kMockSide, "mock:NAME" or kFunctionSide
  soccer::PerSide<std::string> names;  ///< empty: from the side, as `cls match` names it
  std::uint64_t seed = 0;
  std::optional<int> cycles;  ///< end of the match in game time; with a book of each situation
  std::vector<std::string> settings;  ///< "server::NAME=VALUE", "player::NAME=VALUE"
  /// Situations that are played in place of a whole match; null: none.
  std::shared_ptr<const analysis::Book> book;
  int situations = 0;      ///< of the book
  bool view = false;       ///< with the stream of the viewer
  bool decisions = false;  ///< with those of all players, for the decision debugger
};

/// Reads an object with the members left and right, and as options leftName, rightName, seed (0 to
/// 2^53 - 1), cycles (1 and more), set (an array of settings), view and decisions (booleans), and
/// book: the text of a book of situations (docs/formats/book.md), with the members situations (1
/// and more) and cycles. The error names the member.
base::Result<MatchSetup> parse_setup(std::string_view json);

/// The names of both teams. The error names the side whose name is not valid.
base::Result<soccer::TeamNames> team_names(const MatchSetup& setup);

}  // namespace cls::playground
