// Everything a user can say about one match.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/endpoint.h"
#include "proxy/player_agent.h"
#include "soccer/player_params.h"
#include "soccer/result.h"
#include "soccer/server_params.h"

namespace cls::orchestration {

/// Parameters of the embedded server for `cls match`: those of rcssserver, but a level match ends
/// after normal time (server::nr_extra_halfs 0, server::penalty_shoot_outs off).
soccer::ServerParams match_server_params();

/// Options of one match, plain; defaults are those of `cls match`.
struct MatchOptions {
  Endpoint left;
  Endpoint right;
  std::string left_name;   ///< empty: from the endpoint
  std::string right_name;  ///< empty: from the endpoint

  std::optional<std::uint64_t> seed;  ///< none: drawn, and told
  std::optional<int> cycles;          ///< end when game time reaches this
  soccer::ServerParams server = match_server_params();
  soccer::PlayerParams player;

  std::filesystem::path folder;  ///< empty: ./runs/<UTC>-<left>-vs-<right>

  int protocol = 18;  ///< version our agents speak, 14 to 19
  int rpc_deadline_ms = 10'000;
  bool no_deadline = false;
  proxy::OnLate on_late = proxy::OnLate::kHold;
  int max_missed = 20;                 ///< missed decisions in a row of one player
  double start_timeout_s = 20.0;       ///< until a Playmaker must have answered Register
  double stall_after_s = 10.0;         ///< without a new cycle
  std::optional<double> time_limit_s;  ///< for the whole match

  std::vector<std::string> command_line;  ///< for manifest.json
};

/// Sets a parameter from `server::NAME=VALUE` or `player::NAME=VALUE`.
soccer::Result<void> apply_setting(MatchOptions& options, std::string_view setting);

/// Every contradiction and every value out of range, one line each; empty when all is well.
std::vector<std::string> mistakes_in(const MatchOptions& options);

}  // namespace cls::orchestration
