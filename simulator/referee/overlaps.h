// Which players overlap each other, or a circle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simulator/world/world.h"

namespace cls::simulator {

/// A set of bodies by index.
using BodySet = std::uint32_t;

/// The players on the pitch in the order of their slots, as columns, so that a circle is compared
/// with two of them per instruction. Empty before the first refresh().
struct Bodies {
  alignas(16) std::array<double, soccer::kPlayersOnPitch> x{};
  alignas(16) std::array<double, soccer::kPlayersOnPitch> y{};
  alignas(16) std::array<double, soccer::kPlayersOnPitch> size{};  ///< radius, meters
  std::array<Slot, soccer::kPlayersOnPitch> slots{};
  std::array<std::size_t, soccer::kPlayersOnPitch> by_slot{};  ///< index of a player on the pitch
  std::size_t count = 0;
  BodySet suspects = 0;  ///< each pair of the others is apart

  Vec2 position(std::size_t i) const { return {x[i], y[i]}; }
};

/// Copies the players on the pitch; those that have moved or changed their size become suspects.
void refresh(Bodies& bodies, const World& world);

/// Moves the body of a player, as refresh() would after the player has moved. Does nothing for
/// those who were not on the pitch.
void move_body(Bodies& bodies, Slot slot, Vec2 position);

/// Bodies that overlap a circle.
BodySet overlapping(const Bodies& bodies, Vec2 center, double radius);

/// By body, the ones with a higher index that it overlaps.
using Overlaps = std::array<BodySet, soccer::kPlayersOnPitch>;

/// Finds all pairs that overlap. Those bodies become the suspects.
Overlaps find_overlaps(Bodies& bodies);

}  // namespace cls::simulator
