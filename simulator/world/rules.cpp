// Validates parameters and draws player types.
#include "simulator/world/rules.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

namespace cls::simulator {
namespace {

using base::Error;
using base::Result;

// Rejects only parameters that the simulation cannot compute with.
Result<void> validate(const soccer::ServerParams& server, const soccer::PlayerParams& player) {
  if (server.simulator_step <= 0) return Error{"server::simulator_step must be positive"};
  if (server.send_step <= 0) return Error{"server::send_step must be positive"};
  if (server.recv_step <= 0) return Error{"server::recv_step must be positive"};
  if (server.slow_down_factor <= 0) return Error{"server::slow_down_factor must be positive"};
  if (server.ball_size <= 0) return Error{"server::ball_size must be positive"};
  if (server.player_size <= 0) return Error{"server::player_size must be positive"};
  if (server.maxpower <= 0) return Error{"server::maxpower must be positive"};

  for (const auto& [name, halfs] : {std::pair{"nr_normal_halfs", server.nr_normal_halfs},
                                    std::pair{"nr_extra_halfs", server.nr_extra_halfs}}) {
    if (std::abs(std::int64_t{halfs}) > soccer::kMaxHalfs) {
      return Error{fmt::format("server::{} must be within {}..{}", name, -soccer::kMaxHalfs,
                               soccer::kMaxHalfs)};
    }
  }

  if (player.player_types < 1 || player.player_types > kMaxPlayerTypes) {
    return Error{"player::player_types must be within 1.." + std::to_string(kMaxPlayerTypes)};
  }
  return {};
}

}  // namespace

Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                soccer::PlayerParams player, std::uint64_t seed) {
  TRY(validate(server, player));
  // random_seed, which clients receive, is an int.
  if (player.random_seed < 0) player.random_seed = static_cast<int>(seed & 0x7FFFFFFFU);
  return make_rules(
      server, player,
      draw_player_types(server, player, static_cast<std::uint32_t>(player.random_seed)));
}

Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                const soccer::PlayerParams& player,
                                                std::vector<soccer::PlayerType> types) {
  TRY(validate(server, player));
  if (std::ssize(types) != player.player_types) {
    return Error{"there must be player::player_types player types"};
  }
  Rules rules{server, player, std::move(types)};
  rules.half_time = server.half_time_cycles();
  rules.extra_half_time = server.extra_half_time_cycles();
  rules.normal_time = server.normal_time_cycles();
  rules.total_time = server.total_time_cycles();
  return std::make_shared<const Rules>(std::move(rules));
}

}  // namespace cls::simulator
