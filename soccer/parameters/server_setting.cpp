// The limits of rcssserver's setters (serverparam.cpp).
#include "soccer/parameters/server_setting.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/io/home_path.h"

namespace cls::soccer {

base::Result<void> set_server_parameter(ServerParams& params, std::string_view name,
                                        std::string_view text) {
  if (auto set = set_parameter(params, server_param_table(), name, text); !set) return set;
  params.slow_down_factor = std::max(1, params.slow_down_factor);
  for (int* length : {&params.nr_normal_halfs, &params.nr_extra_halfs, &params.extra_half_time}) {
    *length = std::max(0, *length);
  }
  for (double* probability : {&params.foul_detect_probability, &params.red_card_probability}) {
    *probability = std::clamp(*probability, 0.0, 1.0);
  }
  for (std::string* path : {&params.game_log_dir, &params.text_log_dir, &params.keepaway_log_dir,
                            &params.coach_msg_file, &params.team_l_start, &params.team_r_start}) {
    *path = base::expand_home(*path);
  }
  return {};
}

}  // namespace cls::soccer
