// The players of an episode.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/fixed_list.h"
#include "soccer/pitch.h"
#include "training/scene/scene.h"

namespace cls::player {
struct OptionTable;
struct WorldModel;
}  // namespace cls::player

namespace cls::training {

/// Slots (soccer::slot_of) of an episode; constant for all episodes of a pool.
struct Cast {
  std::vector<int> left;
  std::vector<int> right;
  std::vector<int> agents;  ///< whose actions the caller chooses, left team first

  const std::vector<int>& team(Side side) const { return side == Side::kRight ? right : left; }
  const std::vector<int>& others(Side side) const { return side == Side::kRight ? left : right; }
};

/// Eleven players a side and no agents, as in matches.
inline Cast everybody() {
  Cast cast;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    cast.left.push_back(soccer::slot_of(Side::kLeft, unum));
    cast.right.push_back(soccer::slot_of(Side::kRight, unum));
  }
  return cast;
}

/// Part of the pitch, in the coordinates of a team, to which HFO's features and targets are scaled.
struct Stage {
  double left = 0.0;
  double right = soccer::kHalfLength;
};

class Openings;

/// One agent's point of view: input of features, actions and scripted players.
struct PointOfView {
  const Scene& scene;
  const Cast& cast;
  Seat self;
  Stage stage;
  bool last_action_worked = true;
  double time_left = 1.0;              ///< share of the episode
  const Openings* openings = nullptr;  ///< of the scene, for feature sets that need them
  /// The agent's estimates and what it may choose now; for options, otherwise null.
  const player::WorldModel* world = nullptr;
  const player::OptionTable* options = nullptr;

  const ScenePlayer& me() const { return scene.player(self); }
  int teammate_count() const { return static_cast<int>(cast.team(scene.side).size()) - 1; }
  int opponent_count() const { return static_cast<int>(cast.others(scene.side).size()); }
};

/// Seats of a team.
using Seats = base::FixedList<Seat, soccer::kPlayersPerTeam>;

/// The seats of `team` in the scenes of `side`, in the order of the cast.
inline Seats seats_of(Side side, const std::vector<int>& team) {
  Seats seats;
  for (const int slot : team) seats.push_back(seat_of(side, slot));
  return seats;
}

/// Teammates without the agent, by uniform number in the order of the cast.
inline Seats teammates_of(const PointOfView& view) {
  Seats seats;
  for (const int slot : view.cast.team(view.scene.side)) {
    const Seat seat = seat_of(view.scene.side, slot);
    if (seat != view.self) seats.push_back(seat);
  }
  return seats;
}

inline Seats opponents_of(const PointOfView& view) {
  return seats_of(view.scene.side, view.cast.others(view.scene.side));
}

/// Sorts by distance from `point`, nearest first. Stable, and without the buffer that the standard
/// library's stable sort allocates.
inline void sort_by_distance(const Scene& scene, Vec2 point, Seats& seats) {
  std::array<double, soccer::kPlayersPerTeam> away;
  for (std::size_t i = 0; i < seats.size(); ++i) {
    away[i] = squared_distance(scene.player(seats[i]).position, point);
  }

  for (std::size_t i = 1; i < seats.size(); ++i) {
    for (std::size_t k = i; k > 0 && away[k] < away[k - 1]; --k) {
      std::swap(away[k], away[k - 1]);
      std::swap(seats[k], seats[k - 1]);
    }
  }
}

}  // namespace cls::training
