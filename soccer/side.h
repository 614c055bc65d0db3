// The two sides of the pitch and who stands on them.
#pragma once

#include <cstdint>

namespace cls::soccer {

/// Left defends x = -52.5 and never swaps. The numeric value is the sign that mirrors coordinates
/// into the left team's view (server convention: +1 left, -1 right, 0 nobody).
enum class Side : std::int8_t { kLeft = 1, kNeutral = 0, kRight = -1 };

constexpr int kPlayersPerTeam = 11;
constexpr int kPlayersOnPitch = 22;

constexpr int sign(Side side) { return static_cast<int>(side); }
constexpr Side opponent(Side side) { return static_cast<Side>(-static_cast<int>(side)); }

/// The letter of the text protocol and of play mode names: 'l', 'r', or 'n' for neutral.
constexpr char letter(Side side) {
  return side == Side::kLeft ? 'l' : side == Side::kRight ? 'r' : 'n';
}

/// Slot of a player in every array of 22: left 1..11 are 0..10, right 1..11 are 11..21.
constexpr int slot_of(Side side, int unum) {
  return (side == Side::kRight ? kPlayersPerTeam : 0) + unum - 1;
}
constexpr Side side_of_slot(int slot) {
  return slot < kPlayersPerTeam ? Side::kLeft : Side::kRight;
}
constexpr int unum_of_slot(int slot) { return slot % kPlayersPerTeam + 1; }

}  // namespace cls::soccer
