// Offsets of the parameters in the binary blocks.
#include "gamelog/rcg/binary_format.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <variant>

#include "soccer/parameters/parameter.h"

namespace cls::gamelog {
namespace {

constexpr double kRealScale = 65536.0;

template <typename Params>
struct Field {
  std::size_t offset;
  std::variant<double Params::*, int Params::*, bool Params::*> member;
};

// rcssserver truncates server parameters to 1/65536; all have at most four decimals.
void assign(const char* at, double& value) { value = std::rint(read_real(at) * 1e4) / 1e4; }
void assign(const char* at, int& value) { value = read_int16(at); }
void assign(const char* at, bool& value) { value = read_int16(at) != 0; }

template <typename Params, std::size_t kCount>
void read_fields(std::string_view block, const Field<Params> (&fields)[kCount], Params& params) {
  for (const Field<Params>& field : fields) {
    assert(field.offset + 4 <= block.size() || field.offset + 2 == block.size());
    std::visit([&](auto member) { assign(block.data() + field.offset, params.*member); },
               field.member);
  }
}

using S = soccer::ServerParams;

// slowness_on_top_for_right_team is left out: rcssserver writes the left one in its place.
constexpr Field<S> kServerFields[] = {
    {0, &S::goal_width},
    {4, &S::inertia_moment},
    {8, &S::player_size},
    {12, &S::player_decay},
    {16, &S::player_rand},
    {20, &S::player_weight},
    {24, &S::player_speed_max},
    {28, &S::player_accel_max},
    {32, &S::stamina_max},
    {36, &S::stamina_inc_max},
    {40, &S::recover_init},
    {44, &S::recover_dec_thr},
    {48, &S::recover_min},
    {52, &S::recover_dec},
    {56, &S::effort_init},
    {60, &S::effort_dec_thr},
    {64, &S::effort_min},
    {68, &S::effort_dec},
    {72, &S::effort_inc_thr},
    {76, &S::effort_inc},
    {80, &S::kick_rand},
    {84, &S::team_actuator_noise},
    {88, &S::prand_factor_l},
    {92, &S::prand_factor_r},
    {96, &S::kick_rand_factor_l},
    {100, &S::kick_rand_factor_r},
    {104, &S::ball_size},
    {108, &S::ball_decay},
    {112, &S::ball_rand},
    {116, &S::ball_weight},
    {120, &S::ball_speed_max},
    {124, &S::ball_accel_max},
    {128, &S::dash_power_rate},
    {132, &S::kick_power_rate},
    {136, &S::kickable_margin},
    {140, &S::control_radius},
    {148, &S::maxpower},
    {152, &S::minpower},
    {156, &S::maxmoment},
    {160, &S::minmoment},
    {164, &S::maxneckmoment},
    {168, &S::minneckmoment},
    {172, &S::maxneckang},
    {176, &S::minneckang},
    {180, &S::visible_angle},
    {184, &S::visible_distance},
    {188, &S::wind_dir},
    {192, &S::wind_force},
    {196, &S::wind_ang},
    {200, &S::wind_rand},
    {208, &S::catchable_area_l},
    {212, &S::catchable_area_w},
    {216, &S::catch_probability},
    {220, &S::goalie_max_moves},
    {224, &S::ckick_margin},
    {228, &S::offside_active_area_size},
    {232, &S::wind_none},
    {234, &S::wind_random},
    {236, &S::say_coach_cnt_max},
    {238, &S::say_coach_msg_size},
    {240, &S::clang_win_size},
    {242, &S::clang_define_win},
    {244, &S::clang_meta_win},
    {246, &S::clang_advice_win},
    {248, &S::clang_info_win},
    {250, &S::clang_mess_delay},
    {252, &S::clang_mess_per_cycle},
    {254, &S::half_time},
    {256, &S::simulator_step},
    {258, &S::send_step},
    {260, &S::recv_step},
    {262, &S::sense_body_step},
    {266, &S::say_msg_size},
    {268, &S::hear_max},
    {270, &S::hear_inc},
    {272, &S::hear_decay},
    {274, &S::catch_ban_cycle},
    {276, &S::slow_down_factor},
    {278, &S::use_offside},
    {280, &S::forbid_kick_off_offside},
    {284, &S::offside_kick_margin},
    {288, &S::audio_cut_dist},
    {292, &S::quantize_step},
    {296, &S::quantize_step_l},
    {328, &S::coach},
    {330, &S::coach_w_referee},
    {332, &S::old_coach_hear},
    {334, &S::send_vi_step},
    {336, &S::slowness_on_top_for_left_team},
    {344, &S::keepaway_length},
    {348, &S::keepaway_width},
    {352, &S::ball_stuck_area},
    {356, &S::max_tackle_power},
    {360, &S::max_back_tackle_power},
    {364, &S::tackle_dist},
    {368, &S::tackle_back_dist},
    {372, &S::tackle_width},
    {376, &S::start_goal_l},
    {378, &S::start_goal_r},
    {380, &S::fullstate_l},
    {382, &S::fullstate_r},
    {384, &S::drop_ball_time},
    {386, &S::synch_mode},
    {388, &S::synch_offset},
    {390, &S::synch_micro_sleep},
    {392, &S::point_to_ban},
    {394, &S::point_to_duration},
};

using P = soccer::PlayerParams;

constexpr Field<P> kPlayerFields[] = {
    {0, &P::player_types},
    {2, &P::subs_max},
    {4, &P::pt_max},
    {8, &P::player_speed_max_delta_min},
    {12, &P::player_speed_max_delta_max},
    {16, &P::stamina_inc_max_delta_factor},
    {20, &P::player_decay_delta_min},
    {24, &P::player_decay_delta_max},
    {28, &P::inertia_moment_delta_factor},
    {32, &P::dash_power_rate_delta_min},
    {36, &P::dash_power_rate_delta_max},
    {40, &P::player_size_delta_factor},
    {44, &P::kickable_margin_delta_min},
    {48, &P::kickable_margin_delta_max},
    {52, &P::kick_rand_delta_factor},
    {56, &P::extra_stamina_delta_min},
    {60, &P::extra_stamina_delta_max},
    {64, &P::effort_max_delta_factor},
    {68, &P::effort_min_delta_factor},
    {76, &P::new_dash_power_rate_delta_min},
    {80, &P::new_dash_power_rate_delta_max},
    {84, &P::new_stamina_inc_max_delta_factor},
    {88, &P::kick_power_rate_delta_min},
    {92, &P::kick_power_rate_delta_max},
    {96, &P::foul_detect_probability_delta_factor},
    {100, &P::catchable_area_l_stretch_min},
    {104, &P::catchable_area_l_stretch_max},
    {112, &P::allow_mult_default_type},
};
constexpr std::size_t kRandomSeedOffset = 72;

// Quantization steps without a server parameter.
constexpr std::size_t kFirstUnset = 300;
constexpr std::size_t kLastUnset = 324;

/// Least common multiple of the periods in ms, limited to 16 bits.
int common_step(const soccer::ServerParams& params) {
  int step = 1;
  for (const int one : {params.simulator_step, params.send_step, params.recv_step,
                        params.sense_body_step, params.send_vi_step}) {
    if (one > 0 && step < 32768) step = std::lcm(step, std::min(one, 32767));
  }

  return step;
}

// In a player type they are rounded and have more than four decimals.
constexpr double soccer::PlayerType::*kTypeFields[] = {
    &soccer::PlayerType::player_speed_max,
    &soccer::PlayerType::stamina_inc_max,
    &soccer::PlayerType::player_decay,
    &soccer::PlayerType::inertia_moment,
    &soccer::PlayerType::dash_power_rate,
    &soccer::PlayerType::player_size,
    &soccer::PlayerType::kickable_margin,
    &soccer::PlayerType::kick_rand,
    &soccer::PlayerType::extra_stamina,
    &soccer::PlayerType::effort_max,
    &soccer::PlayerType::effort_min,
    &soccer::PlayerType::kick_power_rate,
    &soccer::PlayerType::foul_detect_probability,
    &soccer::PlayerType::catchable_area_l_stretch,
};
constexpr std::size_t kFirstTypeField = 4;

void put(std::string& block, std::size_t offset, std::string_view bytes) {
  block.replace(offset, bytes.size(), bytes);
}

// Writes values at their offset into a block.
struct BlockWriter {
  std::string& block;
  std::size_t offset;
  Rounding rounding;

  void operator()(double value) const {
    std::string bytes;
    write_real(value, rounding, bytes);
    put(block, offset, bytes);
  }
  void operator()(int value) const {
    std::string bytes;
    write_int16(value, bytes);
    put(block, offset, bytes);
  }
  void operator()(bool value) const { (*this)(value ? 1 : 0); }
};

template <typename Params, std::size_t kCount>
std::string block_of(const Params& params, const Field<Params> (&fields)[kCount], std::size_t size,
                     Rounding rounding) {
  std::string block(size, '\0');
  for (const Field<Params>& field : fields) {
    const BlockWriter write{block, field.offset, rounding};
    std::visit([&](auto member) { write(params.*member); }, field.member);
  }

  return block;
}

}  // namespace

int read_int16(const char* at) {
  const auto high = static_cast<unsigned char>(at[0]);
  const auto low = static_cast<unsigned char>(at[1]);
  return static_cast<std::int16_t>(high << 8 | low);
}

int read_int32(const char* at) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(at[i]);
  return static_cast<std::int32_t>(value);
}

double read_real(const char* at) { return read_int32(at) / kRealScale; }

void read_server_params(std::string_view block, soccer::ServerParams& params) {
  read_fields(block, kServerFields, params);
}

void read_player_params(std::string_view block, soccer::PlayerParams& params) {
  read_fields(block, kPlayerFields, params);
  params.random_seed = read_int32(block.data() + kRandomSeedOffset);
}

void read_player_type(std::string_view block, soccer::PlayerType& type) {
  type.id = read_int16(block.data());

  const char* at = block.data() + kFirstTypeField;
  for (const auto member : kTypeFields) {
    type.*member = read_real(at);
    at += 4;
  }
}

void write_int16(int value, std::string& out) {
  value = std::clamp(value, -32768, 65535);
  out += static_cast<char>(value >> 8);
  out += static_cast<char>(value);
}

void write_int32(std::int64_t value, std::string& out) {
  value = std::clamp<std::int64_t>(value, INT32_MIN, INT32_MAX);
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift);
}

void write_real(double value, Rounding rounding, std::string& out) {
  double scaled = std::clamp(value * kRealScale, -2147483648.0, 2147483647.0);

  if (rounding == Rounding::kNearest) scaled = std::rint(scaled);
  if (rounding == Rounding::kAddHalfAndTruncate) scaled += 0.5;

  write_int32(static_cast<std::int64_t>(scaled), out);
}

void write_parameters(const soccer::ServerParams& params, std::string& out) {
  std::string block = block_of(params, kServerFields, kServerParamSize, Rounding::kTruncate);
  const auto write = [&block](std::size_t offset, auto value) {
    BlockWriter{block, offset, Rounding::kTruncate}(value);
  };

  // Values derived from other parameters.
  write(144, params.control_radius - params.player_size);
  write(204, params.kickable_margin + params.ball_size + params.player_size);
  write(264, common_step(params));
  write(340, params.slowness_on_top_for_left_team);
  for (std::size_t offset = kFirstUnset; offset <= kLastUnset; offset += 4) write(offset, -1.0);

  out += block;
}

void write_parameters(const soccer::PlayerParams& params, std::string& out) {
  std::string block =
      block_of(params, kPlayerFields, kPlayerParamSize, Rounding::kAddHalfAndTruncate);

  std::string seed;
  write_int32(params.random_seed, seed);
  put(block, kRandomSeedOffset, seed);

  out += block;
}

void write_parameters(const soccer::PlayerType& type, std::string& out) {
  std::string block;
  write_int16(type.id, block);
  block.resize(kFirstTypeField, '\0');

  for (const auto member : kTypeFields)
    write_real(type.*member, Rounding::kAddHalfAndTruncate, block);

  block.resize(kPlayerTypeSize, '\0');
  out += block;
}

}  // namespace cls::gamelog
