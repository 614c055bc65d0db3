// Everything a user can say about one match.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/match/options/server_choice.h"
#include "proxy/agent/player_agent.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::orchestration::match {

/// Parameters of the embedded server for `cls match`: those of rcssserver, but a level match ends
/// after normal time (server::nr_extra_halfs 0, server::penalty_shoot_outs off).
soccer::ServerParams match_server_params();

/// Options of one match, plain; defaults are those of `cls match`.
struct MatchOptions {
  Endpoint left;
  Endpoint right;
  std::string left_name;   ///< empty: from the endpoint
  std::string right_name;  ///< empty: from the endpoint
  bool own_names = false;  ///< foreign teams may play under other names than these

  std::optional<std::uint64_t> seed;  ///< none: drawn, and told
  std::optional<int> cycles;          ///< end when game time reaches this
  soccer::ServerParams server = match_server_params();
  soccer::PlayerParams player;

  ServerChoice server_choice;
  std::optional<MatchMode> mode;    ///< none: see mode_of()
  bool coach = true;                ///< both teams bring their coach
  std::optional<Endpoint> trainer;  ///< who is asked GetTrainerActions; none: no trainer
  std::vector<int> left_cpus;       ///< processors of that side's programs and agents; empty: all
  std::vector<int> right_cpus;      ///< see pin_sides()

  // Where our agents belong on the pitch; null: the built-in formations.
  std::shared_ptr<const proxy::FormationSet> left_formations;
  std::shared_ptr<const proxy::FormationSet> right_formations;

  std::filesystem::path record_rpc;  ///< file for all requests and replies; empty: none
  std::filesystem::path folder;      ///< empty: ./runs/<UTC>-<left>-vs-<right>

  int protocol = 18;                   ///< version our agents speak, 14 to 19
  std::optional<int> rpc_deadline_ms;  ///< none: as the mode needs it, see decision_deadline()
  bool no_deadline = false;
  proxy::OnLate on_late = proxy::OnLate::kHold;
  int max_missed = 20;                 ///< missed decisions in a row of one player
  double start_timeout_s = 20.0;       ///< until a Playmaker must have answered Register
  double reconnect_within_s = 3.0;     ///< for a lost Playmaker to come back: proxy::AskingTime
  double stall_after_s = 10.0;         ///< without a new cycle
  std::optional<double> time_limit_s;  ///< for the whole match

  std::optional<int> monitor_port;  ///< where monitors may attach on loopback; 0: a free one
  std::optional<double> speed;      ///< times real time; none: as fast as it goes

  std::vector<std::string> command_line;  ///< for manifest.json
};

/// Sets a parameter from `server::NAME=VALUE` or `player::NAME=VALUE`.
base::Result<void> apply_setting(MatchOptions& options, std::string_view setting);

/// Gives each side half of the processors that this process may use. The error says that there is
/// only one.
base::Result<void> pin_sides(MatchOptions& options);

/// What the match sets of the server's parameters, with the user's wishes for all else: a trainer
/// needs a server that lets him in, with the referees at work (server::coach_w_referee) unless the
/// user has sent them away (server::coach).
soccer::ServerParams server_params(const MatchOptions& options);

/// The mode asked for; else lockstep, or synch when the server or a team is foreign.
MatchMode mode_of(const MatchOptions& options);

/// How long a Playmaker may take for a decision; nothing: for ever. By default 10 s in lockstep, 1
/// s in synch mode (rcssserver goes on after 1.25 s), 70 ms in real time.
std::optional<std::chrono::milliseconds> decision_deadline(const MatchOptions& options);

/// Every contradiction and every value out of range, one line each; empty when all is well.
std::vector<std::string> mistakes_in(const MatchOptions& options);

}  // namespace cls::orchestration::match
