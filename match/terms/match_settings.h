// The parameters of the soccer server that a match leaves to its user.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// Sets a parameter from `server::NAME=VALUE` or `player::NAME=VALUE`, as apply_setting() does.
/// Parameters that the match decides itself (ports, paths of logs, modes) are errors that name the
/// option to use instead.
base::Result<void> apply_match_setting(MatchOptions& options, std::string_view setting);

/// Parameters that differ from their default, but do nothing on the server of these options: one
/// warning each. rcssserver takes them all.
std::vector<std::string> settings_without_effect(const MatchOptions& options);

/// True for a parameter of the logs that a server writes, which change nothing in the match.
bool is_log_parameter(std::string_view name);

/// Why a match with these parameters never ends, or never starts; empty: it does both. `cycles` is
/// a limit given elsewhere, `remedy` says how to give one.
std::string length_problem(const soccer::ServerParams& server, std::optional<int> cycles,
                           std::string_view remedy);

/// Invalid log parameters, one line each; empty: valid.
std::vector<std::string> log_setting_errors(const MatchOptions& options);

}  // namespace cls::match
