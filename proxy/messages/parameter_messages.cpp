// From parameter tables to parameter messages.
#include "proxy/messages/parameter_messages.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "player/world/running.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// Names that differ between server parameter and message field.
using WireName = std::pair<std::string_view, std::string_view>;
constexpr WireName kWireNames[] = {
    {"catchable_area_l", "catch_area_l"},
    {"catchable_area_w", "catch_area_w"},
    {"ckick_margin", "corner_kick_margin"},
    {"coach", "coach_mode"},
    {"coach_port", "trainer_port"},
    {"coach_w_referee", "coach_with_referee_mode"},
    {"forbid_kick_off_offside", "kickoff_offside"},
    {"game_log_dated", "use_game_log_dated"},
    {"game_log_fixed", "use_game_log_fixed"},
    {"hear_decay", "player_hear_decay"},
    {"hear_inc", "player_hear_inc"},
    {"hear_max", "player_hear_max"},
    {"keepaway", "keepaway_mode"},
    {"maxmoment", "max_moment"},
    {"maxneckang", "max_neck_angle"},
    {"maxneckmoment", "max_neck_moment"},
    {"maxpower", "max_power"},
    {"minmoment", "min_moment"},
    {"minneckang", "min_neck_angle"},
    {"minneckmoment", "min_neck_moment"},
    {"minpower", "min_power"},
    {"olcoach_port", "online_coach_port"},
    {"old_coach_hear", "use_old_coach_hear"},
    {"port", "player_port"},
    {"prand_factor_l", "player_rand_factor_l"},
    {"prand_factor_r", "player_rand_factor_r"},
    {"profile", "use_profile"},
    {"quantize_step", "dist_quantize_step"},
    {"quantize_step_l", "landmark_dist_quantize_step"},
    {"record_messages", "record_message"},
    {"say_coach_cnt_max", "coach_say_count_max"},
    {"say_coach_msg_size", "coach_say_msg_size"},
    {"say_msg_size", "player_say_msg_size"},
    {"send_vi_step", "coach_send_vi_step"},
    {"text_log_dated", "use_text_log_dated"},
    {"text_log_fixed", "use_text_log_fixed"},
    {"verbose", "verbose_mode"},
    {"wind_ang", "wind_angle"},
    {"wind_random", "use_wind_random"},
};

std::string_view wire_name(std::string_view name) {
  const auto* found = std::ranges::find(kWireNames, name, &WireName::first);
  return found == std::end(kWireNames) ? name : found->second;
}

template <typename Value>
void set_field(Message& message, const FieldDescriptor& field, const Value& value) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if constexpr (std::is_same_v<Value, double>) {
    reflection.SetFloat(&message, &field, value);
  } else if constexpr (std::is_same_v<Value, int>) {
    reflection.SetInt32(&message, &field, value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    reflection.SetBool(&message, &field, value);
  }
}

// Every row for which the message has a field; newer server parameters have none.
template <typename Params>
void fill_from_table(const Params& params, const soccer::ParameterTable<Params>& table,
                     Message& out) {
  for (const auto& row : table) {
    const FieldDescriptor* field =
        out.GetDescriptor()->FindFieldByName(std::string(wire_name(row.name)));
    if (field == nullptr) continue;
    std::visit([&](auto member) { set_field(out, *field, params.*member); }, row.member);
  }
}

// Distance to the farthest point of the catch area with the given stretch.
double catch_distance(const soccer::ServerParams& server, double stretch) {
  const double half_width = server.catchable_area_w / 2;
  const double length = server.catchable_area_l * stretch;
  return std::sqrt(half_width * half_width + length * length);
}

// Client-side constants of the message that the server does not send (any more).
void fill_unannounced(protos::ServerParam& out) {
  constexpr float kDirQuantum = 0.1F;
  out.set_dir_quantize_step(kDirQuantum);
  out.set_dir_quantize_step_l(kDirQuantum);
  out.set_dir_quantize_step_r(kDirQuantum);

  // Quantization by team is obsolete. Upstream uses the quantum of landmarks for the left team, and
  // Playmakers may depend on it.
  out.set_dist_quantize_step_l(out.landmark_dist_quantize_step());
  out.set_dist_quantize_step_r(out.dist_quantize_step());
  out.set_landmark_dist_quantize_step_l(out.landmark_dist_quantize_step());
  out.set_landmark_dist_quantize_step_r(out.landmark_dist_quantize_step());

  out.set_random_seed(-1);
  out.set_long_kick_power_factor(2.0F);
  out.set_long_kick_delay(2);
}

void fill_pitch(protos::ServerParam& out) {
  constexpr double penalty_line = soccer::kHalfLength - soccer::kPenaltyAreaLength;
  out.set_pitch_half_length(soccer::kHalfLength);
  out.set_pitch_half_width(soccer::kHalfWidth);
  out.set_our_penalty_area_line_x(-penalty_line);
  out.set_their_penalty_area_line_x(penalty_line);
  out.set_penalty_area_half_width(soccer::kPenaltyAreaWidth / 2);
  out.set_penalty_area_length(soccer::kPenaltyAreaLength);
  out.set_goal_area_width(soccer::kGoalAreaWidth);
  out.set_goal_area_length(soccer::kGoalAreaLength);
  out.set_center_circle_r(soccer::kCenterCircleRadius);
  out.set_goal_post_radius(soccer::kGoalPostRadius);
  out.set_pitch_margin(soccer::kPitchMargin);
}

template <typename Out>
void clear_but_identity(Out& out) {
  protos::RegisterResponse identity;
  identity.Swap(out.mutable_register_response());
  out.Clear();
  out.mutable_register_response()->Swap(&identity);
}

}  // namespace

std::string_view server_parameter_of(std::string_view field) {
  const auto* found = std::ranges::find(kWireNames, field, &WireName::second);
  return found == std::end(kWireNames) ? field : found->first;
}

void fill(const soccer::ServerParams& params, protos::ServerParam& out) {
  clear_but_identity(out);
  fill_from_table(params, soccer::server_param_table(), out);
  const soccer::PlayerType type = soccer::default_player_type(params);
  out.set_control_radius_width(params.control_radius - params.player_size);
  out.set_kickable_area(type.kickable_area(params.ball_size));
  out.set_catchable_area(catch_distance(params, 1.0));
  out.set_real_speed_max(player::top_speed(params, type));
  out.set_lcm_step(std::lcm(std::lcm(params.simulator_step, params.send_step),
                            std::lcm(params.recv_step, params.sense_body_step)));
  fill_unannounced(out);
  fill_pitch(out);
}

void fill(const soccer::PlayerParams& params, protos::PlayerParam& out) {
  clear_but_identity(out);
  fill_from_table(params, soccer::player_param_table(), out);
}

void fill(const soccer::PlayerType& type, const soccer::ServerParams& server,
          protos::PlayerType& out) {
  clear_but_identity(out);
  fill_from_table(type, soccer::player_type_table(), out);
  const double speed = player::top_speed(server, type);
  out.set_kickable_area(type.kickable_area(server.ball_size));
  out.set_reliable_catchable_dist(catch_distance(server, 2.0 - type.catchable_area_l_stretch));
  out.set_max_catchable_dist(catch_distance(server, type.catchable_area_l_stretch));
  out.set_real_speed_max(speed);
  out.set_player_speed_max2(type.player_speed_max * type.player_speed_max);
  out.set_real_speed_max2(speed * speed);
  out.set_cycles_to_reach_max_speed(player::cycles_to_top_speed(server, type));
}

}  // namespace cls::proxy
