// Settings of server parameters, as rcssserver takes them.
#pragma once

#include <string_view>

#include "base/result.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {

/// Sets the server parameter `name` from text (set_parameter). As in rcssserver, probabilities of
/// fouls are limited to 0..1, slow_down_factor to 1 and more, numbers of halves and extra_half_time
/// to 0 and more, and folders and programs may begin with a tilde.
base::Result<void> set_server_parameter(ServerParams& params, std::string_view name,
                                        std::string_view text);

}  // namespace cls::soccer
