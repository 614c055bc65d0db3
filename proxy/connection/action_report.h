// What became of the actions that Playmakers asked for, counted by kind.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cls::proxy {

/// Actions are named by their field number in PlayerAction; 0 stands for an action without a known
/// member (nothing set, or a member of a later version).
constexpr int kActionKinds = 70;
/// The same for the members of Say.
constexpr int kSayKinds = 23;

struct ActionCounts {
  std::int64_t done = 0;           ///< a command was issued (or nothing was left to do)
  std::int64_t failed = 0;         ///< tried, but the situation did not allow it
  std::int64_t skipped = 0;        ///< not tried: an earlier main action had succeeded
  std::int64_t invalid = 0;        ///< a number in it was not finite or an enum value unknown
  std::int64_t unimplemented = 0;  ///< this proxy has no such action
};

/// Plain sums over the decisions of an agent, a team or a match.
struct ActionReport {
  std::array<ActionCounts, kActionKinds> actions{};
  std::array<ActionCounts, kSayKinds> say{};

  // Decisions that the proxy took by itself, so that the list's main actions were not tried.
  std::int64_t preprocess = 0;
  std::int64_t sure_shot = 0;
  std::int64_t intention = 0;
  std::int64_t force_kick = 0;
  std::int64_t heard_pass = 0;
};

void add(ActionReport& into, const ActionReport& from);

/// The member's name on the wire ("body_go_to_point"); "unknown" for 0 and what is out of range.
std::string_view action_name(int kind);
std::string_view say_name(int kind);

}  // namespace cls::proxy
