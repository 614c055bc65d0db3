// The events of a match as actions of SPADL, the Soccer Player Action Description Language, and as
// a table with the columns of socceraction.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "base/text/table.h"

namespace cls::analysis {

/// The actions that robots perform, with the numbers of SPADL.
enum class SpadlType : std::uint8_t {
  kPass = 0,
  kCross = 1,
  kThrowIn = 2,
  kFreeKickCrossed = 3,
  kFreeKickShort = 4,
  kCornerCrossed = 5,
  kCornerShort = 6,
  kTakeOn = 7,
  kFoul = 8,
  kTackle = 9,
  kInterception = 10,
  kShot = 11,
  kShotFreeKick = 13,
  kKeeperSave = 14,
  kKeeperClaim = 15,
  kKeeperPunch = 16,
  kKeeperPickUp = 17,
  kClearance = 18,
  kBadTouch = 19,
  kDribble = 21,
  kGoalKick = 22,
};

enum class SpadlResult : std::uint8_t {
  kFail = 0,
  kSuccess = 1,
  kOffside = 2,
  kOwnGoal = 3,
  kYellowCard = 4,
  kRedCard = 5,
};

enum class SpadlBodyPart : std::uint8_t { kFoot = 0, kOther = 2 };

/// "pass", "throw_in", "freekick_short", ...
std::string_view name(SpadlType type);
std::string_view name(SpadlResult result);
std::string_view name(SpadlBodyPart part);

/// Points on 105 x 68 m: the origin is the corner at the lower left, the left team attacks to the
/// right.
struct SpadlAction {
  std::uint32_t frame = 0;
  std::int8_t slot = kNoPlayer;  ///< a player, always
  soccer::Vec2 start;
  soccer::Vec2 end;
  SpadlType type = SpadlType::kPass;
  SpadlResult result = SpadlResult::kFail;
  SpadlBodyPart body_part = SpadlBodyPart::kFoot;
  std::optional<std::size_t>
      event{};  ///< index into list_events(); none: follows from another event
};

/// In the order of the match (docs/formats/events.md has the definitions). Shoot-outs have none.
std::vector<SpadlAction> spadl_actions(const MatchStatistics& statistics);

/// A CSV table to which matches are added one by one.
base::Table spadl_table();
void add_spadl(const MatchSummary& summary, const MatchStatistics& statistics, base::Table& table);

}  // namespace cls::analysis
