// The draw of heterogeneous player types.
#include "soccer/parameters/player_type.h"

#include <cmath>
#include <optional>
#include <random>

#include "soccer/math.h"

namespace cls::soccer {
namespace {

// The random numbers of rcssserver. The C++ standard defines mt19937; the conversion to a real
// number is that of libstdc++, repeated here because std distributions may differ between
// libraries.
class TypeDraw {
 public:
  explicit TypeDraw(std::uint32_t seed) : engine_(seed) {}

  double delta(double low, double high) {
    if (low == high) return low;
    if (low > high) std::swap(low, high);

    const double first = static_cast<double>(engine_());
    const double second = static_cast<double>(engine_());
    const double unit = (first + second * 0x1.0p32) / 0x1.0p64;
    return std::min(unit, std::nextafter(1.0, 0.0)) * (high - low) + low;
  }

 private:
  std::mt19937 engine_;
};

// One trial; nothing if a value is out of bounds (its draws stay consumed).
std::optional<PlayerType> trial(const ServerParams& server, const PlayerParams& player,
                                TypeDraw& draw) {
  PlayerType type = default_player_type(server);

  double d = draw.delta(player.player_speed_max_delta_min, player.player_speed_max_delta_max);
  type.player_speed_max = server.player_speed_max + d;
  type.stamina_inc_max = server.stamina_inc_max + d * player.stamina_inc_max_delta_factor;
  if (type.player_speed_max <= 0.0 || type.stamina_inc_max <= 0.0) return std::nullopt;

  d = draw.delta(player.player_decay_delta_min, player.player_decay_delta_max);
  type.player_decay = server.player_decay + d;
  type.inertia_moment = server.inertia_moment + d * player.inertia_moment_delta_factor;
  if (type.player_decay <= 0.0 || type.inertia_moment < 0.0) return std::nullopt;

  d = draw.delta(player.dash_power_rate_delta_min, player.dash_power_rate_delta_max);
  type.dash_power_rate = server.dash_power_rate + d;
  type.player_size = server.player_size + d * player.player_size_delta_factor;
  if (type.dash_power_rate <= 0.0 || type.player_size <= 0.0) return std::nullopt;

  d = draw.delta(player.new_dash_power_rate_delta_min, player.new_dash_power_rate_delta_max);
  type.dash_power_rate = server.dash_power_rate + d;
  type.stamina_inc_max = server.stamina_inc_max + d * player.new_stamina_inc_max_delta_factor;
  if (type.dash_power_rate <= 0.0 || type.stamina_inc_max <= 0.0) return std::nullopt;

  d = draw.delta(player.kickable_margin_delta_min, player.kickable_margin_delta_max);
  type.kickable_margin = server.kickable_margin + d;
  type.kick_rand = server.kick_rand + d * player.kick_rand_delta_factor;
  if (type.kickable_margin <= 0.0 || type.kick_rand < 0.0) return std::nullopt;

  d = draw.delta(player.extra_stamina_delta_min, player.extra_stamina_delta_max);
  type.extra_stamina = server.extra_stamina + d;
  type.effort_max = server.effort_init + d * player.effort_max_delta_factor;
  type.effort_min = server.effort_min + d * player.effort_min_delta_factor;
  if (type.extra_stamina < 0.0 || type.effort_max <= 0.0 || type.effort_min <= 0.0) {
    return std::nullopt;
  }

  d = draw.delta(player.kick_power_rate_delta_min, player.kick_power_rate_delta_max);
  type.kick_power_rate = server.kick_power_rate + d;
  type.foul_detect_probability =
      server.foul_detect_probability + d * player.foul_detect_probability_delta_factor;

  type.catchable_area_l_stretch =
      draw.delta(player.catchable_area_l_stretch_min, player.catchable_area_l_stretch_max);

  const double speed = type.real_speed_max(server.maxpower);
  if (speed <= server.player_speed_max_min - math::kEps) return std::nullopt;
  if (speed >= server.player_speed_max + math::kEps) return std::nullopt;
  return type;
}

}  // namespace

const ParameterTable<PlayerType>& player_type_table() {
  static const ParameterTable<PlayerType> table = {
#define CLS_PLAYER_TYPE(type, name, value, since) {#name, &PlayerType::name, since, "", ""},
#include "soccer/parameters/player_type.inc"
#undef CLS_PLAYER_TYPE
  };
  return table;
}

PlayerType default_player_type(const ServerParams& server) {
  PlayerType type;

  type.player_speed_max = server.player_speed_max;
  type.stamina_inc_max = server.stamina_inc_max;
  type.player_decay = server.player_decay;
  type.inertia_moment = server.inertia_moment;
  type.dash_power_rate = server.dash_power_rate;
  type.player_size = server.player_size;
  type.kickable_margin = server.kickable_margin;
  type.kick_rand = server.kick_rand;
  type.extra_stamina = server.extra_stamina;
  type.effort_max = server.effort_init;
  type.effort_min = server.effort_min;
  type.kick_power_rate = server.kick_power_rate;
  type.foul_detect_probability = server.foul_detect_probability;
  type.dist_noise_rate = server.dist_noise_rate;
  type.focus_dist_noise_rate = server.focus_dist_noise_rate;
  type.land_dist_noise_rate = server.land_dist_noise_rate;
  type.land_focus_dist_noise_rate = server.land_focus_dist_noise_rate;
  return type;
}

std::vector<PlayerType> draw_player_types(const ServerParams& server, const PlayerParams& player,
                                          std::uint32_t seed) {
  constexpr int kMaxTrials = 1000;
  TypeDraw draw(seed);
  std::vector<PlayerType> types = {default_player_type(server)};

  while (static_cast<int>(types.size()) < player.player_types) {
    PlayerType type = default_player_type(server);
    for (int i = 0; i < kMaxTrials; ++i) {
      if (const auto drawn = trial(server, player, draw)) {
        type = *drawn;
        break;
      }
    }

    type.id = static_cast<int>(types.size());
    types.push_back(type);
  }

  return types;
}

}  // namespace cls::soccer
