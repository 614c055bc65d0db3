// Names the random streams; changing a name changes every match.
#include "simulator/world/random_streams.h"

#include <string_view>
#include <utility>

namespace cls::simulator {
namespace {

template <std::size_t... kSlots>
PlayerStreams per_player(std::uint64_t seed, std::string_view purpose,
                         std::index_sequence<kSlots...>) {
  return {RandomStream(seed, purpose, kSlots)...};
}

PlayerStreams per_player(std::uint64_t seed, std::string_view purpose) {
  return per_player(seed, purpose, std::make_index_sequence<soccer::kPlayersOnPitch>());
}

}  // namespace

RandomStreams::RandomStreams(std::uint64_t seed)
    : ball_motion(seed, "ball motion"),
      player_motion(per_player(seed, "player motion")),
      turn(per_player(seed, "turn")),
      kick_noise(per_player(seed, "kick noise")),
      tackle(per_player(seed, "tackle")),
      tackle_noise(per_player(seed, "tackle noise")),
      catch_ball(per_player(seed, "catch")),
      foul(per_player(seed, "foul")),
      collision(seed, "collision"),
      placement(seed, "placement"),
      shoot_out(seed, "shoot-out") {}

}  // namespace cls::simulator
