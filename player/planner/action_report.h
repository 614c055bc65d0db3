// Results of the actions that Playmakers requested, counted by kind.
#pragma once

#include <array>
#include <cstdint>

namespace cls::player {

/// Index: the field number in PlayerAction; 0 is an action without a known member (nothing set, or
/// a member of a later interface).
constexpr int kActionKinds = 70;
/// Index: the field number in Say; 0 is a message without a known member.
constexpr int kSayKinds = 23;

struct ActionCounts {
  std::int64_t done = 0;     ///< a command was issued, or none was needed
  std::int64_t failed = 0;   ///< not possible in the situation
  std::int64_t skipped = 0;  ///< not tried: an earlier main action succeeded
  std::int64_t invalid = 0;  ///< contains a number that is not finite, or an unknown enum value
  std::int64_t unimplemented = 0;  ///< unknown to this proxy
};

/// Plain sums over the decisions of an agent, a team or a match.
struct ActionReport {
  std::array<ActionCounts, kActionKinds> actions{};
  std::array<ActionCounts, kSayKinds> say{};

  // Decisions that the proxy made automatically; the main actions of the list were not tried.
  std::int64_t preprocess = 0;
  std::int64_t sure_shot = 0;
  std::int64_t intention = 0;
  std::int64_t force_kick = 0;
  std::int64_t heard_pass = 0;

  std::int64_t lists = 0;    ///< decisions that executed the Playmaker's list
  std::int64_t empty = 0;    ///< of these, without any action
  std::int64_t useless = 0;  ///< of these, without any executed action: empty, or all failed
};

void add(ActionReport& into, const ActionReport& from);

}  // namespace cls::player
