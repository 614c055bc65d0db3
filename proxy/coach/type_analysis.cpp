// From movements to decays, from decays to types.
#include "proxy/coach/type_analysis.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

// Positions have four decimals: rounding error of a movement along its direction, four standard
// deviations.
constexpr double kMovementError = 4.0 * 4.1e-5;
// Shorter movements are too inaccurate, and may come from a collision.
constexpr double kMinMovement = 0.1;
// Minimum sum of squared movements before a type is assigned, in square meters.
constexpr double kMinEvidence = 0.5;

}  // namespace

void TypeAnalysis::forget(int unum) {
  const std::size_t i = base::index(unum - 1);
  tracks_[i] = {};
  types_[i] = -1;
}

// A movement that fits no type came from a collision or a trainer.
void TypeAnalysis::add_step(const player::MatchParameters& parameters, Track& track, Vec2 movement,
                            Vec2 velocity) {
  const double squared = movement.squared_length();
  const double length = std::sqrt(squared);
  if (length < kMinMovement) return;
  const double decay_ratio = soccer::dot(movement, velocity) / squared;
  if (std::fabs(soccer::cross(movement, velocity)) > kMovementError * length) return;

  const bool fits = std::ranges::any_of(parameters.types, [&](const soccer::PlayerType& type) {
    return std::fabs(decay_ratio - type.player_decay) < kMovementError * type.player_decay / length;
  });
  if (!fits) return;
  track.weighted_decay += decay_ratio * squared;
  track.weight += squared;
}

int TypeAnalysis::type_by(const player::MatchParameters& parameters, const Track& track) {
  const double decay = track.weighted_decay / track.weight;
  const double error = kMovementError * decay / std::sqrt(track.weight);
  int found = -1;
  for (std::size_t id = 0; id < parameters.types.size(); ++id) {
    if (std::fabs(parameters.types[id].player_decay - decay) > error) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(id);
  }
  return found;
}

void TypeAnalysis::update(const player::WorldModel& world) {
  const bool stopped = player::clock_stopped(world.game.mode);
  const int now = world.game.time.cycle;

  for (const player::PlayerState& opponent : world.opponents) {
    const std::size_t i = base::index(opponent.unum - 1);
    Track& track = tracks_[i];
    if (!stopped && track.cycle == now - 1) {
      add_step(*world.parameters, track, opponent.position - track.position, opponent.velocity);
    }
    track.cycle = now;
    track.position = opponent.position;
    if (track.weight > kMinEvidence) types_[i] = type_by(*world.parameters, track);
  }
}

}  // namespace cls::proxy
