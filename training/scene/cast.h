// Who takes part in an episode.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "soccer/pitch.h"
#include "training/scene/scene.h"

namespace cls::training {

/// Slots (soccer::slot_of) of an episode; constant for all episodes of a pool.
struct Cast {
  std::vector<int> left;
  std::vector<int> right;
  std::vector<int> agents;  ///< whose actions the caller chooses, left team first

  const std::vector<int>& team(Side side) const { return side == Side::kRight ? right : left; }
  const std::vector<int>& others(Side side) const { return side == Side::kRight ? left : right; }
};

/// Part of the pitch, in the coordinates of a team, to which HFO's features and targets are scaled.
struct Stage {
  double left = 0.0;
  double right = soccer::kHalfLength;
};

/// One agent's point of view: input of features, actions and scripted players.
struct PointOfView {
  const Scene& scene;
  const Cast& cast;
  Seat self;
  Stage stage;
  bool last_action_worked = true;
  double time_left = 1.0;  ///< share of the episode

  const ScenePlayer& me() const { return scene.player(self); }
  int teammate_count() const { return static_cast<int>(cast.team(scene.side).size()) - 1; }
  int opponent_count() const { return static_cast<int>(cast.others(scene.side).size()); }
};

/// Up to eleven seats, without allocation.
struct Seats {
  std::array<Seat, soccer::kPlayersPerTeam> items{};
  std::size_t count = 0;

  void add(Seat seat) { items[count++] = seat; }
  const Seat* begin() const { return items.data(); }
  const Seat* end() const { return items.data() + count; }
};

/// Teammates without the agent, by uniform number in the order of the cast.
inline Seats teammates_of(const PointOfView& view) {
  Seats seats;
  for (const int slot : view.cast.team(view.scene.side)) {
    const Seat seat = seat_of(view.scene.side, slot);
    if (seat != view.self) seats.add(seat);
  }
  return seats;
}

inline Seats opponents_of(const PointOfView& view) {
  Seats seats;
  for (const int slot : view.cast.others(view.scene.side)) {
    seats.add(seat_of(view.scene.side, slot));
  }
  return seats;
}

/// Sorts by distance from `point`, nearest first. Stable, and without the buffer that the standard
/// library's stable sort allocates.
inline void sort_by_distance(const Scene& scene, Vec2 point, Seats& seats) {
  const auto away = [&](Seat seat) { return squared_distance(scene.player(seat).position, point); };
  for (std::size_t i = 1; i < seats.count; ++i) {
    for (std::size_t k = i; k > 0 && away(seats.items[k]) < away(seats.items[k - 1]); --k) {
      std::swap(seats.items[k], seats.items[k - 1]);
    }
  }
}

}  // namespace cls::training
