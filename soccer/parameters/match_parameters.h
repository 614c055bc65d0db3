// The parameters of a match, as users set them.
#pragma once

#include <string_view>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {

/// Parameters of the embedded server in a match: those of rcssserver, but a level match ends after
/// normal time (server::nr_extra_halfs 0, server::penalty_shoot_outs off).
ServerParams match_server_params();

/// Sets a parameter from `server::NAME=VALUE` or `player::NAME=VALUE`.
base::Result<void> apply_setting(ServerParams& server, PlayerParams& player,
                                 std::string_view setting);

}  // namespace cls::soccer
