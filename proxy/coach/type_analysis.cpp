// Steps into decays, decays into types.
#include "proxy/coach/type_analysis.h"

#include <algorithm>
#include <cmath>

namespace cls::proxy {
namespace {

using soccer::Vec2;

// Places come with six digits, four of them behind the point: what that does to a way along its
// direction, four standard deviations of it.
constexpr double kWayError = 4.0 * 4.1e-5;
// Shorter ways tell too little, and may be nothing but a collision's push.
constexpr double kShortestWay = 0.1;
// So much way in all before a verdict, in square metres.
constexpr double kEnough = 0.5;

}  // namespace

void TypeAnalysis::forget(int unum) {
  const auto i = static_cast<std::size_t>(unum - 1);
  tracks_[i] = {};
  types_[i] = -1;
}

// A step that fits no type at all was a collision, or somebody moved the player.
void TypeAnalysis::add_step(const MatchParameters& parameters, Track& track, Vec2 way,
                            Vec2 velocity) {
  const double squared = way.squared_length();
  const double length = std::sqrt(squared);
  if (length < kShortestWay) return;
  const double kept = soccer::dot(way, velocity) / squared;
  if (std::fabs(soccer::cross(way, velocity)) > kWayError * length) return;
  const bool fits = std::any_of(
      parameters.types.begin(), parameters.types.end(), [&](const soccer::PlayerType& type) {
        return std::fabs(kept - type.player_decay) < kWayError * type.player_decay / length;
      });
  if (!fits) return;
  track.kept += kept * squared;
  track.moved += squared;
}

int TypeAnalysis::type_by(const MatchParameters& parameters, const Track& track) {
  const double decay = track.kept / track.moved;
  const double error = kWayError * decay / std::sqrt(track.moved);
  int found = -1;
  for (std::size_t id = 0; id < parameters.types.size(); ++id) {
    if (std::fabs(parameters.types[id].player_decay - decay) > error) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(id);
  }
  return found;
}

void TypeAnalysis::look(const WorldModel& world) {
  const bool stands = clock_stands(world.game.mode);
  const int now = world.game.time.cycle;
  for (const PlayerState& opponent : world.opponents) {
    const auto i = static_cast<std::size_t>(opponent.unum - 1);
    Track& track = tracks_[i];
    if (!stands && track.cycle == now - 1) {
      add_step(*world.parameters, track, opponent.position - track.position, opponent.velocity);
    }
    track.cycle = now;
    track.position = opponent.position;
    if (track.moved > kEnough) types_[i] = type_by(*world.parameters, track);
  }
}

}  // namespace cls::proxy
