// The messages server_param, player_param and player_type, derived from the parameter tables.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {

// Format: what a client of `version` is sent (kAllVersions: monitors of version 3 and later, game
// logs), values as the struct holds them. Parse: names that are not in the table are skipped, as
// clients of an older version meet newer servers; parameters that are not mentioned keep the value
// `out` has. A known name with a value of the wrong kind is an error that names the byte.

void format(const ServerParams& params, int version, std::string& out);
void format(const PlayerParams& params, int version, std::string& out);
void format(const PlayerType& type, int version, std::string& out);

base::Result<void> parse(std::string_view message, ServerParams& out);
base::Result<void> parse(std::string_view message, PlayerParams& out);
base::Result<void> parse(std::string_view message, PlayerType& out);

}  // namespace cls::soccer
