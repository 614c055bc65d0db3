// The two sides of the pitch and the numbering of players.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cls::soccer {

/// The left team defends x = -52.5 in both halves. The value is the sign that mirrors coordinates
/// into the view of the left team (as in rcssserver: 1 left, -1 right, 0 neutral).
enum class Side : std::int8_t { kLeft = 1, kNeutral = 0, kRight = -1 };

constexpr int kPlayersPerTeam = 11;
constexpr int kPlayersOnPitch = 22;

/// Whether a number is that of a player: 1 to 11.
constexpr bool is_unum(int unum) { return unum >= 1 && unum <= kPlayersPerTeam; }

constexpr int sign(Side side) { return static_cast<int>(side); }
constexpr Side opponent(Side side) { return static_cast<Side>(-static_cast<int>(side)); }

/// The letter in the text protocol and in play mode names: 'l', 'r', or 'n' for neutral.
constexpr char letter(Side side) {
  return side == Side::kLeft ? 'l' : side == Side::kRight ? 'r' : 'n';
}

/// "left", "right" or "neutral": the name in files, options and messages.
constexpr const char* side_name(Side side) {
  return side == Side::kLeft ? "left" : side == Side::kRight ? "right" : "neutral";
}

/// Parses "left" and "right"; nothing for other text.
constexpr std::optional<Side> parse_side(std::string_view text) {
  if (text == "left") return Side::kLeft;
  if (text == "right") return Side::kRight;
  return std::nullopt;
}

/// Index of a player in arrays of 22: left 1..11 are 0..10, right 1..11 are 11..21.
constexpr int slot_of(Side side, int unum) {
  return (side == Side::kRight ? kPlayersPerTeam : 0) + unum - 1;
}
constexpr Side side_of_slot(int slot) {
  return slot < kPlayersPerTeam ? Side::kLeft : Side::kRight;
}
constexpr int unum_of_slot(int slot) { return slot % kPlayersPerTeam + 1; }

/// In place of such an index: no player.
constexpr std::int8_t kNoPlayer = -1;

}  // namespace cls::soccer
