// The messages server_param, player_param and player_type, generated from the parameter tables.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {

// format() writes the parameters that a client of `version` receives (kAllVersions: monitors of
// version 3 and later, game logs). parse() skips unknown names, which newer servers may send, and
// leaves parameters that are not in the message unchanged. A value of the wrong type is an error
// that names the byte.

void format(const ServerParams& params, int version, std::string& out);
void format(const PlayerParams& params, int version, std::string& out);
void format(const PlayerType& type, int version, std::string& out);

base::Result<void> parse(std::string_view message, ServerParams& out);
base::Result<void> parse(std::string_view message, PlayerParams& out);
base::Result<void> parse(std::string_view message, PlayerType& out);

}  // namespace cls::soccer
